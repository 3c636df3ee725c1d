#version 450

layout(binding = 0, std140) uniform SunShadowParameters
{
    vec4 gOutputSize;
    vec4 gToShadowX;
    vec4 gToShadowY;
    vec4 gToShadowZ;
    vec4 gCascadeScale1;
    vec4 gCascadeOffset1;
    vec4 gCascadeScale2;
    vec4 gCascadeOffset2;
    vec4 gCascadeScale3;
    vec4 gCascadeOffset3;
    vec4 gCascadeFar;
    vec4 gCascadeSize;
    vec3 gDisc;
    float gFrameIndex;
    vec3 gShadowBias;
    float gSubsetCount;
} parameters;

layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInShadowMap;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _90 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _94 = parameters.gOutputSize.zw * 0.5;
    vec4 _97 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_94));
    vec4 _100 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _94));
    float _101 = _97.y;
    float _104 = (_101 > 0.0) ? min(_101, 65504.0) : 65504.0;
    float _105 = _97.x;
    float _108 = (_105 > 0.0) ? min(_105, 65504.0) : 65504.0;
    float _109 = _97.z;
    float _112 = (_109 > 0.0) ? min(_109, 65504.0) : 65504.0;
    float _113 = _100.z;
    float _116 = (_113 > 0.0) ? min(_113, 65504.0) : 65504.0;
    float _117 = _100.x;
    float _120 = (_117 > 0.0) ? min(_117, 65504.0) : 65504.0;
    vec3 _124 = vec3(_90 * _104, _104);
    bvec2 _146 = greaterThan(_90, parameters.gOutputSize.zw);
    bvec2 _148 = lessThan(_90, vec2(1.0) - parameters.gOutputSize.zw);
    float _154 = _116 - _104;
    vec2 _162 = mix(vec2(_154, _116), vec2(_104 - _108, _108), bvec2((_146.x ? abs(_108 - _104) : 131008.0) < (_148.x ? abs(_154) : 65504.0)));
    float _168 = _120 - _104;
    vec2 _176 = mix(vec2(_168, _120), vec2(_104 - _112, _112), bvec2((_146.y ? abs(_112 - _104) : 131008.0) < (_148.y ? abs(_168) : 65504.0)));
    float _180 = _162.x;
    vec3 _187 = vec3((_90 * _180) + (vec2(parameters.gOutputSize.z, 0.0) * _162.y), _180);
    float _195 = _176.x;
    vec3 _202 = vec3((_90 * _195) + (vec2(0.0, parameters.gOutputSize.w) * _176.y), _195);
    vec3 _207 = cross(vec3(dot(parameters.gToShadowX.xyz, _187), dot(parameters.gToShadowY.xyz, _187), dot(parameters.gToShadowZ.xyz, _187)), vec3(dot(parameters.gToShadowX.xyz, _202), dot(parameters.gToShadowY.xyz, _202), dot(parameters.gToShadowZ.xyz, _202)));
    float _208 = _207.z;
    bool _232 = _104 > parameters.gCascadeFar.x;
    bvec3 _233 = bvec3(_232);
    vec3 _234 = mix(vec3(1.0), parameters.gCascadeScale1.xyz, _233);
    float _236 = float(_232);
    vec3 _237 = fma(vec3(dot(parameters.gToShadowX.xyz, _124), dot(parameters.gToShadowY.xyz, _124), dot(parameters.gToShadowZ.xyz, _124)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _234, mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _233));
    float _238 = _234.z;
    vec2 _239 = _234.xy;
    vec2 _242 = clamp((-_207.xy) / vec2((abs(_208) > 9.9999996826552253889678874634872e-21) ? _208 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_238) / _239);
    vec2 _250 = max(parameters.gDisc.xy * _239, vec2(parameters.gDisc.z));
    vec2 _259 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _262 = floor(gl_FragCoord.xy);
    vec2 _264 = floor(_262 * 0.5);
    vec2 _266 = _262 - (_264 * 2.0);
    vec2 _270 = _264 - (floor(_264 * 0.5) * 2.0);
    float _271 = _266.x;
    float _272 = _266.y;
    float _274 = abs(_271 - _272);
    float _275 = _270.y;
    float _280 = _270.x;
    vec2 _292 = vec2(fma(2.0, abs(_280 - _275), fma(8.0, _274, 4.0 * _272)) + _275, fma(2.0, abs(abs(_275 - _272) - _280), fma(4.0, _271, fma(-8.0, _274, 8.0))) + _280) * vec2(0.0625);
    float _297 = floor(parameters.gSubsetCount);
    float _300 = (_297 > 1.0) ? min(_297, 16.0) : 1.0;
    float _304 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _310 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_300, floor((_304 + 0.5) / _300), _304);
    float _314 = 6.283185482025146484375 * (_310.x + _292.x);
    float _315 = cos(_314);
    float _316 = sin(_314);
    float _319 = _310.y + _292.y;
    vec2 _320 = fract(vec2(0.5));
    float _322 = 6.283185482025146484375 * _320.x;
    float _323 = cos(_322);
    float _324 = sin(_322);
    vec2 _331 = _237.xy;
    vec2 _340 = clamp(floor(fma(_250 * sqrt(fract(_320.y + _319)), vec2(fma(_323, _315, -(_324 * _316)), fma(_323, _316, _324 * _315)), _331)) + vec2(0.5), vec2(0.5), _259);
    float _352 = _237.z;
    float _357 = -fma(parameters.gShadowBias.y, _104, parameters.gShadowBias.x);
    vec2 _361 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _363 = 6.283185482025146484375 * _361.x;
    float _364 = cos(_363);
    float _365 = sin(_363);
    vec2 _380 = clamp(floor(fma(_250 * sqrt(fract(_361.y + _319)), vec2(fma(_364, _315, -(_365 * _316)), fma(_364, _316, _365 * _315)), _331)) + vec2(0.5), vec2(0.5), _259);
    vec2 _397 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _399 = 6.283185482025146484375 * _397.x;
    float _400 = cos(_399);
    float _401 = sin(_399);
    vec2 _416 = clamp(floor(fma(_250 * sqrt(fract(_397.y + _319)), vec2(fma(_400, _315, -(_401 * _316)), fma(_400, _316, _401 * _315)), _331)) + vec2(0.5), vec2(0.5), _259);
    vec2 _433 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _435 = 6.283185482025146484375 * _433.x;
    float _436 = cos(_435);
    float _437 = sin(_435);
    vec2 _452 = clamp(floor(fma(_250 * sqrt(fract(_433.y + _319)), vec2(fma(_436, _315, -(_437 * _316)), fma(_436, _316, _437 * _315)), _331)) + vec2(0.5), vec2(0.5), _259);
    float _475 = -(((float(textureLod(gInShadowMap, vec2(fma(_236, parameters.gCascadeSize.x, _340.x), _340.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_357, _238, min(_352 + dot(_242, _340 - _331), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_236, parameters.gCascadeSize.x, _380.x), _380.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_357, _238, min(_352 + dot(_242, _380 - _331), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_236, parameters.gCascadeSize.x, _416.x), _416.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_357, _238, min(_352 + dot(_242, _416 - _331), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_236, parameters.gCascadeSize.x, _452.x), _452.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_357, _238, min(_352 + dot(_242, _452 - _331), 1.0))));
    gOutShadow = vec4((_104 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_331 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_104 <= parameters.gCascadeFar.y)) ? fma(_475, 0.25, 1.0) : 1.0) : 1.0, _104, 0.0, 0.0);
}

