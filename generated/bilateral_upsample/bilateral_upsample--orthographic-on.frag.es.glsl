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
    vec2 _62 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _63 = floor(_62);
    vec2 _64 = _62 - _63;
    vec2 _65 = vec2(1.0) - _64;
    vec2 _66 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _67 = _66 - vec2(1.0);
    vec2 _70 = (clamp(_63, vec2(0.0), _67) + vec2(0.5)) / _66;
    vec2 _74 = (clamp(_63 + vec2(1.0), vec2(0.0), _67) + vec2(0.5)) / _66;
    vec2 _77 = vec2(_74.x, _70.y);
    vec2 _80 = vec2(_70.x, _74.y);
    float _81 = _65.x;
    float _82 = _64.x;
    vec4 _102 = vec4(textureLod(gInFiltered, _70, 0.0).x, textureLod(gInFiltered, _77, 0.0).x, textureLod(gInFiltered, _80, 0.0).x, textureLod(gInFiltered, _74, 0.0).x);
    bvec4 _104 = lessThanEqual(abs(_102), vec4(65504.0));
    vec4 _105 = vec4(_104.x ? _102.x : vec4(1.9999999360571384930131252153835e+38).x, _104.y ? _102.y : vec4(1.9999999360571384930131252153835e+38).y, _104.z ? _102.z : vec4(1.9999999360571384930131252153835e+38).z, _104.w ? _102.w : vec4(1.9999999360571384930131252153835e+38).w);
    vec4 _128 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _129 = _128.x;
    float _137 = _129 * parameters.gLinearDepth.x + parameters.gLinearDepth.y;
    vec4 _148 = vec4(lessThanEqual(abs(_105), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _151 = abs(vec4((abs(_129 - 0.5) <= 0.5) ? (((_137 > 0.0) && (_137 < min(parameters.gSkyDepth, 65504.0))) ? _137 : 65504.0) : 65504.0) - vec4(textureLod(gInCoarseDepth, _70, 0.0).x, textureLod(gInCoarseDepth, _77, 0.0).x, textureLod(gInCoarseDepth, _80, 0.0).x, textureLod(gInCoarseDepth, _74, 0.0).x));
    vec4 _157 = (vec4(_81, _82, _81, _82) * vec4(_65.yy, _64.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _151);
    bvec4 _158 = greaterThan(_148 * vec4(lessThanEqual(abs(_151), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _159 = vec4(_158.x ? _157.x : vec4(0.0).x, _158.y ? _157.y : vec4(0.0).y, _158.z ? _157.z : vec4(0.0).z, _158.w ? _157.w : vec4(0.0).w);
    bvec4 _160 = greaterThan(_159, vec4(0.0));
    vec4 _161 = vec4(_160.x ? _159.x : vec4(0.0).x, _160.y ? _159.y : vec4(0.0).y, _160.z ? _159.z : vec4(0.0).z, _160.w ? _159.w : vec4(0.0).w);
    float _162 = dot(_161, vec4(1.0));
    vec4 _163 = vec4(_158.x ? _151.x : vec4(1.9999999360571384930131252153835e+38).x, _158.y ? _151.y : vec4(1.9999999360571384930131252153835e+38).y, _158.z ? _151.z : vec4(1.9999999360571384930131252153835e+38).z, _158.w ? _151.w : vec4(1.9999999360571384930131252153835e+38).w);
    bvec4 _172 = lessThanEqual(_163, vec4(min(min(_163.x, _163.y), min(_163.z, _163.w))));
    vec4 _173 = vec4(_172.x ? _148.x : vec4(0.0).x, _172.y ? _148.y : vec4(0.0).y, _172.z ? _148.z : vec4(0.0).z, _172.w ? _148.w : vec4(0.0).w);
    vec4 _178 = _161 / vec4(_162);
    vec4 _182 = _173 / vec4(max(dot(_173, vec4(1.0)), 1.0));
    bvec4 _183 = bvec4((_162 >= 1.0000000031710768509710513471353e-30) && (_162 <= 9.9999996802856924650656260769173e+37));
    bvec4 _185 = greaterThan(_148, vec4(0.5));
    gOutUpsampled = vec4(dot(vec4(_185.x ? _105.x : vec4(0.0).x, _185.y ? _105.y : vec4(0.0).y, _185.z ? _105.z : vec4(0.0).z, _185.w ? _105.w : vec4(0.0).w), vec4(_183.x ? _178.x : _182.x, _183.y ? _178.y : _182.y, _183.z ? _178.z : _182.z, _183.w ? _178.w : _182.w)), 0.0, 0.0, 0.0);
}

