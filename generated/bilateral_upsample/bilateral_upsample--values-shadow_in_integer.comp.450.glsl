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
    vec2 _137 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_129 * 0.0322580635547637939453125, min((_128 - _129) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_123) <= 65504.0));
    float _138 = _122.z;
    float _143 = (_138 > 0.0) ? min(_138, 31.984375) : 0.0;
    float _144 = floor(_143);
    vec2 _152 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_144 * 0.0322580635547637939453125, min((_143 - _144) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_138) <= 65504.0));
    float _153 = _122.x;
    float _158 = (_153 > 0.0) ? min(_153, 31.984375) : 0.0;
    float _159 = floor(_158);
    vec2 _167 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_159 * 0.0322580635547637939453125, min((_158 - _159) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_153) <= 65504.0));
    float _168 = _122.y;
    float _173 = (_168 > 0.0) ? min(_168, 31.984375) : 0.0;
    float _174 = floor(_173);
    vec2 _182 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_174 * 0.0322580635547637939453125, min((_173 - _174) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_168) <= 65504.0));
    float _186 = float(abs(_137.x) <= 65504.0);
    vec2 _189 = mix(vec2(0.0), _137, bvec2(_186 > 0.5));
    float _193 = float(abs(_152.x) <= 65504.0);
    vec2 _196 = mix(vec2(0.0), _152, bvec2(_193 > 0.5));
    float _200 = float(abs(_167.x) <= 65504.0);
    vec2 _203 = mix(vec2(0.0), _167, bvec2(_200 > 0.5));
    float _207 = float(abs(_182.x) <= 65504.0);
    vec4 _208 = vec4(_186, _193, _200, _207);
    vec2 _211 = mix(vec2(0.0), _182, bvec2(_207 > 0.5));
    vec4 _219 = textureGather(gInDepth, _101 * parameters.gOutputSize.zw);
    float _220 = _219.w;
    float _230 = 1.0 / max(fma(_220, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _234 = min(parameters.gSkyDepth, 65504.0);
    vec4 _242 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_220 - 0.5) <= 0.5) ? (((_230 > 0.0) && (_230 < _234)) ? _230 : 65504.0) : 65504.0) - _118);
    vec4 _249 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _208) * _242.yxxx) * _242.zzyy) * _242.wwwz;
    vec4 _253 = _249 * (1.0 / max(dot(_249, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _268 = _219.z;
    float _274 = 1.0 / max(fma(_268, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _283 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_268 - 0.5) <= 0.5) ? (((_274 > 0.0) && (_274 < _234)) ? _274 : 65504.0) : 65504.0) - _118);
    vec4 _290 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _208) * _283.yxxx) * _283.zzyy) * _283.wwwz;
    vec4 _294 = _290 * (1.0 / max(dot(_290, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _309 = _219.x;
    float _315 = 1.0 / max(fma(_309, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _324 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_309 - 0.5) <= 0.5) ? (((_315 > 0.0) && (_315 < _234)) ? _315 : 65504.0) : 65504.0) - _118);
    vec4 _331 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _208) * _324.yxxx) * _324.zzyy) * _324.wwwz;
    vec4 _335 = _331 * (1.0 / max(dot(_331, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _350 = _219.y;
    float _356 = 1.0 / max(fma(_350, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _365 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_350 - 0.5) <= 0.5) ? (((_356 > 0.0) && (_356 < _234)) ? _356 : 65504.0) : 65504.0) - _118);
    vec4 _372 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _208) * _365.yxxx) * _365.zzyy) * _365.wwwz;
    vec4 _376 = _372 * (1.0 / max(dot(_372, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _391 = ivec2(_101 - vec2(1.0));
    imageStore(gOutUpsampled, _391, vec4((((_189 * _253.x) + (_196 * _253.y)) + (_203 * _253.z)) + (_211 * _253.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _391 + ivec2(1, 0), vec4((((_189 * _294.x) + (_196 * _294.y)) + (_203 * _294.z)) + (_211 * _294.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _391 + ivec2(0, 1), vec4((((_189 * _335.x) + (_196 * _335.y)) + (_203 * _335.z)) + (_211 * _335.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _391 + ivec2(1), vec4((((_189 * _376.x) + (_196 * _376.y)) + (_203 * _376.z)) + (_211 * _376.w), 0.0, 0.0));
}

