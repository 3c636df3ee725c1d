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
        vec2 _62 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec4 _68 = textureLod(gInDepth, _62 * parameters.gOutputSize.zw, 0.0);
        float _69 = _68.x;
        vec2 _73 = fma(_62, parameters.gOutputSize.zw, -parameters.gJitterUv);
        vec4 _85 = parameters.gReprojection * vec4(fma(_73, parameters.gViewRay.xy, parameters.gViewRay.zw) * _69, _69, 1.0);
        float _86 = _85.w;
        vec2 _91 = fma(_85.xy * (1.0 / _86), vec2(0.5, -0.5), vec2(0.5));
        imageStore(gOutVelocity, ivec2(gl_GlobalInvocationID.xy), vec4(_73 - mix(vec2(-8.0), _91, bvec2((_86 > 0.0) && all(lessThanEqual(abs(_91), vec2(8.0))))), 0.0, 0.0));
        break;
    } while(false);
}

