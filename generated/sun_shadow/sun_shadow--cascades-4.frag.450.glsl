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
    vec2 _91 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _95 = parameters.gOutputSize.zw * 0.5;
    vec4 _98 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_95));
    vec4 _101 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _95));
    float _102 = _98.y;
    float _105 = (_102 > 0.0) ? min(_102, 65504.0) : 65504.0;
    float _106 = _98.x;
    float _109 = (_106 > 0.0) ? min(_106, 65504.0) : 65504.0;
    float _110 = _98.z;
    float _113 = (_110 > 0.0) ? min(_110, 65504.0) : 65504.0;
    float _114 = _101.z;
    float _117 = (_114 > 0.0) ? min(_114, 65504.0) : 65504.0;
    float _118 = _101.x;
    float _121 = (_118 > 0.0) ? min(_118, 65504.0) : 65504.0;
    vec3 _125 = vec3(_91 * _105, _105);
    bvec2 _147 = greaterThan(_91, parameters.gOutputSize.zw);
    bvec2 _149 = lessThan(_91, vec2(1.0) - parameters.gOutputSize.zw);
    float _155 = _117 - _105;
    vec2 _163 = mix(vec2(_155, _117), vec2(_105 - _109, _109), bvec2((_147.x ? abs(_109 - _105) : 131008.0) < (_149.x ? abs(_155) : 65504.0)));
    float _169 = _121 - _105;
    vec2 _177 = mix(vec2(_169, _121), vec2(_105 - _113, _113), bvec2((_147.y ? abs(_113 - _105) : 131008.0) < (_149.y ? abs(_169) : 65504.0)));
    float _181 = _163.x;
    vec3 _188 = vec3((_91 * _181) + (vec2(parameters.gOutputSize.z, 0.0) * _163.y), _181);
    float _196 = _177.x;
    vec3 _203 = vec3((_91 * _196) + (vec2(0.0, parameters.gOutputSize.w) * _177.y), _196);
    vec3 _208 = cross(vec3(dot(parameters.gToShadowX.xyz, _188), dot(parameters.gToShadowY.xyz, _188), dot(parameters.gToShadowZ.xyz, _188)), vec3(dot(parameters.gToShadowX.xyz, _203), dot(parameters.gToShadowY.xyz, _203), dot(parameters.gToShadowZ.xyz, _203)));
    float _209 = _208.z;
    bool _233 = _105 > parameters.gCascadeFar.x;
    bvec3 _234 = bvec3(_233);
    bool _246 = _105 > parameters.gCascadeFar.y;
    bvec3 _247 = bvec3(_246);
    bool _260 = _105 > parameters.gCascadeFar.z;
    bvec3 _261 = bvec3(_260);
    vec3 _262 = mix(mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _234), parameters.gCascadeScale2.xyz, _247), parameters.gCascadeScale3.xyz, _261);
    float _265 = (float(_233) + float(_246)) + float(_260);
    vec3 _266 = fma(vec3(dot(parameters.gToShadowX.xyz, _125), dot(parameters.gToShadowY.xyz, _125), dot(parameters.gToShadowZ.xyz, _125)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _262, mix(mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _234), parameters.gCascadeOffset2.xyz, _247), parameters.gCascadeOffset3.xyz, _261));
    float _267 = _262.z;
    vec2 _268 = _262.xy;
    vec2 _271 = clamp((-_208.xy) / vec2((abs(_209) > 9.9999996826552253889678874634872e-21) ? _209 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_267) / _268);
    vec2 _279 = max(parameters.gDisc.xy * _268, vec2(parameters.gDisc.z));
    vec2 _288 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _291 = floor(gl_FragCoord.xy);
    vec2 _293 = floor(_291 * 0.5);
    vec2 _295 = _291 - (_293 * 2.0);
    vec2 _299 = _293 - (floor(_293 * 0.5) * 2.0);
    float _300 = _295.x;
    float _301 = _295.y;
    float _303 = abs(_300 - _301);
    float _304 = _299.y;
    float _309 = _299.x;
    vec2 _321 = vec2(fma(2.0, abs(_309 - _304), fma(8.0, _303, 4.0 * _301)) + _304, fma(2.0, abs(abs(_304 - _301) - _309), fma(4.0, _300, fma(-8.0, _303, 8.0))) + _309) * vec2(0.0625);
    float _326 = floor(parameters.gSubsetCount);
    float _329 = (_326 > 1.0) ? min(_326, 16.0) : 1.0;
    float _333 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _339 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_329, floor((_333 + 0.5) / _329), _333);
    float _343 = 6.283185482025146484375 * (_339.x + _321.x);
    float _344 = cos(_343);
    float _345 = sin(_343);
    float _348 = _339.y + _321.y;
    vec2 _349 = fract(vec2(0.5));
    float _351 = 6.283185482025146484375 * _349.x;
    float _352 = cos(_351);
    float _353 = sin(_351);
    vec2 _369 = clamp(floor(fma(_279 * sqrt(fract(_349.y + _348)), vec2(fma(_352, _344, -(_353 * _345)), fma(_352, _345, _353 * _344)), _266.xy)) + vec2(0.5), vec2(0.5), _288);
    float _386 = -fma(parameters.gShadowBias.y, _105, parameters.gShadowBias.x);
    vec2 _390 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _392 = 6.283185482025146484375 * _390.x;
    float _393 = cos(_392);
    float _394 = sin(_392);
    vec2 _409 = clamp(floor(fma(_279 * sqrt(fract(_390.y + _348)), vec2(fma(_393, _344, -(_394 * _345)), fma(_393, _345, _394 * _344)), _266.xy)) + vec2(0.5), vec2(0.5), _288);
    vec2 _426 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _428 = 6.283185482025146484375 * _426.x;
    float _429 = cos(_428);
    float _430 = sin(_428);
    vec2 _445 = clamp(floor(fma(_279 * sqrt(fract(_426.y + _348)), vec2(fma(_429, _344, -(_430 * _345)), fma(_429, _345, _430 * _344)), _266.xy)) + vec2(0.5), vec2(0.5), _288);
    vec2 _462 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _464 = 6.283185482025146484375 * _462.x;
    float _465 = cos(_464);
    float _466 = sin(_464);
    vec2 _481 = clamp(floor(fma(_279 * sqrt(fract(_462.y + _348)), vec2(fma(_465, _344, -(_466 * _345)), fma(_465, _345, _466 * _344)), _266.xy)) + vec2(0.5), vec2(0.5), _288);
    float _505 = -(((float(textureLod(gInShadowMap, vec2(fma(_265, parameters.gCascadeSize.x, _369.x), _369.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_386, _267, min(_266.z + dot(_271, _369 - _266.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_265, parameters.gCascadeSize.x, _409.x), _409.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_386, _267, min(_266.z + dot(_271, _409 - _266.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_265, parameters.gCascadeSize.x, _445.x), _445.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_386, _267, min(_266.z + dot(_271, _445 - _266.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_265, parameters.gCascadeSize.x, _481.x), _481.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_386, _267, min(_266.z + dot(_271, _481 - _266.xy), 1.0))));
    gOutShadow = vec4((_105 < 65504.0) ? ((all(lessThanEqual(abs((_266.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_105 <= parameters.gCascadeFar.w)) ? fma(_505, 0.25, 1.0) : 1.0) : 1.0, _105, 0.0, 0.0);
}

