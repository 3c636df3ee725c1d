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
    vec2 _70 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _71 = floor(_70);
    vec2 _72 = _70 - _71;
    vec2 _73 = vec2(1.0) - _72;
    vec2 _74 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _75 = _74 - vec2(1.0);
    vec2 _78 = (clamp(_71, vec2(0.0), _75) + vec2(0.5)) / _74;
    vec2 _82 = (clamp(_71 + vec2(1.0), vec2(0.0), _75) + vec2(0.5)) / _74;
    vec2 _85 = vec2(_82.x, _78.y);
    vec2 _88 = vec2(_78.x, _82.y);
    float _89 = _73.x;
    float _90 = _72.x;
    vec4 _110 = vec4(textureLod(gInFiltered, _78, 0.0).x, textureLod(gInFiltered, _85, 0.0).x, textureLod(gInFiltered, _88, 0.0).x, textureLod(gInFiltered, _82, 0.0).x);
    bvec4 _112 = lessThanEqual(abs(_110), vec4(65504.0));
    vec4 _113 = vec4(_112.x ? _110.x : vec4(1.9999999360571384930131252153835e+38).x, _112.y ? _110.y : vec4(1.9999999360571384930131252153835e+38).y, _112.z ? _110.z : vec4(1.9999999360571384930131252153835e+38).z, _112.w ? _110.w : vec4(1.9999999360571384930131252153835e+38).w);
    vec2 _160 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _162 = textureLod(gInDepth, _160, 0.0);
    float _163 = _162.x;
    float _173 = 1.0 / max(_163 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec3 _184 = textureLod(gInNormal, _160, 0.0).xyz;
    float _187 = dot(textureLod(gInNormal, ((_78 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _184);
    float _191 = min(parameters.gContrast, 256.0);
    bool _194 = parameters.gContrast > 0.0;
    float _196 = dot(textureLod(gInNormal, ((_85 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _184);
    float _203 = dot(textureLod(gInNormal, ((_88 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _184);
    float _210 = dot(textureLod(gInNormal, ((_82 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _184);
    vec4 _220 = vec4(lessThanEqual(abs(_113), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _223 = abs(vec4((abs(_163 - 0.5) <= 0.5) ? (((_173 > 0.0) && (_173 < min(parameters.gSkyDepth, 65504.0))) ? _173 : 65504.0) : 65504.0) - vec4(textureLod(gInCoarseDepth, _78, 0.0).x, textureLod(gInCoarseDepth, _85, 0.0).x, textureLod(gInCoarseDepth, _88, 0.0).x, textureLod(gInCoarseDepth, _82, 0.0).x));
    vec4 _230 = ((vec4(_89, _90, _89, _90) * vec4(_73.yy, _72.yy)) * vec4(_194 ? ((_187 > 0.0) ? pow(min(abs(_187), 1.0), _191) : 0.0) : 1.0, _194 ? ((_196 > 0.0) ? pow(min(abs(_196), 1.0), _191) : 0.0) : 1.0, _194 ? ((_203 > 0.0) ? pow(min(abs(_203), 1.0), _191) : 0.0) : 1.0, _194 ? ((_210 > 0.0) ? pow(min(abs(_210), 1.0), _191) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _223);
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
    gOutUpsampled = vec4(dot(vec4(_258.x ? _113.x : vec4(0.0).x, _258.y ? _113.y : vec4(0.0).y, _258.z ? _113.z : vec4(0.0).z, _258.w ? _113.w : vec4(0.0).w), vec4(_256.x ? _251.x : _255.x, _256.y ? _251.y : _255.y, _256.z ? _251.z : _255.z, _256.w ? _251.w : _255.w)), 0.0, 0.0, 0.0);
}

