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
    vec4 _46 = textureGather(gInDepth, (gl_FragCoord.xy * 2.0) * parameters.gInputSize.zw);
    vec4 _48 = mix(vec4(65504.0), _46, greaterThan(_46, vec4(0.0)));
    vec4 _50 = mix(vec4(65504.0), _48, lessThan(_48, vec4(65504.0)));
    vec4 _52 = min(_50, _50.zwxy);
    vec4 _55 = min(_52.xxxx, _52.yyyy);
    float _56 = _55.x;
    gOutCoarseDepth = vec4(((_56 > 0.0) && (_56 < min(parameters.gSkyDepth, 65504.0))) ? _56 : 65504.0, 0.0, 0.0, 0.0);
}

