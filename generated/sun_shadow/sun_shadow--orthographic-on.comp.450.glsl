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
    vec2 _92 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _96 = _92 * parameters.gOutputSize.zw;
    vec2 _100 = parameters.gOutputSize.zw * 0.5;
    vec4 _103 = textureGather(gInCoarseDepth, fma(_92, parameters.gOutputSize.zw, -_100));
    vec4 _106 = textureGather(gInCoarseDepth, fma(_92, parameters.gOutputSize.zw, _100));
    float _107 = _103.y;
    float _110 = (_107 > 0.0) ? min(_107, 65504.0) : 65504.0;
    float _111 = _103.x;
    float _114 = (_111 > 0.0) ? min(_111, 65504.0) : 65504.0;
    float _115 = _103.z;
    float _118 = (_115 > 0.0) ? min(_115, 65504.0) : 65504.0;
    float _119 = _106.z;
    float _122 = (_119 > 0.0) ? min(_119, 65504.0) : 65504.0;
    float _123 = _106.x;
    float _126 = (_123 > 0.0) ? min(_123, 65504.0) : 65504.0;
    vec3 _129 = vec3(_96, _110);
    bvec2 _151 = greaterThan(_96, parameters.gOutputSize.zw);
    bvec2 _153 = lessThan(_96, vec2(1.0) - parameters.gOutputSize.zw);
    float _159 = _122 - _110;
    float _173 = _126 - _110;
    vec3 _185 = vec3(parameters.gOutputSize.z, 0.0, mix(vec2(_159, _122), vec2(_110 - _114, _114), bvec2((_151.x ? abs(_114 - _110) : 131008.0) < (_153.x ? abs(_159) : 65504.0))).x);
    vec3 _193 = vec3(0.0, parameters.gOutputSize.w, mix(vec2(_173, _126), vec2(_110 - _118, _118), bvec2((_151.y ? abs(_118 - _110) : 131008.0) < (_153.y ? abs(_173) : 65504.0))).x);
    vec3 _198 = cross(vec3(dot(parameters.gToShadowX.xyz, _185), dot(parameters.gToShadowY.xyz, _185), dot(parameters.gToShadowZ.xyz, _185)), vec3(dot(parameters.gToShadowX.xyz, _193), dot(parameters.gToShadowY.xyz, _193), dot(parameters.gToShadowZ.xyz, _193)));
    bool _223 = _110 > parameters.gCascadeFar.x;
    bvec3 _224 = bvec3(_223);
    bool _236 = _110 > parameters.gCascadeFar.y;
    bvec3 _237 = bvec3(_236);
    vec3 _238 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _224), parameters.gCascadeScale2.xyz, _237);
    float _241 = float(_223) + float(_236);
    vec3 _242 = fma(vec3(dot(parameters.gToShadowX.xyz, _129), dot(parameters.gToShadowY.xyz, _129), dot(parameters.gToShadowZ.xyz, _129)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _238, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _224), parameters.gCascadeOffset2.xyz, _237));
    float _243 = _238.z;
    vec2 _244 = _238.xy;
    vec2 _247 = clamp((-_198.xy) / vec2((abs(_198.z) > 9.9999996826552253889678874634872e-21) ? _198.z : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_243) / _244);
    vec2 _255 = max(parameters.gDisc.xy * _244, vec2(parameters.gDisc.z));
    vec2 _264 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _267 = floor(_92);
    vec2 _269 = floor(_267 * 0.5);
    vec2 _271 = _267 - (_269 * 2.0);
    vec2 _275 = _269 - (floor(_269 * 0.5) * 2.0);
    float _276 = _271.x;
    float _277 = _271.y;
    float _279 = abs(_276 - _277);
    float _280 = _275.y;
    float _285 = _275.x;
    vec2 _297 = vec2(fma(2.0, abs(_285 - _280), fma(8.0, _279, 4.0 * _277)) + _280, fma(2.0, abs(abs(_280 - _277) - _285), fma(4.0, _276, fma(-8.0, _279, 8.0))) + _285) * vec2(0.0625);
    float _302 = floor(parameters.gSubsetCount);
    float _305 = (_302 > 1.0) ? min(_302, 16.0) : 1.0;
    float _309 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _315 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_305, floor((_309 + 0.5) / _305), _309);
    float _319 = 6.283185482025146484375 * (_315.x + _297.x);
    float _320 = cos(_319);
    float _321 = sin(_319);
    float _324 = _315.y + _297.y;
    vec2 _325 = fract(vec2(0.5));
    float _327 = 6.283185482025146484375 * _325.x;
    float _328 = cos(_327);
    float _329 = sin(_327);
    vec2 _345 = clamp(floor(fma(_255 * sqrt(fract(_325.y + _324)), vec2(fma(_328, _320, -(_329 * _321)), fma(_328, _321, _329 * _320)), _242.xy)) + vec2(0.5), vec2(0.5), _264);
    float _362 = -fma(parameters.gShadowBias.y, _110, parameters.gShadowBias.x);
    vec2 _366 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _368 = 6.283185482025146484375 * _366.x;
    float _369 = cos(_368);
    float _370 = sin(_368);
    vec2 _385 = clamp(floor(fma(_255 * sqrt(fract(_366.y + _324)), vec2(fma(_369, _320, -(_370 * _321)), fma(_369, _321, _370 * _320)), _242.xy)) + vec2(0.5), vec2(0.5), _264);
    vec2 _402 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _404 = 6.283185482025146484375 * _402.x;
    float _405 = cos(_404);
    float _406 = sin(_404);
    vec2 _421 = clamp(floor(fma(_255 * sqrt(fract(_402.y + _324)), vec2(fma(_405, _320, -(_406 * _321)), fma(_405, _321, _406 * _320)), _242.xy)) + vec2(0.5), vec2(0.5), _264);
    vec2 _438 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _440 = 6.283185482025146484375 * _438.x;
    float _441 = cos(_440);
    float _442 = sin(_440);
    vec2 _457 = clamp(floor(fma(_255 * sqrt(fract(_438.y + _324)), vec2(fma(_441, _320, -(_442 * _321)), fma(_441, _321, _442 * _320)), _242.xy)) + vec2(0.5), vec2(0.5), _264);
    float _480 = -(((float(textureLod(gInShadowMap, vec2(fma(_241, parameters.gCascadeSize.x, _345.x), _345.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_362, _243, min(_242.z + dot(_247, _345 - _242.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_241, parameters.gCascadeSize.x, _385.x), _385.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_362, _243, min(_242.z + dot(_247, _385 - _242.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_241, parameters.gCascadeSize.x, _421.x), _421.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_362, _243, min(_242.z + dot(_247, _421 - _242.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_241, parameters.gCascadeSize.x, _457.x), _457.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_362, _243, min(_242.z + dot(_247, _457 - _242.xy), 1.0))));
    imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_110 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_242.xy / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_110 <= parameters.gCascadeFar.z)) ? fma(_480, 0.25, 1.0) : 1.0) : 1.0, _110, 0.0, 0.0));
}

