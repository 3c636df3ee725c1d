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
    bool _263 = _108 > parameters.gCascadeFar.z;
    bvec3 _264 = bvec3(_263);
    vec3 _265 = mix(mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _237), parameters.gCascadeScale2.xyz, _250), parameters.gCascadeScale3.xyz, _264);
    float _268 = (float(_236) + float(_249)) + float(_263);
    vec3 _269 = fma(vec3(dot(parameters.gToShadowX.xyz, _128), dot(parameters.gToShadowY.xyz, _128), dot(parameters.gToShadowZ.xyz, _128)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _265, mix(mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _237), parameters.gCascadeOffset2.xyz, _250), parameters.gCascadeOffset3.xyz, _264));
    float _270 = _265.z;
    vec2 _271 = _265.xy;
    vec2 _274 = clamp((-_211.xy) / vec2((abs(_212) > 9.9999996826552253889678874634872e-21) ? _212 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_270) / _271);
    vec2 _282 = max(parameters.gDisc.xy * _271, vec2(parameters.gDisc.z));
    vec2 _291 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _294 = floor(gl_FragCoord.xy);
    vec2 _296 = floor(_294 * 0.5);
    vec2 _298 = _294 - (_296 * 2.0);
    vec2 _302 = _296 - (floor(_296 * 0.5) * 2.0);
    float _303 = _298.x;
    float _304 = _298.y;
    float _306 = abs(_303 - _304);
    float _307 = _302.y;
    float _312 = _302.x;
    vec2 _324 = vec2(fma(2.0, abs(_312 - _307), fma(8.0, _306, 4.0 * _304)) + _307, fma(2.0, abs(abs(_307 - _304) - _312), fma(4.0, _303, fma(-8.0, _306, 8.0))) + _312) * vec2(0.0625);
    float _329 = floor(parameters.gSubsetCount);
    float _332 = (_329 > 1.0) ? min(_329, 16.0) : 1.0;
    float _336 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _342 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_332, floor((_336 + 0.5) / _332), _336);
    float _346 = 6.283185482025146484375 * (_342.x + _324.x);
    float _347 = cos(_346);
    float _348 = sin(_346);
    float _351 = _342.y + _324.y;
    vec2 _352 = fract(vec2(0.5));
    float _354 = 6.283185482025146484375 * _352.x;
    float _355 = cos(_354);
    float _356 = sin(_354);
    vec2 _372 = clamp(floor(fma(_282 * sqrt(fract(_352.y + _351)), vec2(fma(_355, _347, -(_356 * _348)), fma(_355, _348, _356 * _347)), _269.xy)) + vec2(0.5), vec2(0.5), _291);
    float _389 = -fma(parameters.gShadowBias.y, _108, parameters.gShadowBias.x);
    vec2 _393 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _395 = 6.283185482025146484375 * _393.x;
    float _396 = cos(_395);
    float _397 = sin(_395);
    vec2 _412 = clamp(floor(fma(_282 * sqrt(fract(_393.y + _351)), vec2(fma(_396, _347, -(_397 * _348)), fma(_396, _348, _397 * _347)), _269.xy)) + vec2(0.5), vec2(0.5), _291);
    vec2 _429 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _431 = 6.283185482025146484375 * _429.x;
    float _432 = cos(_431);
    float _433 = sin(_431);
    vec2 _448 = clamp(floor(fma(_282 * sqrt(fract(_429.y + _351)), vec2(fma(_432, _347, -(_433 * _348)), fma(_432, _348, _433 * _347)), _269.xy)) + vec2(0.5), vec2(0.5), _291);
    vec2 _465 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _467 = 6.283185482025146484375 * _465.x;
    float _468 = cos(_467);
    float _469 = sin(_467);
    vec2 _484 = clamp(floor(fma(_282 * sqrt(fract(_465.y + _351)), vec2(fma(_468, _347, -(_469 * _348)), fma(_468, _348, _469 * _347)), _269.xy)) + vec2(0.5), vec2(0.5), _291);
    float _507 = -(((float(textureLod(gInShadowMap, vec2(fma(_268, parameters.gCascadeSize.x, _372.x), _372.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_389, _270, min(_269.z + dot(_274, _372 - _269.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_268, parameters.gCascadeSize.x, _412.x), _412.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_389, _270, min(_269.z + dot(_274, _412 - _269.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_268, parameters.gCascadeSize.x, _448.x), _448.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_389, _270, min(_269.z + dot(_274, _448 - _269.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_268, parameters.gCascadeSize.x, _484.x), _484.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_389, _270, min(_269.z + dot(_274, _484 - _269.xy), 1.0))));
    gOutShadow = vec4((_108 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_269.xy / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_108 <= parameters.gCascadeFar.w)) ? fma(_507, 0.25, 1.0) : 1.0) : 1.0, _108, 0.0, 0.0);
}

