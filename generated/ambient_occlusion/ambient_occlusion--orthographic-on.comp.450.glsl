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
    float _122 = _99 - _83;
    vec3 _142 = normalize(vec3(vec2(mix(vec2(_108, _95), vec2(_83 - _87, _87), bvec2((_100.x ? abs(_87 - _83) : 131008.0) < (_102.x ? abs(_108) : 65504.0))).x, mix(vec2(_122, _99), vec2(_83 - _91, _91), bvec2((_100.y ? abs(_91 - _83) : 131008.0) < (_102.y ? abs(_122) : 65504.0))).x) / (parameters.gViewRay.xy * parameters.gOutputSize.zw), -1.0));
    vec2 _143 = floor(_65);
    vec2 _145 = floor(_143 * 0.5);
    vec2 _147 = _143 - (_145 * 2.0);
    vec2 _151 = _145 - (floor(_145 * 0.5) * 2.0);
    float _152 = _147.x;
    float _153 = _147.y;
    float _155 = abs(_152 - _153);
    float _156 = _151.y;
    float _161 = _151.x;
    vec2 _173 = vec2(fma(2.0, abs(_161 - _156), fma(8.0, _155, 4.0 * _153)) + _156, fma(2.0, abs(abs(_156 - _153) - _161), fma(4.0, _152, fma(-8.0, _155, 8.0))) + _161) * vec2(0.0625);
    float _175 = 6.283185482025146484375 * _173.x;
    float _176 = cos(_175);
    float _177 = sin(_175);
    float _184 = 1.0 / max(fma(parameters.gOcclusionBias.y, _83, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _185 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _188 = vec3(_69, _83);
    float _189 = _142.z;
    float _191 = (_189 >= 0.0) ? 1.0 : (-1.0);
    float _193 = (-1.0) / (_191 + _189);
    float _194 = _142.x;
    float _195 = _142.y;
    float _197 = (_194 * _195) * _193;
    vec3 _204 = vec3(fma((_191 * _194) * _194, _193, 1.0), _191 * _197, (-_191) * _194);
    vec3 _208 = vec3(_197, fma(_195 * _195, _193, _191), -_195);
    vec3 _214 = ((_204 * _176) + (_208 * _177)) * parameters.gRadius;
    vec3 _220 = vec3(_214.xy * _185, _214.z);
    vec3 _224 = ((_208 * _176) - (_204 * _177)) * parameters.gRadius;
    vec3 _230 = vec3(_224.xy * _185, _224.z);
    vec3 _231 = _142 * parameters.gRadius;
    vec3 _237 = vec3(_231.xy * _185, _231.z);
    float _249 = _173.y;
    vec3 _254 = _188 + ((((_220 * parameters.gTaps[0].x) + (_230 * parameters.gTaps[0].y)) + (_237 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _249)));
    float _255 = 1.0 / parameters.gRadius;
    vec2 _256 = _254.xy;
    float _257 = _254.z;
    vec4 _264 = textureLod(gInCoarseDepth, _256, 0.0);
    float _265 = _264.x;
    float _269 = _257 - ((_265 > 0.0) ? min(_265, 65504.0) : 65504.0);
    vec3 _294 = _188 + ((((_220 * parameters.gTaps[1].x) + (_230 * parameters.gTaps[1].y)) + (_237 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _249)));
    vec2 _295 = _294.xy;
    float _296 = _294.z;
    vec4 _303 = textureLod(gInCoarseDepth, _295, 0.0);
    float _304 = _303.x;
    float _308 = _296 - ((_304 > 0.0) ? min(_304, 65504.0) : 65504.0);
    vec3 _334 = _188 + ((((_220 * parameters.gTaps[2].x) + (_230 * parameters.gTaps[2].y)) + (_237 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _249)));
    vec2 _335 = _334.xy;
    float _336 = _334.z;
    vec4 _343 = textureLod(gInCoarseDepth, _335, 0.0);
    float _344 = _343.x;
    float _348 = _336 - ((_344 > 0.0) ? min(_344, 65504.0) : 65504.0);
    vec3 _374 = _188 + ((((_220 * parameters.gTaps[3].x) + (_230 * parameters.gTaps[3].y)) + (_237 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _249)));
    vec2 _375 = _374.xy;
    float _376 = _374.z;
    vec4 _383 = textureLod(gInCoarseDepth, _375, 0.0);
    float _384 = _383.x;
    float _388 = _376 - ((_384 > 0.0) ? min(_384, 65504.0) : 65504.0);
    vec2 _398 = ((mix(vec2(0.0), vec2(clamp(fma(_269, _184, -1.0), 0.0, 1.0) * clamp(fma(-_269, _255, 2.0), 0.0, 1.0), 1.0), bvec2((_257 > 0.0) && all(lessThanEqual(floatBitsToUint(_256), uvec2(1065353216u))))) + mix(vec2(0.0), vec2(clamp(fma(_308, _184, -1.0), 0.0, 1.0) * clamp(fma(-_308, _255, 2.0), 0.0, 1.0), 1.0), bvec2((_296 > 0.0) && all(lessThanEqual(floatBitsToUint(_295), uvec2(1065353216u)))))) + mix(vec2(0.0), vec2(clamp(fma(_348, _184, -1.0), 0.0, 1.0) * clamp(fma(-_348, _255, 2.0), 0.0, 1.0), 1.0), bvec2((_336 > 0.0) && all(lessThanEqual(floatBitsToUint(_335), uvec2(1065353216u)))))) + mix(vec2(0.0), vec2(clamp(fma(_388, _184, -1.0), 0.0, 1.0) * clamp(fma(-_388, _255, 2.0), 0.0, 1.0), 1.0), bvec2((_376 > 0.0) && all(lessThanEqual(floatBitsToUint(_375), uvec2(1065353216u)))));
    imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_83 < 65504.0) ? (1.0 - (_398.x / max(_398.y, 1.0))) : 1.0, _83, 0.0, 0.0));
}

