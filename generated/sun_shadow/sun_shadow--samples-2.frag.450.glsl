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
    vec2 _85 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _89 = parameters.gOutputSize.zw * 0.5;
    vec4 _92 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_89));
    vec4 _95 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _89));
    float _96 = _92.y;
    float _99 = (_96 > 0.0) ? min(_96, 65504.0) : 65504.0;
    float _100 = _92.x;
    float _103 = (_100 > 0.0) ? min(_100, 65504.0) : 65504.0;
    float _104 = _92.z;
    float _107 = (_104 > 0.0) ? min(_104, 65504.0) : 65504.0;
    float _108 = _95.z;
    float _111 = (_108 > 0.0) ? min(_108, 65504.0) : 65504.0;
    float _112 = _95.x;
    float _115 = (_112 > 0.0) ? min(_112, 65504.0) : 65504.0;
    vec3 _119 = vec3(_85 * _99, _99);
    bvec2 _141 = greaterThan(_85, parameters.gOutputSize.zw);
    bvec2 _143 = lessThan(_85, vec2(1.0) - parameters.gOutputSize.zw);
    float _149 = _111 - _99;
    vec2 _157 = mix(vec2(_149, _111), vec2(_99 - _103, _103), bvec2((_141.x ? abs(_103 - _99) : 131008.0) < (_143.x ? abs(_149) : 65504.0)));
    float _163 = _115 - _99;
    vec2 _171 = mix(vec2(_163, _115), vec2(_99 - _107, _107), bvec2((_141.y ? abs(_107 - _99) : 131008.0) < (_143.y ? abs(_163) : 65504.0)));
    float _175 = _157.x;
    vec3 _182 = vec3((_85 * _175) + (vec2(parameters.gOutputSize.z, 0.0) * _157.y), _175);
    float _190 = _171.x;
    vec3 _197 = vec3((_85 * _190) + (vec2(0.0, parameters.gOutputSize.w) * _171.y), _190);
    vec3 _202 = cross(vec3(dot(parameters.gToShadowX.xyz, _182), dot(parameters.gToShadowY.xyz, _182), dot(parameters.gToShadowZ.xyz, _182)), vec3(dot(parameters.gToShadowX.xyz, _197), dot(parameters.gToShadowY.xyz, _197), dot(parameters.gToShadowZ.xyz, _197)));
    float _203 = _202.z;
    bool _227 = _99 > parameters.gCascadeFar.x;
    bvec3 _228 = bvec3(_227);
    bool _240 = _99 > parameters.gCascadeFar.y;
    bvec3 _241 = bvec3(_240);
    vec3 _242 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _228), parameters.gCascadeScale2.xyz, _241);
    float _245 = float(_227) + float(_240);
    vec3 _246 = fma(vec3(dot(parameters.gToShadowX.xyz, _119), dot(parameters.gToShadowY.xyz, _119), dot(parameters.gToShadowZ.xyz, _119)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _242, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _228), parameters.gCascadeOffset2.xyz, _241));
    float _247 = _242.z;
    vec2 _248 = _242.xy;
    vec2 _251 = clamp((-_202.xy) / vec2((abs(_203) > 9.9999996826552253889678874634872e-21) ? _203 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_247) / _248);
    vec2 _259 = max(parameters.gDisc.xy * _248, vec2(parameters.gDisc.z));
    vec2 _268 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _271 = floor(gl_FragCoord.xy);
    vec2 _273 = floor(_271 * 0.5);
    vec2 _275 = _271 - (_273 * 2.0);
    vec2 _279 = _273 - (floor(_273 * 0.5) * 2.0);
    float _280 = _275.x;
    float _281 = _275.y;
    float _283 = abs(_280 - _281);
    float _284 = _279.y;
    float _289 = _279.x;
    vec2 _301 = vec2(fma(2.0, abs(_289 - _284), fma(8.0, _283, 4.0 * _281)) + _284, fma(2.0, abs(abs(_284 - _281) - _289), fma(4.0, _280, fma(-8.0, _283, 8.0))) + _289) * vec2(0.0625);
    float _306 = floor(parameters.gSubsetCount);
    float _309 = (_306 > 1.0) ? min(_306, 16.0) : 1.0;
    float _313 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _319 = vec2(0.509755313396453857421875, 0.13968057930469512939453125) * fma(-_309, floor((_313 + 0.5) / _309), _313);
    float _323 = 6.283185482025146484375 * (_319.x + _301.x);
    float _324 = cos(_323);
    float _325 = sin(_323);
    float _328 = _319.y + _301.y;
    vec2 _329 = fract(vec2(0.5));
    float _331 = 6.283185482025146484375 * _329.x;
    float _332 = cos(_331);
    float _333 = sin(_331);
    vec2 _340 = _246.xy;
    vec2 _349 = clamp(floor(fma(_259 * sqrt(fract(_329.y + _328)), vec2(fma(_332, _324, -(_333 * _325)), fma(_332, _325, _333 * _324)), _340)) + vec2(0.5), vec2(0.5), _268);
    float _361 = _246.z;
    float _366 = -fma(parameters.gShadowBias.y, _99, parameters.gShadowBias.x);
    vec2 _370 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _372 = 6.283185482025146484375 * _370.x;
    float _373 = cos(_372);
    float _374 = sin(_372);
    vec2 _389 = clamp(floor(fma(_259 * sqrt(fract(_370.y + _328)), vec2(fma(_373, _324, -(_374 * _325)), fma(_373, _325, _374 * _324)), _340)) + vec2(0.5), vec2(0.5), _268);
    gOutShadow = vec4((_99 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_340 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_99 <= parameters.gCascadeFar.z)) ? fma(-(float(textureLod(gInShadowMap, vec2(fma(_245, parameters.gCascadeSize.x, _349.x), _349.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_366, _247, min(_361 + dot(_251, _349 - _340), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_245, parameters.gCascadeSize.x, _389.x), _389.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_366, _247, min(_361 + dot(_251, _389 - _340), 1.0)))), 0.5, 1.0) : 1.0) : 1.0, _99, 0.0, 0.0);
}

