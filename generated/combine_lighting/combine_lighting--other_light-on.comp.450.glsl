#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform CombineLightingParameters
{
    vec4 gOutputSize;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutLit;
layout(binding = 1) uniform sampler2D gInLighting;
layout(binding = 2) uniform sampler2D gInAmbientLight;
layout(binding = 3) uniform sampler2D gInSunLight;
layout(binding = 4) uniform sampler2D gInOtherLight;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _62 = (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * parameters.gOutputSize.zw;
        vec4 _66 = textureLod(gInLighting, _62, 0.0);
        vec4 _70 = textureLod(gInAmbientLight, _62, 0.0);
        float _71 = _70.x;
        float _74 = _70.y;
        float _77 = _70.z;
        float _82 = _66.x;
        vec4 _91 = textureLod(gInSunLight, _62, 0.0);
        float _92 = _91.x;
        float _95 = _91.y;
        float _98 = _91.z;
        float _103 = _66.y;
        vec4 _113 = textureLod(gInOtherLight, _62, 0.0);
        float _114 = _113.x;
        float _117 = _113.y;
        float _120 = _113.z;
        imageStore(gOutLit, ivec2(gl_GlobalInvocationID.xy), vec4(min(((min(vec3((_71 > 0.0) ? _71 : 0.0, (_74 > 0.0) ? _74 : 0.0, (_77 > 0.0) ? _77 : 0.0), vec3(65504.0)) * ((abs(_82) <= 9.9999996802856924650656260769173e+37) ? clamp(_82, 0.0, 1.0) : 1.0)) + (min(vec3((_92 > 0.0) ? _92 : 0.0, (_95 > 0.0) ? _95 : 0.0, (_98 > 0.0) ? _98 : 0.0), vec3(65504.0)) * ((abs(_103) <= 9.9999996802856924650656260769173e+37) ? clamp(_103, 0.0, 1.0) : 1.0))) + min(vec3((_114 > 0.0) ? _114 : 0.0, (_117 > 0.0) ? _117 : 0.0, (_120 > 0.0) ? _120 : 0.0), vec3(65504.0)), vec3(65504.0)), 1.0));
        break;
    } while(false);
}

