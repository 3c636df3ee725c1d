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
    vec2 _60 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _61 = floor(_60);
    vec2 _62 = _60 - _61;
    vec2 _63 = vec2(1.0) - _62;
    vec2 _64 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _65 = _64 - vec2(1.0);
    vec2 _68 = (clamp(_61, vec2(0.0), _65) + vec2(0.5)) / _64;
    vec2 _72 = (clamp(_61 + vec2(1.0), vec2(0.0), _65) + vec2(0.5)) / _64;
    vec2 _75 = vec2(_72.x, _68.y);
    vec2 _78 = vec2(_68.x, _72.y);
    float _79 = _63.x;
    float _80 = _62.x;
    vec4 _100 = vec4(textureLod(gInFiltered, _68, 0.0).x, textureLod(gInFiltered, _75, 0.0).x, textureLod(gInFiltered, _78, 0.0).x, textureLod(gInFiltered, _72, 0.0).x);
    bvec4 _102 = lessThanEqual(abs(_100), vec4(65504.0));
    vec4 _103 = vec4(_102.x ? _100.x : vec4(1.9999999360571384930131252153835e+38).x, _102.y ? _100.y : vec4(1.9999999360571384930131252153835e+38).y, _102.z ? _100.z : vec4(1.9999999360571384930131252153835e+38).z, _102.w ? _100.w : vec4(1.9999999360571384930131252153835e+38).w);
    vec4 _126 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _127 = _126.x;
    vec4 _137 = vec4(lessThanEqual(abs(_103), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _140 = abs(vec4(((_127 > 0.0) && (_127 < min(parameters.gSkyDepth, 65504.0))) ? _127 : 65504.0) - vec4(textureLod(gInCoarseDepth, _68, 0.0).x, textureLod(gInCoarseDepth, _75, 0.0).x, textureLod(gInCoarseDepth, _78, 0.0).x, textureLod(gInCoarseDepth, _72, 0.0).x));
    vec4 _146 = (vec4(_79, _80, _79, _80) * vec4(_63.yy, _62.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _140);
    bvec4 _147 = greaterThan(_137 * vec4(lessThanEqual(abs(_140), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _148 = vec4(_147.x ? _146.x : vec4(0.0).x, _147.y ? _146.y : vec4(0.0).y, _147.z ? _146.z : vec4(0.0).z, _147.w ? _146.w : vec4(0.0).w);
    bvec4 _149 = greaterThan(_148, vec4(0.0));
    vec4 _150 = vec4(_149.x ? _148.x : vec4(0.0).x, _149.y ? _148.y : vec4(0.0).y, _149.z ? _148.z : vec4(0.0).z, _149.w ? _148.w : vec4(0.0).w);
    float _151 = dot(_150, vec4(1.0));
    vec4 _152 = vec4(_147.x ? _140.x : vec4(1.9999999360571384930131252153835e+38).x, _147.y ? _140.y : vec4(1.9999999360571384930131252153835e+38).y, _147.z ? _140.z : vec4(1.9999999360571384930131252153835e+38).z, _147.w ? _140.w : vec4(1.9999999360571384930131252153835e+38).w);
    bvec4 _161 = lessThanEqual(_152, vec4(min(min(_152.x, _152.y), min(_152.z, _152.w))));
    vec4 _162 = vec4(_161.x ? _137.x : vec4(0.0).x, _161.y ? _137.y : vec4(0.0).y, _161.z ? _137.z : vec4(0.0).z, _161.w ? _137.w : vec4(0.0).w);
    vec4 _167 = _150 / vec4(_151);
    vec4 _171 = _162 / vec4(max(dot(_162, vec4(1.0)), 1.0));
    bvec4 _172 = bvec4((_151 >= 1.0000000031710768509710513471353e-30) && (_151 <= 9.9999996802856924650656260769173e+37));
    bvec4 _174 = greaterThan(_137, vec4(0.5));
    gOutUpsampled = vec4(dot(vec4(_174.x ? _103.x : vec4(0.0).x, _174.y ? _103.y : vec4(0.0).y, _174.z ? _103.z : vec4(0.0).z, _174.w ? _103.w : vec4(0.0).w), vec4(_172.x ? _167.x : _171.x, _172.y ? _167.y : _171.y, _172.z ? _167.z : _171.z, _172.w ? _167.w : _171.w)), 0.0, 0.0, 0.0);
}

