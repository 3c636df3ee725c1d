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
layout(binding = 2) uniform sampler2D gInCacheFiltered;
layout(binding = 4) uniform sampler2D gInCacheStateFiltered;

layout(location = 0) out vec4 gOutFiltered;

void main()
{
    vec2 _65 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _68 = parameters.gDirection * parameters.gOutputSize.zw;
    vec4 _72 = textureLod(gInCacheState, _65, 0.0);
    vec2 _77 = textureLod(gInCache, _65, 0.0).xy;
    float _78 = _72.y;
    vec2 _80 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _68 * (-3.5));
    vec2 _89 = textureLod(gInCacheFiltered, _80, 0.0).xy;
    vec2 _92 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _68 * (-1.5));
    vec2 _97 = textureLod(gInCacheFiltered, _92, 0.0).xy;
    vec2 _100 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _68 * 1.5);
    vec2 _105 = textureLod(gInCacheFiltered, _100, 0.0).xy;
    vec2 _108 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _68 * 3.5);
    vec2 _113 = textureLod(gInCacheFiltered, _108, 0.0).xy;
    float _121 = _72.x / max(parameters.gConverged, 1.0);
    float _134 = (fma(((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0, 1.0 - ((_121 > 0.0) ? min(_121, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
    float _137 = (_134 > 0.0) ? min(_134, 16.0) : 0.0;
    float _146 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_78 > 0.001000000047497451305389404296875) ? min(_78, 65504.0) : 0.001000000047497451305389404296875));
    float _148 = abs(textureLod(gInCacheStateFiltered, _80, 0.0).y - _78);
    float _152 = (_146 > 0.0) ? min(_146, 9.9999996169031624536541560020822e+35) : 0.0;
    float _157 = 0.0544886849820613861083984375 * (_137 * ((_148 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_152, _148, 1.0)) : 0.0));
    bool _160 = all(lessThanEqual(abs(_89), vec2(65504.0)));
    float _166 = abs(textureLod(gInCacheStateFiltered, _92, 0.0).y - _78);
    float _172 = 0.24420134723186492919921875 * (_137 * ((_166 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_152, _166, 1.0)) : 0.0));
    bool _175 = all(lessThanEqual(abs(_97), vec2(65504.0)));
    bool _184 = all(lessThanEqual(abs(_77), vec2(65504.0)));
    float _192 = abs(textureLod(gInCacheStateFiltered, _100, 0.0).y - _78);
    float _198 = 0.24420134723186492919921875 * (_137 * ((_192 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_152, _192, 1.0)) : 0.0));
    bool _201 = all(lessThanEqual(abs(_105), vec2(65504.0)));
    float _209 = abs(textureLod(gInCacheStateFiltered, _108, 0.0).y - _78);
    float _215 = 0.0544886849820613861083984375 * (_137 * ((_209 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_152, _209, 1.0)) : 0.0));
    bool _218 = all(lessThanEqual(abs(_113), vec2(65504.0)));
    float _224 = ((((_160 ? _157 : 0.0) + (_175 ? _172 : 0.0)) + (_184 ? 0.40261995792388916015625 : 0.0)) + (_201 ? _198 : 0.0)) + (_218 ? _215 : 0.0);
    gOutFiltered = vec4(mix(vec2(0.0), ((((mix(vec2(0.0), _89 * _157, bvec2(_160)) + mix(vec2(0.0), _97 * _172, bvec2(_175))) + mix(vec2(0.0), _77 * 0.40261995792388916015625, bvec2(_184))) + mix(vec2(0.0), _105 * _198, bvec2(_201))) + mix(vec2(0.0), _113 * _215, bvec2(_218))) * (1.0 / _224), bvec2(_224 > 1.0000000031710768509710513471353e-30)), 0.0, 0.0);
}

