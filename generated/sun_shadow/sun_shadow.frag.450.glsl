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
    vec3 _126 = vec3(_92 * _106, _106);
    bvec2 _148 = greaterThan(_92, parameters.gOutputSize.zw);
    bvec2 _150 = lessThan(_92, vec2(1.0) - parameters.gOutputSize.zw);
    float _156 = _118 - _106;
    vec2 _164 = mix(vec2(_156, _118), vec2(_106 - _110, _110), bvec2((_148.x ? abs(_110 - _106) : 131008.0) < (_150.x ? abs(_156) : 65504.0)));
    float _170 = _122 - _106;
    vec2 _178 = mix(vec2(_170, _122), vec2(_106 - _114, _114), bvec2((_148.y ? abs(_114 - _106) : 131008.0) < (_150.y ? abs(_170) : 65504.0)));
    float _182 = _164.x;
    vec3 _189 = vec3((_92 * _182) + (vec2(parameters.gOutputSize.z, 0.0) * _164.y), _182);
    float _197 = _178.x;
    vec3 _204 = vec3((_92 * _197) + (vec2(0.0, parameters.gOutputSize.w) * _178.y), _197);
    vec3 _209 = cross(vec3(dot(parameters.gToShadowX.xyz, _189), dot(parameters.gToShadowY.xyz, _189), dot(parameters.gToShadowZ.xyz, _189)), vec3(dot(parameters.gToShadowX.xyz, _204), dot(parameters.gToShadowY.xyz, _204), dot(parameters.gToShadowZ.xyz, _204)));
    float _210 = _209.z;
    bool _234 = _106 > parameters.gCascadeFar.x;
    bvec3 _235 = bvec3(_234);
    bool _247 = _106 > parameters.gCascadeFar.y;
    bvec3 _248 = bvec3(_247);
    vec3 _249 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _235), parameters.gCascadeScale2.xyz, _248);
    float _252 = float(_234) + float(_247);
    vec3 _253 = fma(vec3(dot(parameters.gToShadowX.xyz, _126), dot(parameters.gToShadowY.xyz, _126), dot(parameters.gToShadowZ.xyz, _126)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _249, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _235), parameters.gCascadeOffset2.xyz, _248));
    float _254 = _249.z;
    vec2 _255 = _249.xy;
    vec2 _258 = clamp((-_209.xy) / vec2((abs(_210) > 9.9999996826552253889678874634872e-21) ? _210 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_254) / _255);
    vec2 _266 = max(parameters.gDisc.xy * _255, vec2(parameters.gDisc.z));
    vec2 _275 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _278 = floor(gl_FragCoord.xy);
    vec2 _280 = floor(_278 * 0.5);
    vec2 _282 = _278 - (_280 * 2.0);
    vec2 _286 = _280 - (floor(_280 * 0.5) * 2.0);
    float _287 = _282.x;
    float _288 = _282.y;
    float _290 = abs(_287 - _288);
    float _291 = _286.y;
    float _296 = _286.x;
    vec2 _308 = vec2(fma(2.0, abs(_296 - _291), fma(8.0, _290, 4.0 * _288)) + _291, fma(2.0, abs(abs(_291 - _288) - _296), fma(4.0, _287, fma(-8.0, _290, 8.0))) + _296) * vec2(0.0625);
    float _313 = floor(parameters.gSubsetCount);
    float _316 = (_313 > 1.0) ? min(_313, 16.0) : 1.0;
    float _320 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _326 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_316, floor((_320 + 0.5) / _316), _320);
    float _330 = 6.283185482025146484375 * (_326.x + _308.x);
    float _331 = cos(_330);
    float _332 = sin(_330);
    float _335 = _326.y + _308.y;
    vec2 _336 = fract(vec2(0.5));
    float _338 = 6.283185482025146484375 * _336.x;
    float _339 = cos(_338);
    float _340 = sin(_338);
    vec2 _347 = _253.xy;
    vec2 _356 = clamp(floor(fma(_266 * sqrt(fract(_336.y + _335)), vec2(fma(_339, _331, -(_340 * _332)), fma(_339, _332, _340 * _331)), _347)) + vec2(0.5), vec2(0.5), _275);
    float _368 = _253.z;
    float _373 = -fma(parameters.gShadowBias.y, _106, parameters.gShadowBias.x);
    vec2 _377 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _379 = 6.283185482025146484375 * _377.x;
    float _380 = cos(_379);
    float _381 = sin(_379);
    vec2 _396 = clamp(floor(fma(_266 * sqrt(fract(_377.y + _335)), vec2(fma(_380, _331, -(_381 * _332)), fma(_380, _332, _381 * _331)), _347)) + vec2(0.5), vec2(0.5), _275);
    vec2 _413 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _415 = 6.283185482025146484375 * _413.x;
    float _416 = cos(_415);
    float _417 = sin(_415);
    vec2 _432 = clamp(floor(fma(_266 * sqrt(fract(_413.y + _335)), vec2(fma(_416, _331, -(_417 * _332)), fma(_416, _332, _417 * _331)), _347)) + vec2(0.5), vec2(0.5), _275);
    vec2 _449 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _451 = 6.283185482025146484375 * _449.x;
    float _452 = cos(_451);
    float _453 = sin(_451);
    vec2 _468 = clamp(floor(fma(_266 * sqrt(fract(_449.y + _335)), vec2(fma(_452, _331, -(_453 * _332)), fma(_452, _332, _453 * _331)), _347)) + vec2(0.5), vec2(0.5), _275);
    float _491 = -(((float(textureLod(gInShadowMap, vec2(fma(_252, parameters.gCascadeSize.x, _356.x), _356.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_373, _254, min(_368 + dot(_258, _356 - _347), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_252, parameters.gCascadeSize.x, _396.x), _396.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_373, _254, min(_368 + dot(_258, _396 - _347), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_252, parameters.gCascadeSize.x, _432.x), _432.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_373, _254, min(_368 + dot(_258, _432 - _347), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_252, parameters.gCascadeSize.x, _468.x), _468.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_373, _254, min(_368 + dot(_258, _468 - _347), 1.0))));
    gOutShadow = vec4((_106 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_347 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_106 <= parameters.gCascadeFar.z)) ? fma(_491, 0.25, 1.0) : 1.0) : 1.0, _106, 0.0, 0.0);
}

