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
    vec2 _95 = vec2((gl_WorkGroupID.xy * uvec2(32u, 8u)) + uvec2((gl_LocalInvocationIndex & 15u) + ((gl_LocalInvocationIndex >> 1u) & 16u), ((gl_LocalInvocationIndex >> 4u) & 1u) + (2u * (gl_LocalInvocationIndex >> 6u)))) * 2.0;
    vec2 _97 = fma(_95 + vec2(0.5), vec2(0.25), vec2(-0.5));
    vec2 _103 = (floor(_97) + vec2(1.0)) * parameters.gCoarseSize.zw;
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
    vec4 _149 = textureGather(gInDepth, (_95 + vec2(1.0)) * parameters.gOutputSize.zw);
    vec2 _150 = fract(_97);
    vec2 _151 = vec2(1.0) - _150;
    float _152 = _151.x;
    float _153 = _150.x;
    float _159 = _149.w;
    float _169 = 1.0 / max(fma(_159, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _173 = min(parameters.gSkyDepth, 65504.0);
    vec4 _181 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_159 - 0.5) <= 0.5) ? (((_169 > 0.0) && (_169 < _173)) ? _169 : 65504.0) : 65504.0) - _111);
    vec4 _188 = ((((vec4(_152, _153, _152, _153) * vec4(_151.yy, _150.yy)) * _138) * _181.yxxx) * _181.zzyy) * _181.wwwz;
    vec4 _192 = _188 * (1.0 / max(dot(_188, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _202 = _150 + vec2(0.25, 0.0);
    vec2 _203 = vec2(0.75, 1.0) - _150;
    float _204 = _203.x;
    float _205 = _202.x;
    float _211 = _149.z;
    float _217 = 1.0 / max(fma(_211, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _226 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_211 - 0.5) <= 0.5) ? (((_217 > 0.0) && (_217 < _173)) ? _217 : 65504.0) : 65504.0) - _111);
    vec4 _233 = ((((vec4(_204, _205, _204, _205) * vec4(_203.yy, _202.yy)) * _138) * _226.yxxx) * _226.zzyy) * _226.wwwz;
    vec4 _237 = _233 * (1.0 / max(dot(_233, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _247 = _150 + vec2(0.0, 0.25);
    vec2 _248 = vec2(1.0, 0.75) - _150;
    float _249 = _248.x;
    float _250 = _247.x;
    float _256 = _149.x;
    float _262 = 1.0 / max(fma(_256, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _271 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_256 - 0.5) <= 0.5) ? (((_262 > 0.0) && (_262 < _173)) ? _262 : 65504.0) : 65504.0) - _111);
    vec4 _278 = ((((vec4(_249, _250, _249, _250) * vec4(_248.yy, _247.yy)) * _138) * _271.yxxx) * _271.zzyy) * _271.wwwz;
    vec4 _282 = _278 * (1.0 / max(dot(_278, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _292 = _150 + vec2(0.25);
    vec2 _293 = vec2(0.75) - _150;
    float _294 = _293.x;
    float _295 = _292.x;
    float _301 = _149.y;
    float _307 = 1.0 / max(fma(_301, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _316 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_301 - 0.5) <= 0.5) ? (((_307 > 0.0) && (_307 < _173)) ? _307 : 65504.0) : 65504.0) - _111);
    vec4 _323 = ((((vec4(_294, _295, _294, _295) * vec4(_293.yy, _292.yy)) * _138) * _316.yxxx) * _316.zzyy) * _316.wwwz;
    vec4 _327 = _323 * (1.0 / max(dot(_323, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _337 = ivec2(_95);
    imageStore(gOutUpsampled, _337, vec4(fma(_192.w, _140, fma(_192.z, _134, fma(_192.x, _124, _192.y * _129))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _337 + ivec2(1, 0), vec4(fma(_237.w, _140, fma(_237.z, _134, fma(_237.x, _124, _237.y * _129))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _337 + ivec2(0, 1), vec4(fma(_282.w, _140, fma(_282.z, _134, fma(_282.x, _124, _282.y * _129))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _337 + ivec2(1), vec4(fma(_327.w, _140, fma(_327.z, _134, fma(_327.x, _124, _327.y * _129))), 0.0, 0.0, 0.0));
}

