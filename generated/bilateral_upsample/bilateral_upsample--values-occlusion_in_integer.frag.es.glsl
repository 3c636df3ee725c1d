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
    vec2 _164 = min(vec2(_159 * 0.0322580635547637939453125, (_158 - _159) * 1.01587307453155517578125), vec2(1.0));
    vec2 _165 = vec2(_153);
    bvec2 _166 = bvec2(abs(_153) <= 9.9999996802856924650656260769173e+37);
    vec2 _167 = vec2(_166.x ? _164.x : _165.x, _166.y ? _164.y : _165.y);
    float _168 = _110.y;
    float _173 = (_168 > 0.0) ? min(_168, 31.984375) : 0.0;
    float _174 = floor(_173);
    vec2 _179 = min(vec2(_174 * 0.0322580635547637939453125, (_173 - _174) * 1.01587307453155517578125), vec2(1.0));
    vec2 _180 = vec2(_168);
    bvec2 _181 = bvec2(abs(_168) <= 9.9999996802856924650656260769173e+37);
    vec2 _182 = vec2(_181.x ? _179.x : _180.x, _181.y ? _179.y : _180.y);
    float _183 = _110.z;
    float _188 = (_183 > 0.0) ? min(_183, 31.984375) : 0.0;
    float _189 = floor(_188);
    vec2 _194 = min(vec2(_189 * 0.0322580635547637939453125, (_188 - _189) * 1.01587307453155517578125), vec2(1.0));
    vec2 _195 = vec2(_183);
    bvec2 _196 = bvec2(abs(_183) <= 9.9999996802856924650656260769173e+37);
    vec2 _197 = vec2(_196.x ? _194.x : _195.x, _196.y ? _194.y : _195.y);
    float _198 = _110.w;
    float _203 = (_198 > 0.0) ? min(_198, 31.984375) : 0.0;
    float _204 = floor(_203);
    vec2 _209 = min(vec2(_204 * 0.0322580635547637939453125, (_203 - _204) * 1.01587307453155517578125), vec2(1.0));
    vec2 _210 = vec2(_198);
    bvec2 _211 = bvec2(abs(_198) <= 9.9999996802856924650656260769173e+37);
    vec2 _212 = vec2(_211.x ? _209.x : _210.x, _211.y ? _209.y : _210.y);
    bool _215 = all(lessThanEqual(abs(_167), vec2(9.9999996802856924650656260769173e+37)));
    bool _219 = all(lessThanEqual(abs(_182), vec2(9.9999996802856924650656260769173e+37)));
    bool _223 = all(lessThanEqual(abs(_197), vec2(9.9999996802856924650656260769173e+37)));
    bool _227 = all(lessThanEqual(abs(_212), vec2(9.9999996802856924650656260769173e+37)));
    vec4 _229 = vec4(float(_215), float(_219), float(_223), float(_227));
    vec4 _232 = abs(vec4((abs(_134 - 0.5) <= 0.5) ? (((_144 > 0.0) && (_144 < min(parameters.gSkyDepth, 65504.0))) ? _144 : 65504.0) : 65504.0) - vec4(textureLod(gInCoarseDepth, _75, 0.0).x, textureLod(gInCoarseDepth, _82, 0.0).x, textureLod(gInCoarseDepth, _85, 0.0).x, textureLod(gInCoarseDepth, _79, 0.0).x));
    vec4 _238 = (vec4(_86, _87, _86, _87) * vec4(_70.yy, _69.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _232);
    bvec4 _239 = greaterThan(_229 * vec4(lessThanEqual(abs(_232), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _240 = vec4(_239.x ? _238.x : vec4(0.0).x, _239.y ? _238.y : vec4(0.0).y, _239.z ? _238.z : vec4(0.0).z, _239.w ? _238.w : vec4(0.0).w);
    bvec4 _241 = greaterThan(_240, vec4(0.0));
    vec4 _242 = vec4(_241.x ? _240.x : vec4(0.0).x, _241.y ? _240.y : vec4(0.0).y, _241.z ? _240.z : vec4(0.0).z, _241.w ? _240.w : vec4(0.0).w);
    float _243 = dot(_242, vec4(1.0));
    vec4 _244 = vec4(_239.x ? _232.x : vec4(1.9999999360571384930131252153835e+38).x, _239.y ? _232.y : vec4(1.9999999360571384930131252153835e+38).y, _239.z ? _232.z : vec4(1.9999999360571384930131252153835e+38).z, _239.w ? _232.w : vec4(1.9999999360571384930131252153835e+38).w);
    bvec4 _253 = lessThanEqual(_244, vec4(min(min(_244.x, _244.y), min(_244.z, _244.w))));
    vec4 _254 = vec4(_253.x ? _229.x : vec4(0.0).x, _253.y ? _229.y : vec4(0.0).y, _253.z ? _229.z : vec4(0.0).z, _253.w ? _229.w : vec4(0.0).w);
    vec4 _259 = _242 / vec4(_243);
    vec4 _263 = _254 / vec4(max(dot(_254, vec4(1.0)), 1.0));
    bvec4 _264 = bvec4((_243 >= 1.0000000031710768509710513471353e-30) && (_243 <= 9.9999996802856924650656260769173e+37));
    vec4 _265 = vec4(_264.x ? _259.x : _263.x, _264.y ? _259.y : _263.y, _264.z ? _259.z : _263.z, _264.w ? _259.w : _263.w);
    bvec2 _267 = bvec2(_215);
    bvec2 _271 = bvec2(_219);
    bvec2 _276 = bvec2(_223);
    bvec2 _281 = bvec2(_227);
    gOutUpsampled = vec4((((vec2(_267.x ? _167.x : vec2(0.0).x, _267.y ? _167.y : vec2(0.0).y) * _265.x) + (vec2(_271.x ? _182.x : vec2(0.0).x, _271.y ? _182.y : vec2(0.0).y) * _265.y)) + (vec2(_276.x ? _197.x : vec2(0.0).x, _276.y ? _197.y : vec2(0.0).y) * _265.z)) + (vec2(_281.x ? _212.x : vec2(0.0).x, _281.y ? _212.y : vec2(0.0).y) * _265.w), 0.0, 0.0);
}

