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
    vec2 _57 = gl_FragCoord.xy * vec2(0.5) + vec2(-0.5);
    vec2 _58 = floor(_57);
    vec2 _59 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _60 = _59 - vec2(1.0);
    vec2 _63 = (clamp(_58, vec2(0.0), _60) + vec2(0.5)) / _59;
    vec2 _67 = (clamp(_58 + vec2(1.0), vec2(0.0), _60) + vec2(0.5)) / _59;
    vec2 _70 = vec2(_67.x, _63.y);
    vec2 _73 = vec2(_63.x, _67.y);
    vec2 _74 = _57 - _58;
    vec2 _75 = vec2(1.0) - _74;
    float _76 = _75.x;
    float _77 = _74.x;
    vec4 _97 = vec4(textureLod(gInCoarseDepth, _63, 0.0).x, textureLod(gInCoarseDepth, _70, 0.0).x, textureLod(gInCoarseDepth, _73, 0.0).x, textureLod(gInCoarseDepth, _67, 0.0).x);
    vec4 _98 = min(_97, vec4(65504.0));
    bvec4 _99 = greaterThan(_97, vec4(0.0));
    vec4 _104 = textureLod(gInFiltered, _63, 0.0);
    vec4 _106 = textureLod(gInFiltered, _70, 0.0);
    vec4 _108 = textureLod(gInFiltered, _73, 0.0);
    vec4 _110 = textureLod(gInFiltered, _67, 0.0);
    float _114 = float(all(lessThanEqual(abs(_104), vec4(65504.0))));
    bvec4 _116 = bvec4(_114 > 0.5);
    float _121 = float(all(lessThanEqual(abs(_106), vec4(65504.0))));
    bvec4 _123 = bvec4(_121 > 0.5);
    float _128 = float(all(lessThanEqual(abs(_108), vec4(65504.0))));
    bvec4 _130 = bvec4(_128 > 0.5);
    float _135 = float(all(lessThanEqual(abs(_110), vec4(65504.0))));
    bvec4 _138 = bvec4(_135 > 0.5);
    vec4 _147 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _148 = _147.x;
    float _158 = 1.0 / max(_148 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _170 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_148 - 0.5) <= 0.5) ? (((_158 > 0.0) && (_158 < min(parameters.gSkyDepth, 65504.0))) ? _158 : 65504.0) : 65504.0) - vec4(_99.x ? _98.x : vec4(65504.0).x, _99.y ? _98.y : vec4(65504.0).y, _99.z ? _98.z : vec4(65504.0).z, _99.w ? _98.w : vec4(65504.0).w));
    vec4 _177 = ((((vec4(_76, _77, _76, _77) * vec4(_75.yy, _74.yy)) * vec4(_114, _121, _128, _135)) * _170.yxxx) * _170.zzyy) * _170.wwwz;
    vec4 _181 = _177 * (1.0 / max(dot(_177, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = (((vec4(_116.x ? _104.x : vec4(0.0).x, _116.y ? _104.y : vec4(0.0).y, _116.z ? _104.z : vec4(0.0).z, _116.w ? _104.w : vec4(0.0).w) * _181.x) + (vec4(_123.x ? _106.x : vec4(0.0).x, _123.y ? _106.y : vec4(0.0).y, _123.z ? _106.z : vec4(0.0).z, _123.w ? _106.w : vec4(0.0).w) * _181.y)) + (vec4(_130.x ? _108.x : vec4(0.0).x, _130.y ? _108.y : vec4(0.0).y, _130.z ? _108.z : vec4(0.0).z, _130.w ? _108.w : vec4(0.0).w) * _181.z)) + (vec4(_138.x ? _110.x : vec4(0.0).x, _138.y ? _110.y : vec4(0.0).y, _138.z ? _110.z : vec4(0.0).z, _138.w ? _110.w : vec4(0.0).w) * _181.w);
}

