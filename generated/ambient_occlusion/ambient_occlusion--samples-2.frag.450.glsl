#version 450

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    float gRadius;
    float gFrameIndex;
    float gSubsetCount;
    vec2 gBias;
    vec2 gFrameToCoarse;
} parameters;

layout(binding = 1) uniform sampler2D gInCoarseDepth;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _76 = parameters.gOutputSize.zw * 0.5;
    vec4 _79 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_76));
    vec4 _82 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76));
    float _83 = _79.y;
    float _85 = (_83 > 0.0) ? _83 : 65504.0;
    float _87 = (_85 < 65504.0) ? _85 : 65504.0;
    float _88 = _79.x;
    float _90 = (_88 > 0.0) ? _88 : 65504.0;
    float _92 = (_90 < 65504.0) ? _90 : 65504.0;
    float _93 = _79.z;
    float _95 = (_93 > 0.0) ? _93 : 65504.0;
    float _97 = (_95 < 65504.0) ? _95 : 65504.0;
    float _98 = _82.z;
    float _100 = (_98 > 0.0) ? _98 : 65504.0;
    float _102 = (_100 < 65504.0) ? _100 : 65504.0;
    float _103 = _82.x;
    float _105 = (_103 > 0.0) ? _103 : 65504.0;
    float _107 = (_105 < 65504.0) ? _105 : 65504.0;
    vec3 _116 = vec3(fma(gl_FragCoord.xy * parameters.gOutputSize.zw, parameters.gViewRay.xy, parameters.gViewRay.zw) * _87, _87);
    vec2 _119 = vec2(parameters.gOutputSize.z, 0.0);
    vec2 _121 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_119);
    vec2 _129 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _119);
    vec2 _154 = vec2(0.0, parameters.gOutputSize.w);
    vec2 _156 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_154);
    vec2 _164 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _154);
    vec3 _187 = cross(mix(vec3(fma(_129, parameters.gViewRay.xy, parameters.gViewRay.zw) * _102, _102) - _116, _116 - vec3(fma(_121, parameters.gViewRay.xy, parameters.gViewRay.zw) * _92, _92), bvec3((all(lessThanEqual(abs(_121 - vec2(0.5)), vec2(0.5))) ? abs(_92 - _87) : 131008.0) < (all(lessThanEqual(abs(_129 - vec2(0.5)), vec2(0.5))) ? abs(_102 - _87) : 65504.0))), mix(vec3(fma(_164, parameters.gViewRay.xy, parameters.gViewRay.zw) * _107, _107) - _116, _116 - vec3(fma(_156, parameters.gViewRay.xy, parameters.gViewRay.zw) * _97, _97), bvec3((all(lessThanEqual(abs(_156 - vec2(0.5)), vec2(0.5))) ? abs(_97 - _87) : 131008.0) < (all(lessThanEqual(abs(_164 - vec2(0.5)), vec2(0.5))) ? abs(_107 - _87) : 65504.0))));
    vec3 _197 = normalize(mix(-_187, _187, bvec3((parameters.gViewRay.x * parameters.gViewRay.y) < 0.0)));
    vec2 _198 = floor(gl_FragCoord.xy);
    float _203 = floor(parameters.gSubsetCount);
    float _206 = (_203 > 1.0) ? min(_203, 16.0) : 1.0;
    float _210 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec3 _216 = vec3(0.6383450031280517578125, 0.342087209224700927734375, 0.09940095245838165283203125) * fma(-_206, floor((_210 + 0.5) / _206), _210);
    vec2 _219 = floor(_198 * 0.5);
    vec2 _221 = _198 - (_219 * 2.0);
    vec2 _225 = _219 - (floor(_198 * 0.25) * 2.0);
    float _227 = _221.y;
    float _230 = _225.y;
    vec2 _236 = (abs(vec2(_221.x - _227, _225.x - _230)) * 2.0) + vec2(_227, _230);
    float _241 = 6.283185482025146484375 * fma(fma(4.0, _236.x, _236.y), 0.0625, _216.x);
    float _242 = cos(_241);
    float _243 = sin(_241);
    vec2 _248 = vec2(_198.y + 1.0, _198.x);
    vec2 _250 = floor(_248 * 0.5);
    vec2 _252 = _248 - (_250 * 2.0);
    vec2 _256 = _250 - (floor(_248 * 0.25) * 2.0);
    float _258 = _252.y;
    float _261 = _256.y;
    vec2 _267 = (abs(vec2(_252.x - _258, _256.x - _261)) * 2.0) + vec2(_258, _261);
    float _271 = fma(fma(4.0, _267.x, _267.y), 0.0625, _216.z);
    float _277 = max(fma(parameters.gBias.y, _87, parameters.gBias.x), 9.9999999747524270787835121154785e-07);
    float _278 = _197.z;
    float _280 = (_278 >= 0.0) ? 1.0 : (-1.0);
    float _282 = (-1.0) / (_280 + _278);
    float _283 = _197.x;
    float _284 = _197.y;
    float _286 = (_283 * _284) * _282;
    vec3 _293 = vec3(fma((_280 * _283) * _283, _282, 1.0), _280 * _286, (-_280) * _283);
    vec3 _297 = vec3(_286, fma(_284 * _284, _282, _280), -_284);
    vec3 _298 = fract(vec3(0.5));
    float _300 = 6.283185482025146484375 * _298.x;
    float _301 = cos(_300);
    float _302 = sin(_300);
    float _310 = _216.y;
    float _312 = fract(_298.y + _310);
    vec2 _314 = vec2(fma(_301, _242, -(_302 * _243)), fma(_301, _243, _302 * _242)) * sqrt(_312);
    vec3 _332 = _116 + ((((_293 * _314.x) + (_297 * _314.y)) + (_197 * sqrt(1.0 - _312))) * (parameters.gRadius * sqrt(fract(_298.z + _271))));
    float _334 = _332.z;
    vec2 _338 = ((_332.xy / vec2(_334)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _346 = textureLod(gInCoarseDepth, _338, 0.0);
    float _347 = _346.x;
    float _349 = (_347 > 0.0) ? _347 : 65504.0;
    float _352 = _334 - ((_349 < 65504.0) ? _349 : 65504.0);
    vec3 _363 = fract(vec3(1.31917250156402587890625, 1.1710436344146728515625, 1.0497004985809326171875));
    float _365 = 6.283185482025146484375 * _363.x;
    float _366 = cos(_365);
    float _367 = sin(_365);
    float _376 = fract(_363.y + _310);
    vec2 _378 = vec2(fma(_366, _242, -(_367 * _243)), fma(_366, _243, _367 * _242)) * sqrt(_376);
    vec3 _394 = _116 + ((((_293 * _378.x) + (_297 * _378.y)) + (_197 * sqrt(1.0 - _376))) * (parameters.gRadius * sqrt(fract(_363.z + _271))));
    float _396 = _394.z;
    vec2 _400 = ((_394.xy / vec2(_396)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _408 = textureLod(gInCoarseDepth, _400, 0.0);
    float _409 = _408.x;
    float _411 = (_409 > 0.0) ? _409 : 65504.0;
    float _414 = _396 - ((_411 < 65504.0) ? _411 : 65504.0);
    vec2 _425 = mix(vec2(0.0), vec2(clamp((_352 / _277) - 1.0, 0.0, 1.0) * clamp(2.0 - (_352 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_334 > 0.0) && all(lessThanEqual(abs(_338 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp((_414 / _277) - 1.0, 0.0, 1.0) * clamp(2.0 - (_414 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_396 > 0.0) && all(lessThanEqual(abs(_400 - vec2(0.5)), vec2(0.5)))));
    gOutOcclusion = vec4(mix(vec2(1.0, 65504.0), vec2(1.0 - (_425.x / max(_425.y, 1.0)), _87), bvec2(_87 < 65504.0)), 0.0, 0.0);
}

