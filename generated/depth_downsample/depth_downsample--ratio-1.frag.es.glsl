#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform DepthDownsampleParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutCoarseDepth;

void main()
{
    vec4 _50 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gInputSize.zw, 0.0).xxxx;
    bvec4 _53 = lessThanEqual(abs(_50 - vec4(0.5)), vec4(0.5));
    vec4 _54 = vec4(_53.x ? _50.x : vec4(1.0).x, _53.y ? _50.y : vec4(1.0).y, _53.z ? _50.z : vec4(1.0).z, _53.w ? _50.w : vec4(1.0).w);
    vec4 _56 = min(_54, _54.zwxy);
    float _67 = 1.0 / max(min(_56.xxxx, _56.yyyy).x * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    gOutCoarseDepth = vec4(((_67 > 0.0) && (_67 < min(parameters.gSkyDepth, 65504.0))) ? _67 : 65504.0, 0.0, 0.0, 0.0);
}

