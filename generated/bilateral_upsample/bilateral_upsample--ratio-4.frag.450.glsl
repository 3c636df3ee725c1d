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
    vec2 _54 = fma(gl_FragCoord.xy, vec2(0.25), vec2(-0.5));
    vec2 _55 = floor(_54);
    vec2 _56 = _54 - _55;
    vec2 _57 = vec2(1.0) - _56;
    float _58 = _57.x;
    float _59 = _56.x;
    vec2 _69 = (_55 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _74 = textureGather(gInCoarseDepth, _69).wzxy;
    vec4 _81 = textureGather(gInFiltered, _69);
    float _82 = _81.w;
    float _83 = _81.z;
    float _84 = _81.x;
    float _85 = _81.y;
    float _88 = float(abs(_82) <= 65504.0);
    float _93 = float(abs(_83) <= 65504.0);
    float _98 = float(abs(_84) <= 65504.0);
    float _103 = float(abs(_85) <= 65504.0);
    vec4 _114 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _115 = _114.x;
    float _125 = 1.0 / max(fma(_115, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _137 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_115 - 0.5) <= 0.5) ? (((_125 > 0.0) && (_125 < min(parameters.gSkyDepth, 65504.0))) ? _125 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_74, vec4(65504.0)), greaterThan(_74, vec4(0.0))));
    vec4 _144 = ((((vec4(_58, _59, _58, _59) * vec4(_57.yy, _56.yy)) * vec4(_88, _93, _98, _103)) * _137.yxxx) * _137.zzyy) * _137.wwwz;
    vec4 _148 = _144 * (1.0 / max(dot(_144, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4(fma(_148.w, (_103 > 0.5) ? _85 : 0.0, fma(_148.z, (_98 > 0.5) ? _84 : 0.0, fma(_148.x, (_88 > 0.5) ? _82 : 0.0, _148.y * ((_93 > 0.5) ? _83 : 0.0)))), 0.0, 0.0, 0.0);
}

