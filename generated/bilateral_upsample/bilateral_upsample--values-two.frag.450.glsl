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
    vec2 _56 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _57 = floor(_56);
    vec2 _58 = _56 - _57;
    vec2 _59 = vec2(1.0) - _58;
    float _60 = _59.x;
    float _61 = _58.x;
    vec2 _71 = (_57 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _76 = textureGather(gInCoarseDepth, _71).wzxy;
    vec4 _83 = textureGather(gInFiltered, _71);
    vec4 _85 = textureGather(gInFiltered, _71, 1);
    vec2 _89 = vec4(_83.w, _85.w, 0.0, 0.0).xy;
    vec2 _93 = vec4(_83.z, _85.z, 0.0, 0.0).xy;
    vec2 _97 = vec4(_83.x, _85.x, 0.0, 0.0).xy;
    vec2 _101 = vec4(_83.y, _85.y, 0.0, 0.0).xy;
    float _105 = float(all(lessThanEqual(abs(_89), vec2(65504.0))));
    float _112 = float(all(lessThanEqual(abs(_93), vec2(65504.0))));
    float _119 = float(all(lessThanEqual(abs(_97), vec2(65504.0))));
    float _126 = float(all(lessThanEqual(abs(_101), vec2(65504.0))));
    vec4 _138 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _139 = _138.x;
    float _149 = 1.0 / max(fma(_139, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _161 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_139 - 0.5) <= 0.5) ? (((_149 > 0.0) && (_149 < min(parameters.gSkyDepth, 65504.0))) ? _149 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_76, vec4(65504.0)), greaterThan(_76, vec4(0.0))));
    vec4 _168 = ((((vec4(_60, _61, _60, _61) * vec4(_59.yy, _58.yy)) * vec4(_105, _112, _119, _126)) * _161.yxxx) * _161.zzyy) * _161.wwwz;
    vec4 _172 = _168 * (1.0 / max(dot(_168, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _183 = (((mix(vec2(0.0), _89, bvec2(_105 > 0.5)) * _172.x) + (mix(vec2(0.0), _93, bvec2(_112 > 0.5)) * _172.y)) + (mix(vec2(0.0), _97, bvec2(_119 > 0.5)) * _172.z)) + (mix(vec2(0.0), _101, bvec2(_126 > 0.5)) * _172.w);
    gOutUpsampled = vec4(_183, 0.0, 0.0);
}

