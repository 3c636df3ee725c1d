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
    vec2 _79 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _83 = parameters.gOutputSize.zw * 0.5;
    vec4 _86 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_83));
    vec4 _89 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _83));
    float _90 = _86.y;
    float _92 = (_90 > 0.0) ? _90 : 65504.0;
    float _94 = (_92 < 65504.0) ? _92 : 65504.0;
    float _95 = _86.x;
    float _97 = (_95 > 0.0) ? _95 : 65504.0;
    float _99 = (_97 < 65504.0) ? _97 : 65504.0;
    float _100 = _86.z;
    float _102 = (_100 > 0.0) ? _100 : 65504.0;
    float _104 = (_102 < 65504.0) ? _102 : 65504.0;
    float _105 = _89.z;
    float _107 = (_105 > 0.0) ? _105 : 65504.0;
    float _109 = (_107 < 65504.0) ? _107 : 65504.0;
    float _110 = _89.x;
    float _112 = (_110 > 0.0) ? _110 : 65504.0;
    float _114 = (_112 < 65504.0) ? _112 : 65504.0;
    vec3 _118 = vec3(_79 * _94, _94);
    vec2 _142 = vec2(parameters.gOutputSize.z, 0.0);
    float _157 = _109 - _94;
    vec2 _165 = mix(vec2(_157, _109), vec2(_94 - _99, _99), bvec2((all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_142) - vec2(0.5)), vec2(0.5))) ? abs(_99 - _94) : 131008.0) < (all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _142) - vec2(0.5)), vec2(0.5))) ? abs(_157) : 65504.0)));
    float _166 = _165.x;
    vec3 _173 = vec3((_79 * _166) + (_142 * _165.y), _166);
    vec2 _180 = vec2(0.0, parameters.gOutputSize.w);
    float _195 = _114 - _94;
    vec2 _203 = mix(vec2(_195, _114), vec2(_94 - _104, _104), bvec2((all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_180) - vec2(0.5)), vec2(0.5))) ? abs(_104 - _94) : 131008.0) < (all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _180) - vec2(0.5)), vec2(0.5))) ? abs(_195) : 65504.0)));
    float _204 = _203.x;
    vec3 _211 = vec3((_79 * _204) + (_180 * _203.y), _204);
    vec3 _216 = cross(vec3(dot(parameters.gToShadowX.xyz, _173), dot(parameters.gToShadowY.xyz, _173), dot(parameters.gToShadowZ.xyz, _173)), vec3(dot(parameters.gToShadowX.xyz, _211), dot(parameters.gToShadowY.xyz, _211), dot(parameters.gToShadowZ.xyz, _211)));
    float _217 = _216.z;
    bool _241 = _94 > parameters.gCascadeFar.x;
    bvec3 _242 = bvec3(_241);
    bool _254 = _94 > parameters.gCascadeFar.y;
    bvec3 _255 = bvec3(_254);
    vec3 _256 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _242), parameters.gCascadeScale2.xyz, _255);
    float _259 = float(_241) + float(_254);
    vec3 _260 = fma(vec3(dot(parameters.gToShadowX.xyz, _118), dot(parameters.gToShadowY.xyz, _118), dot(parameters.gToShadowZ.xyz, _118)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _256, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _242), parameters.gCascadeOffset2.xyz, _255));
    float _261 = _256.z;
    vec2 _262 = _256.xy;
    vec2 _265 = clamp((-_216.xy) / vec2((abs(_217) > 9.9999996826552253889678874634872e-21) ? _217 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_261) / _262);
    vec2 _273 = max(parameters.gDisc.xy * _262, vec2(parameters.gDisc.z));
    vec2 _282 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _285 = floor(gl_FragCoord.xy);
    float _290 = floor(parameters.gSubsetCount);
    float _293 = (_290 > 1.0) ? min(_290, 16.0) : 1.0;
    float _297 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _303 = vec2(0.509755313396453857421875, 0.13968057930469512939453125) * fma(-_293, floor((_297 + 0.5) / _293), _297);
    vec2 _306 = floor(_285 * 0.5);
    vec2 _308 = _285 - (_306 * 2.0);
    vec2 _312 = _306 - (floor(_285 * 0.25) * 2.0);
    float _314 = _308.y;
    float _317 = _312.y;
    vec2 _323 = (abs(vec2(_308.x - _314, _312.x - _317)) * 2.0) + vec2(_314, _317);
    float _328 = 6.283185482025146484375 * fma(fma(4.0, _323.x, _323.y), 0.0625, _303.x);
    float _329 = cos(_328);
    float _330 = sin(_328);
    vec2 _335 = vec2(_285.y + 1.0, _285.x);
    vec2 _337 = floor(_335 * 0.5);
    vec2 _339 = _335 - (_337 * 2.0);
    vec2 _343 = _337 - (floor(_335 * 0.25) * 2.0);
    float _345 = _339.y;
    float _348 = _343.y;
    vec2 _354 = (abs(vec2(_339.x - _345, _343.x - _348)) * 2.0) + vec2(_345, _348);
    float _358 = fma(fma(4.0, _354.x, _354.y), 0.0625, _303.y);
    vec2 _359 = fract(vec2(0.5));
    float _361 = 6.283185482025146484375 * _359.x;
    float _362 = cos(_361);
    float _363 = sin(_361);
    vec2 _379 = clamp(floor(fma(_273 * sqrt(fract(_359.y + _358)), vec2(fma(_362, _329, -(_363 * _330)), fma(_362, _330, _363 * _329)), _260.xy)) + vec2(0.5), vec2(0.5), _282);
    float _396 = -fma(parameters.gBias.y, _94, parameters.gBias.x);
    vec2 _400 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _402 = 6.283185482025146484375 * _400.x;
    float _403 = cos(_402);
    float _404 = sin(_402);
    vec2 _419 = clamp(floor(fma(_273 * sqrt(fract(_400.y + _358)), vec2(fma(_403, _329, -(_404 * _330)), fma(_403, _330, _404 * _329)), _260.xy)) + vec2(0.5), vec2(0.5), _282);
    gOutShadow = vec4((_94 < 65504.0) ? ((all(lessThanEqual(abs((_260.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_94 <= parameters.gCascadeFar.z)) ? fma(-(float(textureLod(gInShadowMap, vec2(fma(_259, parameters.gCascadeSize.x, _379.x), _379.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_396, _261, min(_260.z + dot(_265, _379 - _260.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_259, parameters.gCascadeSize.x, _419.x), _419.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_396, _261, min(_260.z + dot(_265, _419 - _260.xy), 1.0)))), 0.5, 1.0) : 1.0) : 1.0, _94, 0.0, 0.0);
}

