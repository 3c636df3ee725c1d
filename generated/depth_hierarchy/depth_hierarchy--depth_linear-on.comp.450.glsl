#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform DepthHierarchyParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutDepthHierarchy;
layout(binding = 1) uniform sampler2D gInDepth;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _66 = floor(vec2(gl_GlobalInvocationID.xy) + vec2(0.5));
        vec2 _94;
        float _95;
        if (_66.x >= parameters.gInputSize.x)
        {
            vec3 _77 = floor(vec3(0.5, 0.25, 0.125) * parameters.gInputSize.y);
            float _78 = parameters.gInputSize.y - _66.y;
            float _87 = (_78 <= _77.z) ? 16.0 : ((_78 <= _77.y) ? 8.0 : ((_78 <= _77.x) ? 4.0 : 2.0));
            _94 = _66 - vec2(parameters.gInputSize.x, parameters.gInputSize.y - floor((2.0 * parameters.gInputSize.y) / _87));
            _95 = _87;
        }
        else
        {
            _94 = _66;
            _95 = 1.0;
        }
        float _97 = floor(0.25 * _95);
        vec4 _115 = textureLod(gInDepth, (((_94 * _95) + mix(vec2((_95 - 1.0) - _97), vec2(_97), fract(_94.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gInputSize.zw, 0.0);
        float _116 = _115.x;
        imageStore(gOutDepthHierarchy, ivec2(gl_GlobalInvocationID.xy), vec4(((_116 > 0.0) && (_116 < min(parameters.gSkyDepth, 65504.0))) ? _116 : 65504.0, 0.0, 0.0, 0.0));
        break;
    } while(false);
}

