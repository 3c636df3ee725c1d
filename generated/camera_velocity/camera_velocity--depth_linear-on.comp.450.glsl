#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform CameraVelocityParameters
{
    mat4 gReprojection;
    vec4 gViewRay;
    vec4 gOutputSize;
    vec2 gJitterUv;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutVelocity;
layout(binding = 1) uniform sampler2D gInDepth;

void main()
{
    vec2 _52 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _65 = fma(_52, parameters.gOutputSize.zw, -parameters.gJitterUv);
    vec4 _80 = ((parameters.gReprojection * vec4(fma(_65, parameters.gViewRay.xy, parameters.gViewRay.zw) * 1.0, 1.0, 0.0)) * textureLod(gInDepth, _52 * parameters.gOutputSize.zw, 0.0).x) + (parameters.gReprojection * vec4(0.0, 0.0, 0.0, 1.0));
    float _81 = _80.w;
    vec2 _86 = fma(_80.xy * (1.0 / _81), vec2(0.5, -0.5), vec2(0.5));
    imageStore(gOutVelocity, ivec2(gl_GlobalInvocationID.xy), vec4(_65 - mix(vec2(-8.0), _86, bvec2((_81 > 0.0) && all(lessThanEqual(abs(_86), vec2(8.0))))), 0.0, 0.0));
}

