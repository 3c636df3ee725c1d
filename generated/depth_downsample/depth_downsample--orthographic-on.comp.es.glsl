#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform DepthDownsampleParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

layout(binding = 16, r32f) uniform writeonly highp image2D gOutCoarseDepth;
layout(binding = 1) uniform highp sampler2D gInDepth;

void main()
{
    vec4 _57 = textureGather(gInDepth, ((vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * 2.0) * parameters.gInputSize.zw);
    vec4 _61 = mix(vec4(1.0), _57, lessThanEqual(abs(_57 - vec4(0.5)), vec4(0.5)));
    vec4 _63 = min(_61, _61.zwxy);
    float _72 = min(_63.xxxx, _63.yyyy).x * parameters.gLinearDepth.x + parameters.gLinearDepth.y;
    imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_72 > 0.0) && (_72 < min(parameters.gSkyDepth, 65504.0))) ? _72 : 65504.0, 0.0, 0.0, 0.0));
}

