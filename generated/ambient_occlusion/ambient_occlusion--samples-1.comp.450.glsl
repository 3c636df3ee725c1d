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
        vec2 _72 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _74 = _72 * parameters.gOutputSize.zw;
        vec2 _78 = parameters.gOutputSize.zw * 0.5;
        vec4 _81 = textureGather(gInCoarseDepth, fma(_72, parameters.gOutputSize.zw, -_78));
        vec4 _84 = textureGather(gInCoarseDepth, fma(_72, parameters.gOutputSize.zw, _78));
        float _85 = _81.y;
        float _88 = (_85 > 0.0) ? min(_85, 65504.0) : 65504.0;
        float _89 = _81.x;
        float _92 = (_89 > 0.0) ? min(_89, 65504.0) : 65504.0;
        float _93 = _81.z;
        float _96 = (_93 > 0.0) ? min(_93, 65504.0) : 65504.0;
        float _97 = _84.z;
        float _100 = (_97 > 0.0) ? min(_97, 65504.0) : 65504.0;
        float _101 = _84.x;
        float _104 = (_101 > 0.0) ? min(_101, 65504.0) : 65504.0;
        bvec2 _105 = greaterThan(_74, parameters.gOutputSize.zw);
        bvec2 _107 = lessThan(_74, vec2(1.0) - parameters.gOutputSize.zw);
        float _113 = _100 - _88;
        vec2 _121 = mix(vec2(_113, _100), vec2(_88 - _92, _92), bvec2((_105.x ? abs(_92 - _88) : 131008.0) < (_107.x ? abs(_113) : 65504.0)));
        float _127 = _104 - _88;
        vec2 _135 = mix(vec2(_127, _104), vec2(_88 - _96, _96), bvec2((_105.y ? abs(_96 - _88) : 131008.0) < (_107.y ? abs(_127) : 65504.0)));
        vec2 _147 = vec2(_121.x, _135.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_121.y, _135.y));
        vec3 _155 = normalize(vec3(_147, (-1.0) - dot(fma(_74, parameters.gViewRay.xy, parameters.gViewRay.zw), _147)));
        vec2 _156 = floor(_72);
        vec2 _158 = floor(_156 * 0.5);
        vec2 _160 = _156 - (_158 * 2.0);
        vec2 _164 = _158 - (floor(_158 * 0.5) * 2.0);
        float _165 = _160.x;
        float _166 = _160.y;
        float _168 = abs(_165 - _166);
        float _169 = _164.y;
        float _174 = _164.x;
        vec2 _186 = vec2(fma(2.0, abs(_174 - _169), fma(8.0, _168, 4.0 * _166)) + _169, fma(2.0, abs(abs(_169 - _166) - _174), fma(4.0, _165, fma(-8.0, _168, 8.0))) + _174) * vec2(0.0625);
        float _188 = 6.283185482025146484375 * _186.x;
        float _189 = cos(_188);
        float _190 = sin(_188);
        vec2 _198 = vec2(1.0) / parameters.gViewRay.xy;
        float _203 = _155.z;
        float _205 = (_203 >= 0.0) ? 1.0 : (-1.0);
        float _207 = (-1.0) / (_205 + _203);
        float _208 = _155.x;
        float _209 = _155.y;
        float _211 = (_208 * _209) * _207;
        vec3 _218 = vec3(fma((_205 * _208) * _208, _207, 1.0), _205 * _211, (-_205) * _208);
        vec3 _222 = vec3(_211, fma(_209 * _209, _207, _205), -_209);
        vec3 _228 = ((_218 * _189) + (_222 * _190)) * parameters.gRadius;
        float _230 = _228.z;
        vec3 _240 = ((_222 * _189) - (_218 * _190)) * parameters.gRadius;
        float _242 = _240.z;
        vec3 _249 = _155 * parameters.gRadius;
        float _251 = _249.z;
        vec3 _274 = vec3(_74 * _88, _88) + ((((vec3((_228.xy - (parameters.gViewRay.zw * _230)) * _198, _230) * parameters.gTaps[0].x) + (vec3((_240.xy - (parameters.gViewRay.zw * _242)) * _198, _242) * parameters.gTaps[0].y)) + (vec3((_249.xy - (parameters.gViewRay.zw * _251)) * _198, _251) * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _186.y)));
        float _277 = _274.z;
        vec2 _279 = _274.xy * (1.0 / _277);
        vec4 _287 = textureLod(gInCoarseDepth, _279, 0.0);
        float _288 = _287.x;
        float _292 = _277 - ((_288 > 0.0) ? min(_288, 65504.0) : 65504.0);
        vec2 _301 = mix(vec2(0.0), vec2(clamp(fma(_292, 1.0 / max(fma(parameters.gOcclusionBias.y, _88, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07), -1.0), 0.0, 1.0) * clamp(fma(-_292, 1.0 / parameters.gRadius, 2.0), 0.0, 1.0), 1.0), bvec2((_277 > 0.0) && all(lessThanEqual(abs(_279 - vec2(0.5)), vec2(0.5)))));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_88 < 65504.0) ? (1.0 - (_301.x / max(_301.y, 1.0))) : 1.0, _88, 0.0, 0.0));
        break;
    } while(false);
}

