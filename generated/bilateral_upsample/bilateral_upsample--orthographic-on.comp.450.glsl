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
    float _157 = fma(_149, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
    float _161 = min(parameters.gSkyDepth, 65504.0);
    vec4 _169 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_149 - 0.5) <= 0.5) ? (((_157 > 0.0) && (_157 < _161)) ? _157 : 65504.0) : 65504.0) - _111);
    vec4 _176 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _138) * _169.yxxx) * _169.zzyy) * _169.wwwz;
    vec4 _180 = _176 * (1.0 / max(dot(_176, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _190 = _148.z;
    float _194 = fma(_190, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
    vec4 _203 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_190 - 0.5) <= 0.5) ? (((_194 > 0.0) && (_194 < _161)) ? _194 : 65504.0) : 65504.0) - _111);
    vec4 _210 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _138) * _203.yxxx) * _203.zzyy) * _203.wwwz;
    vec4 _214 = _210 * (1.0 / max(dot(_210, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _224 = _148.x;
    float _228 = fma(_224, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
    vec4 _237 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_224 - 0.5) <= 0.5) ? (((_228 > 0.0) && (_228 < _161)) ? _228 : 65504.0) : 65504.0) - _111);
    vec4 _244 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _138) * _237.yxxx) * _237.zzyy) * _237.wwwz;
    vec4 _248 = _244 * (1.0 / max(dot(_244, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _258 = _148.y;
    float _262 = fma(_258, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
    vec4 _271 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_258 - 0.5) <= 0.5) ? (((_262 > 0.0) && (_262 < _161)) ? _262 : 65504.0) : 65504.0) - _111);
    vec4 _278 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _138) * _271.yxxx) * _271.zzyy) * _271.wwwz;
    vec4 _282 = _278 * (1.0 / max(dot(_278, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _292 = ivec2(_94 - vec2(1.0));
    imageStore(gOutUpsampled, _292, vec4(fma(_180.w, _140, fma(_180.z, _134, fma(_180.x, _124, _180.y * _129))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _292 + ivec2(1, 0), vec4(fma(_214.w, _140, fma(_214.z, _134, fma(_214.x, _124, _214.y * _129))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _292 + ivec2(0, 1), vec4(fma(_248.w, _140, fma(_248.z, _134, fma(_248.x, _124, _248.y * _129))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _292 + ivec2(1), vec4(fma(_282.w, _140, fma(_282.z, _134, fma(_282.x, _124, _282.y * _129))), 0.0, 0.0, 0.0));
}

