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
    vec2 _91 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _95 = parameters.gOutputSize.zw * 0.5;
    vec4 _98 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_95));
    vec4 _101 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _95));
    float _102 = _98.y;
    float _105 = (_102 > 0.0) ? min(_102, 65504.0) : 65504.0;
    float _106 = _98.x;
    float _109 = (_106 > 0.0) ? min(_106, 65504.0) : 65504.0;
    float _110 = _98.z;
    float _113 = (_110 > 0.0) ? min(_110, 65504.0) : 65504.0;
    float _114 = _101.z;
    float _117 = (_114 > 0.0) ? min(_114, 65504.0) : 65504.0;
    float _118 = _101.x;
    float _121 = (_118 > 0.0) ? min(_118, 65504.0) : 65504.0;
    vec3 _125 = vec3(_91 * _105, _105);
    bvec2 _147 = greaterThan(_91, parameters.gOutputSize.zw);
    bvec2 _149 = lessThan(_91, vec2(1.0) - parameters.gOutputSize.zw);
    float _155 = _117 - _105;
    vec2 _163 = mix(vec2(_155, _117), vec2(_105 - _109, _109), bvec2((_147.x ? abs(_109 - _105) : 131008.0) < (_149.x ? abs(_155) : 65504.0)));
    float _169 = _121 - _105;
    vec2 _177 = mix(vec2(_169, _121), vec2(_105 - _113, _113), bvec2((_147.y ? abs(_113 - _105) : 131008.0) < (_149.y ? abs(_169) : 65504.0)));
    float _181 = _163.x;
    vec3 _188 = vec3((_91 * _181) + (vec2(parameters.gOutputSize.z, 0.0) * _163.y), _181);
    float _196 = _177.x;
    vec3 _203 = vec3((_91 * _196) + (vec2(0.0, parameters.gOutputSize.w) * _177.y), _196);
    vec3 _208 = cross(vec3(dot(parameters.gToShadowX.xyz, _188), dot(parameters.gToShadowY.xyz, _188), dot(parameters.gToShadowZ.xyz, _188)), vec3(dot(parameters.gToShadowX.xyz, _203), dot(parameters.gToShadowY.xyz, _203), dot(parameters.gToShadowZ.xyz, _203)));
    float _209 = _208.z;
    bool _233 = _105 > parameters.gCascadeFar.x;
    bvec3 _234 = bvec3(_233);
    bool _246 = _105 > parameters.gCascadeFar.y;
    bvec3 _247 = bvec3(_246);
    vec3 _248 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _234), parameters.gCascadeScale2.xyz, _247);
    float _251 = float(_233) + float(_246);
    vec3 _252 = fma(vec3(dot(parameters.gToShadowX.xyz, _125), dot(parameters.gToShadowY.xyz, _125), dot(parameters.gToShadowZ.xyz, _125)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _248, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _234), parameters.gCascadeOffset2.xyz, _247));
    float _253 = _248.z;
    vec2 _254 = _248.xy;
    vec2 _257 = clamp((-_208.xy) / vec2((abs(_209) > 9.9999996826552253889678874634872e-21) ? _209 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_253) / _254);
    vec2 _265 = max(parameters.gDisc.xy * _254, vec2(parameters.gDisc.z));
    vec2 _274 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _277 = floor(gl_FragCoord.xy);
    vec2 _279 = floor(_277 * 0.5);
    vec2 _281 = _277 - (_279 * 2.0);
    vec2 _285 = _279 - (floor(_279 * 0.5) * 2.0);
    float _286 = _281.x;
    float _287 = _281.y;
    float _289 = abs(_286 - _287);
    float _290 = _285.y;
    float _295 = _285.x;
    vec2 _307 = vec2(fma(2.0, abs(_295 - _290), fma(8.0, _289, 4.0 * _287)) + _290, fma(2.0, abs(abs(_290 - _287) - _295), fma(4.0, _286, fma(-8.0, _289, 8.0))) + _295) * vec2(0.0625);
    float _312 = floor(parameters.gSubsetCount);
    float _315 = (_312 > 1.0) ? min(_312, 16.0) : 1.0;
    float _319 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _325 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_315, floor((_319 + 0.5) / _315), _319);
    float _329 = 6.283185482025146484375 * (_325.x + _307.x);
    float _330 = cos(_329);
    float _331 = sin(_329);
    float _334 = _325.y + _307.y;
    vec2 _335 = fract(vec2(0.5));
    float _337 = 6.283185482025146484375 * _335.x;
    float _338 = cos(_337);
    float _339 = sin(_337);
    vec2 _346 = _252.xy;
    vec2 _355 = clamp(floor(fma(_265 * sqrt(fract(_335.y + _334)), vec2(fma(_338, _330, -(_339 * _331)), fma(_338, _331, _339 * _330)), _346)) + vec2(0.5), vec2(0.5), _274);
    float _367 = _252.z;
    float _372 = -fma(parameters.gShadowBias.y, _105, parameters.gShadowBias.x);
    vec2 _376 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _378 = 6.283185482025146484375 * _376.x;
    float _379 = cos(_378);
    float _380 = sin(_378);
    vec2 _395 = clamp(floor(fma(_265 * sqrt(fract(_376.y + _334)), vec2(fma(_379, _330, -(_380 * _331)), fma(_379, _331, _380 * _330)), _346)) + vec2(0.5), vec2(0.5), _274);
    vec2 _412 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _414 = 6.283185482025146484375 * _412.x;
    float _415 = cos(_414);
    float _416 = sin(_414);
    vec2 _431 = clamp(floor(fma(_265 * sqrt(fract(_412.y + _334)), vec2(fma(_415, _330, -(_416 * _331)), fma(_415, _331, _416 * _330)), _346)) + vec2(0.5), vec2(0.5), _274);
    vec2 _448 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _450 = 6.283185482025146484375 * _448.x;
    float _451 = cos(_450);
    float _452 = sin(_450);
    vec2 _467 = clamp(floor(fma(_265 * sqrt(fract(_448.y + _334)), vec2(fma(_451, _330, -(_452 * _331)), fma(_451, _331, _452 * _330)), _346)) + vec2(0.5), vec2(0.5), _274);
    float _491 = -(((float(textureLod(gInShadowMap, vec2(fma(_251, parameters.gCascadeSize.x, _355.x), _355.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_372, _253, min(_367 + dot(_257, _355 - _346), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_251, parameters.gCascadeSize.x, _395.x), _395.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_372, _253, min(_367 + dot(_257, _395 - _346), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_251, parameters.gCascadeSize.x, _431.x), _431.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_372, _253, min(_367 + dot(_257, _431 - _346), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_251, parameters.gCascadeSize.x, _467.x), _467.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_372, _253, min(_367 + dot(_257, _467 - _346), 1.0))));
    gOutShadow = vec4(textureLod(gInOcclusion, _91, 0.0).x, (_105 < 65504.0) ? ((all(lessThanEqual(abs((_346 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_105 <= parameters.gCascadeFar.z)) ? fma(_491, 0.25, 1.0) : 1.0) : 1.0, 0.0, 0.0);
}

