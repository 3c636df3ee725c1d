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
    vec2 _63 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _67 = _63 * parameters.gOutputSize.zw;
    vec2 _71 = parameters.gOutputSize.zw * 0.5;
    vec4 _74 = textureGather(gInCoarseDepth, fma(_63, parameters.gOutputSize.zw, -_71));
    vec4 _77 = textureGather(gInCoarseDepth, fma(_63, parameters.gOutputSize.zw, _71));
    float _78 = _74.y;
    float _81 = (_78 > 0.0) ? min(_78, 65504.0) : 65504.0;
    float _82 = _74.x;
    float _85 = (_82 > 0.0) ? min(_82, 65504.0) : 65504.0;
    float _86 = _74.z;
    float _89 = (_86 > 0.0) ? min(_86, 65504.0) : 65504.0;
    float _90 = _77.z;
    float _93 = (_90 > 0.0) ? min(_90, 65504.0) : 65504.0;
    float _94 = _77.x;
    float _97 = (_94 > 0.0) ? min(_94, 65504.0) : 65504.0;
    bvec2 _98 = greaterThan(_67, parameters.gOutputSize.zw);
    bvec2 _100 = lessThan(_67, vec2(1.0) - parameters.gOutputSize.zw);
    float _106 = _93 - _81;
    vec2 _114 = mix(vec2(_106, _93), vec2(_81 - _85, _85), bvec2((_98.x ? abs(_85 - _81) : 131008.0) < (_100.x ? abs(_106) : 65504.0)));
    float _120 = _97 - _81;
    vec2 _128 = mix(vec2(_120, _97), vec2(_81 - _89, _89), bvec2((_98.y ? abs(_89 - _81) : 131008.0) < (_100.y ? abs(_120) : 65504.0)));
    vec2 _140 = vec2(_114.x, _128.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_114.y, _128.y));
    vec3 _148 = normalize(vec3(_140, (-1.0) - dot(fma(_67, parameters.gViewRay.xy, parameters.gViewRay.zw), _140)));
    vec2 _149 = floor(_63);
    vec2 _151 = floor(_149 * 0.5);
    vec2 _153 = _149 - (_151 * 2.0);
    vec2 _157 = _151 - (floor(_151 * 0.5) * 2.0);
    float _158 = _153.x;
    float _159 = _153.y;
    float _161 = abs(_158 - _159);
    float _162 = _157.y;
    float _167 = _157.x;
    vec2 _179 = vec2(fma(2.0, abs(_167 - _162), fma(8.0, _161, 4.0 * _159)) + _162, fma(2.0, abs(abs(_162 - _159) - _167), fma(4.0, _158, fma(-8.0, _161, 8.0))) + _167) * vec2(0.0625);
    float _181 = 6.283185482025146484375 * _179.x;
    float _182 = cos(_181);
    float _183 = sin(_181);
    float _190 = 1.0 / max(fma(parameters.gOcclusionBias.y, _81, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _191 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _195 = vec3(_67 * _81, _81);
    float _196 = _148.z;
    float _198 = (_196 >= 0.0) ? 1.0 : (-1.0);
    float _200 = (-1.0) / (_198 + _196);
    float _201 = _148.x;
    float _202 = _148.y;
    float _204 = (_201 * _202) * _200;
    vec3 _211 = vec3(fma((_198 * _201) * _201, _200, 1.0), _198 * _204, (-_198) * _201);
    vec3 _215 = vec3(_204, fma(_202 * _202, _200, _198), -_202);
    vec3 _221 = ((_211 * _182) + (_215 * _183)) * parameters.gRadius;
    float _223 = _221.z;
    vec3 _229 = vec3((_221.xy - (parameters.gViewRay.zw * _223)) * _191, _223);
    vec3 _233 = ((_215 * _182) - (_211 * _183)) * parameters.gRadius;
    float _235 = _233.z;
    vec3 _241 = vec3((_233.xy - (parameters.gViewRay.zw * _235)) * _191, _235);
    vec3 _242 = _148 * parameters.gRadius;
    float _244 = _242.z;
    vec3 _250 = vec3((_242.xy - (parameters.gViewRay.zw * _244)) * _191, _244);
    float _262 = _179.y;
    vec3 _267 = _195 + ((((_229 * parameters.gTaps[0].x) + (_241 * parameters.gTaps[0].y)) + (_250 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _262)));
    float _268 = 1.0 / parameters.gRadius;
    float _270 = _267.z;
    vec2 _272 = _267.xy * (1.0 / _270);
    vec4 _280 = textureLod(gInCoarseDepth, _272, 0.0);
    float _281 = _280.x;
    float _285 = _270 - ((_281 > 0.0) ? min(_281, 65504.0) : 65504.0);
    vec3 _310 = _195 + ((((_229 * parameters.gTaps[1].x) + (_241 * parameters.gTaps[1].y)) + (_250 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _262)));
    float _312 = _310.z;
    vec2 _314 = _310.xy * (1.0 / _312);
    vec4 _322 = textureLod(gInCoarseDepth, _314, 0.0);
    float _323 = _322.x;
    float _327 = _312 - ((_323 > 0.0) ? min(_323, 65504.0) : 65504.0);
    vec3 _353 = _195 + ((((_229 * parameters.gTaps[2].x) + (_241 * parameters.gTaps[2].y)) + (_250 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _262)));
    float _355 = _353.z;
    vec2 _357 = _353.xy * (1.0 / _355);
    vec4 _365 = textureLod(gInCoarseDepth, _357, 0.0);
    float _366 = _365.x;
    float _370 = _355 - ((_366 > 0.0) ? min(_366, 65504.0) : 65504.0);
    vec3 _396 = _195 + ((((_229 * parameters.gTaps[3].x) + (_241 * parameters.gTaps[3].y)) + (_250 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _262)));
    float _398 = _396.z;
    vec2 _400 = _396.xy * (1.0 / _398);
    vec4 _408 = textureLod(gInCoarseDepth, _400, 0.0);
    float _409 = _408.x;
    float _413 = _398 - ((_409 > 0.0) ? min(_409, 65504.0) : 65504.0);
    vec2 _423 = ((mix(vec2(0.0), vec2(clamp(fma(_285, _190, -1.0), 0.0, 1.0) * clamp(fma(-_285, _268, 2.0), 0.0, 1.0), 1.0), bvec2((_270 > 0.0) && all(lessThanEqual(abs(_272 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_327, _190, -1.0), 0.0, 1.0) * clamp(fma(-_327, _268, 2.0), 0.0, 1.0), 1.0), bvec2((_312 > 0.0) && all(lessThanEqual(abs(_314 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_370, _190, -1.0), 0.0, 1.0) * clamp(fma(-_370, _268, 2.0), 0.0, 1.0), 1.0), bvec2((_355 > 0.0) && all(lessThanEqual(abs(_357 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_413, _190, -1.0), 0.0, 1.0) * clamp(fma(-_413, _268, 2.0), 0.0, 1.0), 1.0), bvec2((_398 > 0.0) && all(lessThanEqual(abs(_400 - vec2(0.5)), vec2(0.5)))));
    imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_81 < 65504.0) ? (1.0 - (_423.x / max(_423.y, 1.0))) : 1.0, _81, 0.0, 0.0));
}

