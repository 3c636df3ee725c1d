#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform DepthHierarchyParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutDepthHierarchy;

void main()
{
    vec2 _52 = floor(gl_FragCoord.xy);
    vec2 _80;
    float _81;
    if (_52.x >= parameters.gInputSize.x)
    {
        vec3 _63 = floor(vec3(0.5, 0.25, 0.125) * parameters.gInputSize.y);
        float _64 = parameters.gInputSize.y - _52.y;
        float _73 = (_64 <= _63.z) ? 16.0 : ((_64 <= _63.y) ? 8.0 : ((_64 <= _63.x) ? 4.0 : 2.0));
        _80 = _52 - vec2(parameters.gInputSize.x, parameters.gInputSize.y - floor((2.0 * parameters.gInputSize.y) / _73));
        _81 = _73;
    }
    else
    {
        _80 = _52;
        _81 = 1.0;
    }
    float _83 = floor(0.25 * _81);
    vec4 _101 = textureLod(gInDepth, (((_80 * _81) + mix(vec2((_81 - 1.0) - _83), vec2(_83), fract(_80.yx * 0.5) * 2.0)) + vec2(0.5)) * parameters.gInputSize.zw, 0.0);
    float _102 = _101.x;
    float _113 = (abs(_102 - 0.5) <= 0.5) ? (1.0 / max(_102 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30)) : 65504.0;
    gOutDepthHierarchy = vec4(((_113 > 0.0) && (_113 < min(parameters.gSkyDepth, 65504.0))) ? _113 : 65504.0, 0.0, 0.0, 0.0);
}

