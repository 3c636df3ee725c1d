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
    vec4 _58 = textureGather(gInDepth, ((vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * 2.0) * parameters.gInputSize.zw);
    vec4 _62 = mix(vec4(0.0), _58, lessThanEqual(abs(_58 - vec4(0.5)), vec4(0.5)));
    vec4 _64 = max(_62, _62.zwxy);
    float _75 = 1.0 / max(max(_64.xxxx, _64.yyyy).x * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_75 > 0.0) && (_75 < min(parameters.gSkyDepth, 65504.0))) ? _75 : 65504.0, 0.0, 0.0, 0.0));
}

