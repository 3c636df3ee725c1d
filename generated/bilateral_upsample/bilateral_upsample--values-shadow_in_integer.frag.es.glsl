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
    vec2 _64 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _65 = floor(_64);
    vec2 _66 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _67 = _66 - vec2(1.0);
    vec2 _70 = (clamp(_65, vec2(0.0), _67) + vec2(0.5)) / _66;
    vec2 _74 = (clamp(_65 + vec2(1.0), vec2(0.0), _67) + vec2(0.5)) / _66;
    vec2 _77 = vec2(_74.x, _70.y);
    vec2 _80 = vec2(_70.x, _74.y);
    vec2 _81 = _64 - _65;
    vec2 _82 = vec2(1.0) - _81;
    float _83 = _82.x;
    float _84 = _81.x;
    vec4 _93 = textureLod(gInFiltered, _70, 0.0);
    float _94 = _93.x;
    vec4 _96 = textureLod(gInFiltered, _77, 0.0);
    float _97 = _96.x;
    vec4 _99 = textureLod(gInFiltered, _80, 0.0);
    float _100 = _99.x;
    vec4 _102 = textureLod(gInFiltered, _74, 0.0);
    float _103 = _102.x;
    float _108 = (_94 > 0.0) ? min(_94, 31.984375) : 0.0;
    float _109 = floor(_108);
    vec2 _115 = min(vec2(_109 * 0.0322580635547637939453125, (_108 - _109) * 1.01587307453155517578125), vec2(1.0)).yx;
    bvec2 _116 = bvec2(abs(_94) <= 65504.0);
    vec2 _117 = vec2(_116.x ? _115.x : vec2(1.9999999360571384930131252153835e+38).x, _116.y ? _115.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _122 = (_97 > 0.0) ? min(_97, 31.984375) : 0.0;
    float _123 = floor(_122);
    vec2 _129 = min(vec2(_123 * 0.0322580635547637939453125, (_122 - _123) * 1.01587307453155517578125), vec2(1.0)).yx;
    bvec2 _130 = bvec2(abs(_97) <= 65504.0);
    vec2 _131 = vec2(_130.x ? _129.x : vec2(1.9999999360571384930131252153835e+38).x, _130.y ? _129.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _136 = (_100 > 0.0) ? min(_100, 31.984375) : 0.0;
    float _137 = floor(_136);
    vec2 _143 = min(vec2(_137 * 0.0322580635547637939453125, (_136 - _137) * 1.01587307453155517578125), vec2(1.0)).yx;
    bvec2 _144 = bvec2(abs(_100) <= 65504.0);
    vec2 _145 = vec2(_144.x ? _143.x : vec2(1.9999999360571384930131252153835e+38).x, _144.y ? _143.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _150 = (_103 > 0.0) ? min(_103, 31.984375) : 0.0;
    float _151 = floor(_150);
    vec2 _157 = min(vec2(_151 * 0.0322580635547637939453125, (_150 - _151) * 1.01587307453155517578125), vec2(1.0)).yx;
    bvec2 _158 = bvec2(abs(_103) <= 65504.0);
    vec2 _159 = vec2(_158.x ? _157.x : vec2(1.9999999360571384930131252153835e+38).x, _158.y ? _157.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _163 = float(all(lessThanEqual(abs(_117), vec2(65504.0))));
    bvec2 _165 = bvec2(_163 > 0.5);
    float _170 = float(all(lessThanEqual(abs(_131), vec2(65504.0))));
    bvec2 _172 = bvec2(_170 > 0.5);
    float _177 = float(all(lessThanEqual(abs(_145), vec2(65504.0))));
    bvec2 _179 = bvec2(_177 > 0.5);
    float _184 = float(all(lessThanEqual(abs(_159), vec2(65504.0))));
    bvec2 _187 = bvec2(_184 > 0.5);
    vec4 _203 = vec4(textureLod(gInCoarseDepth, _70, 0.0).x, textureLod(gInCoarseDepth, _77, 0.0).x, textureLod(gInCoarseDepth, _80, 0.0).x, textureLod(gInCoarseDepth, _74, 0.0).x);
    vec4 _204 = min(_203, vec4(65504.0));
    bvec4 _205 = greaterThan(_203, vec4(0.0));
    vec4 _214 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _215 = _214.x;
    float _225 = 1.0 / max(_215 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _237 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_215 - 0.5) <= 0.5) ? (((_225 > 0.0) && (_225 < min(parameters.gSkyDepth, 65504.0))) ? _225 : 65504.0) : 65504.0) - vec4(_205.x ? _204.x : vec4(65504.0).x, _205.y ? _204.y : vec4(65504.0).y, _205.z ? _204.z : vec4(65504.0).z, _205.w ? _204.w : vec4(65504.0).w));
    vec4 _244 = ((((vec4(_83, _84, _83, _84) * vec4(_82.yy, _81.yy)) * vec4(_163, _170, _177, _184)) * _237.yxxx) * _237.zzyy) * _237.wwwz;
    vec4 _248 = _244 * (1.0 / max(dot(_244, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((vec2(_165.x ? _117.x : vec2(0.0).x, _165.y ? _117.y : vec2(0.0).y) * _248.x) + (vec2(_172.x ? _131.x : vec2(0.0).x, _172.y ? _131.y : vec2(0.0).y) * _248.y)) + (vec2(_179.x ? _145.x : vec2(0.0).x, _179.y ? _145.y : vec2(0.0).y) * _248.z)) + (vec2(_187.x ? _159.x : vec2(0.0).x, _187.y ? _159.y : vec2(0.0).y) * _248.w), 0.0, 0.0);
}

