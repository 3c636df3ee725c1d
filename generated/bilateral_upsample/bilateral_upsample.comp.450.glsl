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
    vec2 _94 = vec2((gl_WorkGroupID.xy * uvec2(32u, 8u)) + uvec2((gl_LocalInvocationIndex & 15u) + ((gl_LocalInvocationIndex >> 1u) & 16u), ((gl_LocalInvocationIndex >> 4u) & 1u) + (2u * (gl_LocalInvocationIndex >> 6u)))) * 2.0;
    vec2 _103 = (floor(fma(_94 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _108 = textureGather(gInCoarseDepth, _103).wzxy;
    vec4 _111 = mix(vec4(65504.0), min(_108, vec4(65504.0)), greaterThan(_108, vec4(0.0)));
    vec4 _115 = textureGather(gInFiltered, _103);
    float _116 = _115.w;
    float _117 = _115.z;
    float _118 = _115.x;
    float _119 = _115.y;
    float _122 = float(abs(_116) <= 65504.0);
    float _124 = (_122 > 0.5) ? _116 : 0.0;
    float _127 = float(abs(_117) <= 65504.0);
    float _129 = (_127 > 0.5) ? _117 : 0.0;
    float _132 = float(abs(_118) <= 65504.0);
    float _134 = (_132 > 0.5) ? _118 : 0.0;
    float _137 = float(abs(_119) <= 65504.0);
    vec4 _138 = vec4(_122, _127, _132, _137);
    float _140 = (_137 > 0.5) ? _119 : 0.0;
    vec4 _148 = textureGather(gInDepth, _94 * parameters.gOutputSize.zw);
    float _149 = _148.w;
    float _159 = 1.0 / max(fma(_149, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _163 = min(parameters.gSkyDepth, 65504.0);
    vec4 _171 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_149 - 0.5) <= 0.5) ? (((_159 > 0.0) && (_159 < _163)) ? _159 : 65504.0) : 65504.0) - _111);
    vec4 _178 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _138) * _171.yxxx) * _171.zzyy) * _171.wwwz;
    vec4 _182 = _178 * (1.0 / max(dot(_178, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _192 = _148.z;
    float _198 = 1.0 / max(fma(_192, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _207 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_192 - 0.5) <= 0.5) ? (((_198 > 0.0) && (_198 < _163)) ? _198 : 65504.0) : 65504.0) - _111);
    vec4 _214 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _138) * _207.yxxx) * _207.zzyy) * _207.wwwz;
    vec4 _218 = _214 * (1.0 / max(dot(_214, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _228 = _148.x;
    float _234 = 1.0 / max(fma(_228, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _243 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_228 - 0.5) <= 0.5) ? (((_234 > 0.0) && (_234 < _163)) ? _234 : 65504.0) : 65504.0) - _111);
    vec4 _250 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _138) * _243.yxxx) * _243.zzyy) * _243.wwwz;
    vec4 _254 = _250 * (1.0 / max(dot(_250, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _264 = _148.y;
    float _270 = 1.0 / max(fma(_264, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _279 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_264 - 0.5) <= 0.5) ? (((_270 > 0.0) && (_270 < _163)) ? _270 : 65504.0) : 65504.0) - _111);
    vec4 _286 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _138) * _279.yxxx) * _279.zzyy) * _279.wwwz;
    vec4 _290 = _286 * (1.0 / max(dot(_286, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _300 = ivec2(_94 - vec2(1.0));
    imageStore(gOutUpsampled, _300, vec4(fma(_182.w, _140, fma(_182.z, _134, fma(_182.x, _124, _182.y * _129))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _300 + ivec2(1, 0), vec4(fma(_218.w, _140, fma(_218.z, _134, fma(_218.x, _124, _218.y * _129))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _300 + ivec2(0, 1), vec4(fma(_254.w, _140, fma(_254.z, _134, fma(_254.x, _124, _254.y * _129))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _300 + ivec2(1), vec4(fma(_290.w, _140, fma(_290.z, _134, fma(_290.x, _124, _290.y * _129))), 0.0, 0.0, 0.0));
}

