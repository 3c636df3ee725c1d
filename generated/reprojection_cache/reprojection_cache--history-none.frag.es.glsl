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

void main()
{
    vec4 _42 = textureLod(gInFresh, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _43 = _42.y;
    float _48 = _42.x;
    vec2 _51 = vec2(_48, 0.0);
    bvec2 _52 = bvec2(abs(_48) <= 65504.0);
    gOutCache = vec4(vec2(_52.x ? _51.x : vec2(0.0).x, _52.y ? _51.y : vec2(0.0).y).x, 0.0, 1.0, ((_43 > 0.0) && (_43 < 65504.0)) ? _43 : 65504.0);
}

