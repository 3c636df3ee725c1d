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
layout(binding = 1) uniform sampler2D gInDepth;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec4 _67 = textureGather(gInDepth, ((vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * 2.0) * parameters.gInputSize.zw);
        vec4 _69 = mix(vec4(65504.0), _67, greaterThan(_67, vec4(0.0)));
        vec4 _71 = mix(vec4(65504.0), _69, lessThan(_69, vec4(65504.0)));
        vec4 _73 = min(_71, _71.zwxy);
        vec4 _76 = min(_73.xxxx, _73.yyyy);
        float _77 = _76.x;
        imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_77 > 0.0) && (_77 < min(parameters.gSkyDepth, 65504.0))) ? _77 : 65504.0, 0.0, 0.0, 0.0));
        break;
    } while(false);
}

