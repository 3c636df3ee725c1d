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

layout(binding = 1) uniform sampler2D gInCache;

layout(location = 0) out vec4 gOutFiltered;

void main()
{
    vec2 _64 = parameters.gDirection * parameters.gOutputSize.zw;
    vec4 _68 = textureLod(gInCache, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _69 = _68.x;
    vec2 _74 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_69, 0.0), bvec2(abs(_69) <= 65504.0));
    float _75 = _68.w;
    float _76 = _74.x;
    vec2 _80 = _64 * 1.0;
    vec4 _83 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_80), 0.0);
    float _84 = _83.x;
    vec2 _89 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_84, 0.0), bvec2(abs(_84) <= 65504.0));
    float _90 = _83.w;
    float _91 = _89.x;
    vec4 _96 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _80), 0.0);
    float _97 = _96.x;
    vec2 _102 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_97, 0.0), bvec2(abs(_97) <= 65504.0));
    float _103 = _96.w;
    float _104 = _102.x;
    vec2 _108 = _64 * 2.0;
    vec4 _111 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_108), 0.0);
    float _112 = _111.x;
    vec2 _117 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_112, 0.0), bvec2(abs(_112) <= 65504.0));
    float _118 = _111.w;
    float _119 = _117.x;
    vec4 _124 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _108), 0.0);
    float _125 = _124.x;
    vec2 _130 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_125, 0.0), bvec2(abs(_125) <= 65504.0));
    float _131 = _124.w;
    float _132 = _130.x;
    vec2 _136 = _64 * 3.0;
    vec4 _139 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_136), 0.0);
    float _140 = _139.x;
    vec2 _145 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_140, 0.0), bvec2(abs(_140) <= 65504.0));
    float _146 = _139.w;
    float _147 = _145.x;
    vec4 _152 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _136), 0.0);
    float _153 = _152.x;
    vec2 _158 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_153, 0.0), bvec2(abs(_153) <= 65504.0));
    float _159 = _152.w;
    float _160 = _158.x;
    vec2 _164 = _64 * 4.0;
    vec4 _167 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_164), 0.0);
    float _168 = _167.x;
    vec2 _173 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_168, 0.0), bvec2(abs(_168) <= 65504.0));
    float _174 = _167.w;
    float _175 = _173.x;
    vec4 _180 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _164), 0.0);
    float _181 = _180.x;
    vec2 _186 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_181, 0.0), bvec2(abs(_181) <= 65504.0));
    float _187 = _180.w;
    float _188 = _186.x;
    float _199 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_75 > 0.001000000047497451305389404296875) ? min(_75, 65504.0) : 0.001000000047497451305389404296875));
    float _200 = _68.z;
    float _206 = _200 / max(parameters.gConverged, 1.0);
    float _219 = (fma(((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0, 1.0 - ((_206 > 0.0) ? min(_206, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
    float _222 = (_219 > 0.0) ? min(_219, 16.0) : 0.0;
    bool _227 = (abs(_76) <= 9.9999996169031624536541560020822e+35) && (abs(_74.y) <= 9.9999996169031624536541560020822e+35);
    float _233 = _222 * 0.122100673615932464599609375;
    float _235 = abs(_90 - _75);
    float _239 = (_199 > 0.0) ? min(_199, 9.9999996169031624536541560020822e+35) : 0.0;
    float _243 = _233 * ((_235 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_239, _235, 1.0)) : 0.0);
    bool _248 = (abs(_91) <= 9.9999996169031624536541560020822e+35) && (abs(_89.y) <= 9.9999996169031624536541560020822e+35);
    float _257 = abs(_103 - _75);
    float _262 = _233 * ((_257 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_239, _257, 1.0)) : 0.0);
    bool _267 = (abs(_104) <= 9.9999996169031624536541560020822e+35) && (abs(_102.y) <= 9.9999996169031624536541560020822e+35);
    float _276 = abs(_118 - _75);
    float _281 = _233 * ((_276 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_239, _276, 1.0)) : 0.0);
    bool _286 = (abs(_119) <= 9.9999996169031624536541560020822e+35) && (abs(_117.y) <= 9.9999996169031624536541560020822e+35);
    float _295 = abs(_131 - _75);
    float _300 = _233 * ((_295 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_239, _295, 1.0)) : 0.0);
    bool _305 = (abs(_132) <= 9.9999996169031624536541560020822e+35) && (abs(_130.y) <= 9.9999996169031624536541560020822e+35);
    float _313 = _222 * 0.02724434249103069305419921875;
    float _315 = abs(_146 - _75);
    float _320 = _313 * ((_315 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_239, _315, 1.0)) : 0.0);
    bool _325 = (abs(_147) <= 9.9999996169031624536541560020822e+35) && (abs(_145.y) <= 9.9999996169031624536541560020822e+35);
    float _334 = abs(_159 - _75);
    float _339 = _313 * ((_334 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_239, _334, 1.0)) : 0.0);
    bool _344 = (abs(_160) <= 9.9999996169031624536541560020822e+35) && (abs(_158.y) <= 9.9999996169031624536541560020822e+35);
    vec2 _349 = (((((mix(vec2(0.0), vec3(_76, _74.y, _75).xy * 0.40261995792388916015625, bvec2(_227)) + mix(vec2(0.0), vec3(_91, _89.y, _90).xy * _243, bvec2(_248))) + mix(vec2(0.0), vec3(_104, _102.y, _103).xy * _262, bvec2(_267))) + mix(vec2(0.0), vec3(_119, _117.y, _118).xy * _281, bvec2(_286))) + mix(vec2(0.0), vec3(_132, _130.y, _131).xy * _300, bvec2(_305))) + mix(vec2(0.0), vec3(_147, _145.y, _146).xy * _320, bvec2(_325))) + mix(vec2(0.0), vec3(_160, _158.y, _159).xy * _339, bvec2(_344));
    float _353 = abs(_174 - _75);
    float _358 = _313 * ((_353 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_239, _353, 1.0)) : 0.0);
    bool _363 = (abs(_175) <= 9.9999996169031624536541560020822e+35) && (abs(_173.y) <= 9.9999996169031624536541560020822e+35);
    float _372 = abs(_187 - _75);
    float _377 = _313 * ((_372 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_239, _372, 1.0)) : 0.0);
    bool _382 = (abs(_188) <= 9.9999996169031624536541560020822e+35) && (abs(_186.y) <= 9.9999996169031624536541560020822e+35);
    float _389 = ((((((((_227 ? 0.40261995792388916015625 : 0.0) + (_248 ? _243 : 0.0)) + (_267 ? _262 : 0.0)) + (_286 ? _281 : 0.0)) + (_305 ? _300 : 0.0)) + (_325 ? _320 : 0.0)) + (_344 ? _339 : 0.0)) + (_363 ? _358 : 0.0)) + (_382 ? _377 : 0.0);
    gOutFiltered = vec4(mix(vec2(0.0), ((_349 + mix(vec2(0.0), vec3(_175, _173.y, _174).xy * _358, bvec2(_363))) + mix(vec2(0.0), vec3(_188, _186.y, _187).xy * _377, bvec2(_382))) / vec2(_389), bvec2(_389 > 1.0000000031710768509710513471353e-30)).x, 0.0, (_200 > 0.0) ? min(_200, 255.0) : 0.0, min((_75 > 0.0) ? min(_75, 9.9999996169031624536541560020822e+35) : 0.0, 65504.0));
}

