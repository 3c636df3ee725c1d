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
layout(binding = 3) uniform sampler2D gInOcclusion;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _94 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _98 = parameters.gOutputSize.zw * 0.5;
    vec4 _101 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_98));
    vec4 _104 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _98));
    float _105 = _101.y;
    float _108 = (_105 > 0.0) ? min(_105, 65504.0) : 65504.0;
    float _109 = _101.x;
    float _112 = (_109 > 0.0) ? min(_109, 65504.0) : 65504.0;
    float _113 = _101.z;
    float _116 = (_113 > 0.0) ? min(_113, 65504.0) : 65504.0;
    float _117 = _104.z;
    float _120 = (_117 > 0.0) ? min(_117, 65504.0) : 65504.0;
    float _121 = _104.x;
    float _124 = (_121 > 0.0) ? min(_121, 65504.0) : 65504.0;
    vec3 _128 = vec3(_94 * _108, _108);
    bvec2 _150 = greaterThan(_94, parameters.gOutputSize.zw);
    bvec2 _152 = lessThan(_94, vec2(1.0) - parameters.gOutputSize.zw);
    float _158 = _120 - _108;
    vec2 _166 = mix(vec2(_158, _120), vec2(_108 - _112, _112), bvec2((_150.x ? abs(_112 - _108) : 131008.0) < (_152.x ? abs(_158) : 65504.0)));
    float _172 = _124 - _108;
    vec2 _180 = mix(vec2(_172, _124), vec2(_108 - _116, _116), bvec2((_150.y ? abs(_116 - _108) : 131008.0) < (_152.y ? abs(_172) : 65504.0)));
    float _184 = _166.x;
    vec3 _191 = vec3((_94 * _184) + (vec2(parameters.gOutputSize.z, 0.0) * _166.y), _184);
    float _199 = _180.x;
    vec3 _206 = vec3((_94 * _199) + (vec2(0.0, parameters.gOutputSize.w) * _180.y), _199);
    vec3 _211 = cross(vec3(dot(parameters.gToShadowX.xyz, _191), dot(parameters.gToShadowY.xyz, _191), dot(parameters.gToShadowZ.xyz, _191)), vec3(dot(parameters.gToShadowX.xyz, _206), dot(parameters.gToShadowY.xyz, _206), dot(parameters.gToShadowZ.xyz, _206)));
    float _212 = _211.z;
    bool _236 = _108 > parameters.gCascadeFar.x;
    bvec3 _237 = bvec3(_236);
    bool _249 = _108 > parameters.gCascadeFar.y;
    bvec3 _250 = bvec3(_249);
    vec3 _251 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _237), parameters.gCascadeScale2.xyz, _250);
    float _254 = float(_236) + float(_249);
    vec3 _255 = fma(vec3(dot(parameters.gToShadowX.xyz, _128), dot(parameters.gToShadowY.xyz, _128), dot(parameters.gToShadowZ.xyz, _128)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _251, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _237), parameters.gCascadeOffset2.xyz, _250));
    float _256 = _251.z;
    vec2 _257 = _251.xy;
    vec2 _260 = clamp((-_211.xy) / vec2((abs(_212) > 9.9999996826552253889678874634872e-21) ? _212 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_256) / _257);
    vec2 _268 = max(parameters.gDisc.xy * _257, vec2(parameters.gDisc.z));
    vec2 _277 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _280 = floor(gl_FragCoord.xy);
    vec2 _282 = floor(_280 * 0.5);
    vec2 _284 = _280 - (_282 * 2.0);
    vec2 _288 = _282 - (floor(_282 * 0.5) * 2.0);
    float _289 = _284.x;
    float _290 = _284.y;
    float _292 = abs(_289 - _290);
    float _293 = _288.y;
    float _298 = _288.x;
    vec2 _310 = vec2(fma(2.0, abs(_298 - _293), fma(8.0, _292, 4.0 * _290)) + _293, fma(2.0, abs(abs(_293 - _290) - _298), fma(4.0, _289, fma(-8.0, _292, 8.0))) + _298) * vec2(0.0625);
    float _315 = floor(parameters.gSubsetCount);
    float _318 = (_315 > 1.0) ? min(_315, 16.0) : 1.0;
    float _322 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _328 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_318, floor((_322 + 0.5) / _318), _322);
    float _332 = 6.283185482025146484375 * (_328.x + _310.x);
    float _333 = cos(_332);
    float _334 = sin(_332);
    float _337 = _328.y + _310.y;
    vec2 _338 = fract(vec2(0.5));
    float _340 = 6.283185482025146484375 * _338.x;
    float _341 = cos(_340);
    float _342 = sin(_340);
    vec2 _349 = _255.xy;
    vec2 _358 = clamp(floor(fma(_268 * sqrt(fract(_338.y + _337)), vec2(fma(_341, _333, -(_342 * _334)), fma(_341, _334, _342 * _333)), _349)) + vec2(0.5), vec2(0.5), _277);
    float _370 = _255.z;
    float _375 = -fma(parameters.gShadowBias.y, _108, parameters.gShadowBias.x);
    vec2 _379 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _381 = 6.283185482025146484375 * _379.x;
    float _382 = cos(_381);
    float _383 = sin(_381);
    vec2 _398 = clamp(floor(fma(_268 * sqrt(fract(_379.y + _337)), vec2(fma(_382, _333, -(_383 * _334)), fma(_382, _334, _383 * _333)), _349)) + vec2(0.5), vec2(0.5), _277);
    vec2 _415 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _417 = 6.283185482025146484375 * _415.x;
    float _418 = cos(_417);
    float _419 = sin(_417);
    vec2 _434 = clamp(floor(fma(_268 * sqrt(fract(_415.y + _337)), vec2(fma(_418, _333, -(_419 * _334)), fma(_418, _334, _419 * _333)), _349)) + vec2(0.5), vec2(0.5), _277);
    vec2 _451 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _453 = 6.283185482025146484375 * _451.x;
    float _454 = cos(_453);
    float _455 = sin(_453);
    vec2 _470 = clamp(floor(fma(_268 * sqrt(fract(_451.y + _337)), vec2(fma(_454, _333, -(_455 * _334)), fma(_454, _334, _455 * _333)), _349)) + vec2(0.5), vec2(0.5), _277);
    float _493 = -(((float(textureLod(gInShadowMap, vec2(fma(_254, parameters.gCascadeSize.x, _358.x), _358.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_375, _256, min(_370 + dot(_260, _358 - _349), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_254, parameters.gCascadeSize.x, _398.x), _398.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_375, _256, min(_370 + dot(_260, _398 - _349), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_254, parameters.gCascadeSize.x, _434.x), _434.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_375, _256, min(_370 + dot(_260, _434 - _349), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_254, parameters.gCascadeSize.x, _470.x), _470.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_375, _256, min(_370 + dot(_260, _470 - _349), 1.0))));
    gOutShadow = vec4(textureLod(gInOcclusion, _94, 0.0).x, (_108 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_349 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_108 <= parameters.gCascadeFar.z)) ? fma(_493, 0.25, 1.0) : 1.0) : 1.0, 0.0, 0.0);
}

