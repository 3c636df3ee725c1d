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
    vec2 _95 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_87 * 0.0322580635547637939453125, (_86 - _87) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_81) <= 65504.0));
    float _96 = _80.z;
    float _101 = (_96 > 0.0) ? min(_96, 31.984375) : 0.0;
    float _102 = floor(_101);
    vec2 _110 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_102 * 0.0322580635547637939453125, (_101 - _102) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_96) <= 65504.0));
    float _111 = _80.x;
    float _116 = (_111 > 0.0) ? min(_111, 31.984375) : 0.0;
    float _117 = floor(_116);
    vec2 _125 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_117 * 0.0322580635547637939453125, (_116 - _117) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_111) <= 65504.0));
    float _126 = _80.y;
    float _131 = (_126 > 0.0) ? min(_126, 31.984375) : 0.0;
    float _132 = floor(_131);
    vec2 _140 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_132 * 0.0322580635547637939453125, (_131 - _132) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_126) <= 65504.0));
    float _144 = float(all(lessThanEqual(abs(_95), vec2(65504.0))));
    float _151 = float(all(lessThanEqual(abs(_110), vec2(65504.0))));
    float _158 = float(all(lessThanEqual(abs(_125), vec2(65504.0))));
    float _165 = float(all(lessThanEqual(abs(_140), vec2(65504.0))));
    vec4 _174 = textureGather(gInCoarseDepth, _78).wzxy;
    vec4 _185 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _186 = _185.x;
    float _196 = 1.0 / max(fma(_186, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _208 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_186 - 0.5) <= 0.5) ? (((_196 > 0.0) && (_196 < min(parameters.gSkyDepth, 65504.0))) ? _196 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_174, vec4(65504.0)), greaterThan(_174, vec4(0.0))));
    vec4 _215 = ((((vec4(_65, _66, _65, _66) * vec4(_64.yy, _63.yy)) * vec4(_144, _151, _158, _165)) * _208.yxxx) * _208.zzyy) * _208.wwwz;
    vec4 _219 = _215 * (1.0 / max(dot(_215, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((mix(vec2(0.0), _95, bvec2(_144 > 0.5)) * _219.x) + (mix(vec2(0.0), _110, bvec2(_151 > 0.5)) * _219.y)) + (mix(vec2(0.0), _125, bvec2(_158 > 0.5)) * _219.z)) + (mix(vec2(0.0), _140, bvec2(_165 > 0.5)) * _219.w), 0.0, 0.0);
}

