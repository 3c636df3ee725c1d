#version 450

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    float gRadius;
    float gFrameIndex;
    float gSubsetCount;
    vec2 gBias;
} parameters;

layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInCoarseNormal;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _81 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _85 = textureLod(gInCoarseDepth, _81, 0.0);
    float _86 = _85.x;
    float _88 = (_86 > 0.0) ? _86 : 65504.0;
    float _90 = (_88 < 65504.0) ? _88 : 65504.0;
    vec3 _99 = vec3(fma(_81, parameters.gViewRay.xy, parameters.gViewRay.zw) * _90, _90);
    vec3 _104 = textureLod(gInCoarseNormal, _81, 0.0).xyz;
    float _105 = dot(_104, _104);
    vec3 _112 = mix(vec3(0.0, 0.0, -1.0), _104 * inversesqrt(_105), bvec3((_105 > 9.9999999747524270787835121154785e-07) && (_105 < 1000000.0)));
    vec2 _113 = floor(gl_FragCoord.xy);
    float _118 = floor(parameters.gSubsetCount);
    float _121 = (_118 > 1.0) ? min(_118, 16.0) : 1.0;
    float _125 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec3 _131 = vec3(0.276690065860748291015625, 0.68417441844940185546875, 0.1988019049167633056640625) * fma(-_121, floor((_125 + 0.5) / _121), _125);
    vec2 _134 = floor(_113 * 0.5);
    vec2 _136 = _113 - (_134 * 2.0);
    vec2 _140 = _134 - (floor(_113 * 0.25) * 2.0);
    float _142 = _136.y;
    float _145 = _140.y;
    vec2 _151 = (abs(vec2(_136.x - _142, _140.x - _145)) * 2.0) + vec2(_142, _145);
    float _156 = 6.283185482025146484375 * fma(fma(4.0, _151.x, _151.y), 0.0625, _131.x);
    float _157 = cos(_156);
    float _158 = sin(_156);
    vec2 _163 = vec2(_113.y + 1.0, _113.x);
    vec2 _165 = floor(_163 * 0.5);
    vec2 _167 = _163 - (_165 * 2.0);
    vec2 _171 = _165 - (floor(_163 * 0.25) * 2.0);
    float _173 = _167.y;
    float _176 = _171.y;
    vec2 _182 = (abs(vec2(_167.x - _173, _171.x - _176)) * 2.0) + vec2(_173, _176);
    float _186 = fma(fma(4.0, _182.x, _182.y), 0.0625, _131.z);
    float _192 = max(fma(parameters.gBias.y, _90, parameters.gBias.x), 9.9999999747524270787835121154785e-07);
    float _193 = _112.z;
    float _195 = (_193 >= 0.0) ? 1.0 : (-1.0);
    float _197 = (-1.0) / (_195 + _193);
    float _198 = _112.x;
    float _199 = _112.y;
    float _201 = (_198 * _199) * _197;
    vec3 _208 = vec3(fma((_195 * _198) * _198, _197, 1.0), _195 * _201, (-_195) * _198);
    vec3 _212 = vec3(_201, fma(_199 * _199, _197, _195), -_199);
    vec3 _213 = fract(vec3(0.5));
    float _215 = 6.283185482025146484375 * _213.x;
    float _216 = cos(_215);
    float _217 = sin(_215);
    float _225 = _131.y;
    float _227 = fract(_213.y + _225);
    vec2 _229 = vec2(fma(_216, _157, -(_217 * _158)), fma(_216, _158, _217 * _157)) * sqrt(_227);
    vec3 _247 = _99 + ((((_208 * _229.x) + (_212 * _229.y)) + (_112 * sqrt(1.0 - _227))) * (parameters.gRadius * sqrt(fract(_213.z + _186))));
    float _249 = _247.z;
    vec2 _253 = ((_247.xy / vec2(_249)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _261 = textureLod(gInCoarseDepth, _253, 0.0);
    float _262 = _261.x;
    float _264 = (_262 > 0.0) ? _262 : 65504.0;
    float _267 = _249 - ((_264 < 65504.0) ? _264 : 65504.0);
    vec3 _278 = fract(vec3(1.31917250156402587890625, 1.1710436344146728515625, 1.0497004985809326171875));
    float _280 = 6.283185482025146484375 * _278.x;
    float _281 = cos(_280);
    float _282 = sin(_280);
    float _291 = fract(_278.y + _225);
    vec2 _293 = vec2(fma(_281, _157, -(_282 * _158)), fma(_281, _158, _282 * _157)) * sqrt(_291);
    vec3 _309 = _99 + ((((_208 * _293.x) + (_212 * _293.y)) + (_112 * sqrt(1.0 - _291))) * (parameters.gRadius * sqrt(fract(_278.z + _186))));
    float _311 = _309.z;
    vec2 _315 = ((_309.xy / vec2(_311)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _323 = textureLod(gInCoarseDepth, _315, 0.0);
    float _324 = _323.x;
    float _326 = (_324 > 0.0) ? _324 : 65504.0;
    float _329 = _311 - ((_326 < 65504.0) ? _326 : 65504.0);
    vec3 _341 = fract(vec3(2.1383450031280517578125, 1.842087268829345703125, 1.599400997161865234375));
    float _343 = 6.283185482025146484375 * _341.x;
    float _344 = cos(_343);
    float _345 = sin(_343);
    float _354 = fract(_341.y + _225);
    vec2 _356 = vec2(fma(_344, _157, -(_345 * _158)), fma(_344, _158, _345 * _157)) * sqrt(_354);
    vec3 _372 = _99 + ((((_208 * _356.x) + (_212 * _356.y)) + (_112 * sqrt(1.0 - _354))) * (parameters.gRadius * sqrt(fract(_341.z + _186))));
    float _374 = _372.z;
    vec2 _378 = ((_372.xy / vec2(_374)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _386 = textureLod(gInCoarseDepth, _378, 0.0);
    float _387 = _386.x;
    float _389 = (_387 > 0.0) ? _387 : 65504.0;
    float _392 = _374 - ((_389 < 65504.0) ? _389 : 65504.0);
    vec3 _404 = fract(vec3(2.9575176239013671875, 2.5131309032440185546875, 2.1491014957427978515625));
    float _406 = 6.283185482025146484375 * _404.x;
    float _407 = cos(_406);
    float _408 = sin(_406);
    float _417 = fract(_404.y + _225);
    vec2 _419 = vec2(fma(_407, _157, -(_408 * _158)), fma(_407, _158, _408 * _157)) * sqrt(_417);
    vec3 _435 = _99 + ((((_208 * _419.x) + (_212 * _419.y)) + (_112 * sqrt(1.0 - _417))) * (parameters.gRadius * sqrt(fract(_404.z + _186))));
    float _437 = _435.z;
    vec2 _441 = ((_435.xy / vec2(_437)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _449 = textureLod(gInCoarseDepth, _441, 0.0);
    float _450 = _449.x;
    float _452 = (_450 > 0.0) ? _450 : 65504.0;
    float _455 = _437 - ((_452 < 65504.0) ? _452 : 65504.0);
    vec2 _466 = ((mix(vec2(0.0), vec2(clamp((_267 / _192) - 1.0, 0.0, 1.0) * clamp(2.0 - (_267 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_249 > 0.0) && all(lessThanEqual(abs(_253 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp((_329 / _192) - 1.0, 0.0, 1.0) * clamp(2.0 - (_329 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_311 > 0.0) && all(lessThanEqual(abs(_315 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_392 / _192) - 1.0, 0.0, 1.0) * clamp(2.0 - (_392 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_374 > 0.0) && all(lessThanEqual(abs(_378 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_455 / _192) - 1.0, 0.0, 1.0) * clamp(2.0 - (_455 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_437 > 0.0) && all(lessThanEqual(abs(_441 - vec2(0.5)), vec2(0.5)))));
    gOutOcclusion = vec4(mix(vec2(1.0, 65504.0), vec2(1.0 - (_466.x / max(_466.y, 1.0)), _90), bvec2(_90 < 65504.0)), 0.0, 0.0);
}

