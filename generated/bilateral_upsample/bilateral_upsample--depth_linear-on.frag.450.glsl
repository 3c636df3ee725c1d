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
    vec2 _51 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _52 = floor(_51);
    vec2 _53 = _51 - _52;
    vec2 _54 = vec2(1.0) - _53;
    float _55 = _54.x;
    float _56 = _53.x;
    vec2 _66 = (_52 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _71 = textureGather(gInCoarseDepth, _66).wzxy;
    vec4 _78 = textureGather(gInFiltered, _66);
    float _79 = _78.w;
    float _80 = _78.z;
    float _81 = _78.x;
    float _82 = _78.y;
    float _85 = float(abs(_79) <= 65504.0);
    float _90 = float(abs(_80) <= 65504.0);
    float _95 = float(abs(_81) <= 65504.0);
    float _100 = float(abs(_82) <= 65504.0);
    vec4 _111 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _112 = _111.x;
    vec4 _123 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_112 > 0.0) && (_112 < min(parameters.gSkyDepth, 65504.0))) ? _112 : 65504.0) - mix(vec4(65504.0), min(_71, vec4(65504.0)), greaterThan(_71, vec4(0.0))));
    vec4 _130 = ((((vec4(_55, _56, _55, _56) * vec4(_54.yy, _53.yy)) * vec4(_85, _90, _95, _100)) * _123.yxxx) * _123.zzyy) * _123.wwwz;
    vec4 _134 = _130 * (1.0 / max(dot(_130, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4(fma(_134.w, (_100 > 0.5) ? _82 : 0.0, fma(_134.z, (_95 > 0.5) ? _81 : 0.0, fma(_134.x, (_85 > 0.5) ? _79 : 0.0, _134.y * ((_90 > 0.5) ? _80 : 0.0)))), 0.0, 0.0, 0.0);
}

