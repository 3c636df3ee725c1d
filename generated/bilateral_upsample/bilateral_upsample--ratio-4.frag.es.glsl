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
    vec2 _59 = gl_FragCoord.xy * vec2(0.25) + vec2(-0.5);
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
    vec4 _106 = textureLod(gInFiltered, _65, 0.0);
    float _107 = _106.x;
    vec4 _109 = textureLod(gInFiltered, _72, 0.0);
    float _110 = _109.x;
    vec4 _112 = textureLod(gInFiltered, _75, 0.0);
    float _113 = _112.x;
    vec4 _115 = textureLod(gInFiltered, _69, 0.0);
    float _116 = _115.x;
    float _119 = float(abs(_107) <= 65504.0);
    float _124 = float(abs(_110) <= 65504.0);
    float _129 = float(abs(_113) <= 65504.0);
    float _134 = float(abs(_116) <= 65504.0);
    vec4 _145 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _146 = _145.x;
    float _156 = 1.0 / max(_146 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _168 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_146 - 0.5) <= 0.5) ? (((_156 > 0.0) && (_156 < min(parameters.gSkyDepth, 65504.0))) ? _156 : 65504.0) : 65504.0) - vec4(_101.x ? _100.x : vec4(65504.0).x, _101.y ? _100.y : vec4(65504.0).y, _101.z ? _100.z : vec4(65504.0).z, _101.w ? _100.w : vec4(65504.0).w));
    vec4 _175 = ((((vec4(_78, _79, _78, _79) * vec4(_77.yy, _76.yy)) * vec4(_119, _124, _129, _134)) * _168.yxxx) * _168.zzyy) * _168.wwwz;
    vec4 _179 = _175 * (1.0 / max(dot(_175, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4(_179.w * ((_134 > 0.5) ? _116 : 0.0) + (_179.z * ((_129 > 0.5) ? _113 : 0.0) + (_179.x * ((_119 > 0.5) ? _107 : 0.0) + (_179.y * ((_124 > 0.5) ? _110 : 0.0)))), 0.0, 0.0, 0.0);
}

