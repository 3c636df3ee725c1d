#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

uniform highp sampler2D gInFiltered;
uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _71 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _72 = floor(_71);
    vec2 _73 = _71 - _72;
    vec2 _74 = vec2(1.0) - _73;
    vec2 _75 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _76 = _75 - vec2(1.0);
    vec2 _79 = (clamp(_72, vec2(0.0), _76) + vec2(0.5)) / _75;
    vec2 _83 = (clamp(_72 + vec2(1.0), vec2(0.0), _76) + vec2(0.5)) / _75;
    vec2 _86 = vec2(_83.x, _79.y);
    vec2 _89 = vec2(_79.x, _83.y);
    float _90 = _74.x;
    float _91 = _73.x;
    vec4 _111 = vec4(textureLod(gInFiltered, _79, 0.0).x, textureLod(gInFiltered, _86, 0.0).x, textureLod(gInFiltered, _89, 0.0).x, textureLod(gInFiltered, _83, 0.0).x);
    bvec4 _113 = lessThanEqual(abs(_111), vec4(65504.0));
    vec4 _114 = vec4(_113.x ? _111.x : vec4(1.9999999360571384930131252153835e+38).x, _113.y ? _111.y : vec4(1.9999999360571384930131252153835e+38).y, _113.z ? _111.z : vec4(1.9999999360571384930131252153835e+38).z, _113.w ? _111.w : vec4(1.9999999360571384930131252153835e+38).w);
    float _130 = _114.x;
    float _135 = (_130 > 0.0) ? min(_130, 31.984375) : 0.0;
    float _136 = floor(_135);
    vec2 _142 = min(vec2(_136 * 0.0322580635547637939453125, (_135 - _136) * 1.01587307453155517578125), vec2(1.0)).yx;
    vec2 _143 = vec2(_130);
    bvec2 _144 = bvec2(abs(_130) <= 9.9999996802856924650656260769173e+37);
    vec2 _145 = vec2(_144.x ? _142.x : _143.x, _144.y ? _142.y : _143.y);
    float _146 = _114.y;
    float _151 = (_146 > 0.0) ? min(_146, 31.984375) : 0.0;
    float _152 = floor(_151);
    vec2 _158 = min(vec2(_152 * 0.0322580635547637939453125, (_151 - _152) * 1.01587307453155517578125), vec2(1.0)).yx;
    vec2 _159 = vec2(_146);
    bvec2 _160 = bvec2(abs(_146) <= 9.9999996802856924650656260769173e+37);
    vec2 _161 = vec2(_160.x ? _158.x : _159.x, _160.y ? _158.y : _159.y);
    float _162 = _114.z;
    float _167 = (_162 > 0.0) ? min(_162, 31.984375) : 0.0;
    float _168 = floor(_167);
    vec2 _174 = min(vec2(_168 * 0.0322580635547637939453125, (_167 - _168) * 1.01587307453155517578125), vec2(1.0)).yx;
    vec2 _175 = vec2(_162);
    bvec2 _176 = bvec2(abs(_162) <= 9.9999996802856924650656260769173e+37);
    vec2 _177 = vec2(_176.x ? _174.x : _175.x, _176.y ? _174.y : _175.y);
    float _178 = _114.w;
    float _183 = (_178 > 0.0) ? min(_178, 31.984375) : 0.0;
    float _184 = floor(_183);
    vec2 _190 = min(vec2(_184 * 0.0322580635547637939453125, (_183 - _184) * 1.01587307453155517578125), vec2(1.0)).yx;
    vec2 _191 = vec2(_178);
    bvec2 _192 = bvec2(abs(_178) <= 9.9999996802856924650656260769173e+37);
    vec2 _193 = vec2(_192.x ? _190.x : _191.x, _192.y ? _190.y : _191.y);
    vec4 _197 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _198 = _197.x;
    float _208 = 1.0 / max(_198 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    bool _219 = all(lessThanEqual(abs(_145), vec2(9.9999996802856924650656260769173e+37)));
    bool _223 = all(lessThanEqual(abs(_161), vec2(9.9999996802856924650656260769173e+37)));
    bool _227 = all(lessThanEqual(abs(_177), vec2(9.9999996802856924650656260769173e+37)));
    bool _231 = all(lessThanEqual(abs(_193), vec2(9.9999996802856924650656260769173e+37)));
    vec4 _233 = vec4(float(_219), float(_223), float(_227), float(_231));
    vec4 _236 = abs(vec4((abs(_198 - 0.5) <= 0.5) ? (((_208 > 0.0) && (_208 < min(parameters.gSkyDepth, 65504.0))) ? _208 : 65504.0) : 65504.0) - vec4(textureLod(gInCoarseDepth, _79, 0.0).x, textureLod(gInCoarseDepth, _86, 0.0).x, textureLod(gInCoarseDepth, _89, 0.0).x, textureLod(gInCoarseDepth, _83, 0.0).x));
    vec4 _242 = (vec4(_90, _91, _90, _91) * vec4(_74.yy, _73.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _236);
    bvec4 _243 = greaterThan(_233 * vec4(lessThanEqual(abs(_236), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _244 = vec4(_243.x ? _242.x : vec4(0.0).x, _243.y ? _242.y : vec4(0.0).y, _243.z ? _242.z : vec4(0.0).z, _243.w ? _242.w : vec4(0.0).w);
    bvec4 _245 = greaterThan(_244, vec4(0.0));
    vec4 _246 = vec4(_245.x ? _244.x : vec4(0.0).x, _245.y ? _244.y : vec4(0.0).y, _245.z ? _244.z : vec4(0.0).z, _245.w ? _244.w : vec4(0.0).w);
    float _247 = dot(_246, vec4(1.0));
    vec4 _248 = vec4(_243.x ? _236.x : vec4(1.9999999360571384930131252153835e+38).x, _243.y ? _236.y : vec4(1.9999999360571384930131252153835e+38).y, _243.z ? _236.z : vec4(1.9999999360571384930131252153835e+38).z, _243.w ? _236.w : vec4(1.9999999360571384930131252153835e+38).w);
    bvec4 _257 = lessThanEqual(_248, vec4(min(min(_248.x, _248.y), min(_248.z, _248.w))));
    vec4 _258 = vec4(_257.x ? _233.x : vec4(0.0).x, _257.y ? _233.y : vec4(0.0).y, _257.z ? _233.z : vec4(0.0).z, _257.w ? _233.w : vec4(0.0).w);
    vec4 _263 = _246 / vec4(_247);
    vec4 _267 = _258 / vec4(max(dot(_258, vec4(1.0)), 1.0));
    bvec4 _268 = bvec4((_247 >= 1.0000000031710768509710513471353e-30) && (_247 <= 9.9999996802856924650656260769173e+37));
    vec4 _269 = vec4(_268.x ? _263.x : _267.x, _268.y ? _263.y : _267.y, _268.z ? _263.z : _267.z, _268.w ? _263.w : _267.w);
    bvec2 _271 = bvec2(_219);
    bvec2 _275 = bvec2(_223);
    bvec2 _280 = bvec2(_227);
    bvec2 _285 = bvec2(_231);
    gOutUpsampled = vec4((((vec2(_271.x ? _145.x : vec2(0.0).x, _271.y ? _145.y : vec2(0.0).y) * _269.x) + (vec2(_275.x ? _161.x : vec2(0.0).x, _275.y ? _161.y : vec2(0.0).y) * _269.y)) + (vec2(_280.x ? _177.x : vec2(0.0).x, _280.y ? _177.y : vec2(0.0).y) * _269.z)) + (vec2(_285.x ? _193.x : vec2(0.0).x, _285.y ? _193.y : vec2(0.0).y) * _269.w), 0.0, 0.0);
}

