#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform ReprojectionCacheParameters
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

uniform highp sampler2D gInFresh;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec4 _42 = textureLod(gInFresh, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _43 = _42.y;
    float _44 = _42.x;
    gOutCache = vec4((abs(_44) <= 65504.0) ? _44 : 0.0, ((_43 > 0.0) && (_43 < 65504.0)) ? _43 : 65504.0, 0.0, 0.0);
    gOutCacheState = vec4(1.0, 0.0, 0.0, 0.0);
}

