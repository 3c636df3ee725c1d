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
    vec2 _57 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _58 = floor(_57);
    vec2 _59 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _60 = _59 - vec2(1.0);
    vec2 _63 = (clamp(_58, vec2(0.0), _60) + vec2(0.5)) / _59;
    vec2 _64 = _58 + vec2(1.0);
    vec2 _67 = (clamp(_64, vec2(0.0), _60) + vec2(0.5)) / _59;
    vec2 _74 = _57 - _58;
    vec2 _75 = vec2(1.0) - _74;
    float _76 = _75.x;
    float _77 = _74.x;
    vec4 _89 = textureGather(gInCoarseDepth, _64 * parameters.gCoarseSize.zw).wzxy;
    vec4 _96 = textureLod(gInFiltered, _63, 0.0);
    vec4 _98 = textureLod(gInFiltered, vec2(_67.x, _63.y), 0.0);
    vec4 _100 = textureLod(gInFiltered, vec2(_63.x, _67.y), 0.0);
    vec4 _102 = textureLod(gInFiltered, _67, 0.0);
    float _106 = float(all(lessThanEqual(abs(_96), vec4(65504.0))));
    float _113 = float(all(lessThanEqual(abs(_98), vec4(65504.0))));
    float _120 = float(all(lessThanEqual(abs(_100), vec4(65504.0))));
    float _127 = float(all(lessThanEqual(abs(_102), vec4(65504.0))));
    vec4 _139 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _140 = _139.x;
    float _150 = 1.0 / max(fma(_140, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _162 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_140 - 0.5) <= 0.5) ? (((_150 > 0.0) && (_150 < min(parameters.gSkyDepth, 65504.0))) ? _150 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_89, vec4(65504.0)), greaterThan(_89, vec4(0.0))));
    vec4 _169 = ((((vec4(_76, _77, _76, _77) * vec4(_75.yy, _74.yy)) * vec4(_106, _113, _120, _127)) * _162.yxxx) * _162.zzyy) * _162.wwwz;
    vec4 _173 = _169 * (1.0 / max(dot(_169, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = (((mix(vec4(0.0), _96, bvec4(_106 > 0.5)) * _173.x) + (mix(vec4(0.0), _98, bvec4(_113 > 0.5)) * _173.y)) + (mix(vec4(0.0), _100, bvec4(_120 > 0.5)) * _173.z)) + (mix(vec4(0.0), _102, bvec4(_127 > 0.5)) * _173.w);
}

