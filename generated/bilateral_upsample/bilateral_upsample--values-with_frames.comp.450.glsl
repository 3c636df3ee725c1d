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
    vec2 _78 = vec2(gl_GlobalInvocationID.xy) * 2.0;
    vec2 _87 = (floor(fma(_78 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _92 = textureGather(gInCoarseDepth, _87).wzxy;
    vec4 _95 = mix(vec4(65504.0), min(_92, vec4(65504.0)), greaterThan(_92, vec4(0.0)));
    vec4 _100 = textureGather(gInFiltered, _87).wzxy;
    bvec4 _101 = greaterThanEqual(_100, vec4(0.0));
    bvec4 _102 = lessThan(_100, vec4(16777216.0));
    vec4 _104 = vec4(bvec4(_101.x && _102.x, _101.y && _102.y, _101.z && _102.z, _101.w && _102.w));
    vec4 _106 = mix(vec4(0.0), _100, greaterThan(_104, vec4(0.5)));
    vec4 _110 = _106 - (floor(_106 * 9.5367431640625e-07) * 1048576.0);
    vec4 _112 = floor(_110 * 0.0009765625);
    vec4 _113 = _112 * 0.000977517105638980865478515625;
    vec4 _117 = min((_110 - (_112 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0));
    vec2 _120 = vec2(_113.x, _117.x);
    vec2 _123 = vec2(_113.y, _117.y);
    vec2 _126 = vec2(_113.z, _117.z);
    vec2 _129 = vec2(_113.w, _117.w);
    vec4 _137 = textureGather(gInDepth, _78 * parameters.gOutputSize.zw);
    float _138 = _137.w;
    float _148 = 1.0 / max(fma(_138, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _152 = min(parameters.gSkyDepth, 65504.0);
    vec4 _160 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_138 - 0.5) <= 0.5) ? (((_148 > 0.0) && (_148 < _152)) ? _148 : 65504.0) : 65504.0) - _95);
    vec4 _167 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _104) * _160.yxxx) * _160.zzyy) * _160.wwwz;
    vec4 _171 = _167 * (1.0 / max(dot(_167, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _186 = _137.z;
    float _192 = 1.0 / max(fma(_186, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _201 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_186 - 0.5) <= 0.5) ? (((_192 > 0.0) && (_192 < _152)) ? _192 : 65504.0) : 65504.0) - _95);
    vec4 _208 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _104) * _201.yxxx) * _201.zzyy) * _201.wwwz;
    vec4 _212 = _208 * (1.0 / max(dot(_208, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _227 = _137.x;
    float _233 = 1.0 / max(fma(_227, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _242 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_227 - 0.5) <= 0.5) ? (((_233 > 0.0) && (_233 < _152)) ? _233 : 65504.0) : 65504.0) - _95);
    vec4 _249 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _104) * _242.yxxx) * _242.zzyy) * _242.wwwz;
    vec4 _253 = _249 * (1.0 / max(dot(_249, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _268 = _137.y;
    float _274 = 1.0 / max(fma(_268, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _283 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_268 - 0.5) <= 0.5) ? (((_274 > 0.0) && (_274 < _152)) ? _274 : 65504.0) : 65504.0) - _95);
    vec4 _290 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _104) * _283.yxxx) * _283.zzyy) * _283.wwwz;
    vec4 _294 = _290 * (1.0 / max(dot(_290, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _309 = ivec2(_78 - vec2(1.0));
    imageStore(gOutUpsampled, _309, vec4((((_120 * _171.x) + (_123 * _171.y)) + (_126 * _171.z)) + (_129 * _171.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _309 + ivec2(1, 0), vec4((((_120 * _212.x) + (_123 * _212.y)) + (_126 * _212.z)) + (_129 * _212.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _309 + ivec2(0, 1), vec4((((_120 * _253.x) + (_123 * _253.y)) + (_126 * _253.z)) + (_129 * _253.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _309 + ivec2(1), vec4((((_120 * _294.x) + (_123 * _294.y)) + (_126 * _294.z)) + (_129 * _294.w), 0.0, 0.0));
}

