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

void main()
{
    vec4 _50 = textureLod(gInFresh, (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * parameters.gOutputSize.zw, 0.0);
    float _51 = _50.y;
    float _52 = _50.x;
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((abs(_52) <= 65504.0) ? _52 : 0.0, ((_51 > 0.0) && (_51 < 65504.0)) ? _51 : 65504.0, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(1.0, 0.0, 0.0, 0.0));
}

