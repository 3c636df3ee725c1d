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
    vec2 _97 = vec2((gl_WorkGroupID.xy * uvec2(32u, 8u)) + uvec2((gl_LocalInvocationIndex & 15u) + ((gl_LocalInvocationIndex >> 1u) & 16u), ((gl_LocalInvocationIndex >> 4u) & 1u) + (2u * (gl_LocalInvocationIndex >> 6u)))) * 2.0;
    vec2 _106 = (floor(fma(_97 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _111 = textureGather(gInCoarseDepth, _106).wzxy;
    vec4 _114 = mix(vec4(65504.0), min(_111, vec4(65504.0)), greaterThan(_111, vec4(0.0)));
    vec4 _118 = textureGather(gInFiltered, _106);
    vec4 _120 = textureGather(gInFiltered, _106, 1);
    vec2 _124 = vec4(_118.w, _120.w, 0.0, 0.0).xy;
    vec2 _128 = vec4(_118.z, _120.z, 0.0, 0.0).xy;
    vec2 _132 = vec4(_118.x, _120.x, 0.0, 0.0).xy;
    vec2 _136 = vec4(_118.y, _120.y, 0.0, 0.0).xy;
    float _140 = float(all(lessThanEqual(abs(_124), vec2(65504.0))));
    vec2 _143 = mix(vec2(0.0), _124, bvec2(_140 > 0.5));
    float _147 = float(all(lessThanEqual(abs(_128), vec2(65504.0))));
    vec2 _150 = mix(vec2(0.0), _128, bvec2(_147 > 0.5));
    float _154 = float(all(lessThanEqual(abs(_132), vec2(65504.0))));
    vec2 _157 = mix(vec2(0.0), _132, bvec2(_154 > 0.5));
    float _161 = float(all(lessThanEqual(abs(_136), vec2(65504.0))));
    vec4 _162 = vec4(_140, _147, _154, _161);
    vec2 _165 = mix(vec2(0.0), _136, bvec2(_161 > 0.5));
    vec4 _173 = textureGather(gInDepth, _97 * parameters.gOutputSize.zw);
    float _174 = _173.w;
    float _184 = 1.0 / max(fma(_174, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _188 = min(parameters.gSkyDepth, 65504.0);
    vec4 _196 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_174 - 0.5) <= 0.5) ? (((_184 > 0.0) && (_184 < _188)) ? _184 : 65504.0) : 65504.0) - _114);
    vec4 _203 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _162) * _196.yxxx) * _196.zzyy) * _196.wwwz;
    vec4 _207 = _203 * (1.0 / max(dot(_203, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _222 = _173.z;
    float _228 = 1.0 / max(fma(_222, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _237 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_222 - 0.5) <= 0.5) ? (((_228 > 0.0) && (_228 < _188)) ? _228 : 65504.0) : 65504.0) - _114);
    vec4 _244 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _162) * _237.yxxx) * _237.zzyy) * _237.wwwz;
    vec4 _248 = _244 * (1.0 / max(dot(_244, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _263 = _173.x;
    float _269 = 1.0 / max(fma(_263, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _278 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_263 - 0.5) <= 0.5) ? (((_269 > 0.0) && (_269 < _188)) ? _269 : 65504.0) : 65504.0) - _114);
    vec4 _285 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _162) * _278.yxxx) * _278.zzyy) * _278.wwwz;
    vec4 _289 = _285 * (1.0 / max(dot(_285, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _304 = _173.y;
    float _310 = 1.0 / max(fma(_304, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _319 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_304 - 0.5) <= 0.5) ? (((_310 > 0.0) && (_310 < _188)) ? _310 : 65504.0) : 65504.0) - _114);
    vec4 _326 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _162) * _319.yxxx) * _319.zzyy) * _319.wwwz;
    vec4 _330 = _326 * (1.0 / max(dot(_326, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _345 = ivec2(_97 - vec2(1.0));
    imageStore(gOutUpsampled, _345, vec4((((_143 * _207.x) + (_150 * _207.y)) + (_157 * _207.z)) + (_165 * _207.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _345 + ivec2(1, 0), vec4((((_143 * _248.x) + (_150 * _248.y)) + (_157 * _248.z)) + (_165 * _248.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _345 + ivec2(0, 1), vec4((((_143 * _289.x) + (_150 * _289.y)) + (_157 * _289.z)) + (_165 * _289.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _345 + ivec2(1), vec4((((_143 * _330.x) + (_150 * _330.y)) + (_157 * _330.z)) + (_165 * _330.w), 0.0, 0.0));
}

