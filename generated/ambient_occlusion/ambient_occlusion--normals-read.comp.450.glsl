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
    vec2 _69 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _73 = _69 * parameters.gOutputSize.zw;
    vec4 _77 = textureLod(gInCoarseDepth, _73, 0.0);
    float _78 = _77.x;
    float _81 = (_78 > 0.0) ? min(_78, 65504.0) : 65504.0;
    vec3 _92 = textureLod(gInNormal, fma(_69, parameters.gOutputSize.zw, -(parameters.gOutputSize.zw * 0.125)) / parameters.gFrameToCoarse, 0.0).xyz;
    float _93 = dot(_92, _92);
    vec3 _100 = mix(vec3(0.0, 0.0, -1.0), _92 * inversesqrt(_93), bvec3((_93 > 9.9999999747524270787835121154785e-07) && (_93 < 1000000.0)));
    vec2 _101 = floor(_69);
    vec2 _103 = floor(_101 * 0.5);
    vec2 _105 = _101 - (_103 * 2.0);
    vec2 _109 = _103 - (floor(_103 * 0.5) * 2.0);
    float _110 = _105.x;
    float _111 = _105.y;
    float _113 = abs(_110 - _111);
    float _114 = _109.y;
    float _119 = _109.x;
    vec2 _131 = vec2(fma(2.0, abs(_119 - _114), fma(8.0, _113, 4.0 * _111)) + _114, fma(2.0, abs(abs(_114 - _111) - _119), fma(4.0, _110, fma(-8.0, _113, 8.0))) + _119) * vec2(0.0625);
    float _133 = 6.283185482025146484375 * _131.x;
    float _134 = cos(_133);
    float _135 = sin(_133);
    float _142 = 1.0 / max(fma(parameters.gOcclusionBias.y, _81, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _146 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _150 = vec3(_73 * _81, _81);
    float _151 = _100.z;
    float _153 = (_151 >= 0.0) ? 1.0 : (-1.0);
    float _155 = (-1.0) / (_153 + _151);
    float _156 = _100.x;
    float _157 = _100.y;
    float _159 = (_156 * _157) * _155;
    vec3 _166 = vec3(fma((_153 * _156) * _156, _155, 1.0), _153 * _159, (-_153) * _156);
    vec3 _170 = vec3(_159, fma(_157 * _157, _155, _153), -_157);
    vec3 _176 = ((_166 * _134) + (_170 * _135)) * parameters.gRadius;
    float _179 = _176.z;
    vec3 _185 = vec3((_176.xy - (parameters.gViewRay.zw * _179)) * _146, _179);
    vec3 _189 = ((_170 * _134) - (_166 * _135)) * parameters.gRadius;
    float _191 = _189.z;
    vec3 _197 = vec3((_189.xy - (parameters.gViewRay.zw * _191)) * _146, _191);
    vec3 _198 = _100 * parameters.gRadius;
    float _200 = _198.z;
    vec3 _206 = vec3((_198.xy - (parameters.gViewRay.zw * _200)) * _146, _200);
    float _218 = _131.y;
    vec3 _223 = _150 + ((((_185 * parameters.gTaps[0].x) + (_197 * parameters.gTaps[0].y)) + (_206 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _218)));
    float _224 = 1.0 / parameters.gRadius;
    float _226 = _223.z;
    vec2 _228 = _223.xy * (1.0 / _226);
    vec4 _236 = textureLod(gInCoarseDepth, _228, 0.0);
    float _237 = _236.x;
    float _241 = _226 - ((_237 > 0.0) ? min(_237, 65504.0) : 65504.0);
    vec3 _266 = _150 + ((((_185 * parameters.gTaps[1].x) + (_197 * parameters.gTaps[1].y)) + (_206 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _218)));
    float _268 = _266.z;
    vec2 _270 = _266.xy * (1.0 / _268);
    vec4 _278 = textureLod(gInCoarseDepth, _270, 0.0);
    float _279 = _278.x;
    float _283 = _268 - ((_279 > 0.0) ? min(_279, 65504.0) : 65504.0);
    vec3 _309 = _150 + ((((_185 * parameters.gTaps[2].x) + (_197 * parameters.gTaps[2].y)) + (_206 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _218)));
    float _311 = _309.z;
    vec2 _313 = _309.xy * (1.0 / _311);
    vec4 _321 = textureLod(gInCoarseDepth, _313, 0.0);
    float _322 = _321.x;
    float _326 = _311 - ((_322 > 0.0) ? min(_322, 65504.0) : 65504.0);
    vec3 _352 = _150 + ((((_185 * parameters.gTaps[3].x) + (_197 * parameters.gTaps[3].y)) + (_206 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _218)));
    float _354 = _352.z;
    vec2 _356 = _352.xy * (1.0 / _354);
    vec4 _364 = textureLod(gInCoarseDepth, _356, 0.0);
    float _365 = _364.x;
    float _369 = _354 - ((_365 > 0.0) ? min(_365, 65504.0) : 65504.0);
    vec2 _379 = ((mix(vec2(0.0), vec2(clamp(fma(_241, _142, -1.0), 0.0, 1.0) * clamp(fma(-_241, _224, 2.0), 0.0, 1.0), 1.0), bvec2((_226 > 0.0) && all(lessThanEqual(abs(_228 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_283, _142, -1.0), 0.0, 1.0) * clamp(fma(-_283, _224, 2.0), 0.0, 1.0), 1.0), bvec2((_268 > 0.0) && all(lessThanEqual(abs(_270 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_326, _142, -1.0), 0.0, 1.0) * clamp(fma(-_326, _224, 2.0), 0.0, 1.0), 1.0), bvec2((_311 > 0.0) && all(lessThanEqual(abs(_313 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_369, _142, -1.0), 0.0, 1.0) * clamp(fma(-_369, _224, 2.0), 0.0, 1.0), 1.0), bvec2((_354 > 0.0) && all(lessThanEqual(abs(_356 - vec2(0.5)), vec2(0.5)))));
    imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_81 < 65504.0) ? (1.0 - (_379.x / max(_379.y, 1.0))) : 1.0, _81, 0.0, 0.0));
}

