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
    vec2 _57 = floor(vec2(gl_GlobalInvocationID.xy) + vec2(0.5));
    vec2 _85;
    float _86;
    if (_57.x >= parameters.gInputSize.x)
    {
        vec3 _68 = floor(vec3(0.5, 0.25, 0.125) * parameters.gInputSize.y);
        float _69 = parameters.gInputSize.y - _57.y;
        float _78 = (_69 <= _68.z) ? 16.0 : ((_69 <= _68.y) ? 8.0 : ((_69 <= _68.x) ? 4.0 : 2.0));
        _85 = _57 - vec2(parameters.gInputSize.x, parameters.gInputSize.y - floor((2.0 * parameters.gInputSize.y) / _78));
        _86 = _78;
    }
    else
    {
        _85 = _57;
        _86 = 1.0;
    }
    float _88 = floor(0.25 * _86);
    vec4 _106 = textureLod(gInDepth, (((_85 * _86) + mix(vec2((_86 - 1.0) - _88), vec2(_88), fract(_85.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gInputSize.zw, 0.0);
    float _107 = _106.x;
    float _118 = (abs(_107 - 0.5) <= 0.5) ? (1.0 / max(fma(_107, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30)) : 65504.0;
    imageStore(gOutDepthHierarchy, ivec2(gl_GlobalInvocationID.xy), vec4(((_118 > 0.0) && (_118 < min(parameters.gSkyDepth, 65504.0))) ? _118 : 65504.0, 0.0, 0.0, 0.0));
}

