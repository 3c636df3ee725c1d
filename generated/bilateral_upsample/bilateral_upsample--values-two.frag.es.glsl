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
    vec2 _89 = textureLod(gInFiltered, _65, 0.0).xy;
    vec2 _92 = textureLod(gInFiltered, _72, 0.0).xy;
    vec2 _95 = textureLod(gInFiltered, _75, 0.0).xy;
    vec2 _98 = textureLod(gInFiltered, _69, 0.0).xy;
    float _102 = float(all(lessThanEqual(abs(_89), vec2(65504.0))));
    bvec2 _104 = bvec2(_102 > 0.5);
    float _109 = float(all(lessThanEqual(abs(_92), vec2(65504.0))));
    bvec2 _111 = bvec2(_109 > 0.5);
    float _116 = float(all(lessThanEqual(abs(_95), vec2(65504.0))));
    bvec2 _118 = bvec2(_116 > 0.5);
    float _123 = float(all(lessThanEqual(abs(_98), vec2(65504.0))));
    bvec2 _126 = bvec2(_123 > 0.5);
    vec4 _142 = vec4(textureLod(gInCoarseDepth, _65, 0.0).x, textureLod(gInCoarseDepth, _72, 0.0).x, textureLod(gInCoarseDepth, _75, 0.0).x, textureLod(gInCoarseDepth, _69, 0.0).x);
    vec4 _143 = min(_142, vec4(65504.0));
    bvec4 _144 = greaterThan(_142, vec4(0.0));
    vec4 _153 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _154 = _153.x;
    float _164 = 1.0 / max(_154 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _176 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_154 - 0.5) <= 0.5) ? (((_164 > 0.0) && (_164 < min(parameters.gSkyDepth, 65504.0))) ? _164 : 65504.0) : 65504.0) - vec4(_144.x ? _143.x : vec4(65504.0).x, _144.y ? _143.y : vec4(65504.0).y, _144.z ? _143.z : vec4(65504.0).z, _144.w ? _143.w : vec4(65504.0).w));
    vec4 _183 = ((((vec4(_78, _79, _78, _79) * vec4(_77.yy, _76.yy)) * vec4(_102, _109, _116, _123)) * _176.yxxx) * _176.zzyy) * _176.wwwz;
    vec4 _187 = _183 * (1.0 / max(dot(_183, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _198 = (((vec2(_104.x ? _89.x : vec2(0.0).x, _104.y ? _89.y : vec2(0.0).y) * _187.x) + (vec2(_111.x ? _92.x : vec2(0.0).x, _111.y ? _92.y : vec2(0.0).y) * _187.y)) + (vec2(_118.x ? _95.x : vec2(0.0).x, _118.y ? _95.y : vec2(0.0).y) * _187.z)) + (vec2(_126.x ? _98.x : vec2(0.0).x, _126.y ? _98.y : vec2(0.0).y) * _187.w);
    gOutUpsampled = vec4(_198, 0.0, 0.0);
}

