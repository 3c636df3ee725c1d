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
    vec2 _67 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _68 = floor(_67);
    vec2 _69 = _67 - _68;
    vec2 _70 = vec2(1.0) - _69;
    vec2 _71 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _72 = _71 - vec2(1.0);
    vec2 _75 = (clamp(_68, vec2(0.0), _72) + vec2(0.5)) / _71;
    vec2 _79 = (clamp(_68 + vec2(1.0), vec2(0.0), _72) + vec2(0.5)) / _71;
    vec2 _82 = vec2(_79.x, _75.y);
    vec2 _85 = vec2(_75.x, _79.y);
    float _86 = _70.x;
    float _87 = _69.x;
    vec4 _107 = vec4(textureLod(gInFiltered, _75, 0.0).x, textureLod(gInFiltered, _82, 0.0).x, textureLod(gInFiltered, _85, 0.0).x, textureLod(gInFiltered, _79, 0.0).x);
    bvec4 _109 = lessThanEqual(abs(_107), vec4(65504.0));
    vec4 _110 = vec4(_109.x ? _107.x : vec4(1.9999999360571384930131252153835e+38).x, _109.y ? _107.y : vec4(1.9999999360571384930131252153835e+38).y, _109.z ? _107.z : vec4(1.9999999360571384930131252153835e+38).z, _109.w ? _107.w : vec4(1.9999999360571384930131252153835e+38).w);
    vec4 _133 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _134 = _133.x;
    float _144 = 1.0 / max(_134 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    float _153 = _110.x;
    float _158 = (_153 > 0.0) ? min(_153, 31.984375) : 0.0;
    float _159 = floor(_158);
    vec2 _165 = min(vec2(_159 * 0.0322580635547637939453125, (_158 - _159) * 1.01587307453155517578125), vec2(1.0)).yx;
    vec2 _166 = vec2(_153);
    bvec2 _167 = bvec2(abs(_153) <= 9.9999996802856924650656260769173e+37);
    vec2 _168 = vec2(_167.x ? _165.x : _166.x, _167.y ? _165.y : _166.y);
    float _169 = _110.y;
    float _174 = (_169 > 0.0) ? min(_169, 31.984375) : 0.0;
    float _175 = floor(_174);
    vec2 _181 = min(vec2(_175 * 0.0322580635547637939453125, (_174 - _175) * 1.01587307453155517578125), vec2(1.0)).yx;
    vec2 _182 = vec2(_169);
    bvec2 _183 = bvec2(abs(_169) <= 9.9999996802856924650656260769173e+37);
    vec2 _184 = vec2(_183.x ? _181.x : _182.x, _183.y ? _181.y : _182.y);
    float _185 = _110.z;
    float _190 = (_185 > 0.0) ? min(_185, 31.984375) : 0.0;
    float _191 = floor(_190);
    vec2 _197 = min(vec2(_191 * 0.0322580635547637939453125, (_190 - _191) * 1.01587307453155517578125), vec2(1.0)).yx;
    vec2 _198 = vec2(_185);
    bvec2 _199 = bvec2(abs(_185) <= 9.9999996802856924650656260769173e+37);
    vec2 _200 = vec2(_199.x ? _197.x : _198.x, _199.y ? _197.y : _198.y);
    float _201 = _110.w;
    float _206 = (_201 > 0.0) ? min(_201, 31.984375) : 0.0;
    float _207 = floor(_206);
    vec2 _213 = min(vec2(_207 * 0.0322580635547637939453125, (_206 - _207) * 1.01587307453155517578125), vec2(1.0)).yx;
    vec2 _214 = vec2(_201);
    bvec2 _215 = bvec2(abs(_201) <= 9.9999996802856924650656260769173e+37);
    vec2 _216 = vec2(_215.x ? _213.x : _214.x, _215.y ? _213.y : _214.y);
    bool _219 = all(lessThanEqual(abs(_168), vec2(9.9999996802856924650656260769173e+37)));
    bool _223 = all(lessThanEqual(abs(_184), vec2(9.9999996802856924650656260769173e+37)));
    bool _227 = all(lessThanEqual(abs(_200), vec2(9.9999996802856924650656260769173e+37)));
    bool _231 = all(lessThanEqual(abs(_216), vec2(9.9999996802856924650656260769173e+37)));
    vec4 _233 = vec4(float(_219), float(_223), float(_227), float(_231));
    vec4 _236 = abs(vec4((abs(_134 - 0.5) <= 0.5) ? (((_144 > 0.0) && (_144 < min(parameters.gSkyDepth, 65504.0))) ? _144 : 65504.0) : 65504.0) - vec4(textureLod(gInCoarseDepth, _75, 0.0).x, textureLod(gInCoarseDepth, _82, 0.0).x, textureLod(gInCoarseDepth, _85, 0.0).x, textureLod(gInCoarseDepth, _79, 0.0).x));
    vec4 _242 = (vec4(_86, _87, _86, _87) * vec4(_70.yy, _69.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _236);
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
    gOutUpsampled = vec4((((vec2(_271.x ? _168.x : vec2(0.0).x, _271.y ? _168.y : vec2(0.0).y) * _269.x) + (vec2(_275.x ? _184.x : vec2(0.0).x, _275.y ? _184.y : vec2(0.0).y) * _269.y)) + (vec2(_280.x ? _200.x : vec2(0.0).x, _280.y ? _200.y : vec2(0.0).y) * _269.z)) + (vec2(_285.x ? _216.x : vec2(0.0).x, _285.y ? _216.y : vec2(0.0).y) * _269.w), 0.0, 0.0);
}

