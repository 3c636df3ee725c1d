#version 450

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 1) uniform sampler2D gInFiltered;
layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 3) uniform sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _61 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _62 = floor(_61);
    vec2 _63 = _61 - _62;
    vec2 _64 = vec2(1.0) - _63;
    float _65 = _64.x;
    float _66 = _63.x;
    vec2 _78 = (_62 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _80 = textureGather(gInFiltered, _78);
    float _81 = _80.w;
    float _86 = (_81 > 0.0) ? min(_81, 31.984375) : 0.0;
    float _87 = floor(_86);
    vec2 _94 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_87 * 0.0322580635547637939453125, (_86 - _87) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_81) <= 65504.0));
    float _95 = _80.z;
    float _100 = (_95 > 0.0) ? min(_95, 31.984375) : 0.0;
    float _101 = floor(_100);
    vec2 _108 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_101 * 0.0322580635547637939453125, (_100 - _101) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_95) <= 65504.0));
    float _109 = _80.x;
    float _114 = (_109 > 0.0) ? min(_109, 31.984375) : 0.0;
    float _115 = floor(_114);
    vec2 _122 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_115 * 0.0322580635547637939453125, (_114 - _115) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_109) <= 65504.0));
    float _123 = _80.y;
    float _128 = (_123 > 0.0) ? min(_123, 31.984375) : 0.0;
    float _129 = floor(_128);
    vec2 _136 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_129 * 0.0322580635547637939453125, (_128 - _129) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_123) <= 65504.0));
    float _140 = float(all(lessThanEqual(abs(_94), vec2(65504.0))));
    float _147 = float(all(lessThanEqual(abs(_108), vec2(65504.0))));
    float _154 = float(all(lessThanEqual(abs(_122), vec2(65504.0))));
    float _161 = float(all(lessThanEqual(abs(_136), vec2(65504.0))));
    vec4 _170 = textureGather(gInCoarseDepth, _78).wzxy;
    vec4 _181 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _182 = _181.x;
    float _192 = 1.0 / max(fma(_182, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _204 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_182 - 0.5) <= 0.5) ? (((_192 > 0.0) && (_192 < min(parameters.gSkyDepth, 65504.0))) ? _192 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_170, vec4(65504.0)), greaterThan(_170, vec4(0.0))));
    vec4 _211 = ((((vec4(_65, _66, _65, _66) * vec4(_64.yy, _63.yy)) * vec4(_140, _147, _154, _161)) * _204.yxxx) * _204.zzyy) * _204.wwwz;
    vec4 _215 = _211 * (1.0 / max(dot(_211, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((mix(vec2(0.0), _94, bvec2(_140 > 0.5)) * _215.x) + (mix(vec2(0.0), _108, bvec2(_147 > 0.5)) * _215.y)) + (mix(vec2(0.0), _122, bvec2(_154 > 0.5)) * _215.z)) + (mix(vec2(0.0), _136, bvec2(_161 > 0.5)) * _215.w), 0.0, 0.0);
}

