#version 450

layout(binding = 0, std140) uniform SunShadowParameters
{
    vec4 gOutputSize;
    vec4 gToShadowX;
    vec4 gToShadowY;
    vec4 gToShadowZ;
    vec4 gCascadeScale1;
    vec4 gCascadeOffset1;
    vec4 gCascadeScale2;
    vec4 gCascadeOffset2;
    vec4 gCascadeScale3;
    vec4 gCascadeOffset3;
    vec4 gCascadeFar;
    vec4 gCascadeSize;
    vec3 gDisc;
    float gFrameIndex;
    vec3 gShadowBias;
    float gSubsetCount;
} parameters;

layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInShadowMap;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _92 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _96 = parameters.gOutputSize.zw * 0.5;
    vec4 _99 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_96));
    vec4 _102 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _96));
    float _103 = _99.y;
    float _106 = (_103 > 0.0) ? min(_103, 65504.0) : 65504.0;
    float _107 = _99.x;
    float _110 = (_107 > 0.0) ? min(_107, 65504.0) : 65504.0;
    float _111 = _99.z;
    float _114 = (_111 > 0.0) ? min(_111, 65504.0) : 65504.0;
    float _115 = _102.z;
    float _118 = (_115 > 0.0) ? min(_115, 65504.0) : 65504.0;
    float _119 = _102.x;
    float _122 = (_119 > 0.0) ? min(_119, 65504.0) : 65504.0;
    vec3 _125 = vec3(_92, _106);
    bvec2 _147 = greaterThan(_92, parameters.gOutputSize.zw);
    bvec2 _149 = lessThan(_92, vec2(1.0) - parameters.gOutputSize.zw);
    float _155 = _118 - _106;
    float _169 = _122 - _106;
    vec3 _181 = vec3(parameters.gOutputSize.z, 0.0, mix(vec2(_155, _118), vec2(_106 - _110, _110), bvec2((_147.x ? abs(_110 - _106) : 131008.0) < (_149.x ? abs(_155) : 65504.0))).x);
    vec3 _189 = vec3(0.0, parameters.gOutputSize.w, mix(vec2(_169, _122), vec2(_106 - _114, _114), bvec2((_147.y ? abs(_114 - _106) : 131008.0) < (_149.y ? abs(_169) : 65504.0))).x);
    vec3 _194 = cross(vec3(dot(parameters.gToShadowX.xyz, _181), dot(parameters.gToShadowY.xyz, _181), dot(parameters.gToShadowZ.xyz, _181)), vec3(dot(parameters.gToShadowX.xyz, _189), dot(parameters.gToShadowY.xyz, _189), dot(parameters.gToShadowZ.xyz, _189)));
    bool _219 = _106 > parameters.gCascadeFar.x;
    bvec3 _220 = bvec3(_219);
    bool _232 = _106 > parameters.gCascadeFar.y;
    bvec3 _233 = bvec3(_232);
    vec3 _234 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _220), parameters.gCascadeScale2.xyz, _233);
    float _237 = float(_219) + float(_232);
    vec3 _238 = fma(vec3(dot(parameters.gToShadowX.xyz, _125), dot(parameters.gToShadowY.xyz, _125), dot(parameters.gToShadowZ.xyz, _125)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _234, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _220), parameters.gCascadeOffset2.xyz, _233));
    float _239 = _234.z;
    vec2 _240 = _234.xy;
    vec2 _243 = clamp((-_194.xy) / vec2((abs(_194.z) > 9.9999996826552253889678874634872e-21) ? _194.z : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_239) / _240);
    vec2 _251 = max(parameters.gDisc.xy * _240, vec2(parameters.gDisc.z));
    vec2 _260 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _263 = floor(gl_FragCoord.xy);
    vec2 _265 = floor(_263 * 0.5);
    vec2 _267 = _263 - (_265 * 2.0);
    vec2 _271 = _265 - (floor(_265 * 0.5) * 2.0);
    float _272 = _267.x;
    float _273 = _267.y;
    float _275 = abs(_272 - _273);
    float _276 = _271.y;
    float _281 = _271.x;
    vec2 _293 = vec2(fma(2.0, abs(_281 - _276), fma(8.0, _275, 4.0 * _273)) + _276, fma(2.0, abs(abs(_276 - _273) - _281), fma(4.0, _272, fma(-8.0, _275, 8.0))) + _281) * vec2(0.0625);
    float _298 = floor(parameters.gSubsetCount);
    float _301 = (_298 > 1.0) ? min(_298, 16.0) : 1.0;
    float _305 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _311 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_301, floor((_305 + 0.5) / _301), _305);
    float _315 = 6.283185482025146484375 * (_311.x + _293.x);
    float _316 = cos(_315);
    float _317 = sin(_315);
    float _320 = _311.y + _293.y;
    vec2 _321 = fract(vec2(0.5));
    float _323 = 6.283185482025146484375 * _321.x;
    float _324 = cos(_323);
    float _325 = sin(_323);
    vec2 _332 = _238.xy;
    vec2 _341 = clamp(floor(fma(_251 * sqrt(fract(_321.y + _320)), vec2(fma(_324, _316, -(_325 * _317)), fma(_324, _317, _325 * _316)), _332)) + vec2(0.5), vec2(0.5), _260);
    float _353 = _238.z;
    float _358 = -fma(parameters.gShadowBias.y, _106, parameters.gShadowBias.x);
    vec2 _362 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _364 = 6.283185482025146484375 * _362.x;
    float _365 = cos(_364);
    float _366 = sin(_364);
    vec2 _381 = clamp(floor(fma(_251 * sqrt(fract(_362.y + _320)), vec2(fma(_365, _316, -(_366 * _317)), fma(_365, _317, _366 * _316)), _332)) + vec2(0.5), vec2(0.5), _260);
    vec2 _398 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _400 = 6.283185482025146484375 * _398.x;
    float _401 = cos(_400);
    float _402 = sin(_400);
    vec2 _417 = clamp(floor(fma(_251 * sqrt(fract(_398.y + _320)), vec2(fma(_401, _316, -(_402 * _317)), fma(_401, _317, _402 * _316)), _332)) + vec2(0.5), vec2(0.5), _260);
    vec2 _434 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _436 = 6.283185482025146484375 * _434.x;
    float _437 = cos(_436);
    float _438 = sin(_436);
    vec2 _453 = clamp(floor(fma(_251 * sqrt(fract(_434.y + _320)), vec2(fma(_437, _316, -(_438 * _317)), fma(_437, _317, _438 * _316)), _332)) + vec2(0.5), vec2(0.5), _260);
    float _476 = -(((float(textureLod(gInShadowMap, vec2(fma(_237, parameters.gCascadeSize.x, _341.x), _341.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_358, _239, min(_353 + dot(_243, _341 - _332), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_237, parameters.gCascadeSize.x, _381.x), _381.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_358, _239, min(_353 + dot(_243, _381 - _332), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_237, parameters.gCascadeSize.x, _417.x), _417.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_358, _239, min(_353 + dot(_243, _417 - _332), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_237, parameters.gCascadeSize.x, _453.x), _453.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_358, _239, min(_353 + dot(_243, _453 - _332), 1.0))));
    gOutShadow = vec4((_106 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_332 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_106 <= parameters.gCascadeFar.z)) ? fma(_476, 0.25, 1.0) : 1.0) : 1.0, _106, 0.0, 0.0);
}

