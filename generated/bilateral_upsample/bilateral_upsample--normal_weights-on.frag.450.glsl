#version 450

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 1) uniform sampler2D gInFiltered;
layout(binding = 4) uniform sampler2D gInNormal;
layout(binding = 3) uniform sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _70 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _71 = floor(_70);
    vec2 _72 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _73 = _72 - vec2(1.0);
    vec2 _76 = (clamp(_71, vec2(0.0), _73) + vec2(0.5)) / _72;
    vec2 _77 = _71 + vec2(1.0);
    vec2 _80 = (clamp(_77, vec2(0.0), _73) + vec2(0.5)) / _72;
    vec2 _87 = _70 - _71;
    vec2 _88 = vec2(1.0) - _87;
    float _89 = _88.x;
    float _90 = _87.x;
    vec2 _97 = _77 * parameters.gCoarseSize.zw;
    vec4 _102 = textureGather(gInCoarseDepth, _97).wzxy;
    vec4 _109 = textureGather(gInFiltered, _97);
    float _110 = _109.w;
    float _111 = _109.z;
    float _112 = _109.x;
    float _113 = _109.y;
    float _116 = float(abs(_110) <= 65504.0);
    float _121 = float(abs(_111) <= 65504.0);
    float _126 = float(abs(_112) <= 65504.0);
    float _131 = float(abs(_113) <= 65504.0);
    vec4 _132 = vec4(_116, _121, _126, _131);
    vec2 _166 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _168 = textureLod(gInDepth, _166, 0.0);
    float _169 = _168.x;
    float _179 = 1.0 / max(fma(_169, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec3 _190 = textureLod(gInNormal, _166, 0.0).xyz;
    float _193 = dot(textureLod(gInNormal, (fma(_76, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _190);
    float _197 = min(parameters.gContrast, 256.0);
    bool _200 = parameters.gContrast > 0.0;
    float _202 = dot(textureLod(gInNormal, (fma(vec2(_80.x, _76.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _190);
    float _209 = dot(textureLod(gInNormal, (fma(vec2(_76.x, _80.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _190);
    float _216 = dot(textureLod(gInNormal, (fma(_80, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _190);
    vec4 _226 = abs(vec4((abs(_169 - 0.5) <= 0.5) ? (((_179 > 0.0) && (_179 < min(parameters.gSkyDepth, 65504.0))) ? _179 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_102, vec4(65504.0)), greaterThan(_102, vec4(0.0))));
    bvec4 _234 = greaterThan(_132 * vec4(lessThanEqual(abs(_226), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _235 = mix(vec4(0.0), ((vec4(_89, _90, _89, _90) * vec4(_88.yy, _87.yy)) * vec4(_200 ? ((_193 > 0.0) ? pow(min(abs(_193), 1.0), _197) : 0.0) : 1.0, _200 ? ((_202 > 0.0) ? pow(min(abs(_202), 1.0), _197) : 0.0) : 1.0, _200 ? ((_209 > 0.0) ? pow(min(abs(_209), 1.0), _197) : 0.0) : 1.0, _200 ? ((_216 > 0.0) ? pow(min(abs(_216), 1.0), _197) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _226), _234);
    vec4 _237 = mix(vec4(0.0), _235, greaterThan(_235, vec4(0.0)));
    float _238 = dot(_237, vec4(1.0));
    vec4 _239 = mix(vec4(1.9999999360571384930131252153835e+38), _226, _234);
    vec4 _249 = mix(vec4(0.0), _132, lessThanEqual(_239, vec4(min(min(_239.x, _239.y), min(_239.z, _239.w)))));
    vec4 _260 = mix(_249 / vec4(max(dot(_249, vec4(1.0)), 1.0)), _237 / vec4(_238), bvec4((_238 >= 1.0000000031710768509710513471353e-30) && (_238 <= 9.9999996802856924650656260769173e+37)));
    gOutUpsampled = vec4(fma(_260.w, (_131 > 0.5) ? _113 : 0.0, fma(_260.z, (_126 > 0.5) ? _112 : 0.0, fma(_260.x, (_116 > 0.5) ? _110 : 0.0, _260.y * ((_121 > 0.5) ? _111 : 0.0)))), 0.0, 0.0, 0.0);
}

