#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform BilateralFilterParameters
{
    vec4 gOutputSize;
    vec2 gDirection;
    vec2 gDepthAmplitude;
    float gConverged;
    float gMaxSmoothing;
    float gMinSmoothing;
} parameters;

uniform highp sampler2D gInCacheState;
uniform highp sampler2D gInCache;
uniform highp sampler2D gInCacheFiltered;

layout(location = 0) out vec4 gOutFiltered;

void main()
{
    vec2 _60 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _63 = parameters.gDirection * parameters.gOutputSize.zw;
    vec4 _71 = textureLod(gInCache, _60, 0.0);
    float _72 = _71.x;
    float _73 = _71.y;
    vec4 _79 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + (_63 * (-3.5)), 0.0);
    float _80 = _79.x;
    vec4 _85 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + (_63 * (-1.5)), 0.0);
    float _86 = _85.x;
    vec4 _91 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + (_63 * 1.5), 0.0);
    float _92 = _91.x;
    vec4 _97 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + (_63 * 3.5), 0.0);
    float _98 = _97.x;
    float _106 = textureLod(gInCacheState, _60, 0.0).x / max(parameters.gConverged, 1.0);
    float _119 = (((((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0) * (1.0 - ((_106 > 0.0) ? min(_106, 1.0) : 0.0)) + 1.0) - 1.0) + parameters.gMinSmoothing;
    float _122 = (_119 > 0.0) ? min(_119, 16.0) : 0.0;
    float _128 = min(_73, 65504.0);
    float _131 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_73 > 0.001000000047497451305389404296875) ? _128 : 0.001000000047497451305389404296875));
    float _133 = abs(_79.y - _73);
    float _137 = (_131 > 0.0) ? min(_131, 9.9999996169031624536541560020822e+35) : 0.0;
    float _142 = 0.0544886849820613861083984375 * (_122 * ((_133 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_137 * _133 + 1.0)) : 0.0));
    bool _144 = abs(_80) <= 65504.0;
    float _149 = abs(_85.y - _73);
    float _155 = 0.24420134723186492919921875 * (_122 * ((_149 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_137 * _149 + 1.0)) : 0.0));
    bool _157 = abs(_86) <= 65504.0;
    bool _164 = abs(_72) <= 65504.0;
    float _171 = abs(_91.y - _73);
    float _177 = 0.24420134723186492919921875 * (_122 * ((_171 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_137 * _171 + 1.0)) : 0.0));
    bool _179 = abs(_92) <= 65504.0;
    float _186 = abs(_97.y - _73);
    float _192 = 0.0544886849820613861083984375 * (_122 * ((_186 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_137 * _186 + 1.0)) : 0.0));
    bool _194 = abs(_98) <= 65504.0;
    float _199 = ((((_144 ? _142 : 0.0) + (_157 ? _155 : 0.0)) + (_164 ? 0.40261995792388916015625 : 0.0)) + (_179 ? _177 : 0.0)) + (_194 ? _192 : 0.0);
    gOutFiltered = vec4((_199 > 1.0000000031710768509710513471353e-30) ? ((((((_144 ? (_142 * _80) : 0.0) + (_157 ? (_155 * _86) : 0.0)) + (_164 ? (0.40261995792388916015625 * _72) : 0.0)) + (_179 ? (_177 * _92) : 0.0)) + (_194 ? (_192 * _98) : 0.0)) * (1.0 / _199)) : 0.0, (_73 > 0.0) ? _128 : 0.0, 0.0, 0.0);
}

