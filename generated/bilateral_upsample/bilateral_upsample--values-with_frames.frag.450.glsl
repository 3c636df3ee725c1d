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
    vec2 _61 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _62 = floor(_61);
    vec2 _63 = _61 - _62;
    vec2 _64 = vec2(1.0) - _63;
    float _65 = _64.x;
    float _66 = _63.x;
    vec2 _76 = (_62 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _81 = textureGather(gInCoarseDepth, _76).wzxy;
    vec4 _89 = textureGather(gInFiltered, _76).wzxy;
    bvec4 _90 = greaterThanEqual(_89, vec4(0.0));
    bvec4 _91 = lessThan(_89, vec4(16777216.0));
    vec4 _93 = vec4(bvec4(_90.x && _91.x, _90.y && _91.y, _90.z && _91.z, _90.w && _91.w));
    vec4 _95 = mix(vec4(0.0), _89, greaterThan(_93, vec4(0.5)));
    vec4 _99 = _95 - (floor(_95 * 9.5367431640625e-07) * 1048576.0);
    vec4 _101 = floor(_99 * 0.0009765625);
    vec4 _102 = _101 * 0.000977517105638980865478515625;
    vec4 _106 = min((_99 - (_101 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0));
    vec4 _126 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _127 = _126.x;
    float _137 = 1.0 / max(fma(_127, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _149 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_127 - 0.5) <= 0.5) ? (((_137 > 0.0) && (_137 < min(parameters.gSkyDepth, 65504.0))) ? _137 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_81, vec4(65504.0)), greaterThan(_81, vec4(0.0))));
    vec4 _156 = ((((vec4(_65, _66, _65, _66) * vec4(_64.yy, _63.yy)) * _93) * _149.yxxx) * _149.zzyy) * _149.wwwz;
    vec4 _160 = _156 * (1.0 / max(dot(_156, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((vec2(_102.x, _106.x) * _160.x) + (vec2(_102.y, _106.y) * _160.y)) + (vec2(_102.z, _106.z) * _160.z)) + (vec2(_102.w, _106.w) * _160.w), 0.0, 0.0);
}

