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
        vec2 _67 = (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * 4.0;
        vec4 _76 = textureGather(gInDepth, (_67 - vec2(1.0)) * parameters.gInputSize.zw);
        vec4 _84 = textureGather(gInDepth, (_67 + vec2(1.0, -1.0)) * parameters.gInputSize.zw);
        vec4 _92 = textureGather(gInDepth, (_67 + vec2(-1.0, 1.0)) * parameters.gInputSize.zw);
        vec4 _100 = textureGather(gInDepth, (_67 + vec2(1.0)) * parameters.gInputSize.zw);
        vec4 _107 = min(min(mix(vec4(1.0), _76, lessThanEqual(abs(_76 - vec4(0.5)), vec4(0.5))), mix(vec4(1.0), _84, lessThanEqual(abs(_84 - vec4(0.5)), vec4(0.5)))), min(mix(vec4(1.0), _92, lessThanEqual(abs(_92 - vec4(0.5)), vec4(0.5))), mix(vec4(1.0), _100, lessThanEqual(abs(_100 - vec4(0.5)), vec4(0.5)))));
        vec4 _109 = min(_107, _107.zwxy);
        float _120 = 1.0 / max(fma(min(_109.xxxx, _109.yyyy).x, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_120 > 0.0) && (_120 < min(parameters.gSkyDepth, 65504.0))) ? _120 : 65504.0, 0.0, 0.0, 0.0));
        break;
    } while(false);
}

