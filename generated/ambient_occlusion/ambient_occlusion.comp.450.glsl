#version 450
layout(local_size_x = 32, local_size_y = 32, local_size_z = 1) in;

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gOcclusionBias;
    vec2 gFrameToCoarse;
    float gRadius;
    vec4 gTaps[32];
} parameters;

layout(binding = 16) uniform writeonly image2D gOutOcclusion;
layout(binding = 1) uniform sampler2D gInCoarseDepth;

void main()
{
    vec2 _65 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _69 = _65 * parameters.gOutputSize.zw;
    vec2 _73 = parameters.gOutputSize.zw * 0.5;
    vec4 _76 = textureGather(gInCoarseDepth, fma(_65, parameters.gOutputSize.zw, -_73));
    vec4 _79 = textureGather(gInCoarseDepth, fma(_65, parameters.gOutputSize.zw, _73));
    float _80 = _76.y;
    float _83 = (_80 > 0.0) ? min(_80, 65504.0) : 65504.0;
    float _84 = _76.x;
    float _87 = (_84 > 0.0) ? min(_84, 65504.0) : 65504.0;
    float _88 = _76.z;
    float _91 = (_88 > 0.0) ? min(_88, 65504.0) : 65504.0;
    float _92 = _79.z;
    float _95 = (_92 > 0.0) ? min(_92, 65504.0) : 65504.0;
    float _96 = _79.x;
    float _99 = (_96 > 0.0) ? min(_96, 65504.0) : 65504.0;
    bvec2 _100 = greaterThan(_69, parameters.gOutputSize.zw);
    bvec2 _102 = lessThan(_69, vec2(1.0) - parameters.gOutputSize.zw);
    float _108 = _95 - _83;
    vec2 _116 = mix(vec2(_108, _95), vec2(_83 - _87, _87), bvec2((_100.x ? abs(_87 - _83) : 131008.0) < (_102.x ? abs(_108) : 65504.0)));
    float _122 = _99 - _83;
    vec2 _130 = mix(vec2(_122, _99), vec2(_83 - _91, _91), bvec2((_100.y ? abs(_91 - _83) : 131008.0) < (_102.y ? abs(_122) : 65504.0)));
    vec2 _142 = vec2(_116.x, _130.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_116.y, _130.y));
    vec3 _150 = normalize(vec3(_142, (-1.0) - dot(fma(_69, parameters.gViewRay.xy, parameters.gViewRay.zw), _142)));
    vec2 _151 = floor(_65);
    vec2 _153 = floor(_151 * 0.5);
    vec2 _155 = _151 - (_153 * 2.0);
    vec2 _159 = _153 - (floor(_153 * 0.5) * 2.0);
    float _160 = _155.x;
    float _161 = _155.y;
    float _163 = abs(_160 - _161);
    float _164 = _159.y;
    float _169 = _159.x;
    vec2 _181 = vec2(fma(2.0, abs(_169 - _164), fma(8.0, _163, 4.0 * _161)) + _164, fma(2.0, abs(abs(_164 - _161) - _169), fma(4.0, _160, fma(-8.0, _163, 8.0))) + _169) * vec2(0.0625);
    float _183 = 6.283185482025146484375 * _181.x;
    float _184 = cos(_183);
    float _185 = sin(_183);
    float _192 = 1.0 / max(fma(parameters.gOcclusionBias.y, _83, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _193 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _197 = vec3(_69 * _83, _83);
    float _198 = _150.z;
    float _200 = (_198 >= 0.0) ? 1.0 : (-1.0);
    float _202 = (-1.0) / (_200 + _198);
    float _203 = _150.x;
    float _204 = _150.y;
    float _206 = (_203 * _204) * _202;
    vec3 _213 = vec3(fma((_200 * _203) * _203, _202, 1.0), _200 * _206, (-_200) * _203);
    vec3 _217 = vec3(_206, fma(_204 * _204, _202, _200), -_204);
    vec3 _223 = ((_213 * _184) + (_217 * _185)) * parameters.gRadius;
    float _225 = _223.z;
    vec3 _231 = vec3((_223.xy - (parameters.gViewRay.zw * _225)) * _193, _225);
    vec3 _235 = ((_217 * _184) - (_213 * _185)) * parameters.gRadius;
    float _237 = _235.z;
    vec3 _243 = vec3((_235.xy - (parameters.gViewRay.zw * _237)) * _193, _237);
    vec3 _244 = _150 * parameters.gRadius;
    float _246 = _244.z;
    vec3 _252 = vec3((_244.xy - (parameters.gViewRay.zw * _246)) * _193, _246);
    float _264 = _181.y;
    vec3 _269 = _197 + ((((_231 * parameters.gTaps[0].x) + (_243 * parameters.gTaps[0].y)) + (_252 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _264)));
    float _270 = 1.0 / parameters.gRadius;
    float _272 = _269.z;
    vec2 _274 = _269.xy * (1.0 / _272);
    vec4 _281 = textureLod(gInCoarseDepth, _274, 0.0);
    float _282 = _281.x;
    float _286 = _272 - ((_282 > 0.0) ? min(_282, 65504.0) : 65504.0);
    vec3 _311 = _197 + ((((_231 * parameters.gTaps[1].x) + (_243 * parameters.gTaps[1].y)) + (_252 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _264)));
    float _313 = _311.z;
    vec2 _315 = _311.xy * (1.0 / _313);
    vec4 _322 = textureLod(gInCoarseDepth, _315, 0.0);
    float _323 = _322.x;
    float _327 = _313 - ((_323 > 0.0) ? min(_323, 65504.0) : 65504.0);
    vec3 _353 = _197 + ((((_231 * parameters.gTaps[2].x) + (_243 * parameters.gTaps[2].y)) + (_252 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _264)));
    float _355 = _353.z;
    vec2 _357 = _353.xy * (1.0 / _355);
    vec4 _364 = textureLod(gInCoarseDepth, _357, 0.0);
    float _365 = _364.x;
    float _369 = _355 - ((_365 > 0.0) ? min(_365, 65504.0) : 65504.0);
    vec3 _395 = _197 + ((((_231 * parameters.gTaps[3].x) + (_243 * parameters.gTaps[3].y)) + (_252 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _264)));
    float _397 = _395.z;
    vec2 _399 = _395.xy * (1.0 / _397);
    vec4 _406 = textureLod(gInCoarseDepth, _399, 0.0);
    float _407 = _406.x;
    float _411 = _397 - ((_407 > 0.0) ? min(_407, 65504.0) : 65504.0);
    vec2 _421 = ((mix(vec2(0.0), vec2(clamp(fma(_286, _192, -1.0), 0.0, 1.0) * clamp(fma(-_286, _270, 2.0), 0.0, 1.0), 1.0), bvec2((_272 > 0.0) && all(lessThanEqual(floatBitsToUint(_274), uvec2(1065353216u))))) + mix(vec2(0.0), vec2(clamp(fma(_327, _192, -1.0), 0.0, 1.0) * clamp(fma(-_327, _270, 2.0), 0.0, 1.0), 1.0), bvec2((_313 > 0.0) && all(lessThanEqual(floatBitsToUint(_315), uvec2(1065353216u)))))) + mix(vec2(0.0), vec2(clamp(fma(_369, _192, -1.0), 0.0, 1.0) * clamp(fma(-_369, _270, 2.0), 0.0, 1.0), 1.0), bvec2((_355 > 0.0) && all(lessThanEqual(floatBitsToUint(_357), uvec2(1065353216u)))))) + mix(vec2(0.0), vec2(clamp(fma(_411, _192, -1.0), 0.0, 1.0) * clamp(fma(-_411, _270, 2.0), 0.0, 1.0), 1.0), bvec2((_397 > 0.0) && all(lessThanEqual(floatBitsToUint(_399), uvec2(1065353216u)))));
    imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_83 < 65504.0) ? (1.0 - (_421.x / max(_421.y, 1.0))) : 1.0, _83, 0.0, 0.0));
}

