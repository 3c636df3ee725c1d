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
        vec2 _68 = floor(vec2(gl_GlobalInvocationID.xy) + vec2(0.5));
        vec2 _96;
        float _97;
        if (_68.x >= parameters.gInputSize.x)
        {
            vec3 _79 = floor(vec3(0.5, 0.25, 0.125) * parameters.gInputSize.y);
            float _80 = parameters.gInputSize.y - _68.y;
            float _89 = (_80 <= _79.z) ? 16.0 : ((_80 <= _79.y) ? 8.0 : ((_80 <= _79.x) ? 4.0 : 2.0));
            _96 = _68 - vec2(parameters.gInputSize.x, parameters.gInputSize.y - floor((2.0 * parameters.gInputSize.y) / _89));
            _97 = _89;
        }
        else
        {
            _96 = _68;
            _97 = 1.0;
        }
        float _99 = floor(0.25 * _97);
        vec4 _117 = textureLod(gInDepth, (((_96 * _97) + mix(vec2((_97 - 1.0) - _99), vec2(_99), fract(_96.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gInputSize.zw, 0.0);
        float _118 = _117.x;
        float _127 = (abs(_118 - 0.5) <= 0.5) ? fma(_118, parameters.gLinearDepth.x, parameters.gLinearDepth.y) : 65504.0;
        imageStore(gOutDepthHierarchy, ivec2(gl_GlobalInvocationID.xy), vec4(((_127 > 0.0) && (_127 < min(parameters.gSkyDepth, 65504.0))) ? _127 : 65504.0, 0.0, 0.0, 0.0));
        break;
    } while(false);
}

