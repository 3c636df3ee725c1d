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
    vec2 _55 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _56 = floor(_55);
    vec2 _57 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _58 = _57 - vec2(1.0);
    vec2 _61 = (clamp(_56, vec2(0.0), _58) + vec2(0.5)) / _57;
    vec2 _65 = (clamp(_56 + vec2(1.0), vec2(0.0), _58) + vec2(0.5)) / _57;
    vec2 _68 = vec2(_65.x, _61.y);
    vec2 _71 = vec2(_61.x, _65.y);
    vec2 _72 = _55 - _56;
    vec2 _73 = vec2(1.0) - _72;
    float _74 = _73.x;
    float _75 = _72.x;
    vec4 _95 = vec4(textureLod(gInCoarseDepth, _61, 0.0).x, textureLod(gInCoarseDepth, _68, 0.0).x, textureLod(gInCoarseDepth, _71, 0.0).x, textureLod(gInCoarseDepth, _65, 0.0).x);
    vec4 _96 = min(_95, vec4(65504.0));
    bvec4 _97 = greaterThan(_95, vec4(0.0));
    vec4 _102 = textureLod(gInFiltered, _61, 0.0);
    float _103 = _102.x;
    vec4 _105 = textureLod(gInFiltered, _68, 0.0);
    float _106 = _105.x;
    vec4 _108 = textureLod(gInFiltered, _71, 0.0);
    float _109 = _108.x;
    vec4 _111 = textureLod(gInFiltered, _65, 0.0);
    float _112 = _111.x;
    float _115 = float(abs(_103) <= 65504.0);
    float _120 = float(abs(_106) <= 65504.0);
    float _125 = float(abs(_109) <= 65504.0);
    float _130 = float(abs(_112) <= 65504.0);
    vec4 _141 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _142 = _141.x;
    vec4 _153 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_142 > 0.0) && (_142 < min(parameters.gSkyDepth, 65504.0))) ? _142 : 65504.0) - vec4(_97.x ? _96.x : vec4(65504.0).x, _97.y ? _96.y : vec4(65504.0).y, _97.z ? _96.z : vec4(65504.0).z, _97.w ? _96.w : vec4(65504.0).w));
    vec4 _160 = ((((vec4(_74, _75, _74, _75) * vec4(_73.yy, _72.yy)) * vec4(_115, _120, _125, _130)) * _153.yxxx) * _153.zzyy) * _153.wwwz;
    vec4 _164 = _160 * (1.0 / max(dot(_160, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4(_164.w * ((_130 > 0.5) ? _112 : 0.0) + (_164.z * ((_125 > 0.5) ? _109 : 0.0) + (_164.x * ((_115 > 0.5) ? _103 : 0.0) + (_164.y * ((_120 > 0.5) ? _106 : 0.0)))), 0.0, 0.0, 0.0);
}

