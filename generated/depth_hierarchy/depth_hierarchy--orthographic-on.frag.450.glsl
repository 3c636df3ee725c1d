#version 450

layout(binding = 0, std140) uniform DepthHierarchyParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

layout(binding = 1) uniform sampler2D gInDepth;

layout(location = 0) out vec4 gOutDepthHierarchy;

void main()
{
    vec2 _51 = floor(gl_FragCoord.xy);
    vec2 _79;
    float _80;
    if (_51.x >= parameters.gInputSize.x)
    {
        vec3 _62 = floor(vec3(0.5, 0.25, 0.125) * parameters.gInputSize.y);
        float _63 = parameters.gInputSize.y - _51.y;
        float _72 = (_63 <= _62.z) ? 16.0 : ((_63 <= _62.y) ? 8.0 : ((_63 <= _62.x) ? 4.0 : 2.0));
        _79 = _51 - vec2(parameters.gInputSize.x, parameters.gInputSize.y - floor((2.0 * parameters.gInputSize.y) / _72));
        _80 = _72;
    }
    else
    {
        _79 = _51;
        _80 = 1.0;
    }
    float _82 = floor(0.25 * _80);
    vec4 _100 = textureLod(gInDepth, (((_79 * _80) + mix(vec2((_80 - 1.0) - _82), vec2(_82), fract(_79.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gInputSize.zw, 0.0);
    float _101 = _100.x;
    float _110 = (abs(_101 - 0.5) <= 0.5) ? fma(_101, parameters.gLinearDepth.x, parameters.gLinearDepth.y) : 65504.0;
    gOutDepthHierarchy = vec4(((_110 > 0.0) && (_110 < min(parameters.gSkyDepth, 65504.0))) ? _110 : 65504.0, 0.0, 0.0, 0.0);
}

