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
        vec2 _69 = floor(vec2(gl_GlobalInvocationID.xy) + vec2(0.5));
        vec2 _97;
        float _98;
        if (_69.x >= parameters.gInputSize.x)
        {
            vec3 _80 = floor(vec3(0.5, 0.25, 0.125) * parameters.gInputSize.y);
            float _81 = parameters.gInputSize.y - _69.y;
            float _90 = (_81 <= _80.z) ? 16.0 : ((_81 <= _80.y) ? 8.0 : ((_81 <= _80.x) ? 4.0 : 2.0));
            _97 = _69 - vec2(parameters.gInputSize.x, parameters.gInputSize.y - floor((2.0 * parameters.gInputSize.y) / _90));
            _98 = _90;
        }
        else
        {
            _97 = _69;
            _98 = 1.0;
        }
        float _100 = floor(0.25 * _98);
        vec4 _118 = textureLod(gInDepth, (((_97 * _98) + mix(vec2((_98 - 1.0) - _100), vec2(_100), fract(_97.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gInputSize.zw, 0.0);
        float _119 = _118.x;
        float _130 = (abs(_119 - 0.5) <= 0.5) ? (1.0 / max(fma(_119, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30)) : 65504.0;
        imageStore(gOutDepthHierarchy, ivec2(gl_GlobalInvocationID.xy), vec4(((_130 > 0.0) && (_130 < min(parameters.gSkyDepth, 65504.0))) ? _130 : 65504.0, 0.0, 0.0, 0.0));
        break;
    } while(false);
}

