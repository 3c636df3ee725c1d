#version 310 es
layout(local_size_x = 32, local_size_y = 8, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutUpsampled;
layout(binding = 2) uniform highp sampler2D gInCoarseDepth;
layout(binding = 1) uniform highp sampler2D gInFiltered;
layout(binding = 3) uniform highp sampler2D gInDepth;

void main()
{
    vec2 _71 = vec2(gl_GlobalInvocationID.xy) * 2.0;
    vec2 _77 = floor(_71 * vec2(0.5) + vec2(-0.5));
    vec2 _78 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _79 = _78 - vec2(1.0);
    vec2 _82 = (clamp(_77, vec2(0.0), _79) + vec2(0.5)) / _78;
    vec2 _86 = (clamp(_77 + vec2(1.0), vec2(0.0), _79) + vec2(0.5)) / _78;
    vec4 _103 = textureGather(gInCoarseDepth, (floor((_71 + vec2(-0.5)) * vec2(0.5) + vec2(-0.5)) + vec2(1.0)) * parameters.gCoarseSize.zw).wzxy;
    vec4 _106 = mix(vec4(65504.0), min(_103, vec4(65504.0)), greaterThan(_103, vec4(0.0)));
    vec4 _110 = textureLod(gInFiltered, _82, 0.0);
    vec4 _112 = textureLod(gInFiltered, vec2(_86.x, _82.y), 0.0);
    vec4 _114 = textureLod(gInFiltered, vec2(_82.x, _86.y), 0.0);
    vec4 _116 = textureLod(gInFiltered, _86, 0.0);
    float _120 = float(all(lessThanEqual(abs(_110), vec4(65504.0))));
    vec4 _123 = mix(vec4(0.0), _110, bvec4(_120 > 0.5));
    float _127 = float(all(lessThanEqual(abs(_112), vec4(65504.0))));
    vec4 _130 = mix(vec4(0.0), _112, bvec4(_127 > 0.5));
    float _134 = float(all(lessThanEqual(abs(_114), vec4(65504.0))));
    vec4 _137 = mix(vec4(0.0), _114, bvec4(_134 > 0.5));
    float _141 = float(all(lessThanEqual(abs(_116), vec4(65504.0))));
    vec4 _142 = vec4(_120, _127, _134, _141);
    vec4 _145 = mix(vec4(0.0), _116, bvec4(_141 > 0.5));
    vec4 _153 = textureGather(gInDepth, _71 * parameters.gOutputSize.zw);
    float _154 = _153.w;
    float _164 = 1.0 / max(_154 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    float _168 = min(parameters.gSkyDepth, 65504.0);
    vec4 _176 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_154 - 0.5) <= 0.5) ? (((_164 > 0.0) && (_164 < _168)) ? _164 : 65504.0) : 65504.0) - _106);
    vec4 _183 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _142) * _176.yxxx) * _176.zzyy) * _176.wwwz;
    vec4 _187 = _183 * (1.0 / max(dot(_183, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _199 = _153.z;
    float _205 = 1.0 / max(_199 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _214 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_199 - 0.5) <= 0.5) ? (((_205 > 0.0) && (_205 < _168)) ? _205 : 65504.0) : 65504.0) - _106);
    vec4 _221 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _142) * _214.yxxx) * _214.zzyy) * _214.wwwz;
    vec4 _225 = _221 * (1.0 / max(dot(_221, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _237 = _153.x;
    float _243 = 1.0 / max(_237 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _252 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_237 - 0.5) <= 0.5) ? (((_243 > 0.0) && (_243 < _168)) ? _243 : 65504.0) : 65504.0) - _106);
    vec4 _259 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _142) * _252.yxxx) * _252.zzyy) * _252.wwwz;
    vec4 _263 = _259 * (1.0 / max(dot(_259, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _275 = _153.y;
    float _281 = 1.0 / max(_275 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _290 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_275 - 0.5) <= 0.5) ? (((_281 > 0.0) && (_281 < _168)) ? _281 : 65504.0) : 65504.0) - _106);
    vec4 _297 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _142) * _290.yxxx) * _290.zzyy) * _290.wwwz;
    vec4 _301 = _297 * (1.0 / max(dot(_297, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _313 = ivec2(_71 - vec2(1.0));
    imageStore(gOutUpsampled, _313, (((_123 * _187.x) + (_130 * _187.y)) + (_137 * _187.z)) + (_145 * _187.w));
    imageStore(gOutUpsampled, _313 + ivec2(1, 0), (((_123 * _225.x) + (_130 * _225.y)) + (_137 * _225.z)) + (_145 * _225.w));
    imageStore(gOutUpsampled, _313 + ivec2(0, 1), (((_123 * _263.x) + (_130 * _263.y)) + (_137 * _263.z)) + (_145 * _263.w));
    imageStore(gOutUpsampled, _313 + ivec2(1), (((_123 * _301.x) + (_130 * _301.y)) + (_137 * _301.z)) + (_145 * _301.w));
}

