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
    vec2 _102 = vec2((gl_WorkGroupID.xy * uvec2(32u, 8u)) + uvec2((gl_LocalInvocationIndex & 15u) + ((gl_LocalInvocationIndex >> 1u) & 16u), ((gl_LocalInvocationIndex >> 4u) & 1u) + (2u * (gl_LocalInvocationIndex >> 6u)))) * 2.0;
    vec2 _111 = (floor(fma(_102 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _116 = textureGather(gInCoarseDepth, _111).wzxy;
    vec4 _119 = mix(vec4(65504.0), min(_116, vec4(65504.0)), greaterThan(_116, vec4(0.0)));
    vec4 _124 = textureGather(gInFiltered, _111).wzxy;
    bvec4 _125 = greaterThanEqual(_124, vec4(0.0));
    bvec4 _126 = lessThan(_124, vec4(16777216.0));
    vec4 _128 = vec4(bvec4(_125.x && _126.x, _125.y && _126.y, _125.z && _126.z, _125.w && _126.w));
    vec4 _130 = mix(vec4(0.0), _124, greaterThan(_128, vec4(0.5)));
    vec4 _134 = _130 - (floor(_130 * 9.5367431640625e-07) * 1048576.0);
    vec4 _136 = floor(_134 * 0.0009765625);
    vec4 _137 = _136 * 0.000977517105638980865478515625;
    vec4 _141 = min((_134 - (_136 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0));
    vec2 _144 = vec2(_137.x, _141.x);
    vec2 _147 = vec2(_137.y, _141.y);
    vec2 _150 = vec2(_137.z, _141.z);
    vec2 _153 = vec2(_137.w, _141.w);
    vec4 _161 = textureGather(gInDepth, _102 * parameters.gOutputSize.zw);
    float _162 = _161.w;
    float _172 = 1.0 / max(fma(_162, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _176 = min(parameters.gSkyDepth, 65504.0);
    vec4 _184 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_162 - 0.5) <= 0.5) ? (((_172 > 0.0) && (_172 < _176)) ? _172 : 65504.0) : 65504.0) - _119);
    vec4 _191 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _128) * _184.yxxx) * _184.zzyy) * _184.wwwz;
    vec4 _195 = _191 * (1.0 / max(dot(_191, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _206 = (((_144 * _195.x) + (_147 * _195.y)) + (_150 * _195.z)) + (_153 * _195.w);
    float _210 = _161.z;
    float _216 = 1.0 / max(fma(_210, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _225 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_210 - 0.5) <= 0.5) ? (((_216 > 0.0) && (_216 < _176)) ? _216 : 65504.0) : 65504.0) - _119);
    vec4 _232 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _128) * _225.yxxx) * _225.zzyy) * _225.wwwz;
    vec4 _236 = _232 * (1.0 / max(dot(_232, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _247 = (((_144 * _236.x) + (_147 * _236.y)) + (_150 * _236.z)) + (_153 * _236.w);
    float _251 = _161.x;
    float _257 = 1.0 / max(fma(_251, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _266 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_251 - 0.5) <= 0.5) ? (((_257 > 0.0) && (_257 < _176)) ? _257 : 65504.0) : 65504.0) - _119);
    vec4 _273 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _128) * _266.yxxx) * _266.zzyy) * _266.wwwz;
    vec4 _277 = _273 * (1.0 / max(dot(_273, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _288 = (((_144 * _277.x) + (_147 * _277.y)) + (_150 * _277.z)) + (_153 * _277.w);
    float _292 = _161.y;
    float _298 = 1.0 / max(fma(_292, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _307 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_292 - 0.5) <= 0.5) ? (((_298 > 0.0) && (_298 < _176)) ? _298 : 65504.0) : 65504.0) - _119);
    vec4 _314 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _128) * _307.yxxx) * _307.zzyy) * _307.wwwz;
    vec4 _318 = _314 * (1.0 / max(dot(_314, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _329 = (((_144 * _318.x) + (_147 * _318.y)) + (_150 * _318.z)) + (_153 * _318.w);
    ivec2 _333 = ivec2(_102 - vec2(1.0));
    imageStore(gOutUpsampled, _333, vec4(_206, 0.0, 0.0));
    imageStore(gOutUpsampled, _333 + ivec2(1, 0), vec4(_247, 0.0, 0.0));
    imageStore(gOutUpsampled, _333 + ivec2(0, 1), vec4(_288, 0.0, 0.0));
    imageStore(gOutUpsampled, _333 + ivec2(1), vec4(_329, 0.0, 0.0));
}

