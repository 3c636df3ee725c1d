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
layout(binding = 2) uniform sampler2D gInNormal;

void main()
{
    vec2 _71 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _75 = _71 * parameters.gOutputSize.zw;
    vec4 _79 = textureLod(gInCoarseDepth, _75, 0.0);
    float _80 = _79.x;
    float _83 = (_80 > 0.0) ? min(_80, 65504.0) : 65504.0;
    vec3 _94 = textureLod(gInNormal, fma(_71, parameters.gOutputSize.zw, -(parameters.gOutputSize.zw * 0.125)) / parameters.gFrameToCoarse, 0.0).xyz;
    float _95 = dot(_94, _94);
    vec3 _102 = mix(vec3(0.0, 0.0, -1.0), _94 * inversesqrt(_95), bvec3((_95 > 9.9999999747524270787835121154785e-07) && (_95 < 1000000.0)));
    vec2 _103 = floor(_71);
    vec2 _105 = floor(_103 * 0.5);
    vec2 _107 = _103 - (_105 * 2.0);
    vec2 _111 = _105 - (floor(_105 * 0.5) * 2.0);
    float _112 = _107.x;
    float _113 = _107.y;
    float _115 = abs(_112 - _113);
    float _116 = _111.y;
    float _121 = _111.x;
    vec2 _133 = vec2(fma(2.0, abs(_121 - _116), fma(8.0, _115, 4.0 * _113)) + _116, fma(2.0, abs(abs(_116 - _113) - _121), fma(4.0, _112, fma(-8.0, _115, 8.0))) + _121) * vec2(0.0625);
    float _135 = 6.283185482025146484375 * _133.x;
    float _136 = cos(_135);
    float _137 = sin(_135);
    float _144 = 1.0 / max(fma(parameters.gOcclusionBias.y, _83, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _148 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _152 = vec3(_75 * _83, _83);
    float _153 = _102.z;
    float _155 = (_153 >= 0.0) ? 1.0 : (-1.0);
    float _157 = (-1.0) / (_155 + _153);
    float _158 = _102.x;
    float _159 = _102.y;
    float _161 = (_158 * _159) * _157;
    vec3 _168 = vec3(fma((_155 * _158) * _158, _157, 1.0), _155 * _161, (-_155) * _158);
    vec3 _172 = vec3(_161, fma(_159 * _159, _157, _155), -_159);
    vec3 _178 = ((_168 * _136) + (_172 * _137)) * parameters.gRadius;
    float _181 = _178.z;
    vec3 _187 = vec3((_178.xy - (parameters.gViewRay.zw * _181)) * _148, _181);
    vec3 _191 = ((_172 * _136) - (_168 * _137)) * parameters.gRadius;
    float _193 = _191.z;
    vec3 _199 = vec3((_191.xy - (parameters.gViewRay.zw * _193)) * _148, _193);
    vec3 _200 = _102 * parameters.gRadius;
    float _202 = _200.z;
    vec3 _208 = vec3((_200.xy - (parameters.gViewRay.zw * _202)) * _148, _202);
    float _220 = _133.y;
    vec3 _225 = _152 + ((((_187 * parameters.gTaps[0].x) + (_199 * parameters.gTaps[0].y)) + (_208 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _220)));
    float _226 = 1.0 / parameters.gRadius;
    float _228 = _225.z;
    vec2 _230 = _225.xy * (1.0 / _228);
    vec4 _237 = textureLod(gInCoarseDepth, _230, 0.0);
    float _238 = _237.x;
    float _242 = _228 - ((_238 > 0.0) ? min(_238, 65504.0) : 65504.0);
    vec3 _267 = _152 + ((((_187 * parameters.gTaps[1].x) + (_199 * parameters.gTaps[1].y)) + (_208 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _220)));
    float _269 = _267.z;
    vec2 _271 = _267.xy * (1.0 / _269);
    vec4 _278 = textureLod(gInCoarseDepth, _271, 0.0);
    float _279 = _278.x;
    float _283 = _269 - ((_279 > 0.0) ? min(_279, 65504.0) : 65504.0);
    vec3 _309 = _152 + ((((_187 * parameters.gTaps[2].x) + (_199 * parameters.gTaps[2].y)) + (_208 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _220)));
    float _311 = _309.z;
    vec2 _313 = _309.xy * (1.0 / _311);
    vec4 _320 = textureLod(gInCoarseDepth, _313, 0.0);
    float _321 = _320.x;
    float _325 = _311 - ((_321 > 0.0) ? min(_321, 65504.0) : 65504.0);
    vec3 _351 = _152 + ((((_187 * parameters.gTaps[3].x) + (_199 * parameters.gTaps[3].y)) + (_208 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _220)));
    float _353 = _351.z;
    vec2 _355 = _351.xy * (1.0 / _353);
    vec4 _362 = textureLod(gInCoarseDepth, _355, 0.0);
    float _363 = _362.x;
    float _367 = _353 - ((_363 > 0.0) ? min(_363, 65504.0) : 65504.0);
    vec2 _377 = ((mix(vec2(0.0), vec2(clamp(fma(_242, _144, -1.0), 0.0, 1.0) * clamp(fma(-_242, _226, 2.0), 0.0, 1.0), 1.0), bvec2((_228 > 0.0) && all(lessThanEqual(floatBitsToUint(_230), uvec2(1065353216u))))) + mix(vec2(0.0), vec2(clamp(fma(_283, _144, -1.0), 0.0, 1.0) * clamp(fma(-_283, _226, 2.0), 0.0, 1.0), 1.0), bvec2((_269 > 0.0) && all(lessThanEqual(floatBitsToUint(_271), uvec2(1065353216u)))))) + mix(vec2(0.0), vec2(clamp(fma(_325, _144, -1.0), 0.0, 1.0) * clamp(fma(-_325, _226, 2.0), 0.0, 1.0), 1.0), bvec2((_311 > 0.0) && all(lessThanEqual(floatBitsToUint(_313), uvec2(1065353216u)))))) + mix(vec2(0.0), vec2(clamp(fma(_367, _144, -1.0), 0.0, 1.0) * clamp(fma(-_367, _226, 2.0), 0.0, 1.0), 1.0), bvec2((_353 > 0.0) && all(lessThanEqual(floatBitsToUint(_355), uvec2(1065353216u)))));
    imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_83 < 65504.0) ? (1.0 - (_377.x / max(_377.y, 1.0))) : 1.0, _83, 0.0, 0.0));
}

