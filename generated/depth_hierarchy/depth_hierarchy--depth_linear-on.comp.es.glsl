#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform DepthHierarchyParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

layout(binding = 16, r32f) uniform writeonly highp image2D gOutDepthHierarchy;
layout(binding = 1) uniform highp sampler2D gInDepth;

void main()
{
    vec2 _54 = floor(vec2(gl_GlobalInvocationID.xy) + vec2(0.5));
    vec2 _82;
    float _83;
    if (_54.x >= parameters.gInputSize.x)
    {
        vec3 _65 = floor(vec3(0.5, 0.25, 0.125) * parameters.gInputSize.y);
        float _66 = parameters.gInputSize.y - _54.y;
        float _75 = (_66 <= _65.z) ? 16.0 : ((_66 <= _65.y) ? 8.0 : ((_66 <= _65.x) ? 4.0 : 2.0));
        _82 = _54 - vec2(parameters.gInputSize.x, parameters.gInputSize.y - floor((2.0 * parameters.gInputSize.y) / _75));
        _83 = _75;
    }
    else
    {
        _82 = _54;
        _83 = 1.0;
    }
    float _85 = floor(0.25 * _83);
    vec4 _103 = textureLod(gInDepth, (((_82 * _83) + mix(vec2((_83 - 1.0) - _85), vec2(_85), fract(_82.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gInputSize.zw, 0.0);
    float _104 = _103.x;
    imageStore(gOutDepthHierarchy, ivec2(gl_GlobalInvocationID.xy), vec4(((_104 > 0.0) && (_104 < min(parameters.gSkyDepth, 65504.0))) ? _104 : 65504.0, 0.0, 0.0, 0.0));
}

