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
    vec2 _57 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _58 = floor(_57);
    vec2 _59 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _60 = _59 - vec2(1.0);
    vec2 _63 = (clamp(_58, vec2(0.0), _60) + vec2(0.5)) / _59;
    vec2 _67 = (clamp(_58 + vec2(1.0), vec2(0.0), _60) + vec2(0.5)) / _59;
    vec2 _70 = vec2(_67.x, _63.y);
    vec2 _73 = vec2(_63.x, _67.y);
    vec2 _74 = _57 - _58;
    vec2 _75 = vec2(1.0) - _74;
    float _76 = _75.x;
    float _77 = _74.x;
    vec4 _86 = textureLod(gInFiltered, _63, 0.0);
    float _87 = _86.x;
    vec4 _89 = textureLod(gInFiltered, _70, 0.0);
    float _90 = _89.x;
    vec4 _92 = textureLod(gInFiltered, _73, 0.0);
    float _93 = _92.x;
    vec4 _95 = textureLod(gInFiltered, _67, 0.0);
    float _96 = _95.x;
    float _99 = float(abs(_87) <= 65504.0);
    float _104 = float(abs(_90) <= 65504.0);
    float _109 = float(abs(_93) <= 65504.0);
    float _114 = float(abs(_96) <= 65504.0);
    vec4 _132 = vec4(textureLod(gInCoarseDepth, _63, 0.0).x, textureLod(gInCoarseDepth, _70, 0.0).x, textureLod(gInCoarseDepth, _73, 0.0).x, textureLod(gInCoarseDepth, _67, 0.0).x);
    vec4 _133 = min(_132, vec4(65504.0));
    bvec4 _134 = greaterThan(_132, vec4(0.0));
    vec4 _143 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _144 = _143.x;
    float _154 = 1.0 / max(_144 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _166 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_144 - 0.5) <= 0.5) ? (((_154 > 0.0) && (_154 < min(parameters.gSkyDepth, 65504.0))) ? _154 : 65504.0) : 65504.0) - vec4(_134.x ? _133.x : vec4(65504.0).x, _134.y ? _133.y : vec4(65504.0).y, _134.z ? _133.z : vec4(65504.0).z, _134.w ? _133.w : vec4(65504.0).w));
    vec4 _173 = ((((vec4(_76, _77, _76, _77) * vec4(_75.yy, _74.yy)) * vec4(_99, _104, _109, _114)) * _166.yxxx) * _166.zzyy) * _166.wwwz;
    vec4 _177 = _173 * (1.0 / max(dot(_173, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4(_177.w * ((_114 > 0.5) ? _96 : 0.0) + (_177.z * ((_109 > 0.5) ? _93 : 0.0) + (_177.x * ((_99 > 0.5) ? _87 : 0.0) + (_177.y * ((_104 > 0.5) ? _90 : 0.0)))), 0.0, 0.0, 0.0);
}

