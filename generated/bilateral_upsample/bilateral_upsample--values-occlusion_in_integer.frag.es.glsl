#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

uniform highp sampler2D gInFiltered;
uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _64 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _65 = floor(_64);
    vec2 _66 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _67 = _66 - vec2(1.0);
    vec2 _70 = (clamp(_65, vec2(0.0), _67) + vec2(0.5)) / _66;
    vec2 _74 = (clamp(_65 + vec2(1.0), vec2(0.0), _67) + vec2(0.5)) / _66;
    vec2 _77 = vec2(_74.x, _70.y);
    vec2 _80 = vec2(_70.x, _74.y);
    vec2 _81 = _64 - _65;
    vec2 _82 = vec2(1.0) - _81;
    float _83 = _82.x;
    float _84 = _81.x;
    vec4 _93 = textureLod(gInFiltered, _70, 0.0);
    float _94 = _93.x;
    vec4 _96 = textureLod(gInFiltered, _77, 0.0);
    float _97 = _96.x;
    vec4 _99 = textureLod(gInFiltered, _80, 0.0);
    float _100 = _99.x;
    vec4 _102 = textureLod(gInFiltered, _74, 0.0);
    float _103 = _102.x;
    float _108 = (_94 > 0.0) ? min(_94, 31.984375) : 0.0;
    float _109 = floor(_108);
    vec2 _114 = min(vec2(_109 * 0.0322580635547637939453125, (_108 - _109) * 1.01587307453155517578125), vec2(1.0));
    bvec2 _115 = bvec2(abs(_94) <= 65504.0);
    vec2 _116 = vec2(_115.x ? _114.x : vec2(1.9999999360571384930131252153835e+38).x, _115.y ? _114.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _121 = (_97 > 0.0) ? min(_97, 31.984375) : 0.0;
    float _122 = floor(_121);
    vec2 _127 = min(vec2(_122 * 0.0322580635547637939453125, (_121 - _122) * 1.01587307453155517578125), vec2(1.0));
    bvec2 _128 = bvec2(abs(_97) <= 65504.0);
    vec2 _129 = vec2(_128.x ? _127.x : vec2(1.9999999360571384930131252153835e+38).x, _128.y ? _127.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _134 = (_100 > 0.0) ? min(_100, 31.984375) : 0.0;
    float _135 = floor(_134);
    vec2 _140 = min(vec2(_135 * 0.0322580635547637939453125, (_134 - _135) * 1.01587307453155517578125), vec2(1.0));
    bvec2 _141 = bvec2(abs(_100) <= 65504.0);
    vec2 _142 = vec2(_141.x ? _140.x : vec2(1.9999999360571384930131252153835e+38).x, _141.y ? _140.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _147 = (_103 > 0.0) ? min(_103, 31.984375) : 0.0;
    float _148 = floor(_147);
    vec2 _153 = min(vec2(_148 * 0.0322580635547637939453125, (_147 - _148) * 1.01587307453155517578125), vec2(1.0));
    bvec2 _154 = bvec2(abs(_103) <= 65504.0);
    vec2 _155 = vec2(_154.x ? _153.x : vec2(1.9999999360571384930131252153835e+38).x, _154.y ? _153.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _159 = float(all(lessThanEqual(abs(_116), vec2(65504.0))));
    bvec2 _161 = bvec2(_159 > 0.5);
    float _166 = float(all(lessThanEqual(abs(_129), vec2(65504.0))));
    bvec2 _168 = bvec2(_166 > 0.5);
    float _173 = float(all(lessThanEqual(abs(_142), vec2(65504.0))));
    bvec2 _175 = bvec2(_173 > 0.5);
    float _180 = float(all(lessThanEqual(abs(_155), vec2(65504.0))));
    bvec2 _183 = bvec2(_180 > 0.5);
    vec4 _199 = vec4(textureLod(gInCoarseDepth, _70, 0.0).x, textureLod(gInCoarseDepth, _77, 0.0).x, textureLod(gInCoarseDepth, _80, 0.0).x, textureLod(gInCoarseDepth, _74, 0.0).x);
    vec4 _200 = min(_199, vec4(65504.0));
    bvec4 _201 = greaterThan(_199, vec4(0.0));
    vec4 _210 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _211 = _210.x;
    float _221 = 1.0 / max(_211 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _233 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_211 - 0.5) <= 0.5) ? (((_221 > 0.0) && (_221 < min(parameters.gSkyDepth, 65504.0))) ? _221 : 65504.0) : 65504.0) - vec4(_201.x ? _200.x : vec4(65504.0).x, _201.y ? _200.y : vec4(65504.0).y, _201.z ? _200.z : vec4(65504.0).z, _201.w ? _200.w : vec4(65504.0).w));
    vec4 _240 = ((((vec4(_83, _84, _83, _84) * vec4(_82.yy, _81.yy)) * vec4(_159, _166, _173, _180)) * _233.yxxx) * _233.zzyy) * _233.wwwz;
    vec4 _244 = _240 * (1.0 / max(dot(_240, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((vec2(_161.x ? _116.x : vec2(0.0).x, _161.y ? _116.y : vec2(0.0).y) * _244.x) + (vec2(_168.x ? _129.x : vec2(0.0).x, _168.y ? _129.y : vec2(0.0).y) * _244.y)) + (vec2(_175.x ? _142.x : vec2(0.0).x, _175.y ? _142.y : vec2(0.0).y) * _244.z)) + (vec2(_183.x ? _155.x : vec2(0.0).x, _183.y ? _155.y : vec2(0.0).y) * _244.w), 0.0, 0.0);
}

