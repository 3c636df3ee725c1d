#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

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
layout(binding = 17) uniform writeonly image2D gOutCacheState;
layout(binding = 1) uniform sampler2D gInFresh;
layout(binding = 5) uniform sampler2D gHistoryCacheState;
layout(binding = 3) uniform sampler2D gHistoryCache;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _71 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _73 = _71 * parameters.gOutputSize.zw;
        vec4 _77 = textureLod(gInFresh, _73, 0.0);
        float _78 = _77.y;
        float _79 = _77.x;
        float _82 = (abs(_79) <= 65504.0) ? _79 : 0.0;
        float _86 = ((_78 > 0.0) && (_78 < 65504.0)) ? _78 : 65504.0;
        vec4 _90 = textureLod(gHistoryCacheState, _73, 0.0);
        vec4 _94 = textureLod(gHistoryCache, _73, 0.0);
        float _95 = _94.x;
        float _97 = _90.x;
        float _100 = (_97 > 0.0) ? min(_97, 255.0) : 0.0;
        float _106 = max(fma(parameters.gMissThreshold.y, _86, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _112 = _106 - abs(_86 - _94.y);
        float _115 = (_112 > 0.0) ? (_112 * (parameters.gConvergenceTime / _106)) : 0.0;
        float _127 = abs(_95);
        float _130 = ((parameters.gHistoryValid > 0.5) && (_127 <= 65504.0)) ? (((_115 > 0.0) && all(lessThanEqual(abs(fma(_71, parameters.gOutputSize.zw, vec2(-0.5))), vec2(0.5)))) ? min(_115, 1.0) : 0.0) : 0.0;
        float _142 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _144 = parameters.gSpeedPx.y - abs(length(fma(_71, parameters.gOutputSize.zw, -_73) * parameters.gOutputSize.xy));
        float _148 = ((_144 > 0.0) ? min(_144, _142) : 0.0) / _142;
        float _151 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _156 = _100 * _130;
        float _159 = (_156 > 0.0) ? min(_156, 255.0) : 0.0;
        float _163 = min(min(_159 / (_159 + 1.0), _151), ((_151 * _148) * _148) * fma(-2.0, _148, 3.0));
        float _166 = (abs(_82) <= 9.9999996802856924650656260769173e+37) ? _82 : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_163 > 0.0) ? ((_127 <= 9.9999996802856924650656260769173e+37) ? fma(_95 - _166, clamp(_163, 0.0, 1.0), _166) : _166) : _82, _86, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_100 > 0.0) ? min(_100, 255.0) : 0.0, (_130 > 0.0) ? min(_130, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

