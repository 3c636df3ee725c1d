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
    vec3 gBias;
    float gSubsetCount;
} parameters;

layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInShadowMap;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _89 = parameters.gOutputSize.zw * 0.5;
    vec4 _92 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_89));
    vec4 _95 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _89));
    float _96 = _92.y;
    float _98 = (_96 > 0.0) ? _96 : 65504.0;
    float _100 = (_98 < 65504.0) ? _98 : 65504.0;
    float _101 = _92.x;
    float _103 = (_101 > 0.0) ? _101 : 65504.0;
    float _105 = (_103 < 65504.0) ? _103 : 65504.0;
    float _106 = _92.z;
    float _108 = (_106 > 0.0) ? _106 : 65504.0;
    float _110 = (_108 < 65504.0) ? _108 : 65504.0;
    float _111 = _95.z;
    float _113 = (_111 > 0.0) ? _111 : 65504.0;
    float _115 = (_113 < 65504.0) ? _113 : 65504.0;
    float _116 = _95.x;
    float _118 = (_116 > 0.0) ? _116 : 65504.0;
    float _120 = (_118 < 65504.0) ? _118 : 65504.0;
    vec3 _123 = vec3(gl_FragCoord.xy * parameters.gOutputSize.zw, _100);
    vec2 _147 = vec2(parameters.gOutputSize.z, 0.0);
    float _162 = _115 - _100;
    vec3 _172 = vec3(parameters.gOutputSize.z, 0.0, mix(vec2(_162, _115), vec2(_100 - _105, _105), bvec2((all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_147) - vec2(0.5)), vec2(0.5))) ? abs(_105 - _100) : 131008.0) < (all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _147) - vec2(0.5)), vec2(0.5))) ? abs(_162) : 65504.0))).x);
    vec2 _179 = vec2(0.0, parameters.gOutputSize.w);
    float _194 = _120 - _100;
    vec3 _204 = vec3(0.0, parameters.gOutputSize.w, mix(vec2(_194, _120), vec2(_100 - _110, _110), bvec2((all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_179) - vec2(0.5)), vec2(0.5))) ? abs(_110 - _100) : 131008.0) < (all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _179) - vec2(0.5)), vec2(0.5))) ? abs(_194) : 65504.0))).x);
    vec3 _209 = cross(vec3(dot(parameters.gToShadowX.xyz, _172), dot(parameters.gToShadowY.xyz, _172), dot(parameters.gToShadowZ.xyz, _172)), vec3(dot(parameters.gToShadowX.xyz, _204), dot(parameters.gToShadowY.xyz, _204), dot(parameters.gToShadowZ.xyz, _204)));
    float _210 = _209.z;
    bool _234 = _100 > parameters.gCascadeFar.x;
    bvec3 _235 = bvec3(_234);
    bool _247 = _100 > parameters.gCascadeFar.y;
    bvec3 _248 = bvec3(_247);
    vec3 _249 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _235), parameters.gCascadeScale2.xyz, _248);
    float _252 = float(_234) + float(_247);
    vec3 _253 = fma(vec3(dot(parameters.gToShadowX.xyz, _123), dot(parameters.gToShadowY.xyz, _123), dot(parameters.gToShadowZ.xyz, _123)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _249, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _235), parameters.gCascadeOffset2.xyz, _248));
    float _254 = _249.z;
    vec2 _255 = _249.xy;
    vec2 _258 = clamp((-_209.xy) / vec2((abs(_210) > 9.9999996826552253889678874634872e-21) ? _210 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_254) / _255);
    vec2 _266 = max(parameters.gDisc.xy * _255, vec2(parameters.gDisc.z));
    vec2 _275 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _278 = floor(gl_FragCoord.xy);
    float _283 = floor(parameters.gSubsetCount);
    float _286 = (_283 > 1.0) ? min(_283, 16.0) : 1.0;
    float _290 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _296 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_286, floor((_290 + 0.5) / _286), _290);
    vec2 _299 = floor(_278 * 0.5);
    vec2 _301 = _278 - (_299 * 2.0);
    vec2 _305 = _299 - (floor(_278 * 0.25) * 2.0);
    float _307 = _301.y;
    float _310 = _305.y;
    vec2 _316 = (abs(vec2(_301.x - _307, _305.x - _310)) * 2.0) + vec2(_307, _310);
    float _321 = 6.283185482025146484375 * fma(fma(4.0, _316.x, _316.y), 0.0625, _296.x);
    float _322 = cos(_321);
    float _323 = sin(_321);
    vec2 _328 = vec2(_278.y + 1.0, _278.x);
    vec2 _330 = floor(_328 * 0.5);
    vec2 _332 = _328 - (_330 * 2.0);
    vec2 _336 = _330 - (floor(_328 * 0.25) * 2.0);
    float _338 = _332.y;
    float _341 = _336.y;
    vec2 _347 = (abs(vec2(_332.x - _338, _336.x - _341)) * 2.0) + vec2(_338, _341);
    float _351 = fma(fma(4.0, _347.x, _347.y), 0.0625, _296.y);
    vec2 _352 = fract(vec2(0.5));
    float _354 = 6.283185482025146484375 * _352.x;
    float _355 = cos(_354);
    float _356 = sin(_354);
    vec2 _363 = _253.xy;
    vec2 _372 = clamp(floor(fma(_266 * sqrt(fract(_352.y + _351)), vec2(fma(_355, _322, -(_356 * _323)), fma(_355, _323, _356 * _322)), _363)) + vec2(0.5), vec2(0.5), _275);
    float _384 = _253.z;
    float _389 = -fma(parameters.gBias.y, _100, parameters.gBias.x);
    vec2 _393 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _395 = 6.283185482025146484375 * _393.x;
    float _396 = cos(_395);
    float _397 = sin(_395);
    vec2 _412 = clamp(floor(fma(_266 * sqrt(fract(_393.y + _351)), vec2(fma(_396, _322, -(_397 * _323)), fma(_396, _323, _397 * _322)), _363)) + vec2(0.5), vec2(0.5), _275);
    vec2 _429 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _431 = 6.283185482025146484375 * _429.x;
    float _432 = cos(_431);
    float _433 = sin(_431);
    vec2 _448 = clamp(floor(fma(_266 * sqrt(fract(_429.y + _351)), vec2(fma(_432, _322, -(_433 * _323)), fma(_432, _323, _433 * _322)), _363)) + vec2(0.5), vec2(0.5), _275);
    vec2 _465 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _467 = 6.283185482025146484375 * _465.x;
    float _468 = cos(_467);
    float _469 = sin(_467);
    vec2 _484 = clamp(floor(fma(_266 * sqrt(fract(_465.y + _351)), vec2(fma(_468, _322, -(_469 * _323)), fma(_468, _323, _469 * _322)), _363)) + vec2(0.5), vec2(0.5), _275);
    float _508 = -(((float(textureLod(gInShadowMap, vec2(fma(_252, parameters.gCascadeSize.x, _372.x), _372.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_389, _254, min(_384 + dot(_258, _372 - _363), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_252, parameters.gCascadeSize.x, _412.x), _412.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_389, _254, min(_384 + dot(_258, _412 - _363), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_252, parameters.gCascadeSize.x, _448.x), _448.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_389, _254, min(_384 + dot(_258, _448 - _363), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_252, parameters.gCascadeSize.x, _484.x), _484.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_389, _254, min(_384 + dot(_258, _484 - _363), 1.0))));
    gOutShadow = vec4((_100 < 65504.0) ? ((all(lessThanEqual(abs((_363 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_100 <= parameters.gCascadeFar.z)) ? fma(_508, 0.25, 1.0) : 1.0) : 1.0, _100, 0.0, 0.0);
}

