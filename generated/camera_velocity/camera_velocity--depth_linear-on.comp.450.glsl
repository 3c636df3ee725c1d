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
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _63 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _74 = fma(_63, parameters.gOutputSize.zw, -parameters.gJitterUv);
        vec4 _89 = ((parameters.gReprojection * vec4(fma(_74, parameters.gViewRay.xy, parameters.gViewRay.zw) * 1.0, 1.0, 0.0)) * textureLod(gInDepth, _63 * parameters.gOutputSize.zw, 0.0).x) + (parameters.gReprojection * vec4(0.0, 0.0, 0.0, 1.0));
        float _90 = _89.w;
        vec2 _95 = fma(_89.xy * (1.0 / _90), vec2(0.5, -0.5), vec2(0.5));
        imageStore(gOutVelocity, ivec2(gl_GlobalInvocationID.xy), vec4(_74 - mix(vec2(-8.0), _95, bvec2((_90 > 0.0) && all(lessThanEqual(abs(_95), vec2(8.0))))), 0.0, 0.0));
        break;
    } while(false);
}

