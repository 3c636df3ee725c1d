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
    vec2 _112 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_105 * 0.0322580635547637939453125, min((_104 - _105) * 1.01587307453155517578125, 1.0)), bvec2(abs(_99) <= 65504.0));
    float _113 = _98.z;
    float _118 = (_113 > 0.0) ? min(_113, 31.984375) : 0.0;
    float _119 = floor(_118);
    vec2 _126 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_119 * 0.0322580635547637939453125, min((_118 - _119) * 1.01587307453155517578125, 1.0)), bvec2(abs(_113) <= 65504.0));
    float _127 = _98.x;
    float _132 = (_127 > 0.0) ? min(_127, 31.984375) : 0.0;
    float _133 = floor(_132);
    vec2 _140 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_133 * 0.0322580635547637939453125, min((_132 - _133) * 1.01587307453155517578125, 1.0)), bvec2(abs(_127) <= 65504.0));
    float _141 = _98.y;
    float _146 = (_141 > 0.0) ? min(_141, 31.984375) : 0.0;
    float _147 = floor(_146);
    vec2 _154 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_147 * 0.0322580635547637939453125, min((_146 - _147) * 1.01587307453155517578125, 1.0)), bvec2(abs(_141) <= 65504.0));
    float _158 = float(abs(_112.x) <= 65504.0);
    vec2 _161 = mix(vec2(0.0), _112, bvec2(_158 > 0.5));
    float _165 = float(abs(_126.x) <= 65504.0);
    vec2 _168 = mix(vec2(0.0), _126, bvec2(_165 > 0.5));
    float _172 = float(abs(_140.x) <= 65504.0);
    vec2 _175 = mix(vec2(0.0), _140, bvec2(_172 > 0.5));
    float _179 = float(abs(_154.x) <= 65504.0);
    vec4 _180 = vec4(_158, _165, _172, _179);
    vec2 _183 = mix(vec2(0.0), _154, bvec2(_179 > 0.5));
    vec4 _191 = textureGather(gInDepth, _77 * parameters.gOutputSize.zw);
    float _192 = _191.w;
    float _202 = 1.0 / max(fma(_192, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _206 = min(parameters.gSkyDepth, 65504.0);
    vec4 _214 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_192 - 0.5) <= 0.5) ? (((_202 > 0.0) && (_202 < _206)) ? _202 : 65504.0) : 65504.0) - _94);
    vec4 _221 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _180) * _214.yxxx) * _214.zzyy) * _214.wwwz;
    vec4 _225 = _221 * (1.0 / max(dot(_221, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _240 = _191.z;
    float _246 = 1.0 / max(fma(_240, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _255 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_240 - 0.5) <= 0.5) ? (((_246 > 0.0) && (_246 < _206)) ? _246 : 65504.0) : 65504.0) - _94);
    vec4 _262 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _180) * _255.yxxx) * _255.zzyy) * _255.wwwz;
    vec4 _266 = _262 * (1.0 / max(dot(_262, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _281 = _191.x;
    float _287 = 1.0 / max(fma(_281, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _296 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_281 - 0.5) <= 0.5) ? (((_287 > 0.0) && (_287 < _206)) ? _287 : 65504.0) : 65504.0) - _94);
    vec4 _303 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _180) * _296.yxxx) * _296.zzyy) * _296.wwwz;
    vec4 _307 = _303 * (1.0 / max(dot(_303, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _322 = _191.y;
    float _328 = 1.0 / max(fma(_322, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _337 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_322 - 0.5) <= 0.5) ? (((_328 > 0.0) && (_328 < _206)) ? _328 : 65504.0) : 65504.0) - _94);
    vec4 _344 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _180) * _337.yxxx) * _337.zzyy) * _337.wwwz;
    vec4 _348 = _344 * (1.0 / max(dot(_344, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _363 = ivec2(_77 - vec2(1.0));
    imageStore(gOutUpsampled, _363, vec4((((_161 * _225.x) + (_168 * _225.y)) + (_175 * _225.z)) + (_183 * _225.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _363 + ivec2(1, 0), vec4((((_161 * _266.x) + (_168 * _266.y)) + (_175 * _266.z)) + (_183 * _266.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _363 + ivec2(0, 1), vec4((((_161 * _307.x) + (_168 * _307.y)) + (_175 * _307.z)) + (_183 * _307.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _363 + ivec2(1), vec4((((_161 * _348.x) + (_168 * _348.y)) + (_175 * _348.z)) + (_183 * _348.w), 0.0, 0.0));
}

