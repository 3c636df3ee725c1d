#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform CombineLightingParameters
{
    vec4 gOutputSize;
} parameters;

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutLit;
layout(binding = 1) uniform highp sampler2D gInLighting;
layout(binding = 3) uniform highp sampler2D gInSunLight;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _58 = (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * parameters.gOutputSize.zw;
        vec4 _62 = textureLod(gInLighting, _58, 0.0);
        vec4 _66 = textureLod(gInSunLight, _58, 0.0);
        float _67 = _66.x;
        float _70 = _66.y;
        float _73 = _66.z;
        float _78 = _62.x;
        imageStore(gOutLit, ivec2(gl_GlobalInvocationID.xy), vec4(min(min(vec3((_67 > 0.0) ? _67 : 0.0, (_70 > 0.0) ? _70 : 0.0, (_73 > 0.0) ? _73 : 0.0), vec3(65504.0)) * ((abs(_78) <= 9.9999996802856924650656260769173e+37) ? clamp(_78, 0.0, 1.0) : 1.0), vec3(65504.0)), 1.0));
        break;
    } while(false);
}

