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
    vec2 _59 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _60 = floor(_59);
    vec2 _61 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _62 = _61 - vec2(1.0);
    vec2 _65 = (clamp(_60, vec2(0.0), _62) + vec2(0.5)) / _61;
    vec2 _69 = (clamp(_60 + vec2(1.0), vec2(0.0), _62) + vec2(0.5)) / _61;
    vec2 _72 = vec2(_69.x, _65.y);
    vec2 _75 = vec2(_65.x, _69.y);
    vec2 _76 = _59 - _60;
    vec2 _77 = vec2(1.0) - _76;
    float _78 = _77.x;
    float _79 = _76.x;
    vec4 _99 = vec4(textureLod(gInCoarseDepth, _65, 0.0).x, textureLod(gInCoarseDepth, _72, 0.0).x, textureLod(gInCoarseDepth, _75, 0.0).x, textureLod(gInCoarseDepth, _69, 0.0).x);
    vec4 _100 = min(_99, vec4(65504.0));
    bvec4 _101 = greaterThan(_99, vec4(0.0));
    vec2 _107 = textureLod(gInFiltered, _65, 0.0).xy;
    vec2 _110 = textureLod(gInFiltered, _72, 0.0).xy;
    vec2 _113 = textureLod(gInFiltered, _75, 0.0).xy;
    vec2 _116 = textureLod(gInFiltered, _69, 0.0).xy;
    float _120 = float(all(lessThanEqual(abs(_107), vec2(65504.0))));
    bvec2 _122 = bvec2(_120 > 0.5);
    float _127 = float(all(lessThanEqual(abs(_110), vec2(65504.0))));
    bvec2 _129 = bvec2(_127 > 0.5);
    float _134 = float(all(lessThanEqual(abs(_113), vec2(65504.0))));
    bvec2 _136 = bvec2(_134 > 0.5);
    float _141 = float(all(lessThanEqual(abs(_116), vec2(65504.0))));
    bvec2 _144 = bvec2(_141 > 0.5);
    vec4 _153 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _154 = _153.x;
    float _164 = 1.0 / max(_154 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _176 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_154 - 0.5) <= 0.5) ? (((_164 > 0.0) && (_164 < min(parameters.gSkyDepth, 65504.0))) ? _164 : 65504.0) : 65504.0) - vec4(_101.x ? _100.x : vec4(65504.0).x, _101.y ? _100.y : vec4(65504.0).y, _101.z ? _100.z : vec4(65504.0).z, _101.w ? _100.w : vec4(65504.0).w));
    vec4 _183 = ((((vec4(_78, _79, _78, _79) * vec4(_77.yy, _76.yy)) * vec4(_120, _127, _134, _141)) * _176.yxxx) * _176.zzyy) * _176.wwwz;
    vec4 _187 = _183 * (1.0 / max(dot(_183, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _198 = (((vec2(_122.x ? _107.x : vec2(0.0).x, _122.y ? _107.y : vec2(0.0).y) * _187.x) + (vec2(_129.x ? _110.x : vec2(0.0).x, _129.y ? _110.y : vec2(0.0).y) * _187.y)) + (vec2(_136.x ? _113.x : vec2(0.0).x, _136.y ? _113.y : vec2(0.0).y) * _187.z)) + (vec2(_144.x ? _116.x : vec2(0.0).x, _144.y ? _116.y : vec2(0.0).y) * _187.w);
    gOutUpsampled = vec4(_198, 0.0, 0.0);
}

