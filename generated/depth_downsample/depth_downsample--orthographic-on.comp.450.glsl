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
        vec4 _70 = textureGather(gInDepth, ((vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * 2.0) * parameters.gInputSize.zw);
        vec4 _74 = mix(vec4(1.0), _70, lessThanEqual(abs(_70 - vec4(0.5)), vec4(0.5)));
        vec4 _76 = min(_74, _74.zwxy);
        float _85 = fma(min(_76.xxxx, _76.yyyy).x, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
        imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_85 > 0.0) && (_85 < min(parameters.gSkyDepth, 65504.0))) ? _85 : 65504.0, 0.0, 0.0, 0.0));
        break;
    } while(false);
}

