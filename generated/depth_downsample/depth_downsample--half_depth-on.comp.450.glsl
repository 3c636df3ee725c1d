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
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec4 _73 = textureGather(gInDepth, ((vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * 2.0) * parameters.gInputSize.zw);
        vec4 _77 = mix(vec4(1.0), _73, lessThanEqual(abs(_73 - vec4(0.5)), vec4(0.5)));
        vec4 _79 = min(_77, _77.zwxy);
        float _90 = 1.0 / max(fma(min(_79.xxxx, _79.yyyy).x, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _97 = ((_90 > 0.0) && (_90 < min(parameters.gSkyDepth, 65504.0))) ? _90 : 65504.0;
        imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(_97, 0.0, 0.0, 0.0));
        imageStore(gOutHalfDepth, ivec2(gl_GlobalInvocationID.xy), vec4(min(_97 * 1.00048828125, 65504.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

