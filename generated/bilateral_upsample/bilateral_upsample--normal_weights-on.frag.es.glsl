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
uniform highp sampler2D gInCoarseNormal;
uniform highp sampler2D gInNormal;
uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _69 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _73 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _74 = floor(_73);
    vec2 _75 = _73 - _74;
    vec2 _76 = vec2(1.0) - _75;
    vec2 _77 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _78 = _77 - vec2(1.0);
    vec2 _81 = (clamp(_74, vec2(0.0), _78) + vec2(0.5)) / _77;
    vec2 _85 = (clamp(_74 + vec2(1.0), vec2(0.0), _78) + vec2(0.5)) / _77;
    vec2 _88 = vec2(_85.x, _81.y);
    vec2 _91 = vec2(_81.x, _85.y);
    float _92 = _76.x;
    float _93 = _75.x;
    vec4 _113 = vec4(textureLod(gInFiltered, _81, 0.0).x, textureLod(gInFiltered, _88, 0.0).x, textureLod(gInFiltered, _91, 0.0).x, textureLod(gInFiltered, _85, 0.0).x);
    bvec4 _115 = lessThanEqual(abs(_113), vec4(65504.0));
    vec4 _116 = vec4(_115.x ? _113.x : vec4(1.9999999360571384930131252153835e+38).x, _115.y ? _113.y : vec4(1.9999999360571384930131252153835e+38).y, _115.z ? _113.z : vec4(1.9999999360571384930131252153835e+38).z, _115.w ? _113.w : vec4(1.9999999360571384930131252153835e+38).w);
    vec3 _150 = textureLod(gInNormal, _69, 0.0).xyz;
    float _154 = min(dot(textureLod(gInCoarseNormal, _81, 0.0).xyz, _150), 1.0);
    float _157 = min(parameters.gContrast, 256.0);
    bool _160 = parameters.gContrast > 0.0;
    float _163 = min(dot(textureLod(gInCoarseNormal, _88, 0.0).xyz, _150), 1.0);
    float _170 = min(dot(textureLod(gInCoarseNormal, _91, 0.0).xyz, _150), 1.0);
    float _177 = min(dot(textureLod(gInCoarseNormal, _85, 0.0).xyz, _150), 1.0);
    vec4 _187 = textureLod(gInDepth, _69, 0.0);
    float _188 = _187.x;
    float _198 = 1.0 / max(_188 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _209 = vec4(lessThanEqual(abs(_116), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _212 = abs(vec4((abs(_188 - 0.5) <= 0.5) ? (((_198 > 0.0) && (_198 < min(parameters.gSkyDepth, 65504.0))) ? _198 : 65504.0) : 65504.0) - vec4(textureLod(gInCoarseDepth, _81, 0.0).x, textureLod(gInCoarseDepth, _88, 0.0).x, textureLod(gInCoarseDepth, _91, 0.0).x, textureLod(gInCoarseDepth, _85, 0.0).x));
    vec4 _219 = ((vec4(_92, _93, _92, _93) * vec4(_76.yy, _75.yy)) * vec4(_160 ? ((_154 > 0.0) ? pow(abs(_154), _157) : 0.0) : 1.0, _160 ? ((_163 > 0.0) ? pow(abs(_163), _157) : 0.0) : 1.0, _160 ? ((_170 > 0.0) ? pow(abs(_170), _157) : 0.0) : 1.0, _160 ? ((_177 > 0.0) ? pow(abs(_177), _157) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _212);
    bvec4 _220 = greaterThan(_209 * vec4(lessThanEqual(abs(_212), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _221 = vec4(_220.x ? _219.x : vec4(0.0).x, _220.y ? _219.y : vec4(0.0).y, _220.z ? _219.z : vec4(0.0).z, _220.w ? _219.w : vec4(0.0).w);
    bvec4 _222 = greaterThan(_221, vec4(0.0));
    vec4 _223 = vec4(_222.x ? _221.x : vec4(0.0).x, _222.y ? _221.y : vec4(0.0).y, _222.z ? _221.z : vec4(0.0).z, _222.w ? _221.w : vec4(0.0).w);
    float _224 = dot(_223, vec4(1.0));
    vec4 _225 = vec4(_220.x ? _212.x : vec4(1.9999999360571384930131252153835e+38).x, _220.y ? _212.y : vec4(1.9999999360571384930131252153835e+38).y, _220.z ? _212.z : vec4(1.9999999360571384930131252153835e+38).z, _220.w ? _212.w : vec4(1.9999999360571384930131252153835e+38).w);
    bvec4 _234 = lessThanEqual(_225, vec4(min(min(_225.x, _225.y), min(_225.z, _225.w))));
    vec4 _235 = vec4(_234.x ? _209.x : vec4(0.0).x, _234.y ? _209.y : vec4(0.0).y, _234.z ? _209.z : vec4(0.0).z, _234.w ? _209.w : vec4(0.0).w);
    vec4 _240 = _223 / vec4(_224);
    vec4 _244 = _235 / vec4(max(dot(_235, vec4(1.0)), 1.0));
    bvec4 _245 = bvec4((_224 >= 1.0000000031710768509710513471353e-30) && (_224 <= 9.9999996802856924650656260769173e+37));
    bvec4 _247 = greaterThan(_209, vec4(0.5));
    gOutUpsampled = vec4(dot(vec4(_247.x ? _116.x : vec4(0.0).x, _247.y ? _116.y : vec4(0.0).y, _247.z ? _116.z : vec4(0.0).z, _247.w ? _116.w : vec4(0.0).w), vec4(_245.x ? _240.x : _244.x, _245.y ? _240.y : _244.y, _245.z ? _240.z : _244.z, _245.w ? _240.w : _244.w)), 0.0, 0.0, 0.0);
}

