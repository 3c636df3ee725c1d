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
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _73 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _75 = _73 * parameters.gOutputSize.zw;
        vec2 _79 = parameters.gOutputSize.zw * 0.5;
        vec4 _82 = textureGather(gInCoarseDepth, fma(_73, parameters.gOutputSize.zw, -_79));
        vec4 _85 = textureGather(gInCoarseDepth, fma(_73, parameters.gOutputSize.zw, _79));
        float _86 = _82.y;
        float _89 = (_86 > 0.0) ? min(_86, 65504.0) : 65504.0;
        float _90 = _82.x;
        float _93 = (_90 > 0.0) ? min(_90, 65504.0) : 65504.0;
        float _94 = _82.z;
        float _97 = (_94 > 0.0) ? min(_94, 65504.0) : 65504.0;
        float _98 = _85.z;
        float _101 = (_98 > 0.0) ? min(_98, 65504.0) : 65504.0;
        float _102 = _85.x;
        float _105 = (_102 > 0.0) ? min(_102, 65504.0) : 65504.0;
        bvec2 _106 = greaterThan(_75, parameters.gOutputSize.zw);
        bvec2 _108 = lessThan(_75, vec2(1.0) - parameters.gOutputSize.zw);
        float _114 = _101 - _89;
        float _128 = _105 - _89;
        vec3 _148 = normalize(vec3(vec2(mix(vec2(_114, _101), vec2(_89 - _93, _93), bvec2((_106.x ? abs(_93 - _89) : 131008.0) < (_108.x ? abs(_114) : 65504.0))).x, mix(vec2(_128, _105), vec2(_89 - _97, _97), bvec2((_106.y ? abs(_97 - _89) : 131008.0) < (_108.y ? abs(_128) : 65504.0))).x) / (parameters.gViewRay.xy * parameters.gOutputSize.zw), -1.0));
        vec2 _149 = floor(_73);
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
        float _190 = 1.0 / max(fma(parameters.gOcclusionBias.y, _89, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
        vec2 _191 = vec2(1.0) / parameters.gViewRay.xy;
        vec3 _194 = vec3(_75, _89);
        float _195 = _148.z;
        float _197 = (_195 >= 0.0) ? 1.0 : (-1.0);
        float _199 = (-1.0) / (_197 + _195);
        float _200 = _148.x;
        float _201 = _148.y;
        float _203 = (_200 * _201) * _199;
        vec3 _210 = vec3(fma((_197 * _200) * _200, _199, 1.0), _197 * _203, (-_197) * _200);
        vec3 _214 = vec3(_203, fma(_201 * _201, _199, _197), -_201);
        vec3 _220 = ((_210 * _182) + (_214 * _183)) * parameters.gRadius;
        vec3 _226 = vec3(_220.xy * _191, _220.z);
        vec3 _230 = ((_214 * _182) - (_210 * _183)) * parameters.gRadius;
        vec3 _236 = vec3(_230.xy * _191, _230.z);
        vec3 _237 = _148 * parameters.gRadius;
        vec3 _243 = vec3(_237.xy * _191, _237.z);
        float _255 = _179.y;
        vec3 _260 = _194 + ((((_226 * parameters.gTaps[0].x) + (_236 * parameters.gTaps[0].y)) + (_243 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _255)));
        float _261 = 1.0 / parameters.gRadius;
        vec2 _262 = _260.xy;
        float _263 = _260.z;
        vec4 _271 = textureLod(gInCoarseDepth, _262, 0.0);
        float _272 = _271.x;
        float _276 = _263 - ((_272 > 0.0) ? min(_272, 65504.0) : 65504.0);
        vec3 _301 = _194 + ((((_226 * parameters.gTaps[1].x) + (_236 * parameters.gTaps[1].y)) + (_243 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _255)));
        vec2 _302 = _301.xy;
        float _303 = _301.z;
        vec4 _311 = textureLod(gInCoarseDepth, _302, 0.0);
        float _312 = _311.x;
        float _316 = _303 - ((_312 > 0.0) ? min(_312, 65504.0) : 65504.0);
        vec3 _342 = _194 + ((((_226 * parameters.gTaps[2].x) + (_236 * parameters.gTaps[2].y)) + (_243 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _255)));
        vec2 _343 = _342.xy;
        float _344 = _342.z;
        vec4 _352 = textureLod(gInCoarseDepth, _343, 0.0);
        float _353 = _352.x;
        float _357 = _344 - ((_353 > 0.0) ? min(_353, 65504.0) : 65504.0);
        vec3 _383 = _194 + ((((_226 * parameters.gTaps[3].x) + (_236 * parameters.gTaps[3].y)) + (_243 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _255)));
        vec2 _384 = _383.xy;
        float _385 = _383.z;
        vec4 _393 = textureLod(gInCoarseDepth, _384, 0.0);
        float _394 = _393.x;
        float _398 = _385 - ((_394 > 0.0) ? min(_394, 65504.0) : 65504.0);
        vec2 _408 = ((mix(vec2(0.0), vec2(clamp(fma(_276, _190, -1.0), 0.0, 1.0) * clamp(fma(-_276, _261, 2.0), 0.0, 1.0), 1.0), bvec2((_263 > 0.0) && all(lessThanEqual(abs(_262 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_316, _190, -1.0), 0.0, 1.0) * clamp(fma(-_316, _261, 2.0), 0.0, 1.0), 1.0), bvec2((_303 > 0.0) && all(lessThanEqual(abs(_302 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_357, _190, -1.0), 0.0, 1.0) * clamp(fma(-_357, _261, 2.0), 0.0, 1.0), 1.0), bvec2((_344 > 0.0) && all(lessThanEqual(abs(_343 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_398, _190, -1.0), 0.0, 1.0) * clamp(fma(-_398, _261, 2.0), 0.0, 1.0), 1.0), bvec2((_385 > 0.0) && all(lessThanEqual(abs(_384 - vec2(0.5)), vec2(0.5)))));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_89 < 65504.0) ? (1.0 - (_408.x / max(_408.y, 1.0))) : 1.0, _89, 0.0, 0.0));
        break;
    } while(false);
}

