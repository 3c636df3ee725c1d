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
    vec2 _101 = vec2((gl_WorkGroupID.xy * uvec2(32u, 8u)) + uvec2((gl_LocalInvocationIndex & 15u) + ((gl_LocalInvocationIndex >> 1u) & 16u), ((gl_LocalInvocationIndex >> 4u) & 1u) + (2u * (gl_LocalInvocationIndex >> 6u)))) * 2.0;
    vec2 _110 = (floor(fma(_101 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _115 = textureGather(gInCoarseDepth, _110).wzxy;
    vec4 _118 = mix(vec4(65504.0), min(_115, vec4(65504.0)), greaterThan(_115, vec4(0.0)));
    vec4 _122 = textureGather(gInFiltered, _110);
    float _123 = _122.w;
    float _128 = (_123 > 0.0) ? min(_123, 31.984375) : 0.0;
    float _129 = floor(_128);
    vec2 _136 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_129 * 0.0322580635547637939453125, min((_128 - _129) * 1.01587307453155517578125, 1.0)), bvec2(abs(_123) <= 65504.0));
    float _137 = _122.z;
    float _142 = (_137 > 0.0) ? min(_137, 31.984375) : 0.0;
    float _143 = floor(_142);
    vec2 _150 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_143 * 0.0322580635547637939453125, min((_142 - _143) * 1.01587307453155517578125, 1.0)), bvec2(abs(_137) <= 65504.0));
    float _151 = _122.x;
    float _156 = (_151 > 0.0) ? min(_151, 31.984375) : 0.0;
    float _157 = floor(_156);
    vec2 _164 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_157 * 0.0322580635547637939453125, min((_156 - _157) * 1.01587307453155517578125, 1.0)), bvec2(abs(_151) <= 65504.0));
    float _165 = _122.y;
    float _170 = (_165 > 0.0) ? min(_165, 31.984375) : 0.0;
    float _171 = floor(_170);
    vec2 _178 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_171 * 0.0322580635547637939453125, min((_170 - _171) * 1.01587307453155517578125, 1.0)), bvec2(abs(_165) <= 65504.0));
    float _182 = float(abs(_136.x) <= 65504.0);
    vec2 _185 = mix(vec2(0.0), _136, bvec2(_182 > 0.5));
    float _189 = float(abs(_150.x) <= 65504.0);
    vec2 _192 = mix(vec2(0.0), _150, bvec2(_189 > 0.5));
    float _196 = float(abs(_164.x) <= 65504.0);
    vec2 _199 = mix(vec2(0.0), _164, bvec2(_196 > 0.5));
    float _203 = float(abs(_178.x) <= 65504.0);
    vec4 _204 = vec4(_182, _189, _196, _203);
    vec2 _207 = mix(vec2(0.0), _178, bvec2(_203 > 0.5));
    vec4 _215 = textureGather(gInDepth, _101 * parameters.gOutputSize.zw);
    float _216 = _215.w;
    float _226 = 1.0 / max(fma(_216, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _230 = min(parameters.gSkyDepth, 65504.0);
    vec4 _238 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_216 - 0.5) <= 0.5) ? (((_226 > 0.0) && (_226 < _230)) ? _226 : 65504.0) : 65504.0) - _118);
    vec4 _245 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _204) * _238.yxxx) * _238.zzyy) * _238.wwwz;
    vec4 _249 = _245 * (1.0 / max(dot(_245, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _264 = _215.z;
    float _270 = 1.0 / max(fma(_264, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _279 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_264 - 0.5) <= 0.5) ? (((_270 > 0.0) && (_270 < _230)) ? _270 : 65504.0) : 65504.0) - _118);
    vec4 _286 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _204) * _279.yxxx) * _279.zzyy) * _279.wwwz;
    vec4 _290 = _286 * (1.0 / max(dot(_286, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _305 = _215.x;
    float _311 = 1.0 / max(fma(_305, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _320 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_305 - 0.5) <= 0.5) ? (((_311 > 0.0) && (_311 < _230)) ? _311 : 65504.0) : 65504.0) - _118);
    vec4 _327 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _204) * _320.yxxx) * _320.zzyy) * _320.wwwz;
    vec4 _331 = _327 * (1.0 / max(dot(_327, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _346 = _215.y;
    float _352 = 1.0 / max(fma(_346, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _361 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_346 - 0.5) <= 0.5) ? (((_352 > 0.0) && (_352 < _230)) ? _352 : 65504.0) : 65504.0) - _118);
    vec4 _368 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _204) * _361.yxxx) * _361.zzyy) * _361.wwwz;
    vec4 _372 = _368 * (1.0 / max(dot(_368, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _387 = ivec2(_101 - vec2(1.0));
    imageStore(gOutUpsampled, _387, vec4((((_185 * _249.x) + (_192 * _249.y)) + (_199 * _249.z)) + (_207 * _249.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _387 + ivec2(1, 0), vec4((((_185 * _290.x) + (_192 * _290.y)) + (_199 * _290.z)) + (_207 * _290.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _387 + ivec2(0, 1), vec4((((_185 * _331.x) + (_192 * _331.y)) + (_199 * _331.z)) + (_207 * _331.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _387 + ivec2(1), vec4((((_185 * _372.x) + (_192 * _372.y)) + (_199 * _372.z)) + (_207 * _372.w), 0.0, 0.0));
}

