#version 450

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 1) uniform sampler2D gInFiltered;
layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 3) uniform sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _59 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _60 = floor(_59);
    vec2 _61 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _62 = _61 - vec2(1.0);
    vec2 _65 = (clamp(_60, vec2(0.0), _62) + vec2(0.5)) / _61;
    vec2 _66 = _60 + vec2(1.0);
    vec2 _69 = (clamp(_66, vec2(0.0), _62) + vec2(0.5)) / _61;
    vec2 _76 = _59 - _60;
    vec2 _77 = vec2(1.0) - _76;
    float _78 = _77.x;
    float _79 = _76.x;
    vec2 _89 = textureLod(gInFiltered, _65, 0.0).xy;
    vec2 _92 = textureLod(gInFiltered, vec2(_69.x, _65.y), 0.0).xy;
    vec2 _95 = textureLod(gInFiltered, vec2(_65.x, _69.y), 0.0).xy;
    vec2 _98 = textureLod(gInFiltered, _69, 0.0).xy;
    float _102 = float(all(lessThanEqual(abs(_89), vec2(65504.0))));
    float _109 = float(all(lessThanEqual(abs(_92), vec2(65504.0))));
    float _116 = float(all(lessThanEqual(abs(_95), vec2(65504.0))));
    float _123 = float(all(lessThanEqual(abs(_98), vec2(65504.0))));
    vec4 _134 = textureGather(gInCoarseDepth, _66 * parameters.gCoarseSize.zw).wzxy;
    vec4 _145 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _146 = _145.x;
    float _156 = 1.0 / max(fma(_146, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _168 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_146 - 0.5) <= 0.5) ? (((_156 > 0.0) && (_156 < min(parameters.gSkyDepth, 65504.0))) ? _156 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_134, vec4(65504.0)), greaterThan(_134, vec4(0.0))));
    vec4 _175 = ((((vec4(_78, _79, _78, _79) * vec4(_77.yy, _76.yy)) * vec4(_102, _109, _116, _123)) * _168.yxxx) * _168.zzyy) * _168.wwwz;
    vec4 _179 = _175 * (1.0 / max(dot(_175, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((mix(vec2(0.0), _89, bvec2(_102 > 0.5)) * _179.x) + (mix(vec2(0.0), _92, bvec2(_109 > 0.5)) * _179.y)) + (mix(vec2(0.0), _95, bvec2(_116 > 0.5)) * _179.z)) + (mix(vec2(0.0), _98, bvec2(_123 > 0.5)) * _179.w), 0.0, 0.0);
}

