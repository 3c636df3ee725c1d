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
    vec2 _122 = vec2(_117 * 0.0322580635547637939453125, min((_116 - _117) * 1.01587307453155517578125, 1.0));
    bvec2 _123 = bvec2(abs(_111) <= 65504.0);
    vec2 _124 = vec2(_123.x ? _122.x : vec2(1.9999999360571384930131252153835e+38).x, _123.y ? _122.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _126 = textureLod(gInFiltered, _76, 0.0);
    float _127 = _126.x;
    float _132 = (_127 > 0.0) ? min(_127, 31.984375) : 0.0;
    float _133 = floor(_132);
    vec2 _138 = vec2(_133 * 0.0322580635547637939453125, min((_132 - _133) * 1.01587307453155517578125, 1.0));
    bvec2 _139 = bvec2(abs(_127) <= 65504.0);
    vec2 _140 = vec2(_139.x ? _138.x : vec2(1.9999999360571384930131252153835e+38).x, _139.y ? _138.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _142 = textureLod(gInFiltered, _79, 0.0);
    float _143 = _142.x;
    float _148 = (_143 > 0.0) ? min(_143, 31.984375) : 0.0;
    float _149 = floor(_148);
    vec2 _154 = vec2(_149 * 0.0322580635547637939453125, min((_148 - _149) * 1.01587307453155517578125, 1.0));
    bvec2 _155 = bvec2(abs(_143) <= 65504.0);
    vec2 _156 = vec2(_155.x ? _154.x : vec2(1.9999999360571384930131252153835e+38).x, _155.y ? _154.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _158 = textureLod(gInFiltered, _73, 0.0);
    float _159 = _158.x;
    float _164 = (_159 > 0.0) ? min(_159, 31.984375) : 0.0;
    float _165 = floor(_164);
    vec2 _170 = vec2(_165 * 0.0322580635547637939453125, min((_164 - _165) * 1.01587307453155517578125, 1.0));
    bvec2 _171 = bvec2(abs(_159) <= 65504.0);
    vec2 _172 = vec2(_171.x ? _170.x : vec2(1.9999999360571384930131252153835e+38).x, _171.y ? _170.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _176 = float(abs(_124.x) <= 65504.0);
    bvec2 _178 = bvec2(_176 > 0.5);
    float _183 = float(abs(_140.x) <= 65504.0);
    bvec2 _185 = bvec2(_183 > 0.5);
    float _190 = float(abs(_156.x) <= 65504.0);
    bvec2 _192 = bvec2(_190 > 0.5);
    float _197 = float(abs(_172.x) <= 65504.0);
    bvec2 _200 = bvec2(_197 > 0.5);
    vec4 _209 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _210 = _209.x;
    float _220 = 1.0 / max(_210 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _232 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_210 - 0.5) <= 0.5) ? (((_220 > 0.0) && (_220 < min(parameters.gSkyDepth, 65504.0))) ? _220 : 65504.0) : 65504.0) - vec4(_105.x ? _104.x : vec4(65504.0).x, _105.y ? _104.y : vec4(65504.0).y, _105.z ? _104.z : vec4(65504.0).z, _105.w ? _104.w : vec4(65504.0).w));
    vec4 _239 = ((((vec4(_82, _83, _82, _83) * vec4(_81.yy, _80.yy)) * vec4(_176, _183, _190, _197)) * _232.yxxx) * _232.zzyy) * _232.wwwz;
    vec4 _243 = _239 * (1.0 / max(dot(_239, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((vec2(_178.x ? _124.x : vec2(0.0).x, _178.y ? _124.y : vec2(0.0).y) * _243.x) + (vec2(_185.x ? _140.x : vec2(0.0).x, _185.y ? _140.y : vec2(0.0).y) * _243.y)) + (vec2(_192.x ? _156.x : vec2(0.0).x, _192.y ? _156.y : vec2(0.0).y) * _243.z)) + (vec2(_200.x ? _172.x : vec2(0.0).x, _200.y ? _172.y : vec2(0.0).y) * _243.w), 0.0, 0.0);
}

