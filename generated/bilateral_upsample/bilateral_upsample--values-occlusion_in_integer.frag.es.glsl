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
    vec2 _104 = vec2(_99 * 0.0322580635547637939453125, min((_98 - _99) * 1.01587307453155517578125, 1.0));
    bvec2 _105 = bvec2(abs(_93) <= 65504.0);
    vec2 _106 = vec2(_105.x ? _104.x : vec2(1.9999999360571384930131252153835e+38).x, _105.y ? _104.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _108 = textureLod(gInFiltered, _76, 0.0);
    float _109 = _108.x;
    float _114 = (_109 > 0.0) ? min(_109, 31.984375) : 0.0;
    float _115 = floor(_114);
    vec2 _120 = vec2(_115 * 0.0322580635547637939453125, min((_114 - _115) * 1.01587307453155517578125, 1.0));
    bvec2 _121 = bvec2(abs(_109) <= 65504.0);
    vec2 _122 = vec2(_121.x ? _120.x : vec2(1.9999999360571384930131252153835e+38).x, _121.y ? _120.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _124 = textureLod(gInFiltered, _79, 0.0);
    float _125 = _124.x;
    float _130 = (_125 > 0.0) ? min(_125, 31.984375) : 0.0;
    float _131 = floor(_130);
    vec2 _136 = vec2(_131 * 0.0322580635547637939453125, min((_130 - _131) * 1.01587307453155517578125, 1.0));
    bvec2 _137 = bvec2(abs(_125) <= 65504.0);
    vec2 _138 = vec2(_137.x ? _136.x : vec2(1.9999999360571384930131252153835e+38).x, _137.y ? _136.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _140 = textureLod(gInFiltered, _73, 0.0);
    float _141 = _140.x;
    float _146 = (_141 > 0.0) ? min(_141, 31.984375) : 0.0;
    float _147 = floor(_146);
    vec2 _152 = vec2(_147 * 0.0322580635547637939453125, min((_146 - _147) * 1.01587307453155517578125, 1.0));
    bvec2 _153 = bvec2(abs(_141) <= 65504.0);
    vec2 _154 = vec2(_153.x ? _152.x : vec2(1.9999999360571384930131252153835e+38).x, _153.y ? _152.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _158 = float(abs(_106.x) <= 65504.0);
    bvec2 _160 = bvec2(_158 > 0.5);
    float _165 = float(abs(_122.x) <= 65504.0);
    bvec2 _167 = bvec2(_165 > 0.5);
    float _172 = float(abs(_138.x) <= 65504.0);
    bvec2 _174 = bvec2(_172 > 0.5);
    float _179 = float(abs(_154.x) <= 65504.0);
    bvec2 _182 = bvec2(_179 > 0.5);
    vec4 _198 = vec4(textureLod(gInCoarseDepth, _69, 0.0).x, textureLod(gInCoarseDepth, _76, 0.0).x, textureLod(gInCoarseDepth, _79, 0.0).x, textureLod(gInCoarseDepth, _73, 0.0).x);
    vec4 _199 = min(_198, vec4(65504.0));
    bvec4 _200 = greaterThan(_198, vec4(0.0));
    vec4 _209 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _210 = _209.x;
    float _220 = 1.0 / max(_210 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _232 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_210 - 0.5) <= 0.5) ? (((_220 > 0.0) && (_220 < min(parameters.gSkyDepth, 65504.0))) ? _220 : 65504.0) : 65504.0) - vec4(_200.x ? _199.x : vec4(65504.0).x, _200.y ? _199.y : vec4(65504.0).y, _200.z ? _199.z : vec4(65504.0).z, _200.w ? _199.w : vec4(65504.0).w));
    vec4 _239 = ((((vec4(_82, _83, _82, _83) * vec4(_81.yy, _80.yy)) * vec4(_158, _165, _172, _179)) * _232.yxxx) * _232.zzyy) * _232.wwwz;
    vec4 _243 = _239 * (1.0 / max(dot(_239, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((vec2(_160.x ? _106.x : vec2(0.0).x, _160.y ? _106.y : vec2(0.0).y) * _243.x) + (vec2(_167.x ? _122.x : vec2(0.0).x, _167.y ? _122.y : vec2(0.0).y) * _243.y)) + (vec2(_174.x ? _138.x : vec2(0.0).x, _174.y ? _138.y : vec2(0.0).y) * _243.z)) + (vec2(_182.x ? _154.x : vec2(0.0).x, _182.y ? _154.y : vec2(0.0).y) * _243.w), 0.0, 0.0);
}

