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
    vec4 _86 = textureLod(gInFiltered, _63, 0.0);
    vec4 _88 = textureLod(gInFiltered, _70, 0.0);
    vec4 _90 = textureLod(gInFiltered, _73, 0.0);
    vec4 _92 = textureLod(gInFiltered, _67, 0.0);
    float _96 = float(all(lessThanEqual(abs(_86), vec4(65504.0))));
    bvec4 _98 = bvec4(_96 > 0.5);
    float _103 = float(all(lessThanEqual(abs(_88), vec4(65504.0))));
    bvec4 _105 = bvec4(_103 > 0.5);
    float _110 = float(all(lessThanEqual(abs(_90), vec4(65504.0))));
    bvec4 _112 = bvec4(_110 > 0.5);
    float _117 = float(all(lessThanEqual(abs(_92), vec4(65504.0))));
    bvec4 _120 = bvec4(_117 > 0.5);
    vec4 _136 = vec4(textureLod(gInCoarseDepth, _63, 0.0).x, textureLod(gInCoarseDepth, _70, 0.0).x, textureLod(gInCoarseDepth, _73, 0.0).x, textureLod(gInCoarseDepth, _67, 0.0).x);
    vec4 _137 = min(_136, vec4(65504.0));
    bvec4 _138 = greaterThan(_136, vec4(0.0));
    vec4 _147 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _148 = _147.x;
    float _158 = 1.0 / max(_148 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _170 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_148 - 0.5) <= 0.5) ? (((_158 > 0.0) && (_158 < min(parameters.gSkyDepth, 65504.0))) ? _158 : 65504.0) : 65504.0) - vec4(_138.x ? _137.x : vec4(65504.0).x, _138.y ? _137.y : vec4(65504.0).y, _138.z ? _137.z : vec4(65504.0).z, _138.w ? _137.w : vec4(65504.0).w));
    vec4 _177 = ((((vec4(_76, _77, _76, _77) * vec4(_75.yy, _74.yy)) * vec4(_96, _103, _110, _117)) * _170.yxxx) * _170.zzyy) * _170.wwwz;
    vec4 _181 = _177 * (1.0 / max(dot(_177, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = (((vec4(_98.x ? _86.x : vec4(0.0).x, _98.y ? _86.y : vec4(0.0).y, _98.z ? _86.z : vec4(0.0).z, _98.w ? _86.w : vec4(0.0).w) * _181.x) + (vec4(_105.x ? _88.x : vec4(0.0).x, _105.y ? _88.y : vec4(0.0).y, _105.z ? _88.z : vec4(0.0).z, _105.w ? _88.w : vec4(0.0).w) * _181.y)) + (vec4(_112.x ? _90.x : vec4(0.0).x, _112.y ? _90.y : vec4(0.0).y, _112.z ? _90.z : vec4(0.0).z, _112.w ? _90.w : vec4(0.0).w) * _181.z)) + (vec4(_120.x ? _92.x : vec4(0.0).x, _120.y ? _92.y : vec4(0.0).y, _120.z ? _92.z : vec4(0.0).z, _120.w ? _92.w : vec4(0.0).w) * _181.w);
}

