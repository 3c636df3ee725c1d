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
layout(binding = 3) uniform sampler2D gInOcclusion;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _93 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _97 = parameters.gOutputSize.zw * 0.5;
    vec4 _100 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_97));
    vec4 _103 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _97));
    float _104 = _100.y;
    float _107 = (_104 > 0.0) ? min(_104, 65504.0) : 65504.0;
    float _108 = _100.x;
    float _111 = (_108 > 0.0) ? min(_108, 65504.0) : 65504.0;
    float _112 = _100.z;
    float _115 = (_112 > 0.0) ? min(_112, 65504.0) : 65504.0;
    float _116 = _103.z;
    float _119 = (_116 > 0.0) ? min(_116, 65504.0) : 65504.0;
    float _120 = _103.x;
    float _123 = (_120 > 0.0) ? min(_120, 65504.0) : 65504.0;
    vec3 _127 = vec3(_93 * _107, _107);
    bvec2 _149 = greaterThan(_93, parameters.gOutputSize.zw);
    bvec2 _151 = lessThan(_93, vec2(1.0) - parameters.gOutputSize.zw);
    float _157 = _119 - _107;
    vec2 _165 = mix(vec2(_157, _119), vec2(_107 - _111, _111), bvec2((_149.x ? abs(_111 - _107) : 131008.0) < (_151.x ? abs(_157) : 65504.0)));
    float _171 = _123 - _107;
    vec2 _179 = mix(vec2(_171, _123), vec2(_107 - _115, _115), bvec2((_149.y ? abs(_115 - _107) : 131008.0) < (_151.y ? abs(_171) : 65504.0)));
    float _183 = _165.x;
    vec3 _190 = vec3((_93 * _183) + (vec2(parameters.gOutputSize.z, 0.0) * _165.y), _183);
    float _198 = _179.x;
    vec3 _205 = vec3((_93 * _198) + (vec2(0.0, parameters.gOutputSize.w) * _179.y), _198);
    vec3 _210 = cross(vec3(dot(parameters.gToShadowX.xyz, _190), dot(parameters.gToShadowY.xyz, _190), dot(parameters.gToShadowZ.xyz, _190)), vec3(dot(parameters.gToShadowX.xyz, _205), dot(parameters.gToShadowY.xyz, _205), dot(parameters.gToShadowZ.xyz, _205)));
    float _211 = _210.z;
    bool _235 = _107 > parameters.gCascadeFar.x;
    bvec3 _236 = bvec3(_235);
    bool _248 = _107 > parameters.gCascadeFar.y;
    bvec3 _249 = bvec3(_248);
    vec3 _250 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _236), parameters.gCascadeScale2.xyz, _249);
    float _253 = float(_235) + float(_248);
    vec3 _254 = fma(vec3(dot(parameters.gToShadowX.xyz, _127), dot(parameters.gToShadowY.xyz, _127), dot(parameters.gToShadowZ.xyz, _127)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _250, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _236), parameters.gCascadeOffset2.xyz, _249));
    float _255 = _250.z;
    vec2 _256 = _250.xy;
    vec2 _259 = clamp((-_210.xy) / vec2((abs(_211) > 9.9999996826552253889678874634872e-21) ? _211 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_255) / _256);
    vec2 _267 = max(parameters.gDisc.xy * _256, vec2(parameters.gDisc.z));
    vec2 _276 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _279 = floor(gl_FragCoord.xy);
    vec2 _281 = floor(_279 * 0.5);
    vec2 _283 = _279 - (_281 * 2.0);
    vec2 _287 = _281 - (floor(_281 * 0.5) * 2.0);
    float _288 = _283.x;
    float _289 = _283.y;
    float _291 = abs(_288 - _289);
    float _292 = _287.y;
    float _297 = _287.x;
    vec2 _309 = vec2(fma(2.0, abs(_297 - _292), fma(8.0, _291, 4.0 * _289)) + _292, fma(2.0, abs(abs(_292 - _289) - _297), fma(4.0, _288, fma(-8.0, _291, 8.0))) + _297) * vec2(0.0625);
    float _314 = floor(parameters.gSubsetCount);
    float _317 = (_314 > 1.0) ? min(_314, 16.0) : 1.0;
    float _321 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _327 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_317, floor((_321 + 0.5) / _317), _321);
    float _331 = 6.283185482025146484375 * (_327.x + _309.x);
    float _332 = cos(_331);
    float _333 = sin(_331);
    float _336 = _327.y + _309.y;
    vec2 _337 = fract(vec2(0.5));
    float _339 = 6.283185482025146484375 * _337.x;
    float _340 = cos(_339);
    float _341 = sin(_339);
    vec2 _348 = _254.xy;
    vec2 _357 = clamp(floor(fma(_267 * sqrt(fract(_337.y + _336)), vec2(fma(_340, _332, -(_341 * _333)), fma(_340, _333, _341 * _332)), _348)) + vec2(0.5), vec2(0.5), _276);
    float _369 = _254.z;
    float _374 = -fma(parameters.gShadowBias.y, _107, parameters.gShadowBias.x);
    vec2 _378 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _380 = 6.283185482025146484375 * _378.x;
    float _381 = cos(_380);
    float _382 = sin(_380);
    vec2 _397 = clamp(floor(fma(_267 * sqrt(fract(_378.y + _336)), vec2(fma(_381, _332, -(_382 * _333)), fma(_381, _333, _382 * _332)), _348)) + vec2(0.5), vec2(0.5), _276);
    vec2 _414 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _416 = 6.283185482025146484375 * _414.x;
    float _417 = cos(_416);
    float _418 = sin(_416);
    vec2 _433 = clamp(floor(fma(_267 * sqrt(fract(_414.y + _336)), vec2(fma(_417, _332, -(_418 * _333)), fma(_417, _333, _418 * _332)), _348)) + vec2(0.5), vec2(0.5), _276);
    vec2 _450 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _452 = 6.283185482025146484375 * _450.x;
    float _453 = cos(_452);
    float _454 = sin(_452);
    vec2 _469 = clamp(floor(fma(_267 * sqrt(fract(_450.y + _336)), vec2(fma(_453, _332, -(_454 * _333)), fma(_453, _333, _454 * _332)), _348)) + vec2(0.5), vec2(0.5), _276);
    float _493 = -(((float(textureLod(gInShadowMap, vec2(fma(_253, parameters.gCascadeSize.x, _357.x), _357.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_374, _255, min(_369 + dot(_259, _357 - _348), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_253, parameters.gCascadeSize.x, _397.x), _397.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_374, _255, min(_369 + dot(_259, _397 - _348), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_253, parameters.gCascadeSize.x, _433.x), _433.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_374, _255, min(_369 + dot(_259, _433 - _348), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_253, parameters.gCascadeSize.x, _469.x), _469.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_374, _255, min(_369 + dot(_259, _469 - _348), 1.0))));
    float _497 = (_107 < 65504.0) ? ((all(lessThanEqual(abs((_348 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_107 <= parameters.gCascadeFar.z)) ? fma(_493, 0.25, 1.0) : 1.0) : 1.0;
    vec4 _501 = textureLod(gInOcclusion, _93, 0.0);
    float _502 = _501.x;
    gOutShadow = vec4(fma((_502 > 0.0) ? min(_502, 1.0) : 0.0, 0.984375, floor(fma((_497 > 0.0) ? min(_497, 1.0) : 0.0, 31.0, 0.5))), _107, 0.0, 0.0);
}

