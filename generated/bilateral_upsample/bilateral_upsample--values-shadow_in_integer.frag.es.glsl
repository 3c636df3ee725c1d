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
    vec2 _63 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _64 = floor(_63);
    vec2 _65 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _66 = _65 - vec2(1.0);
    vec2 _69 = (clamp(_64, vec2(0.0), _66) + vec2(0.5)) / _65;
    vec2 _73 = (clamp(_64 + vec2(1.0), vec2(0.0), _66) + vec2(0.5)) / _65;
    vec2 _76 = vec2(_73.x, _69.y);
    vec2 _79 = vec2(_69.x, _73.y);
    vec2 _80 = _63 - _64;
    vec2 _81 = vec2(1.0) - _80;
    float _82 = _81.x;
    float _83 = _80.x;
    vec4 _92 = textureLod(gInFiltered, _69, 0.0);
    float _93 = _92.x;
    float _98 = (_93 > 0.0) ? min(_93, 31.984375) : 0.0;
    float _99 = floor(_98);
    vec2 _105 = vec2(_99 * 0.0322580635547637939453125, min((_98 - _99) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _106 = bvec2(abs(_93) <= 65504.0);
    vec2 _107 = vec2(_106.x ? _105.x : vec2(1.9999999360571384930131252153835e+38).x, _106.y ? _105.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _109 = textureLod(gInFiltered, _76, 0.0);
    float _110 = _109.x;
    float _115 = (_110 > 0.0) ? min(_110, 31.984375) : 0.0;
    float _116 = floor(_115);
    vec2 _122 = vec2(_116 * 0.0322580635547637939453125, min((_115 - _116) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _123 = bvec2(abs(_110) <= 65504.0);
    vec2 _124 = vec2(_123.x ? _122.x : vec2(1.9999999360571384930131252153835e+38).x, _123.y ? _122.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _126 = textureLod(gInFiltered, _79, 0.0);
    float _127 = _126.x;
    float _132 = (_127 > 0.0) ? min(_127, 31.984375) : 0.0;
    float _133 = floor(_132);
    vec2 _139 = vec2(_133 * 0.0322580635547637939453125, min((_132 - _133) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _140 = bvec2(abs(_127) <= 65504.0);
    vec2 _141 = vec2(_140.x ? _139.x : vec2(1.9999999360571384930131252153835e+38).x, _140.y ? _139.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _143 = textureLod(gInFiltered, _73, 0.0);
    float _144 = _143.x;
    float _149 = (_144 > 0.0) ? min(_144, 31.984375) : 0.0;
    float _150 = floor(_149);
    vec2 _156 = vec2(_150 * 0.0322580635547637939453125, min((_149 - _150) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _157 = bvec2(abs(_144) <= 65504.0);
    vec2 _158 = vec2(_157.x ? _156.x : vec2(1.9999999360571384930131252153835e+38).x, _157.y ? _156.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _162 = float(abs(_107.x) <= 65504.0);
    bvec2 _164 = bvec2(_162 > 0.5);
    float _169 = float(abs(_124.x) <= 65504.0);
    bvec2 _171 = bvec2(_169 > 0.5);
    float _176 = float(abs(_141.x) <= 65504.0);
    bvec2 _178 = bvec2(_176 > 0.5);
    float _183 = float(abs(_158.x) <= 65504.0);
    bvec2 _186 = bvec2(_183 > 0.5);
    vec4 _202 = vec4(textureLod(gInCoarseDepth, _69, 0.0).x, textureLod(gInCoarseDepth, _76, 0.0).x, textureLod(gInCoarseDepth, _79, 0.0).x, textureLod(gInCoarseDepth, _73, 0.0).x);
    vec4 _203 = min(_202, vec4(65504.0));
    bvec4 _204 = greaterThan(_202, vec4(0.0));
    vec4 _213 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _214 = _213.x;
    float _224 = 1.0 / max(_214 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _236 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_214 - 0.5) <= 0.5) ? (((_224 > 0.0) && (_224 < min(parameters.gSkyDepth, 65504.0))) ? _224 : 65504.0) : 65504.0) - vec4(_204.x ? _203.x : vec4(65504.0).x, _204.y ? _203.y : vec4(65504.0).y, _204.z ? _203.z : vec4(65504.0).z, _204.w ? _203.w : vec4(65504.0).w));
    vec4 _243 = ((((vec4(_82, _83, _82, _83) * vec4(_81.yy, _80.yy)) * vec4(_162, _169, _176, _183)) * _236.yxxx) * _236.zzyy) * _236.wwwz;
    vec4 _247 = _243 * (1.0 / max(dot(_243, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((vec2(_164.x ? _107.x : vec2(0.0).x, _164.y ? _107.y : vec2(0.0).y) * _247.x) + (vec2(_171.x ? _124.x : vec2(0.0).x, _171.y ? _124.y : vec2(0.0).y) * _247.y)) + (vec2(_178.x ? _141.x : vec2(0.0).x, _178.y ? _141.y : vec2(0.0).y) * _247.z)) + (vec2(_186.x ? _158.x : vec2(0.0).x, _186.y ? _158.y : vec2(0.0).y) * _247.w), 0.0, 0.0);
}

