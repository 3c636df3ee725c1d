#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

float _58;

layout(binding = 0, std140) uniform ReprojectionCacheParameters
{
    mat4 gViewToPreviousClip;
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gFrameToCoarse;
    vec2 gMotionToUv;
    vec2 gClipToDepth;
    vec2 gMissThreshold;
    vec2 gSpeedPx;
    vec2 gChange;
    float gConvergenceTime;
    float gMaxWeight;
    float gHistoryValid;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutCache;
layout(binding = 1) uniform sampler2D gInFresh;
layout(binding = 3) uniform sampler2D gHistoryCache;

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
        vec4 _79 = textureLod(gInFresh, _75, 0.0);
        float _80 = _79.y;
        float _84 = ((_80 > 0.0) && (_80 < 65504.0)) ? _80 : 65504.0;
        float _85 = _79.x;
        vec2 _90 = mix(vec2(0.0), vec2(_85, 0.0), bvec2(abs(_85) <= 65504.0));
        vec4 _94 = textureLod(gHistoryCache, _75, 0.0);
        float _95 = _94.x;
        vec2 _100 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_95, 0.0), bvec2(abs(_95) <= 65504.0));
        float _101 = _100.x;
        float _103 = _94.z;
        float _112 = max(fma(parameters.gMissThreshold.y, _84, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _118 = _112 - abs(_84 - _94.w);
        float _121 = (_118 > 0.0) ? (_118 * (parameters.gConvergenceTime / _112)) : 0.0;
        float _137 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_101, _100.y, _103, _94.w).xy), vec2(65504.0)))) ? (((_121 > 0.0) && all(lessThanEqual(abs(fma(_73, parameters.gOutputSize.zw, vec2(-0.5))), vec2(0.5)))) ? min(_121, 1.0) : 0.0) : 0.0;
        float _149 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _151 = parameters.gSpeedPx.y - abs(length(fma(_73, parameters.gOutputSize.zw, -_75) * parameters.gOutputSize.xy));
        float _155 = ((_151 > 0.0) ? min(_151, _149) : 0.0) / _149;
        float _158 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _165 = (_103 > 0.0) ? min(_103, 255.0) : 0.0;
        float _166 = _165 * _137;
        float _169 = (_166 > 0.0) ? min(_166, 255.0) : 0.0;
        float _173 = min(min(_169 / (_169 + 1.0), _158), ((_158 * _155) * _155) * fma(-2.0, _155, 3.0));
        float _174 = _90.x;
        bool _175 = _173 > 0.0;
        float _177 = _175 ? min(_173, 1.0) : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(mix(_90, vec2((abs(_101) <= 9.9999996802856924650656260769173e+37) ? fma(_101, _177, _174 * (1.0 - _177)) : _174, _58), bvec2(_175)).x, 0.0, min(fma(_165, (_137 > 0.0) ? min(_137, 1.0) : 0.0, 1.0), 255.0), _84));
        break;
    } while(false);
}

