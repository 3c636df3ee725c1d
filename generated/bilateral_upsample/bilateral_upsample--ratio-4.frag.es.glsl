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
    vec2 _64 = gl_FragCoord.xy * vec2(0.25) + vec2(-0.5);
    vec2 _65 = floor(_64);
    vec2 _66 = _64 - _65;
    vec2 _67 = vec2(1.0) - _66;
    vec2 _68 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _69 = _68 - vec2(1.0);
    vec2 _72 = (clamp(_65, vec2(0.0), _69) + vec2(0.5)) / _68;
    vec2 _76 = (clamp(_65 + vec2(1.0), vec2(0.0), _69) + vec2(0.5)) / _68;
    vec2 _79 = vec2(_76.x, _72.y);
    vec2 _82 = vec2(_72.x, _76.y);
    float _83 = _67.x;
    float _84 = _66.x;
    vec4 _104 = vec4(textureLod(gInFiltered, _72, 0.0).x, textureLod(gInFiltered, _79, 0.0).x, textureLod(gInFiltered, _82, 0.0).x, textureLod(gInFiltered, _76, 0.0).x);
    bvec4 _106 = lessThanEqual(abs(_104), vec4(65504.0));
    vec4 _107 = vec4(_106.x ? _104.x : vec4(1.9999999360571384930131252153835e+38).x, _106.y ? _104.y : vec4(1.9999999360571384930131252153835e+38).y, _106.z ? _104.z : vec4(1.9999999360571384930131252153835e+38).z, _106.w ? _104.w : vec4(1.9999999360571384930131252153835e+38).w);
    vec4 _130 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _131 = _130.x;
    float _141 = 1.0 / max(_131 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _152 = vec4(lessThanEqual(abs(_107), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _155 = abs(vec4((abs(_131 - 0.5) <= 0.5) ? (((_141 > 0.0) && (_141 < min(parameters.gSkyDepth, 65504.0))) ? _141 : 65504.0) : 65504.0) - vec4(textureLod(gInCoarseDepth, _72, 0.0).x, textureLod(gInCoarseDepth, _79, 0.0).x, textureLod(gInCoarseDepth, _82, 0.0).x, textureLod(gInCoarseDepth, _76, 0.0).x));
    vec4 _161 = (vec4(_83, _84, _83, _84) * vec4(_67.yy, _66.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _155);
    bvec4 _162 = greaterThan(_152 * vec4(lessThanEqual(abs(_155), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _163 = vec4(_162.x ? _161.x : vec4(0.0).x, _162.y ? _161.y : vec4(0.0).y, _162.z ? _161.z : vec4(0.0).z, _162.w ? _161.w : vec4(0.0).w);
    bvec4 _164 = greaterThan(_163, vec4(0.0));
    vec4 _165 = vec4(_164.x ? _163.x : vec4(0.0).x, _164.y ? _163.y : vec4(0.0).y, _164.z ? _163.z : vec4(0.0).z, _164.w ? _163.w : vec4(0.0).w);
    float _166 = dot(_165, vec4(1.0));
    vec4 _167 = vec4(_162.x ? _155.x : vec4(1.9999999360571384930131252153835e+38).x, _162.y ? _155.y : vec4(1.9999999360571384930131252153835e+38).y, _162.z ? _155.z : vec4(1.9999999360571384930131252153835e+38).z, _162.w ? _155.w : vec4(1.9999999360571384930131252153835e+38).w);
    bvec4 _176 = lessThanEqual(_167, vec4(min(min(_167.x, _167.y), min(_167.z, _167.w))));
    vec4 _177 = vec4(_176.x ? _152.x : vec4(0.0).x, _176.y ? _152.y : vec4(0.0).y, _176.z ? _152.z : vec4(0.0).z, _176.w ? _152.w : vec4(0.0).w);
    vec4 _182 = _165 / vec4(_166);
    vec4 _186 = _177 / vec4(max(dot(_177, vec4(1.0)), 1.0));
    bvec4 _187 = bvec4((_166 >= 1.0000000031710768509710513471353e-30) && (_166 <= 9.9999996802856924650656260769173e+37));
    bvec4 _189 = greaterThan(_152, vec4(0.5));
    gOutUpsampled = vec4(dot(vec4(_189.x ? _107.x : vec4(0.0).x, _189.y ? _107.y : vec4(0.0).y, _189.z ? _107.z : vec4(0.0).z, _189.w ? _107.w : vec4(0.0).w), vec4(_187.x ? _182.x : _186.x, _187.y ? _182.y : _186.y, _187.z ? _182.z : _186.z, _187.w ? _182.w : _186.w)), 0.0, 0.0, 0.0);
}

