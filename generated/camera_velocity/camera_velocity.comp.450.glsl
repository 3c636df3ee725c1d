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
    vec2 _55 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _68 = fma(_55, parameters.gOutputSize.zw, -parameters.gJitterUv);
    vec4 _75 = parameters.gReprojection * vec4(fma(_68, vec2(2.0, -2.0), vec2(-1.0, 1.0)), textureLod(gInDepth, _55 * parameters.gOutputSize.zw, 0.0).x, 1.0);
    float _76 = _75.w;
    vec2 _81 = fma(_75.xy * (1.0 / _76), vec2(0.5, -0.5), vec2(0.5));
    imageStore(gOutVelocity, ivec2(gl_GlobalInvocationID.xy), vec4(_68 - mix(vec2(-8.0), _81, bvec2((_76 > 0.0) && all(lessThanEqual(abs(_81), vec2(8.0))))), 0.0, 0.0));
}

