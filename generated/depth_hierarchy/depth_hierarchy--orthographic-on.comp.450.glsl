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
    vec2 _56 = floor(vec2(gl_GlobalInvocationID.xy) + vec2(0.5));
    vec2 _84;
    float _85;
    if (_56.x >= parameters.gInputSize.x)
    {
        vec3 _67 = floor(vec3(0.5, 0.25, 0.125) * parameters.gInputSize.y);
        float _68 = parameters.gInputSize.y - _56.y;
        float _77 = (_68 <= _67.z) ? 16.0 : ((_68 <= _67.y) ? 8.0 : ((_68 <= _67.x) ? 4.0 : 2.0));
        _84 = _56 - vec2(parameters.gInputSize.x, parameters.gInputSize.y - floor((2.0 * parameters.gInputSize.y) / _77));
        _85 = _77;
    }
    else
    {
        _84 = _56;
        _85 = 1.0;
    }
    float _87 = floor(0.25 * _85);
    vec4 _105 = textureLod(gInDepth, (((_84 * _85) + mix(vec2((_85 - 1.0) - _87), vec2(_87), fract(_84.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gInputSize.zw, 0.0);
    float _106 = _105.x;
    float _115 = (abs(_106 - 0.5) <= 0.5) ? fma(_106, parameters.gLinearDepth.x, parameters.gLinearDepth.y) : 65504.0;
    imageStore(gOutDepthHierarchy, ivec2(gl_GlobalInvocationID.xy), vec4(((_115 > 0.0) && (_115 < min(parameters.gSkyDepth, 65504.0))) ? _115 : 65504.0, 0.0, 0.0, 0.0));
}

