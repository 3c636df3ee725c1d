#version 450

layout(binding = 0, std140) uniform BilateralFilterParameters
{
    vec4 gOutputSize;
    vec2 gDirection;
    vec2 gDepthAmplitude;
    float gConverged;
    float gMaxSmoothing;
    float gMinSmoothing;
} parameters;

layout(binding = 3) uniform sampler2D gInCacheState;
layout(binding = 1) uniform sampler2D gInCache;

layout(location = 0) out vec4 gOutFiltered;

void main()
{
    vec2 _61 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _64 = parameters.gDirection * parameters.gOutputSize.zw;
    vec4 _72 = textureLod(gInCache, _61, 0.0);
    float _73 = _72.x;
    float _74 = _72.y;
    vec4 _78 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _64 * (-4.0)), 0.0);
    float _79 = _78.x;
    vec4 _84 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _64 * (-3.0)), 0.0);
    float _85 = _84.x;
    vec4 _90 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _64 * (-2.0)), 0.0);
    float _91 = _90.x;
    vec4 _96 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _64 * (-1.0)), 0.0);
    float _97 = _96.x;
    vec4 _102 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _64 * 1.0), 0.0);
    float _103 = _102.x;
    vec4 _108 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _64 * 2.0), 0.0);
    float _109 = _108.x;
    vec4 _114 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _64 * 3.0), 0.0);
    float _115 = _114.x;
    vec4 _120 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _64 * 4.0), 0.0);
    float _121 = _120.x;
    float _129 = textureLod(gInCacheState, _61, 0.0).x / max(parameters.gConverged, 1.0);
    float _142 = (fma(((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0, 1.0 - ((_129 > 0.0) ? min(_129, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
    float _145 = (_142 > 0.0) ? min(_142, 16.0) : 0.0;
    float _151 = min(_74, 65504.0);
    float _154 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_74 > 0.001000000047497451305389404296875) ? _151 : 0.001000000047497451305389404296875));
    float _156 = abs(_78.y - _74);
    float _160 = (_154 > 0.0) ? min(_154, 9.9999996169031624536541560020822e+35) : 0.0;
    float _165 = 0.02724434249103069305419921875 * (_145 * ((_156 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _156, 1.0)) : 0.0));
    bool _167 = abs(_79) <= 65504.0;
    float _172 = abs(_84.y - _74);
    float _178 = 0.02724434249103069305419921875 * (_145 * ((_172 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _172, 1.0)) : 0.0));
    bool _180 = abs(_85) <= 65504.0;
    float _187 = abs(_90.y - _74);
    float _193 = 0.122100673615932464599609375 * (_145 * ((_187 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _187, 1.0)) : 0.0));
    bool _195 = abs(_91) <= 65504.0;
    float _202 = abs(_96.y - _74);
    float _208 = 0.122100673615932464599609375 * (_145 * ((_202 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _202, 1.0)) : 0.0));
    bool _210 = abs(_97) <= 65504.0;
    bool _217 = abs(_73) <= 65504.0;
    float _224 = abs(_102.y - _74);
    float _230 = 0.122100673615932464599609375 * (_145 * ((_224 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _224, 1.0)) : 0.0));
    bool _232 = abs(_103) <= 65504.0;
    float _239 = abs(_108.y - _74);
    float _245 = 0.122100673615932464599609375 * (_145 * ((_239 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _239, 1.0)) : 0.0));
    bool _247 = abs(_109) <= 65504.0;
    float _254 = abs(_114.y - _74);
    float _260 = 0.02724434249103069305419921875 * (_145 * ((_254 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _254, 1.0)) : 0.0));
    bool _262 = abs(_115) <= 65504.0;
    float _269 = abs(_120.y - _74);
    float _275 = 0.02724434249103069305419921875 * (_145 * ((_269 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _269, 1.0)) : 0.0));
    bool _277 = abs(_121) <= 65504.0;
    float _282 = ((((((((_167 ? _165 : 0.0) + (_180 ? _178 : 0.0)) + (_195 ? _193 : 0.0)) + (_210 ? _208 : 0.0)) + (_217 ? 0.40261995792388916015625 : 0.0)) + (_232 ? _230 : 0.0)) + (_247 ? _245 : 0.0)) + (_262 ? _260 : 0.0)) + (_277 ? _275 : 0.0);
    gOutFiltered = vec4((_282 > 1.0000000031710768509710513471353e-30) ? ((((((((((_167 ? (_165 * _79) : 0.0) + (_180 ? (_178 * _85) : 0.0)) + (_195 ? (_193 * _91) : 0.0)) + (_210 ? (_208 * _97) : 0.0)) + (_217 ? (0.40261995792388916015625 * _73) : 0.0)) + (_232 ? (_230 * _103) : 0.0)) + (_247 ? (_245 * _109) : 0.0)) + (_262 ? (_260 * _115) : 0.0)) + (_277 ? (_275 * _121) : 0.0)) * (1.0 / _282)) : 0.0, (_74 > 0.0) ? _151 : 0.0, 0.0, 0.0);
}

