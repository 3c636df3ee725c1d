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

uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gInFiltered;
uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _69 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _70 = floor(_69);
    vec2 _71 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _72 = _71 - vec2(1.0);
    vec2 _75 = (clamp(_70, vec2(0.0), _72) + vec2(0.5)) / _71;
    vec2 _79 = (clamp(_70 + vec2(1.0), vec2(0.0), _72) + vec2(0.5)) / _71;
    vec2 _82 = vec2(_79.x, _75.y);
    vec2 _85 = vec2(_75.x, _79.y);
    vec2 _86 = _69 - _70;
    vec2 _87 = vec2(1.0) - _86;
    float _88 = _87.x;
    float _89 = _86.x;
    vec4 _109 = vec4(textureLod(gInCoarseDepth, _75, 0.0).x, textureLod(gInCoarseDepth, _82, 0.0).x, textureLod(gInCoarseDepth, _85, 0.0).x, textureLod(gInCoarseDepth, _79, 0.0).x);
    vec4 _110 = min(_109, vec4(65504.0));
    bvec4 _111 = greaterThan(_109, vec4(0.0));
    vec4 _117 = textureLod(gInFiltered, _75, 0.0).xxxx;
    bvec4 _118 = greaterThanEqual(_117, vec4(0.0));
    bvec4 _119 = lessThan(_117, vec4(16777216.0));
    vec4 _121 = vec4(bvec4(_118.x && _119.x, _118.y && _119.y, _118.z && _119.z, _118.w && _119.w));
    bvec4 _122 = greaterThan(_121, vec4(0.5));
    vec4 _123 = vec4(_122.x ? _117.x : vec4(0.0).x, _122.y ? _117.y : vec4(0.0).y, _122.z ? _117.z : vec4(0.0).z, _122.w ? _117.w : vec4(0.0).w);
    vec4 _127 = _123 - (floor(_123 * 9.5367431640625e-07) * 1048576.0);
    vec4 _129 = floor(_127 * 0.0009765625);
    vec2 _139 = vec2((_129 * 0.000977517105638980865478515625).x, min((_127 - (_129 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0)).x);
    bvec2 _140 = bvec2(_121.x > 0.5);
    vec2 _141 = vec2(_140.x ? _139.x : vec2(1.9999999360571384930131252153835e+38).x, _140.y ? _139.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _144 = textureLod(gInFiltered, _82, 0.0).xxxx;
    bvec4 _145 = greaterThanEqual(_144, vec4(0.0));
    bvec4 _146 = lessThan(_144, vec4(16777216.0));
    vec4 _148 = vec4(bvec4(_145.x && _146.x, _145.y && _146.y, _145.z && _146.z, _145.w && _146.w));
    bvec4 _149 = greaterThan(_148, vec4(0.5));
    vec4 _150 = vec4(_149.x ? _144.x : vec4(0.0).x, _149.y ? _144.y : vec4(0.0).y, _149.z ? _144.z : vec4(0.0).z, _149.w ? _144.w : vec4(0.0).w);
    vec4 _154 = _150 - (floor(_150 * 9.5367431640625e-07) * 1048576.0);
    vec4 _156 = floor(_154 * 0.0009765625);
    vec2 _166 = vec2((_156 * 0.000977517105638980865478515625).x, min((_154 - (_156 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0)).x);
    bvec2 _167 = bvec2(_148.x > 0.5);
    vec2 _168 = vec2(_167.x ? _166.x : vec2(1.9999999360571384930131252153835e+38).x, _167.y ? _166.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _171 = textureLod(gInFiltered, _85, 0.0).xxxx;
    bvec4 _172 = greaterThanEqual(_171, vec4(0.0));
    bvec4 _173 = lessThan(_171, vec4(16777216.0));
    vec4 _175 = vec4(bvec4(_172.x && _173.x, _172.y && _173.y, _172.z && _173.z, _172.w && _173.w));
    bvec4 _176 = greaterThan(_175, vec4(0.5));
    vec4 _177 = vec4(_176.x ? _171.x : vec4(0.0).x, _176.y ? _171.y : vec4(0.0).y, _176.z ? _171.z : vec4(0.0).z, _176.w ? _171.w : vec4(0.0).w);
    vec4 _181 = _177 - (floor(_177 * 9.5367431640625e-07) * 1048576.0);
    vec4 _183 = floor(_181 * 0.0009765625);
    vec2 _193 = vec2((_183 * 0.000977517105638980865478515625).x, min((_181 - (_183 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0)).x);
    bvec2 _194 = bvec2(_175.x > 0.5);
    vec2 _195 = vec2(_194.x ? _193.x : vec2(1.9999999360571384930131252153835e+38).x, _194.y ? _193.y : vec2(1.9999999360571384930131252153835e+38).y);
    vec4 _198 = textureLod(gInFiltered, _79, 0.0).xxxx;
    bvec4 _199 = greaterThanEqual(_198, vec4(0.0));
    bvec4 _200 = lessThan(_198, vec4(16777216.0));
    vec4 _202 = vec4(bvec4(_199.x && _200.x, _199.y && _200.y, _199.z && _200.z, _199.w && _200.w));
    bvec4 _203 = greaterThan(_202, vec4(0.5));
    vec4 _204 = vec4(_203.x ? _198.x : vec4(0.0).x, _203.y ? _198.y : vec4(0.0).y, _203.z ? _198.z : vec4(0.0).z, _203.w ? _198.w : vec4(0.0).w);
    vec4 _208 = _204 - (floor(_204 * 9.5367431640625e-07) * 1048576.0);
    vec4 _210 = floor(_208 * 0.0009765625);
    vec2 _220 = vec2((_210 * 0.000977517105638980865478515625).x, min((_208 - (_210 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0)).x);
    bvec2 _221 = bvec2(_202.x > 0.5);
    vec2 _222 = vec2(_221.x ? _220.x : vec2(1.9999999360571384930131252153835e+38).x, _221.y ? _220.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _226 = float(all(lessThanEqual(abs(_141), vec2(65504.0))));
    bvec2 _228 = bvec2(_226 > 0.5);
    float _233 = float(all(lessThanEqual(abs(_168), vec2(65504.0))));
    bvec2 _235 = bvec2(_233 > 0.5);
    float _240 = float(all(lessThanEqual(abs(_195), vec2(65504.0))));
    bvec2 _242 = bvec2(_240 > 0.5);
    float _247 = float(all(lessThanEqual(abs(_222), vec2(65504.0))));
    bvec2 _250 = bvec2(_247 > 0.5);
    vec4 _259 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _260 = _259.x;
    float _270 = 1.0 / max(_260 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _282 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_260 - 0.5) <= 0.5) ? (((_270 > 0.0) && (_270 < min(parameters.gSkyDepth, 65504.0))) ? _270 : 65504.0) : 65504.0) - vec4(_111.x ? _110.x : vec4(65504.0).x, _111.y ? _110.y : vec4(65504.0).y, _111.z ? _110.z : vec4(65504.0).z, _111.w ? _110.w : vec4(65504.0).w));
    vec4 _289 = ((((vec4(_88, _89, _88, _89) * vec4(_87.yy, _86.yy)) * vec4(_226, _233, _240, _247)) * _282.yxxx) * _282.zzyy) * _282.wwwz;
    vec4 _293 = _289 * (1.0 / max(dot(_289, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((vec2(_228.x ? _141.x : vec2(0.0).x, _228.y ? _141.y : vec2(0.0).y) * _293.x) + (vec2(_235.x ? _168.x : vec2(0.0).x, _235.y ? _168.y : vec2(0.0).y) * _293.y)) + (vec2(_242.x ? _195.x : vec2(0.0).x, _242.y ? _195.y : vec2(0.0).y) * _293.z)) + (vec2(_250.x ? _222.x : vec2(0.0).x, _250.y ? _222.y : vec2(0.0).y) * _293.w), 0.0, 0.0);
}

