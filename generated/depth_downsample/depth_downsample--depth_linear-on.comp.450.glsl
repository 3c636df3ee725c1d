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
    vec4 _54 = textureGather(gInDepth, ((vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * 2.0) * parameters.gInputSize.zw);
    vec4 _56 = mix(vec4(65504.0), _54, greaterThan(_54, vec4(0.0)));
    vec4 _58 = mix(vec4(65504.0), _56, lessThan(_56, vec4(65504.0)));
    vec4 _60 = min(_58, _58.zwxy);
    vec4 _63 = min(_60.xxxx, _60.yyyy);
    float _64 = _63.x;
    imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_64 > 0.0) && (_64 < min(parameters.gSkyDepth, 65504.0))) ? _64 : 65504.0, 0.0, 0.0, 0.0));
}

