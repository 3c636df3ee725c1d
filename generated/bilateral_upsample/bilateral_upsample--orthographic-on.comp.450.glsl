#version 450
layout(local_size_x = 32, local_size_y = 8, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutUpsampled;
layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 1) uniform sampler2D gInFiltered;
layout(binding = 3) uniform sampler2D gInDepth;

void main()
{
    vec2 _70 = vec2(gl_GlobalInvocationID.xy) * 2.0;
    vec2 _79 = (floor(fma(_70 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _84 = textureGather(gInCoarseDepth, _79).wzxy;
    vec4 _87 = mix(vec4(65504.0), min(_84, vec4(65504.0)), greaterThan(_84, vec4(0.0)));
    vec4 _91 = textureGather(gInFiltered, _79);
    float _92 = _91.w;
    float _93 = _91.z;
    float _94 = _91.x;
    float _95 = _91.y;
    float _98 = float(abs(_92) <= 65504.0);
    float _100 = (_98 > 0.5) ? _92 : 0.0;
    float _103 = float(abs(_93) <= 65504.0);
    float _105 = (_103 > 0.5) ? _93 : 0.0;
    float _108 = float(abs(_94) <= 65504.0);
    float _110 = (_108 > 0.5) ? _94 : 0.0;
    float _113 = float(abs(_95) <= 65504.0);
    vec4 _114 = vec4(_98, _103, _108, _113);
    float _116 = (_113 > 0.5) ? _95 : 0.0;
    vec4 _124 = textureGather(gInDepth, _70 * parameters.gOutputSize.zw);
    float _125 = _124.w;
    float _133 = fma(_125, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
    float _137 = min(parameters.gSkyDepth, 65504.0);
    vec4 _145 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_125 - 0.5) <= 0.5) ? (((_133 > 0.0) && (_133 < _137)) ? _133 : 65504.0) : 65504.0) - _87);
    vec4 _152 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _114) * _145.yxxx) * _145.zzyy) * _145.wwwz;
    vec4 _156 = _152 * (1.0 / max(dot(_152, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _166 = _124.z;
    float _170 = fma(_166, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
    vec4 _179 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_166 - 0.5) <= 0.5) ? (((_170 > 0.0) && (_170 < _137)) ? _170 : 65504.0) : 65504.0) - _87);
    vec4 _186 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _114) * _179.yxxx) * _179.zzyy) * _179.wwwz;
    vec4 _190 = _186 * (1.0 / max(dot(_186, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _200 = _124.x;
    float _204 = fma(_200, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
    vec4 _213 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_200 - 0.5) <= 0.5) ? (((_204 > 0.0) && (_204 < _137)) ? _204 : 65504.0) : 65504.0) - _87);
    vec4 _220 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _114) * _213.yxxx) * _213.zzyy) * _213.wwwz;
    vec4 _224 = _220 * (1.0 / max(dot(_220, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _234 = _124.y;
    float _238 = fma(_234, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
    vec4 _247 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_234 - 0.5) <= 0.5) ? (((_238 > 0.0) && (_238 < _137)) ? _238 : 65504.0) : 65504.0) - _87);
    vec4 _254 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _114) * _247.yxxx) * _247.zzyy) * _247.wwwz;
    vec4 _258 = _254 * (1.0 / max(dot(_254, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _268 = ivec2(_70 - vec2(1.0));
    imageStore(gOutUpsampled, _268, vec4(fma(_156.w, _116, fma(_156.z, _110, fma(_156.x, _100, _156.y * _105))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _268 + ivec2(1, 0), vec4(fma(_190.w, _116, fma(_190.z, _110, fma(_190.x, _100, _190.y * _105))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _268 + ivec2(0, 1), vec4(fma(_224.w, _116, fma(_224.z, _110, fma(_224.x, _100, _224.y * _105))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _268 + ivec2(1), vec4(fma(_258.w, _116, fma(_258.z, _110, fma(_258.x, _100, _258.y * _105))), 0.0, 0.0, 0.0));
}

