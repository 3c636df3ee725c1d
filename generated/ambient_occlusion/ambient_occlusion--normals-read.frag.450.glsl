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
layout(binding = 2) uniform sampler2D gInNormal;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _84 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _88 = textureLod(gInCoarseDepth, _84, 0.0);
    float _89 = _88.x;
    float _91 = (_89 > 0.0) ? _89 : 65504.0;
    float _93 = (_91 < 65504.0) ? _91 : 65504.0;
    vec3 _102 = vec3(fma(_84, parameters.gViewRay.xy, parameters.gViewRay.zw) * _93, _93);
    vec3 _113 = textureLod(gInNormal, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(parameters.gOutputSize.zw * 0.125)) / parameters.gFrameToCoarse, 0.0).xyz;
    float _114 = dot(_113, _113);
    vec3 _121 = mix(vec3(0.0, 0.0, -1.0), _113 * inversesqrt(_114), bvec3((_114 > 9.9999999747524270787835121154785e-07) && (_114 < 1000000.0)));
    vec2 _122 = floor(gl_FragCoord.xy);
    float _127 = floor(parameters.gSubsetCount);
    float _130 = (_127 > 1.0) ? min(_127, 16.0) : 1.0;
    float _134 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec3 _140 = vec3(0.276690065860748291015625, 0.68417441844940185546875, 0.1988019049167633056640625) * fma(-_130, floor((_134 + 0.5) / _130), _134);
    vec2 _143 = floor(_122 * 0.5);
    vec2 _145 = _122 - (_143 * 2.0);
    vec2 _149 = _143 - (floor(_122 * 0.25) * 2.0);
    float _151 = _145.y;
    float _154 = _149.y;
    vec2 _160 = (abs(vec2(_145.x - _151, _149.x - _154)) * 2.0) + vec2(_151, _154);
    float _165 = 6.283185482025146484375 * fma(fma(4.0, _160.x, _160.y), 0.0625, _140.x);
    float _166 = cos(_165);
    float _167 = sin(_165);
    vec2 _172 = vec2(_122.y + 1.0, _122.x);
    vec2 _174 = floor(_172 * 0.5);
    vec2 _176 = _172 - (_174 * 2.0);
    vec2 _180 = _174 - (floor(_172 * 0.25) * 2.0);
    float _182 = _176.y;
    float _185 = _180.y;
    vec2 _191 = (abs(vec2(_176.x - _182, _180.x - _185)) * 2.0) + vec2(_182, _185);
    float _195 = fma(fma(4.0, _191.x, _191.y), 0.0625, _140.z);
    float _201 = max(fma(parameters.gBias.y, _93, parameters.gBias.x), 9.9999999747524270787835121154785e-07);
    float _202 = _121.z;
    float _204 = (_202 >= 0.0) ? 1.0 : (-1.0);
    float _206 = (-1.0) / (_204 + _202);
    float _207 = _121.x;
    float _208 = _121.y;
    float _210 = (_207 * _208) * _206;
    vec3 _217 = vec3(fma((_204 * _207) * _207, _206, 1.0), _204 * _210, (-_204) * _207);
    vec3 _221 = vec3(_210, fma(_208 * _208, _206, _204), -_208);
    vec3 _222 = fract(vec3(0.5));
    float _224 = 6.283185482025146484375 * _222.x;
    float _225 = cos(_224);
    float _226 = sin(_224);
    float _234 = _140.y;
    float _236 = fract(_222.y + _234);
    vec2 _238 = vec2(fma(_225, _166, -(_226 * _167)), fma(_225, _167, _226 * _166)) * sqrt(_236);
    vec3 _256 = _102 + ((((_217 * _238.x) + (_221 * _238.y)) + (_121 * sqrt(1.0 - _236))) * (parameters.gRadius * sqrt(fract(_222.z + _195))));
    float _258 = _256.z;
    vec2 _262 = ((_256.xy / vec2(_258)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _270 = textureLod(gInCoarseDepth, _262, 0.0);
    float _271 = _270.x;
    float _273 = (_271 > 0.0) ? _271 : 65504.0;
    float _276 = _258 - ((_273 < 65504.0) ? _273 : 65504.0);
    vec3 _287 = fract(vec3(1.31917250156402587890625, 1.1710436344146728515625, 1.0497004985809326171875));
    float _289 = 6.283185482025146484375 * _287.x;
    float _290 = cos(_289);
    float _291 = sin(_289);
    float _300 = fract(_287.y + _234);
    vec2 _302 = vec2(fma(_290, _166, -(_291 * _167)), fma(_290, _167, _291 * _166)) * sqrt(_300);
    vec3 _318 = _102 + ((((_217 * _302.x) + (_221 * _302.y)) + (_121 * sqrt(1.0 - _300))) * (parameters.gRadius * sqrt(fract(_287.z + _195))));
    float _320 = _318.z;
    vec2 _324 = ((_318.xy / vec2(_320)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _332 = textureLod(gInCoarseDepth, _324, 0.0);
    float _333 = _332.x;
    float _335 = (_333 > 0.0) ? _333 : 65504.0;
    float _338 = _320 - ((_335 < 65504.0) ? _335 : 65504.0);
    vec3 _350 = fract(vec3(2.1383450031280517578125, 1.842087268829345703125, 1.599400997161865234375));
    float _352 = 6.283185482025146484375 * _350.x;
    float _353 = cos(_352);
    float _354 = sin(_352);
    float _363 = fract(_350.y + _234);
    vec2 _365 = vec2(fma(_353, _166, -(_354 * _167)), fma(_353, _167, _354 * _166)) * sqrt(_363);
    vec3 _381 = _102 + ((((_217 * _365.x) + (_221 * _365.y)) + (_121 * sqrt(1.0 - _363))) * (parameters.gRadius * sqrt(fract(_350.z + _195))));
    float _383 = _381.z;
    vec2 _387 = ((_381.xy / vec2(_383)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _395 = textureLod(gInCoarseDepth, _387, 0.0);
    float _396 = _395.x;
    float _398 = (_396 > 0.0) ? _396 : 65504.0;
    float _401 = _383 - ((_398 < 65504.0) ? _398 : 65504.0);
    vec3 _413 = fract(vec3(2.9575176239013671875, 2.5131309032440185546875, 2.1491014957427978515625));
    float _415 = 6.283185482025146484375 * _413.x;
    float _416 = cos(_415);
    float _417 = sin(_415);
    float _426 = fract(_413.y + _234);
    vec2 _428 = vec2(fma(_416, _166, -(_417 * _167)), fma(_416, _167, _417 * _166)) * sqrt(_426);
    vec3 _444 = _102 + ((((_217 * _428.x) + (_221 * _428.y)) + (_121 * sqrt(1.0 - _426))) * (parameters.gRadius * sqrt(fract(_413.z + _195))));
    float _446 = _444.z;
    vec2 _450 = ((_444.xy / vec2(_446)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _458 = textureLod(gInCoarseDepth, _450, 0.0);
    float _459 = _458.x;
    float _461 = (_459 > 0.0) ? _459 : 65504.0;
    float _464 = _446 - ((_461 < 65504.0) ? _461 : 65504.0);
    vec2 _475 = ((mix(vec2(0.0), vec2(clamp((_276 / _201) - 1.0, 0.0, 1.0) * clamp(2.0 - (_276 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_258 > 0.0) && all(lessThanEqual(abs(_262 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp((_338 / _201) - 1.0, 0.0, 1.0) * clamp(2.0 - (_338 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_320 > 0.0) && all(lessThanEqual(abs(_324 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_401 / _201) - 1.0, 0.0, 1.0) * clamp(2.0 - (_401 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_383 > 0.0) && all(lessThanEqual(abs(_387 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp((_464 / _201) - 1.0, 0.0, 1.0) * clamp(2.0 - (_464 / parameters.gRadius), 0.0, 1.0), 1.0), bvec2((_446 > 0.0) && all(lessThanEqual(abs(_450 - vec2(0.5)), vec2(0.5)))));
    gOutOcclusion = vec4(mix(vec2(1.0, 65504.0), vec2(1.0 - (_475.x / max(_475.y, 1.0)), _93), bvec2(_93 < 65504.0)), 0.0, 0.0);
}

