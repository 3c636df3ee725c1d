#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform DepthDownsampleParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutCoarseDepth;
layout(binding = 17) uniform writeonly image2D gOutHalfDepth;
layout(binding = 1) uniform sampler2D gInDepth;

void main()
{
    vec4 _60 = textureGather(gInDepth, ((vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * 2.0) * parameters.gInputSize.zw);
    vec4 _64 = mix(vec4(1.0), _60, lessThanEqual(abs(_60 - vec4(0.5)), vec4(0.5)));
    vec4 _66 = min(_64, _64.zwxy);
    float _77 = 1.0 / max(fma(min(_66.xxxx, _66.yyyy).x, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _84 = ((_77 > 0.0) && (_77 < min(parameters.gSkyDepth, 65504.0))) ? _77 : 65504.0;
    imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(_84, 0.0, 0.0, 0.0));
    imageStore(gOutHalfDepth, ivec2(gl_GlobalInvocationID.xy), vec4(min(_84 * 1.00048828125, 65504.0), 0.0, 0.0, 0.0));
}

