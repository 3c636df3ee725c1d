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
uniform highp sampler2D gInCacheStateFiltered;

layout(location = 0) out vec4 gOutFiltered;

void main()
{
    vec2 _65 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _68 = parameters.gDirection * parameters.gOutputSize.zw;
    vec4 _72 = textureLod(gInCacheState, _65, 0.0);
    vec2 _77 = textureLod(gInCache, _65, 0.0).xy;
    float _78 = _72.y;
    vec2 _80 = gl_FragCoord.xy * parameters.gOutputSize.zw + (_68 * (-3.5));
    vec2 _89 = textureLod(gInCacheFiltered, _80, 0.0).xy;
    vec2 _92 = gl_FragCoord.xy * parameters.gOutputSize.zw + (_68 * (-1.5));
    vec2 _97 = textureLod(gInCacheFiltered, _92, 0.0).xy;
    vec2 _100 = gl_FragCoord.xy * parameters.gOutputSize.zw + (_68 * 1.5);
    vec2 _105 = textureLod(gInCacheFiltered, _100, 0.0).xy;
    vec2 _108 = gl_FragCoord.xy * parameters.gOutputSize.zw + (_68 * 3.5);
    vec2 _113 = textureLod(gInCacheFiltered, _108, 0.0).xy;
    float _121 = _72.x / max(parameters.gConverged, 1.0);
    float _134 = (((((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0) * (1.0 - ((_121 > 0.0) ? min(_121, 1.0) : 0.0)) + 1.0) - 1.0) + parameters.gMinSmoothing;
    float _137 = (_134 > 0.0) ? min(_134, 16.0) : 0.0;
    float _146 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_78 > 0.001000000047497451305389404296875) ? min(_78, 65504.0) : 0.001000000047497451305389404296875));
    float _148 = abs(textureLod(gInCacheStateFiltered, _80, 0.0).y - _78);
    float _152 = (_146 > 0.0) ? min(_146, 9.9999996169031624536541560020822e+35) : 0.0;
    float _157 = 0.0544886849820613861083984375 * (_137 * ((_148 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_152 * _148 + 1.0)) : 0.0));
    bool _160 = all(lessThanEqual(abs(_89), vec2(65504.0)));
    vec2 _161 = _89 * _157;
    bvec2 _162 = bvec2(_160);
    float _166 = abs(textureLod(gInCacheStateFiltered, _92, 0.0).y - _78);
    float _172 = 0.24420134723186492919921875 * (_137 * ((_166 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_152 * _166 + 1.0)) : 0.0));
    bool _175 = all(lessThanEqual(abs(_97), vec2(65504.0)));
    vec2 _176 = _97 * _172;
    bvec2 _177 = bvec2(_175);
    bool _184 = all(lessThanEqual(abs(_77), vec2(65504.0)));
    vec2 _185 = _77 * 0.40261995792388916015625;
    bvec2 _186 = bvec2(_184);
    float _192 = abs(textureLod(gInCacheStateFiltered, _100, 0.0).y - _78);
    float _198 = 0.24420134723186492919921875 * (_137 * ((_192 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_152 * _192 + 1.0)) : 0.0));
    bool _201 = all(lessThanEqual(abs(_105), vec2(65504.0)));
    vec2 _202 = _105 * _198;
    bvec2 _203 = bvec2(_201);
    float _209 = abs(textureLod(gInCacheStateFiltered, _108, 0.0).y - _78);
    float _215 = 0.0544886849820613861083984375 * (_137 * ((_209 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_152 * _209 + 1.0)) : 0.0));
    bool _218 = all(lessThanEqual(abs(_113), vec2(65504.0)));
    vec2 _219 = _113 * _215;
    bvec2 _220 = bvec2(_218);
    float _224 = ((((_160 ? _157 : 0.0) + (_175 ? _172 : 0.0)) + (_184 ? 0.40261995792388916015625 : 0.0)) + (_201 ? _198 : 0.0)) + (_218 ? _215 : 0.0);
    vec2 _227 = ((((vec2(_162.x ? _161.x : vec2(0.0).x, _162.y ? _161.y : vec2(0.0).y) + vec2(_177.x ? _176.x : vec2(0.0).x, _177.y ? _176.y : vec2(0.0).y)) + vec2(_186.x ? _185.x : vec2(0.0).x, _186.y ? _185.y : vec2(0.0).y)) + vec2(_203.x ? _202.x : vec2(0.0).x, _203.y ? _202.y : vec2(0.0).y)) + vec2(_220.x ? _219.x : vec2(0.0).x, _220.y ? _219.y : vec2(0.0).y)) * (1.0 / _224);
    bvec2 _228 = bvec2(_224 > 1.0000000031710768509710513471353e-30);
    gOutFiltered = vec4(vec2(_228.x ? _227.x : vec2(0.0).x, _228.y ? _227.y : vec2(0.0).y), 0.0, 0.0);
}

