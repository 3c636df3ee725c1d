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
} parameters;

uniform highp sampler2D gInCache;
uniform highp sampler2D gInCacheFiltered;

layout(location = 0) out vec4 gOutFiltered;

void main()
{
    vec2 _64 = parameters.gDirection * parameters.gOutputSize.zw;
    vec4 _68 = textureLod(gInCache, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    vec2 _72 = _64 * 3.5;
    vec4 _75 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_72), 0.0);
    float _76 = _75.x;
    vec2 _79 = vec2(_76, 0.0);
    bvec2 _80 = bvec2(abs(_76) <= 65504.0);
    vec2 _81 = vec2(_80.x ? _79.x : vec2(1.9999999233806324907308312004164e+36).x, _80.y ? _79.y : vec2(1.9999999233806324907308312004164e+36).y);
    float _82 = _75.w;
    float _83 = _81.x;
    vec2 _87 = _64 * 1.5;
    vec4 _90 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_87), 0.0);
    float _91 = _90.x;
    vec2 _94 = vec2(_91, 0.0);
    bvec2 _95 = bvec2(abs(_91) <= 65504.0);
    vec2 _96 = vec2(_95.x ? _94.x : vec2(1.9999999233806324907308312004164e+36).x, _95.y ? _94.y : vec2(1.9999999233806324907308312004164e+36).y);
    float _97 = _90.w;
    float _98 = _96.x;
    float _101 = _68.x;
    vec2 _104 = vec2(_101, 0.0);
    bvec2 _105 = bvec2(abs(_101) <= 65504.0);
    vec2 _106 = vec2(_105.x ? _104.x : vec2(1.9999999233806324907308312004164e+36).x, _105.y ? _104.y : vec2(1.9999999233806324907308312004164e+36).y);
    float _107 = _68.w;
    float _108 = _106.x;
    vec4 _113 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + _87, 0.0);
    float _114 = _113.x;
    vec2 _117 = vec2(_114, 0.0);
    bvec2 _118 = bvec2(abs(_114) <= 65504.0);
    vec2 _119 = vec2(_118.x ? _117.x : vec2(1.9999999233806324907308312004164e+36).x, _118.y ? _117.y : vec2(1.9999999233806324907308312004164e+36).y);
    float _120 = _113.w;
    float _121 = _119.x;
    vec4 _126 = textureLod(gInCacheFiltered, gl_FragCoord.xy * parameters.gOutputSize.zw + _72, 0.0);
    float _127 = _126.x;
    vec2 _130 = vec2(_127, 0.0);
    bvec2 _131 = bvec2(abs(_127) <= 65504.0);
    vec2 _132 = vec2(_131.x ? _130.x : vec2(1.9999999233806324907308312004164e+36).x, _131.y ? _130.y : vec2(1.9999999233806324907308312004164e+36).y);
    float _133 = _126.w;
    float _134 = _132.x;
    float _145 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_107 > 0.001000000047497451305389404296875) ? min(_107, 65504.0) : 0.001000000047497451305389404296875));
    float _146 = _68.z;
    float _152 = _146 / max(parameters.gConverged, 1.0);
    float _161 = (((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0) * (1.0 - ((_152 > 0.0) ? min(_152, 1.0) : 0.0)) + 1.0;
    float _164 = (_161 > 0.0) ? min(_161, 16.0) : 0.0;
    bool _169 = (abs(_108) <= 9.9999996169031624536541560020822e+35) && (abs(_106.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _171 = vec3(_108, _106.y, _107).xy * 0.40261995792388916015625;
    bvec2 _172 = bvec2(_169);
    float _176 = abs(_82 - _107);
    float _180 = (_145 > 0.0) ? min(_145, 9.9999996169031624536541560020822e+35) : 0.0;
    float _185 = _164 * (((_176 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_180 * _176 + 1.0)) : 0.0) * 0.0544886849820613861083984375);
    bool _190 = (abs(_83) <= 9.9999996169031624536541560020822e+35) && (abs(_81.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _192 = vec3(_83, _81.y, _82).xy * _185;
    bvec2 _193 = bvec2(_190);
    float _199 = abs(_133 - _107);
    float _205 = _164 * (((_199 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_180 * _199 + 1.0)) : 0.0) * 0.0544886849820613861083984375);
    bool _210 = (abs(_134) <= 9.9999996169031624536541560020822e+35) && (abs(_132.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _212 = vec3(_134, _132.y, _133).xy * _205;
    bvec2 _213 = bvec2(_210);
    float _219 = abs(_97 - _107);
    float _225 = _164 * (((_219 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_180 * _219 + 1.0)) : 0.0) * 0.24420134723186492919921875);
    bool _230 = (abs(_98) <= 9.9999996169031624536541560020822e+35) && (abs(_96.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _232 = vec3(_98, _96.y, _97).xy * _225;
    bvec2 _233 = bvec2(_230);
    float _239 = abs(_120 - _107);
    float _245 = _164 * (((_239 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_180 * _239 + 1.0)) : 0.0) * 0.24420134723186492919921875);
    bool _250 = (abs(_121) <= 9.9999996169031624536541560020822e+35) && (abs(_119.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _252 = vec3(_121, _119.y, _120).xy * _245;
    bvec2 _253 = bvec2(_250);
    float _257 = ((((_169 ? 0.40261995792388916015625 : 0.0) + (_190 ? _185 : 0.0)) + (_210 ? _205 : 0.0)) + (_230 ? _225 : 0.0)) + (_250 ? _245 : 0.0);
    vec2 _260 = ((((vec2(_172.x ? _171.x : vec2(0.0).x, _172.y ? _171.y : vec2(0.0).y) + vec2(_193.x ? _192.x : vec2(0.0).x, _193.y ? _192.y : vec2(0.0).y)) + vec2(_213.x ? _212.x : vec2(0.0).x, _213.y ? _212.y : vec2(0.0).y)) + vec2(_233.x ? _232.x : vec2(0.0).x, _233.y ? _232.y : vec2(0.0).y)) + vec2(_253.x ? _252.x : vec2(0.0).x, _253.y ? _252.y : vec2(0.0).y)) / vec2(_257);
    bvec2 _261 = bvec2(_257 > 1.0000000031710768509710513471353e-30);
    gOutFiltered = vec4(vec2(_261.x ? _260.x : vec2(0.0).x, _261.y ? _260.y : vec2(0.0).y).x, 0.0, (_146 > 0.0) ? min(_146, 255.0) : 0.0, min((_107 > 0.0) ? min(_107, 9.9999996169031624536541560020822e+35) : 0.0, 65504.0));
}

