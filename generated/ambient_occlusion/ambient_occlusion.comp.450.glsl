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
        vec2 _122 = mix(vec2(_114, _101), vec2(_89 - _93, _93), bvec2((_106.x ? abs(_93 - _89) : 131008.0) < (_108.x ? abs(_114) : 65504.0)));
        float _128 = _105 - _89;
        vec2 _136 = mix(vec2(_128, _105), vec2(_89 - _97, _97), bvec2((_106.y ? abs(_97 - _89) : 131008.0) < (_108.y ? abs(_128) : 65504.0)));
        vec2 _148 = vec2(_122.x, _136.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_122.y, _136.y));
        vec3 _156 = normalize(vec3(_148, (-1.0) - dot(fma(_75, parameters.gViewRay.xy, parameters.gViewRay.zw), _148)));
        vec2 _157 = floor(_73);
        vec2 _159 = floor(_157 * 0.5);
        vec2 _161 = _157 - (_159 * 2.0);
        vec2 _165 = _159 - (floor(_159 * 0.5) * 2.0);
        float _166 = _161.x;
        float _167 = _161.y;
        float _169 = abs(_166 - _167);
        float _170 = _165.y;
        float _175 = _165.x;
        vec2 _187 = vec2(fma(2.0, abs(_175 - _170), fma(8.0, _169, 4.0 * _167)) + _170, fma(2.0, abs(abs(_170 - _167) - _175), fma(4.0, _166, fma(-8.0, _169, 8.0))) + _175) * vec2(0.0625);
        float _189 = 6.283185482025146484375 * _187.x;
        float _190 = cos(_189);
        float _191 = sin(_189);
        float _198 = 1.0 / max(fma(parameters.gOcclusionBias.y, _89, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
        vec2 _199 = vec2(1.0) / parameters.gViewRay.xy;
        vec3 _203 = vec3(_75 * _89, _89);
        float _204 = _156.z;
        float _206 = (_204 >= 0.0) ? 1.0 : (-1.0);
        float _208 = (-1.0) / (_206 + _204);
        float _209 = _156.x;
        float _210 = _156.y;
        float _212 = (_209 * _210) * _208;
        vec3 _219 = vec3(fma((_206 * _209) * _209, _208, 1.0), _206 * _212, (-_206) * _209);
        vec3 _223 = vec3(_212, fma(_210 * _210, _208, _206), -_210);
        vec3 _229 = ((_219 * _190) + (_223 * _191)) * parameters.gRadius;
        float _231 = _229.z;
        vec3 _237 = vec3((_229.xy - (parameters.gViewRay.zw * _231)) * _199, _231);
        vec3 _241 = ((_223 * _190) - (_219 * _191)) * parameters.gRadius;
        float _243 = _241.z;
        vec3 _249 = vec3((_241.xy - (parameters.gViewRay.zw * _243)) * _199, _243);
        vec3 _250 = _156 * parameters.gRadius;
        float _252 = _250.z;
        vec3 _258 = vec3((_250.xy - (parameters.gViewRay.zw * _252)) * _199, _252);
        float _270 = _187.y;
        vec3 _275 = _203 + ((((_237 * parameters.gTaps[0].x) + (_249 * parameters.gTaps[0].y)) + (_258 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _270)));
        float _276 = 1.0 / parameters.gRadius;
        float _278 = _275.z;
        vec2 _280 = _275.xy * (1.0 / _278);
        vec4 _288 = textureLod(gInCoarseDepth, _280, 0.0);
        float _289 = _288.x;
        float _293 = _278 - ((_289 > 0.0) ? min(_289, 65504.0) : 65504.0);
        vec3 _318 = _203 + ((((_237 * parameters.gTaps[1].x) + (_249 * parameters.gTaps[1].y)) + (_258 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _270)));
        float _320 = _318.z;
        vec2 _322 = _318.xy * (1.0 / _320);
        vec4 _330 = textureLod(gInCoarseDepth, _322, 0.0);
        float _331 = _330.x;
        float _335 = _320 - ((_331 > 0.0) ? min(_331, 65504.0) : 65504.0);
        vec3 _361 = _203 + ((((_237 * parameters.gTaps[2].x) + (_249 * parameters.gTaps[2].y)) + (_258 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _270)));
        float _363 = _361.z;
        vec2 _365 = _361.xy * (1.0 / _363);
        vec4 _373 = textureLod(gInCoarseDepth, _365, 0.0);
        float _374 = _373.x;
        float _378 = _363 - ((_374 > 0.0) ? min(_374, 65504.0) : 65504.0);
        vec3 _404 = _203 + ((((_237 * parameters.gTaps[3].x) + (_249 * parameters.gTaps[3].y)) + (_258 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _270)));
        float _406 = _404.z;
        vec2 _408 = _404.xy * (1.0 / _406);
        vec4 _416 = textureLod(gInCoarseDepth, _408, 0.0);
        float _417 = _416.x;
        float _421 = _406 - ((_417 > 0.0) ? min(_417, 65504.0) : 65504.0);
        vec2 _431 = ((mix(vec2(0.0), vec2(clamp(fma(_293, _198, -1.0), 0.0, 1.0) * clamp(fma(-_293, _276, 2.0), 0.0, 1.0), 1.0), bvec2((_278 > 0.0) && all(lessThanEqual(abs(_280 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_335, _198, -1.0), 0.0, 1.0) * clamp(fma(-_335, _276, 2.0), 0.0, 1.0), 1.0), bvec2((_320 > 0.0) && all(lessThanEqual(abs(_322 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_378, _198, -1.0), 0.0, 1.0) * clamp(fma(-_378, _276, 2.0), 0.0, 1.0), 1.0), bvec2((_363 > 0.0) && all(lessThanEqual(abs(_365 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_421, _198, -1.0), 0.0, 1.0) * clamp(fma(-_421, _276, 2.0), 0.0, 1.0), 1.0), bvec2((_406 > 0.0) && all(lessThanEqual(abs(_408 - vec2(0.5)), vec2(0.5)))));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_89 < 65504.0) ? (1.0 - (_431.x / max(_431.y, 1.0))) : 1.0, _89, 0.0, 0.0));
        break;
    } while(false);
}

