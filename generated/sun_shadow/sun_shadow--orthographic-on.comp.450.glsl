#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

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

layout(binding = 16) uniform writeonly image2D gOutShadow;
layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInShadowMap;

void main()
{
    vec2 _90 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _94 = _90 * parameters.gOutputSize.zw;
    vec2 _98 = parameters.gOutputSize.zw * 0.5;
    vec4 _101 = textureGather(gInCoarseDepth, fma(_90, parameters.gOutputSize.zw, -_98));
    vec4 _104 = textureGather(gInCoarseDepth, fma(_90, parameters.gOutputSize.zw, _98));
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
    vec3 _127 = vec3(_94, _108);
    bvec2 _149 = greaterThan(_94, parameters.gOutputSize.zw);
    bvec2 _151 = lessThan(_94, vec2(1.0) - parameters.gOutputSize.zw);
    float _157 = _120 - _108;
    float _171 = _124 - _108;
    vec3 _183 = vec3(parameters.gOutputSize.z, 0.0, mix(vec2(_157, _120), vec2(_108 - _112, _112), bvec2((_149.x ? abs(_112 - _108) : 131008.0) < (_151.x ? abs(_157) : 65504.0))).x);
    vec3 _191 = vec3(0.0, parameters.gOutputSize.w, mix(vec2(_171, _124), vec2(_108 - _116, _116), bvec2((_149.y ? abs(_116 - _108) : 131008.0) < (_151.y ? abs(_171) : 65504.0))).x);
    vec3 _196 = cross(vec3(dot(parameters.gToShadowX.xyz, _183), dot(parameters.gToShadowY.xyz, _183), dot(parameters.gToShadowZ.xyz, _183)), vec3(dot(parameters.gToShadowX.xyz, _191), dot(parameters.gToShadowY.xyz, _191), dot(parameters.gToShadowZ.xyz, _191)));
    bool _221 = _108 > parameters.gCascadeFar.x;
    bvec3 _222 = bvec3(_221);
    bool _234 = _108 > parameters.gCascadeFar.y;
    bvec3 _235 = bvec3(_234);
    vec3 _236 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _222), parameters.gCascadeScale2.xyz, _235);
    float _239 = float(_221) + float(_234);
    vec3 _240 = fma(vec3(dot(parameters.gToShadowX.xyz, _127), dot(parameters.gToShadowY.xyz, _127), dot(parameters.gToShadowZ.xyz, _127)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _236, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _222), parameters.gCascadeOffset2.xyz, _235));
    float _241 = _236.z;
    vec2 _242 = _236.xy;
    vec2 _245 = clamp((-_196.xy) / vec2((abs(_196.z) > 9.9999996826552253889678874634872e-21) ? _196.z : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_241) / _242);
    vec2 _253 = max(parameters.gDisc.xy * _242, vec2(parameters.gDisc.z));
    vec2 _262 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _265 = floor(_90);
    vec2 _267 = floor(_265 * 0.5);
    vec2 _269 = _265 - (_267 * 2.0);
    vec2 _273 = _267 - (floor(_267 * 0.5) * 2.0);
    float _274 = _269.x;
    float _275 = _269.y;
    float _277 = abs(_274 - _275);
    float _278 = _273.y;
    float _283 = _273.x;
    vec2 _295 = vec2(fma(2.0, abs(_283 - _278), fma(8.0, _277, 4.0 * _275)) + _278, fma(2.0, abs(abs(_278 - _275) - _283), fma(4.0, _274, fma(-8.0, _277, 8.0))) + _283) * vec2(0.0625);
    float _300 = floor(parameters.gSubsetCount);
    float _303 = (_300 > 1.0) ? min(_300, 16.0) : 1.0;
    float _307 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _313 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_303, floor((_307 + 0.5) / _303), _307);
    float _317 = 6.283185482025146484375 * (_313.x + _295.x);
    float _318 = cos(_317);
    float _319 = sin(_317);
    float _322 = _313.y + _295.y;
    vec2 _323 = fract(vec2(0.5));
    float _325 = 6.283185482025146484375 * _323.x;
    float _326 = cos(_325);
    float _327 = sin(_325);
    vec2 _343 = clamp(floor(fma(_253 * sqrt(fract(_323.y + _322)), vec2(fma(_326, _318, -(_327 * _319)), fma(_326, _319, _327 * _318)), _240.xy)) + vec2(0.5), vec2(0.5), _262);
    float _360 = -fma(parameters.gShadowBias.y, _108, parameters.gShadowBias.x);
    vec2 _364 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _366 = 6.283185482025146484375 * _364.x;
    float _367 = cos(_366);
    float _368 = sin(_366);
    vec2 _383 = clamp(floor(fma(_253 * sqrt(fract(_364.y + _322)), vec2(fma(_367, _318, -(_368 * _319)), fma(_367, _319, _368 * _318)), _240.xy)) + vec2(0.5), vec2(0.5), _262);
    vec2 _400 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _402 = 6.283185482025146484375 * _400.x;
    float _403 = cos(_402);
    float _404 = sin(_402);
    vec2 _419 = clamp(floor(fma(_253 * sqrt(fract(_400.y + _322)), vec2(fma(_403, _318, -(_404 * _319)), fma(_403, _319, _404 * _318)), _240.xy)) + vec2(0.5), vec2(0.5), _262);
    vec2 _436 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _438 = 6.283185482025146484375 * _436.x;
    float _439 = cos(_438);
    float _440 = sin(_438);
    vec2 _455 = clamp(floor(fma(_253 * sqrt(fract(_436.y + _322)), vec2(fma(_439, _318, -(_440 * _319)), fma(_439, _319, _440 * _318)), _240.xy)) + vec2(0.5), vec2(0.5), _262);
    float _479 = -(((float(textureLod(gInShadowMap, vec2(fma(_239, parameters.gCascadeSize.x, _343.x), _343.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_360, _241, min(_240.z + dot(_245, _343 - _240.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_239, parameters.gCascadeSize.x, _383.x), _383.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_360, _241, min(_240.z + dot(_245, _383 - _240.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_239, parameters.gCascadeSize.x, _419.x), _419.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_360, _241, min(_240.z + dot(_245, _419 - _240.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_239, parameters.gCascadeSize.x, _455.x), _455.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_360, _241, min(_240.z + dot(_245, _455 - _240.xy), 1.0))));
    imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_108 < 65504.0) ? ((all(lessThanEqual(abs((_240.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_108 <= parameters.gCascadeFar.z)) ? fma(_479, 0.25, 1.0) : 1.0) : 1.0, _108, 0.0, 0.0));
}

