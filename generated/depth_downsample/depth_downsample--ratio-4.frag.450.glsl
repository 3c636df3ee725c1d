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
    vec2 _47 = gl_FragCoord.xy * 4.0;
    vec4 _56 = textureGather(gInDepth, (_47 - vec2(1.0)) * parameters.gInputSize.zw);
    vec4 _64 = textureGather(gInDepth, (_47 + vec2(1.0, -1.0)) * parameters.gInputSize.zw);
    vec4 _72 = textureGather(gInDepth, (_47 + vec2(-1.0, 1.0)) * parameters.gInputSize.zw);
    vec4 _80 = textureGather(gInDepth, (_47 + vec2(1.0)) * parameters.gInputSize.zw);
    vec4 _87 = min(min(mix(vec4(1.0), _56, lessThanEqual(abs(_56 - vec4(0.5)), vec4(0.5))), mix(vec4(1.0), _64, lessThanEqual(abs(_64 - vec4(0.5)), vec4(0.5)))), min(mix(vec4(1.0), _72, lessThanEqual(abs(_72 - vec4(0.5)), vec4(0.5))), mix(vec4(1.0), _80, lessThanEqual(abs(_80 - vec4(0.5)), vec4(0.5)))));
    vec4 _89 = min(_87, _87.zwxy);
    float _100 = 1.0 / max(fma(min(_89.xxxx, _89.yyyy).x, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    gOutCoarseDepth = vec4(((_100 > 0.0) && (_100 < min(parameters.gSkyDepth, 65504.0))) ? _100 : 65504.0, 0.0, 0.0, 0.0);
}

