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
    float _135 = 1.0 / max(fma(_125, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _139 = min(parameters.gSkyDepth, 65504.0);
    vec4 _147 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_125 - 0.5) <= 0.5) ? (((_135 > 0.0) && (_135 < _139)) ? _135 : 65504.0) : 65504.0) - _87);
    vec4 _154 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _114) * _147.yxxx) * _147.zzyy) * _147.wwwz;
    vec4 _158 = _154 * (1.0 / max(dot(_154, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _168 = _124.z;
    float _174 = 1.0 / max(fma(_168, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _183 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_168 - 0.5) <= 0.5) ? (((_174 > 0.0) && (_174 < _139)) ? _174 : 65504.0) : 65504.0) - _87);
    vec4 _190 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _114) * _183.yxxx) * _183.zzyy) * _183.wwwz;
    vec4 _194 = _190 * (1.0 / max(dot(_190, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _204 = _124.x;
    float _210 = 1.0 / max(fma(_204, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _219 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_204 - 0.5) <= 0.5) ? (((_210 > 0.0) && (_210 < _139)) ? _210 : 65504.0) : 65504.0) - _87);
    vec4 _226 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _114) * _219.yxxx) * _219.zzyy) * _219.wwwz;
    vec4 _230 = _226 * (1.0 / max(dot(_226, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _240 = _124.y;
    float _246 = 1.0 / max(fma(_240, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _255 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_240 - 0.5) <= 0.5) ? (((_246 > 0.0) && (_246 < _139)) ? _246 : 65504.0) : 65504.0) - _87);
    vec4 _262 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _114) * _255.yxxx) * _255.zzyy) * _255.wwwz;
    vec4 _266 = _262 * (1.0 / max(dot(_262, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _276 = ivec2(_70 - vec2(1.0));
    imageStore(gOutUpsampled, _276, vec4(fma(_158.w, _116, fma(_158.z, _110, fma(_158.x, _100, _158.y * _105))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _276 + ivec2(1, 0), vec4(fma(_194.w, _116, fma(_194.z, _110, fma(_194.x, _100, _194.y * _105))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _276 + ivec2(0, 1), vec4(fma(_230.w, _116, fma(_230.z, _110, fma(_230.x, _100, _230.y * _105))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _276 + ivec2(1), vec4(fma(_266.w, _116, fma(_266.z, _110, fma(_266.x, _100, _266.y * _105))), 0.0, 0.0, 0.0));
}

