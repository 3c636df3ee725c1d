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
uniform highp sampler2D gInNormal;
uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _70 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _74 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _75 = floor(_74);
    vec2 _76 = _74 - _75;
    vec2 _77 = vec2(1.0) - _76;
    vec2 _78 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _79 = _78 - vec2(1.0);
    vec2 _82 = (clamp(_75, vec2(0.0), _79) + vec2(0.5)) / _78;
    vec2 _86 = (clamp(_75 + vec2(1.0), vec2(0.0), _79) + vec2(0.5)) / _78;
    vec2 _89 = vec2(_86.x, _82.y);
    vec2 _92 = vec2(_82.x, _86.y);
    float _93 = _77.x;
    float _94 = _76.x;
    vec4 _114 = vec4(textureLod(gInFiltered, _82, 0.0).x, textureLod(gInFiltered, _89, 0.0).x, textureLod(gInFiltered, _92, 0.0).x, textureLod(gInFiltered, _86, 0.0).x);
    bvec4 _116 = lessThanEqual(abs(_114), vec4(65504.0));
    vec4 _117 = vec4(_116.x ? _114.x : vec4(1.9999999360571384930131252153835e+38).x, _116.y ? _114.y : vec4(1.9999999360571384930131252153835e+38).y, _116.z ? _114.z : vec4(1.9999999360571384930131252153835e+38).z, _116.w ? _114.w : vec4(1.9999999360571384930131252153835e+38).w);
    vec3 _161 = textureLod(gInNormal, _70, 0.0).xyz;
    float _164 = dot(textureLod(gInNormal, ((_82 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _161);
    float _168 = min(parameters.gContrast, 256.0);
    bool _171 = parameters.gContrast > 0.0;
    float _173 = dot(textureLod(gInNormal, ((_89 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _161);
    float _180 = dot(textureLod(gInNormal, ((_92 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _161);
    float _187 = dot(textureLod(gInNormal, ((_86 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _161);
    vec4 _198 = textureLod(gInDepth, _70, 0.0);
    float _199 = _198.x;
    float _209 = 1.0 / max(_199 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _220 = vec4(lessThanEqual(abs(_117), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _223 = abs(vec4((abs(_199 - 0.5) <= 0.5) ? (((_209 > 0.0) && (_209 < min(parameters.gSkyDepth, 65504.0))) ? _209 : 65504.0) : 65504.0) - vec4(textureLod(gInCoarseDepth, _82, 0.0).x, textureLod(gInCoarseDepth, _89, 0.0).x, textureLod(gInCoarseDepth, _92, 0.0).x, textureLod(gInCoarseDepth, _86, 0.0).x));
    vec4 _230 = ((vec4(_93, _94, _93, _94) * vec4(_77.yy, _76.yy)) * vec4(_171 ? ((_164 > 0.0) ? pow(min(abs(_164), 1.0), _168) : 0.0) : 1.0, _171 ? ((_173 > 0.0) ? pow(min(abs(_173), 1.0), _168) : 0.0) : 1.0, _171 ? ((_180 > 0.0) ? pow(min(abs(_180), 1.0), _168) : 0.0) : 1.0, _171 ? ((_187 > 0.0) ? pow(min(abs(_187), 1.0), _168) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _223);
    bvec4 _231 = greaterThan(_220 * vec4(lessThanEqual(abs(_223), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _232 = vec4(_231.x ? _230.x : vec4(0.0).x, _231.y ? _230.y : vec4(0.0).y, _231.z ? _230.z : vec4(0.0).z, _231.w ? _230.w : vec4(0.0).w);
    bvec4 _233 = greaterThan(_232, vec4(0.0));
    vec4 _234 = vec4(_233.x ? _232.x : vec4(0.0).x, _233.y ? _232.y : vec4(0.0).y, _233.z ? _232.z : vec4(0.0).z, _233.w ? _232.w : vec4(0.0).w);
    float _235 = dot(_234, vec4(1.0));
    vec4 _236 = vec4(_231.x ? _223.x : vec4(1.9999999360571384930131252153835e+38).x, _231.y ? _223.y : vec4(1.9999999360571384930131252153835e+38).y, _231.z ? _223.z : vec4(1.9999999360571384930131252153835e+38).z, _231.w ? _223.w : vec4(1.9999999360571384930131252153835e+38).w);
    bvec4 _245 = lessThanEqual(_236, vec4(min(min(_236.x, _236.y), min(_236.z, _236.w))));
    vec4 _246 = vec4(_245.x ? _220.x : vec4(0.0).x, _245.y ? _220.y : vec4(0.0).y, _245.z ? _220.z : vec4(0.0).z, _245.w ? _220.w : vec4(0.0).w);
    vec4 _251 = _234 / vec4(_235);
    vec4 _255 = _246 / vec4(max(dot(_246, vec4(1.0)), 1.0));
    bvec4 _256 = bvec4((_235 >= 1.0000000031710768509710513471353e-30) && (_235 <= 9.9999996802856924650656260769173e+37));
    bvec4 _258 = greaterThan(_220, vec4(0.5));
    gOutUpsampled = vec4(dot(vec4(_258.x ? _117.x : vec4(0.0).x, _258.y ? _117.y : vec4(0.0).y, _258.z ? _117.z : vec4(0.0).z, _258.w ? _117.w : vec4(0.0).w), vec4(_256.x ? _251.x : _255.x, _256.y ? _251.y : _255.y, _256.z ? _251.z : _255.z, _256.w ? _251.w : _255.w)), 0.0, 0.0, 0.0);
}

