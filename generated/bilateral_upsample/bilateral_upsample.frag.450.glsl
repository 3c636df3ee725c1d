#version 450

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 1) uniform sampler2D gInFiltered;
layout(binding = 3) uniform sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _53 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _54 = floor(_53);
    vec2 _55 = _53 - _54;
    vec2 _56 = vec2(1.0) - _55;
    float _57 = _56.x;
    float _58 = _55.x;
    vec2 _68 = (_54 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _73 = textureGather(gInCoarseDepth, _68).wzxy;
    vec4 _80 = textureGather(gInFiltered, _68);
    float _81 = _80.w;
    float _82 = _80.z;
    float _83 = _80.x;
    float _84 = _80.y;
    float _87 = float(abs(_81) <= 65504.0);
    float _92 = float(abs(_82) <= 65504.0);
    float _97 = float(abs(_83) <= 65504.0);
    float _102 = float(abs(_84) <= 65504.0);
    vec4 _113 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _114 = _113.x;
    float _124 = 1.0 / max(fma(_114, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _136 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_114 - 0.5) <= 0.5) ? (((_124 > 0.0) && (_124 < min(parameters.gSkyDepth, 65504.0))) ? _124 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_73, vec4(65504.0)), greaterThan(_73, vec4(0.0))));
    vec4 _143 = ((((vec4(_57, _58, _57, _58) * vec4(_56.yy, _55.yy)) * vec4(_87, _92, _97, _102)) * _136.yxxx) * _136.zzyy) * _136.wwwz;
    vec4 _147 = _143 * (1.0 / max(dot(_143, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4(fma(_147.w, (_102 > 0.5) ? _84 : 0.0, fma(_147.z, (_97 > 0.5) ? _83 : 0.0, fma(_147.x, (_87 > 0.5) ? _81 : 0.0, _147.y * ((_92 > 0.5) ? _82 : 0.0)))), 0.0, 0.0, 0.0);
}

