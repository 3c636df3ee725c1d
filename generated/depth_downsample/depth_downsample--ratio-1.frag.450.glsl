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
    vec4 _50 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gInputSize.zw, 0.0).xxxx;
    vec4 _54 = mix(vec4(1.0), _50, lessThanEqual(abs(_50 - vec4(0.5)), vec4(0.5)));
    vec4 _56 = min(_54, _54.zwxy);
    float _67 = 1.0 / max(fma(min(_56.xxxx, _56.yyyy).x, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    gOutCoarseDepth = vec4(((_67 > 0.0) && (_67 < min(parameters.gSkyDepth, 65504.0))) ? _67 : 65504.0, 0.0, 0.0, 0.0);
}

