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
        vec2 _82 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _84 = _82 * parameters.gOutputSize.zw;
        vec4 _88 = textureLod(gInFresh, _84, 0.0);
        float _89 = _88.y;
        float _90 = _88.x;
        float _93 = (abs(_90) <= 65504.0) ? _90 : 0.0;
        float _97 = ((_89 > 0.0) && (_89 < 65504.0)) ? _89 : 65504.0;
        vec4 _109 = parameters.gViewToPreviousClip * vec4(fma(_84, parameters.gViewRay.xy, parameters.gViewRay.zw) * _97, _97, 1.0);
        float _112 = _109.w;
        vec2 _117 = fma(_109.xy * (1.0 / _112), vec2(0.5, -0.5), vec2(0.5));
        vec2 _123 = mix(vec2(-8.0), _117, bvec2((_112 > 0.0) && all(lessThanEqual(abs(_117), vec2(8.0)))));
        float _125 = dot(_109.zw, parameters.gClipToDepth);
        vec2 _131 = _123 * parameters.gFrameToCoarse;
        vec4 _135 = textureLod(gHistoryCacheState, _131, 0.0);
        vec4 _139 = textureLod(gHistoryCache, _131, 0.0);
        float _140 = _139.x;
        float _142 = _135.x;
        float _145 = (_142 > 0.0) ? min(_142, 255.0) : 0.0;
        float _151 = max(fma(parameters.gMissThreshold.y, _97, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _157 = _151 - abs(((abs(_125) <= 9.9999996802856924650656260769173e+37) ? _125 : 0.0) - _139.y);
        float _160 = (_157 > 0.0) ? (_157 * (parameters.gConvergenceTime / _151)) : 0.0;
        float _172 = abs(_140);
        float _175 = ((parameters.gHistoryValid > 0.5) && (_172 <= 65504.0)) ? (((_160 > 0.0) && all(lessThanEqual(abs(fma(_123, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_160, 1.0) : 0.0) : 0.0;
        float _187 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _189 = parameters.gSpeedPx.y - abs(length(fma(_82, parameters.gOutputSize.zw, -_131) * parameters.gOutputSize.xy));
        float _193 = ((_189 > 0.0) ? min(_189, _187) : 0.0) / _187;
        float _196 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _201 = _145 * _175;
        float _204 = (_201 > 0.0) ? min(_201, 255.0) : 0.0;
        float _208 = min(min(_204 / (_204 + 1.0), _196), ((_196 * _193) * _193) * fma(-2.0, _193, 3.0));
        float _211 = (abs(_93) <= 9.9999996802856924650656260769173e+37) ? _93 : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_208 > 0.0) ? ((_172 <= 9.9999996802856924650656260769173e+37) ? fma(_140 - _211, clamp(_208, 0.0, 1.0), _211) : _211) : _93, _97, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_145 > 0.0) ? min(_145, 255.0) : 0.0, (_175 > 0.0) ? min(_175, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

