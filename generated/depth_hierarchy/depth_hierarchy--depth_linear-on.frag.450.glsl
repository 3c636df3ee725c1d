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
    vec2 _49 = floor(gl_FragCoord.xy);
    vec2 _77;
    float _78;
    if (_49.x >= parameters.gInputSize.x)
    {
        vec3 _60 = floor(vec3(0.5, 0.25, 0.125) * parameters.gInputSize.y);
        float _61 = parameters.gInputSize.y - _49.y;
        float _70 = (_61 <= _60.z) ? 16.0 : ((_61 <= _60.y) ? 8.0 : ((_61 <= _60.x) ? 4.0 : 2.0));
        _77 = _49 - vec2(parameters.gInputSize.x, parameters.gInputSize.y - floor((2.0 * parameters.gInputSize.y) / _70));
        _78 = _70;
    }
    else
    {
        _77 = _49;
        _78 = 1.0;
    }
    float _80 = floor(0.25 * _78);
    vec4 _98 = textureLod(gInDepth, (((_77 * _78) + mix(vec2((_78 - 1.0) - _80), vec2(_80), fract(_77.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gInputSize.zw, 0.0);
    float _99 = _98.x;
    gOutDepthHierarchy = vec4(((_99 > 0.0) && (_99 < min(parameters.gSkyDepth, 65504.0))) ? _99 : 65504.0, 0.0, 0.0, 0.0);
}

