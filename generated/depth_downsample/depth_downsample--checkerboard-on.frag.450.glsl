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
    vec4 _52 = textureGather(gInDepth, (gl_FragCoord.xy * 2.0) * parameters.gInputSize.zw);
    vec4 _56 = mix(vec4(1.0), _52, lessThanEqual(abs(_52 - vec4(0.5)), vec4(0.5)));
    vec2 _57 = floor(gl_FragCoord.xy);
    vec4 _64 = _56.zwxy;
    vec4 _65 = max(_56, _64);
    vec4 _70 = min(_56, _64);
    float _82 = 1.0 / max(fma((fract(0.5 * (_57.x + _57.y)) > 0.25) ? max(_65.xxxx, _65.yyyy).x : min(_70.xxxx, _70.yyyy).x, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    gOutCoarseDepth = vec4(((_82 > 0.0) && (_82 < min(parameters.gSkyDepth, 65504.0))) ? _82 : 65504.0, 0.0, 0.0, 0.0);
}

