#version 310 es
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

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutCache;
layout(binding = 1) uniform highp sampler2D gInFresh;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec4 _59 = textureLod(gInFresh, (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * parameters.gOutputSize.zw, 0.0);
        float _60 = _59.y;
        float _65 = _59.x;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(mix(vec2(0.0), vec2(_65, 0.0), bvec2(abs(_65) <= 65504.0)).x, 0.0, 1.0, ((_60 > 0.0) && (_60 < 65504.0)) ? _60 : 65504.0));
        break;
    } while(false);
}

