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
    vec4 _88 = textureLod(gInFiltered, _65, 0.0);
    float _89 = _88.x;
    vec4 _91 = textureLod(gInFiltered, _72, 0.0);
    float _92 = _91.x;
    vec4 _94 = textureLod(gInFiltered, _75, 0.0);
    float _95 = _94.x;
    vec4 _97 = textureLod(gInFiltered, _69, 0.0);
    float _98 = _97.x;
    float _101 = float(abs(_89) <= 65504.0);
    float _106 = float(abs(_92) <= 65504.0);
    float _111 = float(abs(_95) <= 65504.0);
    float _116 = float(abs(_98) <= 65504.0);
    vec4 _134 = vec4(textureLod(gInCoarseDepth, _65, 0.0).x, textureLod(gInCoarseDepth, _72, 0.0).x, textureLod(gInCoarseDepth, _75, 0.0).x, textureLod(gInCoarseDepth, _69, 0.0).x);
    vec4 _135 = min(_134, vec4(65504.0));
    bvec4 _136 = greaterThan(_134, vec4(0.0));
    vec4 _145 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _146 = _145.x;
    float _156 = 1.0 / max(_146 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _168 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_146 - 0.5) <= 0.5) ? (((_156 > 0.0) && (_156 < min(parameters.gSkyDepth, 65504.0))) ? _156 : 65504.0) : 65504.0) - vec4(_136.x ? _135.x : vec4(65504.0).x, _136.y ? _135.y : vec4(65504.0).y, _136.z ? _135.z : vec4(65504.0).z, _136.w ? _135.w : vec4(65504.0).w));
    vec4 _175 = ((((vec4(_78, _79, _78, _79) * vec4(_77.yy, _76.yy)) * vec4(_101, _106, _111, _116)) * _168.yxxx) * _168.zzyy) * _168.wwwz;
    vec4 _179 = _175 * (1.0 / max(dot(_175, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4(_179.w * ((_116 > 0.5) ? _98 : 0.0) + (_179.z * ((_111 > 0.5) ? _95 : 0.0) + (_179.x * ((_101 > 0.5) ? _89 : 0.0) + (_179.y * ((_106 > 0.5) ? _92 : 0.0)))), 0.0, 0.0, 0.0);
}

