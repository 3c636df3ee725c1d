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
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec4 _71 = textureGather(gInDepth, ((vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * 2.0) * parameters.gInputSize.zw);
        vec4 _75 = mix(vec4(0.0), _71, lessThanEqual(abs(_71 - vec4(0.5)), vec4(0.5)));
        vec4 _77 = max(_75, _75.zwxy);
        float _88 = 1.0 / max(max(_77.xxxx, _77.yyyy).x * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
        imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_88 > 0.0) && (_88 < min(parameters.gSkyDepth, 65504.0))) ? _88 : 65504.0, 0.0, 0.0, 0.0));
        break;
    } while(false);
}

