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
uniform highp sampler2D gInNormal;
uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _70 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _71 = floor(_70);
    vec2 _72 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _73 = _72 - vec2(1.0);
    vec2 _76 = (clamp(_71, vec2(0.0), _73) + vec2(0.5)) / _72;
    vec2 _80 = (clamp(_71 + vec2(1.0), vec2(0.0), _73) + vec2(0.5)) / _72;
    vec2 _83 = vec2(_80.x, _76.y);
    vec2 _86 = vec2(_76.x, _80.y);
    vec2 _87 = _70 - _71;
    vec2 _88 = vec2(1.0) - _87;
    float _89 = _88.x;
    float _90 = _87.x;
    vec4 _110 = vec4(textureLod(gInCoarseDepth, _76, 0.0).x, textureLod(gInCoarseDepth, _83, 0.0).x, textureLod(gInCoarseDepth, _86, 0.0).x, textureLod(gInCoarseDepth, _80, 0.0).x);
    vec4 _111 = min(_110, vec4(65504.0));
    bvec4 _112 = greaterThan(_110, vec4(0.0));
    vec4 _117 = textureLod(gInFiltered, _76, 0.0);
    float _118 = _117.x;
    vec4 _120 = textureLod(gInFiltered, _83, 0.0);
    float _121 = _120.x;
    vec4 _123 = textureLod(gInFiltered, _86, 0.0);
    float _124 = _123.x;
    vec4 _126 = textureLod(gInFiltered, _80, 0.0);
    float _127 = _126.x;
    float _130 = float(abs(_118) <= 65504.0);
    float _135 = float(abs(_121) <= 65504.0);
    float _140 = float(abs(_124) <= 65504.0);
    float _145 = float(abs(_127) <= 65504.0);
    vec4 _146 = vec4(_130, _135, _140, _145);
    vec2 _180 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _182 = textureLod(gInDepth, _180, 0.0);
    float _183 = _182.x;
    float _193 = 1.0 / max(_183 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec3 _204 = textureLod(gInNormal, _180, 0.0).xyz;
    float _207 = dot(textureLod(gInNormal, ((_76 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _204);
    float _211 = min(parameters.gContrast, 256.0);
    bool _214 = parameters.gContrast > 0.0;
    float _216 = dot(textureLod(gInNormal, ((_83 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _204);
    float _223 = dot(textureLod(gInNormal, ((_86 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _204);
    float _230 = dot(textureLod(gInNormal, ((_80 * parameters.gCoarseSize.xy + vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _204);
    vec4 _240 = abs(vec4((abs(_183 - 0.5) <= 0.5) ? (((_193 > 0.0) && (_193 < min(parameters.gSkyDepth, 65504.0))) ? _193 : 65504.0) : 65504.0) - vec4(_112.x ? _111.x : vec4(65504.0).x, _112.y ? _111.y : vec4(65504.0).y, _112.z ? _111.z : vec4(65504.0).z, _112.w ? _111.w : vec4(65504.0).w));
    vec4 _247 = ((vec4(_89, _90, _89, _90) * vec4(_88.yy, _87.yy)) * vec4(_214 ? ((_207 > 0.0) ? pow(min(abs(_207), 1.0), _211) : 0.0) : 1.0, _214 ? ((_216 > 0.0) ? pow(min(abs(_216), 1.0), _211) : 0.0) : 1.0, _214 ? ((_223 > 0.0) ? pow(min(abs(_223), 1.0), _211) : 0.0) : 1.0, _214 ? ((_230 > 0.0) ? pow(min(abs(_230), 1.0), _211) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _240);
    bvec4 _248 = greaterThan(_146 * vec4(lessThanEqual(abs(_240), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _249 = vec4(_248.x ? _247.x : vec4(0.0).x, _248.y ? _247.y : vec4(0.0).y, _248.z ? _247.z : vec4(0.0).z, _248.w ? _247.w : vec4(0.0).w);
    bvec4 _250 = greaterThan(_249, vec4(0.0));
    vec4 _251 = vec4(_250.x ? _249.x : vec4(0.0).x, _250.y ? _249.y : vec4(0.0).y, _250.z ? _249.z : vec4(0.0).z, _250.w ? _249.w : vec4(0.0).w);
    float _252 = dot(_251, vec4(1.0));
    vec4 _253 = vec4(_248.x ? _240.x : vec4(1.9999999360571384930131252153835e+38).x, _248.y ? _240.y : vec4(1.9999999360571384930131252153835e+38).y, _248.z ? _240.z : vec4(1.9999999360571384930131252153835e+38).z, _248.w ? _240.w : vec4(1.9999999360571384930131252153835e+38).w);
    bvec4 _262 = lessThanEqual(_253, vec4(min(min(_253.x, _253.y), min(_253.z, _253.w))));
    vec4 _263 = vec4(_262.x ? _146.x : vec4(0.0).x, _262.y ? _146.y : vec4(0.0).y, _262.z ? _146.z : vec4(0.0).z, _262.w ? _146.w : vec4(0.0).w);
    vec4 _268 = _251 / vec4(_252);
    vec4 _272 = _263 / vec4(max(dot(_263, vec4(1.0)), 1.0));
    bvec4 _273 = bvec4((_252 >= 1.0000000031710768509710513471353e-30) && (_252 <= 9.9999996802856924650656260769173e+37));
    vec4 _274 = vec4(_273.x ? _268.x : _272.x, _273.y ? _268.y : _272.y, _273.z ? _268.z : _272.z, _273.w ? _268.w : _272.w);
    gOutUpsampled = vec4(_274.w * ((_145 > 0.5) ? _127 : 0.0) + (_274.z * ((_140 > 0.5) ? _124 : 0.0) + (_274.x * ((_130 > 0.5) ? _118 : 0.0) + (_274.y * ((_135 > 0.5) ? _121 : 0.0)))), 0.0, 0.0, 0.0);
}

