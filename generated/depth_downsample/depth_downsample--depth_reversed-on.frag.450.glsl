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

void main()
{
    vec4 _51 = textureGather(gInDepth, (gl_FragCoord.xy * 2.0) * parameters.gInputSize.zw);
    vec4 _55 = mix(vec4(0.0), _51, lessThanEqual(abs(_51 - vec4(0.5)), vec4(0.5)));
    vec4 _57 = max(_55, _55.zwxy);
    float _68 = 1.0 / max(fma(max(_57.xxxx, _57.yyyy).x, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    gOutCoarseDepth = vec4(((_68 > 0.0) && (_68 < min(parameters.gSkyDepth, 65504.0))) ? _68 : 65504.0, 0.0, 0.0, 0.0);
}

