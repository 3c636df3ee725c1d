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

uniform highp sampler2D gInCache;
uniform highp sampler2D gInCacheFiltered;

layout(location = 0) out vec4 gOutFiltered;

void main()
{
    vec2 _65 = parameters.gDirection * parameters.gOutputSize.zw;
    vec4 _69 = textureLod(gInCache, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    vec2 _73 = _65 * 3.5;
    vec4 _76 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_73), 0.0);
    float _77 = _76.x;
    vec2 _80 = vec2(_77, 0.0);
    bvec2 _81 = bvec2(abs(_77) <= 65504.0);
    vec2 _82 = vec2(_81.x ? _80.x : vec2(1.9999999233806324907308312004164e+36).x, _81.y ? _80.y : vec2(1.9999999233806324907308312004164e+36).y);
    float _83 = _76.w;
    float _84 = _82.x;
    vec2 _88 = _65 * 1.5;
    vec4 _91 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_88), 0.0);
    float _92 = _91.x;
    vec2 _95 = vec2(_92, 0.0);
    bvec2 _96 = bvec2(abs(_92) <= 65504.0);
    vec2 _97 = vec2(_96.x ? _95.x : vec2(1.9999999233806324907308312004164e+36).x, _96.y ? _95.y : vec2(1.9999999233806324907308312004164e+36).y);
    float _98 = _91.w;
    float _99 = _97.x;
    float _102 = _69.x;
    vec2 _105 = vec2(_102, 0.0);
    bvec2 _106 = bvec2(abs(_102) <= 65504.0);
    vec2 _107 = vec2(_106.x ? _105.x : vec2(1.9999999233806324907308312004164e+36).x, _106.y ? _105.y : vec2(1.9999999233806324907308312004164e+36).y);
    float _108 = _69.w;
    float _109 = _107.x;
    vec4 _114 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + _88, 0.0);
    float _115 = _114.x;
    vec2 _118 = vec2(_115, 0.0);
    bvec2 _119 = bvec2(abs(_115) <= 65504.0);
    vec2 _120 = vec2(_119.x ? _118.x : vec2(1.9999999233806324907308312004164e+36).x, _119.y ? _118.y : vec2(1.9999999233806324907308312004164e+36).y);
    float _121 = _114.w;
    float _122 = _120.x;
    vec4 _127 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + _73, 0.0);
    float _128 = _127.x;
    vec2 _131 = vec2(_128, 0.0);
    bvec2 _132 = bvec2(abs(_128) <= 65504.0);
    vec2 _133 = vec2(_132.x ? _131.x : vec2(1.9999999233806324907308312004164e+36).x, _132.y ? _131.y : vec2(1.9999999233806324907308312004164e+36).y);
    float _134 = _127.w;
    float _135 = _133.x;
    float _146 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_108 > 0.001000000047497451305389404296875) ? min(_108, 65504.0) : 0.001000000047497451305389404296875));
    float _147 = _69.z;
    float _153 = _147 / max(parameters.gConverged, 1.0);
    float _166 = (((((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0) * (1.0 - ((_153 > 0.0) ? min(_153, 1.0) : 0.0)) + 1.0) - 1.0) + parameters.gMinSmoothing;
    float _169 = (_166 > 0.0) ? min(_166, 16.0) : 0.0;
    bool _174 = (abs(_109) <= 9.9999996169031624536541560020822e+35) && (abs(_107.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _176 = vec3(_109, _107.y, _108).xy * 0.40261995792388916015625;
    bvec2 _177 = bvec2(_174);
    float _181 = abs(_83 - _108);
    float _185 = (_146 > 0.0) ? min(_146, 9.9999996169031624536541560020822e+35) : 0.0;
    float _190 = _169 * (((_181 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_185 * _181 + 1.0)) : 0.0) * 0.0544886849820613861083984375);
    bool _195 = (abs(_84) <= 9.9999996169031624536541560020822e+35) && (abs(_82.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _197 = vec3(_84, _82.y, _83).xy * _190;
    bvec2 _198 = bvec2(_195);
    float _204 = abs(_134 - _108);
    float _210 = _169 * (((_204 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_185 * _204 + 1.0)) : 0.0) * 0.0544886849820613861083984375);
    bool _215 = (abs(_135) <= 9.9999996169031624536541560020822e+35) && (abs(_133.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _217 = vec3(_135, _133.y, _134).xy * _210;
    bvec2 _218 = bvec2(_215);
    float _224 = abs(_98 - _108);
    float _230 = _169 * (((_224 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_185 * _224 + 1.0)) : 0.0) * 0.24420134723186492919921875);
    bool _235 = (abs(_99) <= 9.9999996169031624536541560020822e+35) && (abs(_97.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _237 = vec3(_99, _97.y, _98).xy * _230;
    bvec2 _238 = bvec2(_235);
    float _244 = abs(_121 - _108);
    float _250 = _169 * (((_244 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_185 * _244 + 1.0)) : 0.0) * 0.24420134723186492919921875);
    bool _255 = (abs(_122) <= 9.9999996169031624536541560020822e+35) && (abs(_120.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _257 = vec3(_122, _120.y, _121).xy * _250;
    bvec2 _258 = bvec2(_255);
    float _262 = ((((_174 ? 0.40261995792388916015625 : 0.0) + (_195 ? _190 : 0.0)) + (_215 ? _210 : 0.0)) + (_235 ? _230 : 0.0)) + (_255 ? _250 : 0.0);
    vec2 _265 = ((((vec2(_177.x ? _176.x : vec2(0.0).x, _177.y ? _176.y : vec2(0.0).y) + vec2(_198.x ? _197.x : vec2(0.0).x, _198.y ? _197.y : vec2(0.0).y)) + vec2(_218.x ? _217.x : vec2(0.0).x, _218.y ? _217.y : vec2(0.0).y)) + vec2(_238.x ? _237.x : vec2(0.0).x, _238.y ? _237.y : vec2(0.0).y)) + vec2(_258.x ? _257.x : vec2(0.0).x, _258.y ? _257.y : vec2(0.0).y)) / vec2(_262);
    bvec2 _266 = bvec2(_262 > 1.0000000031710768509710513471353e-30);
    gOutFiltered = vec4(vec2(_266.x ? _265.x : vec2(0.0).x, _266.y ? _265.y : vec2(0.0).y).x, 0.0, (_147 > 0.0) ? min(_147, 255.0) : 0.0, min((_108 > 0.0) ? min(_108, 9.9999996169031624536541560020822e+35) : 0.0, 65504.0));
}

