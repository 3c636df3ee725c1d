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
    vec2 _77 = vec2(gl_GlobalInvocationID.xy) * 2.0;
    vec2 _86 = (floor(fma(_77 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _91 = textureGather(gInCoarseDepth, _86).wzxy;
    vec4 _94 = mix(vec4(65504.0), min(_91, vec4(65504.0)), greaterThan(_91, vec4(0.0)));
    vec4 _98 = textureGather(gInFiltered, _86);
    float _99 = _98.w;
    float _104 = (_99 > 0.0) ? min(_99, 31.984375) : 0.0;
    float _105 = floor(_104);
    vec2 _113 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_105 * 0.0322580635547637939453125, min((_104 - _105) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_99) <= 65504.0));
    float _114 = _98.z;
    float _119 = (_114 > 0.0) ? min(_114, 31.984375) : 0.0;
    float _120 = floor(_119);
    vec2 _128 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_120 * 0.0322580635547637939453125, min((_119 - _120) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_114) <= 65504.0));
    float _129 = _98.x;
    float _134 = (_129 > 0.0) ? min(_129, 31.984375) : 0.0;
    float _135 = floor(_134);
    vec2 _143 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_135 * 0.0322580635547637939453125, min((_134 - _135) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_129) <= 65504.0));
    float _144 = _98.y;
    float _149 = (_144 > 0.0) ? min(_144, 31.984375) : 0.0;
    float _150 = floor(_149);
    vec2 _158 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_150 * 0.0322580635547637939453125, min((_149 - _150) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_144) <= 65504.0));
    float _162 = float(abs(_113.x) <= 65504.0);
    vec2 _165 = mix(vec2(0.0), _113, bvec2(_162 > 0.5));
    float _169 = float(abs(_128.x) <= 65504.0);
    vec2 _172 = mix(vec2(0.0), _128, bvec2(_169 > 0.5));
    float _176 = float(abs(_143.x) <= 65504.0);
    vec2 _179 = mix(vec2(0.0), _143, bvec2(_176 > 0.5));
    float _183 = float(abs(_158.x) <= 65504.0);
    vec4 _184 = vec4(_162, _169, _176, _183);
    vec2 _187 = mix(vec2(0.0), _158, bvec2(_183 > 0.5));
    vec4 _195 = textureGather(gInDepth, _77 * parameters.gOutputSize.zw);
    float _196 = _195.w;
    float _206 = 1.0 / max(fma(_196, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _210 = min(parameters.gSkyDepth, 65504.0);
    vec4 _218 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_196 - 0.5) <= 0.5) ? (((_206 > 0.0) && (_206 < _210)) ? _206 : 65504.0) : 65504.0) - _94);
    vec4 _225 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _184) * _218.yxxx) * _218.zzyy) * _218.wwwz;
    vec4 _229 = _225 * (1.0 / max(dot(_225, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _244 = _195.z;
    float _250 = 1.0 / max(fma(_244, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _259 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_244 - 0.5) <= 0.5) ? (((_250 > 0.0) && (_250 < _210)) ? _250 : 65504.0) : 65504.0) - _94);
    vec4 _266 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _184) * _259.yxxx) * _259.zzyy) * _259.wwwz;
    vec4 _270 = _266 * (1.0 / max(dot(_266, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _285 = _195.x;
    float _291 = 1.0 / max(fma(_285, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _300 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_285 - 0.5) <= 0.5) ? (((_291 > 0.0) && (_291 < _210)) ? _291 : 65504.0) : 65504.0) - _94);
    vec4 _307 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _184) * _300.yxxx) * _300.zzyy) * _300.wwwz;
    vec4 _311 = _307 * (1.0 / max(dot(_307, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _326 = _195.y;
    float _332 = 1.0 / max(fma(_326, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _341 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_326 - 0.5) <= 0.5) ? (((_332 > 0.0) && (_332 < _210)) ? _332 : 65504.0) : 65504.0) - _94);
    vec4 _348 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _184) * _341.yxxx) * _341.zzyy) * _341.wwwz;
    vec4 _352 = _348 * (1.0 / max(dot(_348, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _367 = ivec2(_77 - vec2(1.0));
    imageStore(gOutUpsampled, _367, vec4((((_165 * _229.x) + (_172 * _229.y)) + (_179 * _229.z)) + (_187 * _229.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _367 + ivec2(1, 0), vec4((((_165 * _270.x) + (_172 * _270.y)) + (_179 * _270.z)) + (_187 * _270.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _367 + ivec2(0, 1), vec4((((_165 * _311.x) + (_172 * _311.y)) + (_179 * _311.z)) + (_187 * _311.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _367 + ivec2(1), vec4((((_165 * _352.x) + (_172 * _352.y)) + (_179 * _352.z)) + (_187 * _352.w), 0.0, 0.0));
}

