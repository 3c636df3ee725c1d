#version 450

layout(binding = 0, std140) uniform DepthDownsampleParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

layout(binding = 1) uniform sampler2D gInDepth;

layout(location = 0) out vec4 gOutCoarseDepth;
layout(location = 1) out vec4 gOutHalfDepth;

void main()
{
    vec4 _53 = textureGather(gInDepth, (gl_FragCoord.xy * 2.0) * parameters.gInputSize.zw);
    vec4 _57 = mix(vec4(1.0), _53, lessThanEqual(abs(_53 - vec4(0.5)), vec4(0.5)));
    vec4 _59 = min(_57, _57.zwxy);
    float _70 = 1.0 / max(fma(min(_59.xxxx, _59.yyyy).x, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _77 = ((_70 > 0.0) && (_70 < min(parameters.gSkyDepth, 65504.0))) ? _70 : 65504.0;
    gOutCoarseDepth = vec4(_77, 0.0, 0.0, 0.0);
    gOutHalfDepth = vec4(min(_77 * 1.00048828125, 65504.0), 0.0, 0.0, 0.0);
}

