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
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _79 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _81 = _79 * parameters.gOutputSize.zw;
        vec4 _85 = textureLod(gInCoarseDepth, _81, 0.0);
        float _86 = _85.x;
        float _89 = (_86 > 0.0) ? min(_86, 65504.0) : 65504.0;
        vec3 _100 = textureLod(gInNormal, fma(_79, parameters.gOutputSize.zw, -(parameters.gOutputSize.zw * 0.125)) / parameters.gFrameToCoarse, 0.0).xyz;
        float _101 = dot(_100, _100);
        vec3 _108 = mix(vec3(0.0, 0.0, -1.0), _100 * inversesqrt(_101), bvec3((_101 > 9.9999999747524270787835121154785e-07) && (_101 < 1000000.0)));
        vec2 _109 = floor(_79);
        vec2 _111 = floor(_109 * 0.5);
        vec2 _113 = _109 - (_111 * 2.0);
        vec2 _117 = _111 - (floor(_111 * 0.5) * 2.0);
        float _118 = _113.x;
        float _119 = _113.y;
        float _121 = abs(_118 - _119);
        float _122 = _117.y;
        float _127 = _117.x;
        vec2 _139 = vec2(fma(2.0, abs(_127 - _122), fma(8.0, _121, 4.0 * _119)) + _122, fma(2.0, abs(abs(_122 - _119) - _127), fma(4.0, _118, fma(-8.0, _121, 8.0))) + _127) * vec2(0.0625);
        float _141 = 6.283185482025146484375 * _139.x;
        float _142 = cos(_141);
        float _143 = sin(_141);
        float _150 = 1.0 / max(fma(parameters.gOcclusionBias.y, _89, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
        vec2 _154 = vec2(1.0) / parameters.gViewRay.xy;
        vec3 _158 = vec3(_81 * _89, _89);
        float _159 = _108.z;
        float _161 = (_159 >= 0.0) ? 1.0 : (-1.0);
        float _163 = (-1.0) / (_161 + _159);
        float _164 = _108.x;
        float _165 = _108.y;
        float _167 = (_164 * _165) * _163;
        vec3 _174 = vec3(fma((_161 * _164) * _164, _163, 1.0), _161 * _167, (-_161) * _164);
        vec3 _178 = vec3(_167, fma(_165 * _165, _163, _161), -_165);
        vec3 _184 = ((_174 * _142) + (_178 * _143)) * parameters.gRadius;
        float _187 = _184.z;
        vec3 _193 = vec3((_184.xy - (parameters.gViewRay.zw * _187)) * _154, _187);
        vec3 _197 = ((_178 * _142) - (_174 * _143)) * parameters.gRadius;
        float _199 = _197.z;
        vec3 _205 = vec3((_197.xy - (parameters.gViewRay.zw * _199)) * _154, _199);
        vec3 _206 = _108 * parameters.gRadius;
        float _208 = _206.z;
        vec3 _214 = vec3((_206.xy - (parameters.gViewRay.zw * _208)) * _154, _208);
        float _226 = _139.y;
        vec3 _231 = _158 + ((((_193 * parameters.gTaps[0].x) + (_205 * parameters.gTaps[0].y)) + (_214 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _226)));
        float _232 = 1.0 / parameters.gRadius;
        float _234 = _231.z;
        vec2 _236 = _231.xy * (1.0 / _234);
        vec4 _244 = textureLod(gInCoarseDepth, _236, 0.0);
        float _245 = _244.x;
        float _249 = _234 - ((_245 > 0.0) ? min(_245, 65504.0) : 65504.0);
        vec3 _274 = _158 + ((((_193 * parameters.gTaps[1].x) + (_205 * parameters.gTaps[1].y)) + (_214 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _226)));
        float _276 = _274.z;
        vec2 _278 = _274.xy * (1.0 / _276);
        vec4 _286 = textureLod(gInCoarseDepth, _278, 0.0);
        float _287 = _286.x;
        float _291 = _276 - ((_287 > 0.0) ? min(_287, 65504.0) : 65504.0);
        vec3 _317 = _158 + ((((_193 * parameters.gTaps[2].x) + (_205 * parameters.gTaps[2].y)) + (_214 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _226)));
        float _319 = _317.z;
        vec2 _321 = _317.xy * (1.0 / _319);
        vec4 _329 = textureLod(gInCoarseDepth, _321, 0.0);
        float _330 = _329.x;
        float _334 = _319 - ((_330 > 0.0) ? min(_330, 65504.0) : 65504.0);
        vec3 _360 = _158 + ((((_193 * parameters.gTaps[3].x) + (_205 * parameters.gTaps[3].y)) + (_214 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _226)));
        float _362 = _360.z;
        vec2 _364 = _360.xy * (1.0 / _362);
        vec4 _372 = textureLod(gInCoarseDepth, _364, 0.0);
        float _373 = _372.x;
        float _377 = _362 - ((_373 > 0.0) ? min(_373, 65504.0) : 65504.0);
        vec2 _387 = ((mix(vec2(0.0), vec2(clamp(fma(_249, _150, -1.0), 0.0, 1.0) * clamp(fma(-_249, _232, 2.0), 0.0, 1.0), 1.0), bvec2((_234 > 0.0) && all(lessThanEqual(abs(_236 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_291, _150, -1.0), 0.0, 1.0) * clamp(fma(-_291, _232, 2.0), 0.0, 1.0), 1.0), bvec2((_276 > 0.0) && all(lessThanEqual(abs(_278 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_334, _150, -1.0), 0.0, 1.0) * clamp(fma(-_334, _232, 2.0), 0.0, 1.0), 1.0), bvec2((_319 > 0.0) && all(lessThanEqual(abs(_321 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_377, _150, -1.0), 0.0, 1.0) * clamp(fma(-_377, _232, 2.0), 0.0, 1.0), 1.0), bvec2((_362 > 0.0) && all(lessThanEqual(abs(_364 - vec2(0.5)), vec2(0.5)))));
        imageStore(gOutOcclusion, ivec2(gl_GlobalInvocationID.xy), vec4((_89 < 65504.0) ? (1.0 - (_387.x / max(_387.y, 1.0))) : 1.0, _89, 0.0, 0.0));
        break;
    } while(false);
}

