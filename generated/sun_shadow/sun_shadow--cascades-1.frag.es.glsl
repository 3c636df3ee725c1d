#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform SunShadowParameters
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

uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gInShadowMap;

layout(location = 0) out vec4 gOutShadow;

void main()
{
    vec2 _85 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _89 = textureLod(gInCoarseDepth, _85, 0.0);
    float _90 = _89.x;
    float _93 = (_90 > 0.0) ? min(_90, 65504.0) : 65504.0;
    vec2 _96 = vec2(parameters.gOutputSize.z, 0.0);
    vec4 _100 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_96), 0.0);
    float _101 = _100.x;
    float _104 = (_101 > 0.0) ? min(_101, 65504.0) : 65504.0;
    vec2 _107 = vec2(0.0, parameters.gOutputSize.w);
    vec4 _111 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_107), 0.0);
    float _112 = _111.x;
    float _115 = (_112 > 0.0) ? min(_112, 65504.0) : 65504.0;
    vec4 _118 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _96, 0.0);
    float _119 = _118.x;
    float _122 = (_119 > 0.0) ? min(_119, 65504.0) : 65504.0;
    vec4 _125 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _107, 0.0);
    float _126 = _125.x;
    float _129 = (_126 > 0.0) ? min(_126, 65504.0) : 65504.0;
    vec3 _133 = vec3(_85 * _93, _93);
    vec3 _154 = vec3(dot(parameters.gToShadowX.xyz, _133), dot(parameters.gToShadowY.xyz, _133), dot(parameters.gToShadowZ.xyz, _133)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w);
    bvec2 _155 = greaterThan(_85, parameters.gOutputSize.zw);
    bvec2 _157 = lessThan(_85, vec2(1.0) - parameters.gOutputSize.zw);
    float _163 = _122 - _93;
    vec2 _168 = vec2(_93 - _104, _104);
    vec2 _169 = vec2(_163, _122);
    bvec2 _170 = bvec2((_155.x ? abs(_104 - _93) : 131008.0) < (_157.x ? abs(_163) : 65504.0));
    vec2 _171 = vec2(_170.x ? _168.x : _169.x, _170.y ? _168.y : _169.y);
    float _177 = _129 - _93;
    vec2 _182 = vec2(_93 - _115, _115);
    vec2 _183 = vec2(_177, _129);
    bvec2 _184 = bvec2((_155.y ? abs(_115 - _93) : 131008.0) < (_157.y ? abs(_177) : 65504.0));
    vec2 _185 = vec2(_184.x ? _182.x : _183.x, _184.y ? _182.y : _183.y);
    float _186 = _171.x;
    vec3 _193 = vec3((_85 * _186) + (_96 * _171.y), _186);
    float _198 = _185.x;
    vec3 _205 = vec3((_85 * _198) + (_107 * _185.y), _198);
    vec3 _210 = cross(vec3(dot(parameters.gToShadowX.xyz, _193), dot(parameters.gToShadowY.xyz, _193), dot(parameters.gToShadowZ.xyz, _193)), vec3(dot(parameters.gToShadowX.xyz, _205), dot(parameters.gToShadowY.xyz, _205), dot(parameters.gToShadowZ.xyz, _205)));
    float _211 = _210.z;
    vec2 _224 = clamp((-_210.xy) / vec2((abs(_211) > 9.9999996826552253889678874634872e-21) ? _211 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z));
    vec2 _233 = max(parameters.gDisc.xy, vec2(parameters.gDisc.z));
    vec2 _242 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _243 = floor(gl_FragCoord.xy);
    vec2 _245 = floor(_243 * 0.5);
    vec2 _247 = _243 - (_245 * 2.0);
    vec2 _251 = _245 - (floor(_245 * 0.5) * 2.0);
    float _252 = _247.x;
    float _253 = _247.y;
    float _255 = abs(_252 - _253);
    float _256 = _251.y;
    float _261 = _251.x;
    vec2 _273 = vec2((2.0 * abs(_261 - _256) + (8.0 * _255 + (4.0 * _253))) + _256, (2.0 * abs(abs(_256 - _253) - _261) + (4.0 * _252 + ((-8.0) * _255 + 8.0))) + _261) * vec2(0.0625);
    float _278 = floor(parameters.gSubsetCount);
    float _281 = (_278 > 1.0) ? min(_278, 16.0) : 1.0;
    float _285 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _291 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * ((-_281) * floor((_285 + 0.5) / _281) + _285);
    float _295 = 6.283185482025146484375 * (_291.x + _273.x);
    float _296 = cos(_295);
    float _297 = sin(_295);
    float _300 = _291.y + _273.y;
    vec2 _301 = fract(vec2(0.5));
    float _303 = 6.283185482025146484375 * _301.x;
    float _304 = cos(_303);
    float _305 = sin(_303);
    vec2 _312 = _154.xy;
    vec2 _321 = clamp(floor((_233 * sqrt(fract(_301.y + _300))) * vec2(_304 * _296 + (-(_305 * _297)), _304 * _297 + (_305 * _296)) + _312) + vec2(0.5), vec2(0.5), _242);
    float _329 = _154.z;
    float _334 = -(parameters.gShadowBias.y * _93 + parameters.gShadowBias.x);
    vec2 _338 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _340 = 6.283185482025146484375 * _338.x;
    float _341 = cos(_340);
    float _342 = sin(_340);
    vec2 _357 = clamp(floor((_233 * sqrt(fract(_338.y + _300))) * vec2(_341 * _296 + (-(_342 * _297)), _341 * _297 + (_342 * _296)) + _312) + vec2(0.5), vec2(0.5), _242);
    vec2 _370 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _372 = 6.283185482025146484375 * _370.x;
    float _373 = cos(_372);
    float _374 = sin(_372);
    vec2 _389 = clamp(floor((_233 * sqrt(fract(_370.y + _300))) * vec2(_373 * _296 + (-(_374 * _297)), _373 * _297 + (_374 * _296)) + _312) + vec2(0.5), vec2(0.5), _242);
    vec2 _402 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _404 = 6.283185482025146484375 * _402.x;
    float _405 = cos(_404);
    float _406 = sin(_404);
    vec2 _421 = clamp(floor((_233 * sqrt(fract(_402.y + _300))) * vec2(_405 * _296 + (-(_406 * _297)), _405 * _297 + (_406 * _296)) + _312) + vec2(0.5), vec2(0.5), _242);
    float _444 = (_93 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_312 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_93 <= parameters.gCascadeFar.x)) ? ((-(((float(textureLod(gInShadowMap, _321 * parameters.gCascadeSize.zw, 0.0).x < (_334 * 1.0 + min(_329 + dot(_224, _321 - _312), 1.0))) + float(textureLod(gInShadowMap, _357 * parameters.gCascadeSize.zw, 0.0).x < (_334 * 1.0 + min(_329 + dot(_224, _357 - _312), 1.0)))) + float(textureLod(gInShadowMap, _389 * parameters.gCascadeSize.zw, 0.0).x < (_334 * 1.0 + min(_329 + dot(_224, _389 - _312), 1.0)))) + float(textureLod(gInShadowMap, _421 * parameters.gCascadeSize.zw, 0.0).x < (_334 * 1.0 + min(_329 + dot(_224, _421 - _312), 1.0))))) * 0.25 + 1.0) : 1.0) : 1.0;
    gOutShadow = vec4(_444, _93, 0.0, 0.0);
}

