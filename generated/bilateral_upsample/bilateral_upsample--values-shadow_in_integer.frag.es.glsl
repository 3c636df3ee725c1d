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

uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gInFiltered;
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
    vec4 _103 = vec4(textureLod(gInCoarseDepth, _69, 0.0).x, textureLod(gInCoarseDepth, _76, 0.0).x, textureLod(gInCoarseDepth, _79, 0.0).x, textureLod(gInCoarseDepth, _73, 0.0).x);
    vec4 _104 = min(_103, vec4(65504.0));
    bvec4 _105 = greaterThan(_103, vec4(0.0));
    vec4 _110 = textureLod(gInFiltered, _69, 0.0);
    float _111 = _110.x;
    float _116 = (_111 > 0.0) ? min(_111, 31.984375) : 0.0;
    float _117 = floor(_116);
    vec2 _123 = vec2(_117 * 0.0322580635547637939453125, min((_116 - _117) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _124 = bvec2(abs(_111) <= 65504.0);
    vec2 _125 = vec2(_124.x ? _123.x : vec2(1.9999999360571384930131252153835e+38).x, _124.y ? _123.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _127 = textureLod(gInFiltered, _76, 0.0);
    float _128 = _127.x;
    float _133 = (_128 > 0.0) ? min(_128, 31.984375) : 0.0;
    float _134 = floor(_133);
    vec2 _140 = vec2(_134 * 0.0322580635547637939453125, min((_133 - _134) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _141 = bvec2(abs(_128) <= 65504.0);
    vec2 _142 = vec2(_141.x ? _140.x : vec2(1.9999999360571384930131252153835e+38).x, _141.y ? _140.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _144 = textureLod(gInFiltered, _79, 0.0);
    float _145 = _144.x;
    float _150 = (_145 > 0.0) ? min(_145, 31.984375) : 0.0;
    float _151 = floor(_150);
    vec2 _157 = vec2(_151 * 0.0322580635547637939453125, min((_150 - _151) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _158 = bvec2(abs(_145) <= 65504.0);
    vec2 _159 = vec2(_158.x ? _157.x : vec2(1.9999999360571384930131252153835e+38).x, _158.y ? _157.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _161 = textureLod(gInFiltered, _73, 0.0);
    float _162 = _161.x;
    float _167 = (_162 > 0.0) ? min(_162, 31.984375) : 0.0;
    float _168 = floor(_167);
    vec2 _174 = vec2(_168 * 0.0322580635547637939453125, min((_167 - _168) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _175 = bvec2(abs(_162) <= 65504.0);
    vec2 _176 = vec2(_175.x ? _174.x : vec2(1.9999999360571384930131252153835e+38).x, _175.y ? _174.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _180 = float(abs(_125.x) <= 65504.0);
    bvec2 _182 = bvec2(_180 > 0.5);
    float _187 = float(abs(_142.x) <= 65504.0);
    bvec2 _189 = bvec2(_187 > 0.5);
    float _194 = float(abs(_159.x) <= 65504.0);
    bvec2 _196 = bvec2(_194 > 0.5);
    float _201 = float(abs(_176.x) <= 65504.0);
    bvec2 _204 = bvec2(_201 > 0.5);
    vec4 _213 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _214 = _213.x;
    float _224 = 1.0 / max(_214 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _236 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_214 - 0.5) <= 0.5) ? (((_224 > 0.0) && (_224 < min(parameters.gSkyDepth, 65504.0))) ? _224 : 65504.0) : 65504.0) - vec4(_105.x ? _104.x : vec4(65504.0).x, _105.y ? _104.y : vec4(65504.0).y, _105.z ? _104.z : vec4(65504.0).z, _105.w ? _104.w : vec4(65504.0).w));
    vec4 _243 = ((((vec4(_82, _83, _82, _83) * vec4(_81.yy, _80.yy)) * vec4(_180, _187, _194, _201)) * _236.yxxx) * _236.zzyy) * _236.wwwz;
    vec4 _247 = _243 * (1.0 / max(dot(_243, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((vec2(_182.x ? _125.x : vec2(0.0).x, _182.y ? _125.y : vec2(0.0).y) * _247.x) + (vec2(_189.x ? _142.x : vec2(0.0).x, _189.y ? _142.y : vec2(0.0).y) * _247.y)) + (vec2(_196.x ? _159.x : vec2(0.0).x, _196.y ? _159.y : vec2(0.0).y) * _247.z)) + (vec2(_204.x ? _176.x : vec2(0.0).x, _204.y ? _176.y : vec2(0.0).y) * _247.w), 0.0, 0.0);
}

