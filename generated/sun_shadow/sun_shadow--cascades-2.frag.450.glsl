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
    vec2 _87 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _91 = parameters.gOutputSize.zw * 0.5;
    vec4 _94 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_91));
    vec4 _97 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _91));
    float _98 = _94.y;
    float _101 = (_98 > 0.0) ? min(_98, 65504.0) : 65504.0;
    float _102 = _94.x;
    float _105 = (_102 > 0.0) ? min(_102, 65504.0) : 65504.0;
    float _106 = _94.z;
    float _109 = (_106 > 0.0) ? min(_106, 65504.0) : 65504.0;
    float _110 = _97.z;
    float _113 = (_110 > 0.0) ? min(_110, 65504.0) : 65504.0;
    float _114 = _97.x;
    float _117 = (_114 > 0.0) ? min(_114, 65504.0) : 65504.0;
    vec3 _121 = vec3(_87 * _101, _101);
    bvec2 _143 = greaterThan(_87, parameters.gOutputSize.zw);
    bvec2 _145 = lessThan(_87, vec2(1.0) - parameters.gOutputSize.zw);
    float _151 = _113 - _101;
    vec2 _159 = mix(vec2(_151, _113), vec2(_101 - _105, _105), bvec2((_143.x ? abs(_105 - _101) : 131008.0) < (_145.x ? abs(_151) : 65504.0)));
    float _165 = _117 - _101;
    vec2 _173 = mix(vec2(_165, _117), vec2(_101 - _109, _109), bvec2((_143.y ? abs(_109 - _101) : 131008.0) < (_145.y ? abs(_165) : 65504.0)));
    float _177 = _159.x;
    vec3 _184 = vec3((_87 * _177) + (vec2(parameters.gOutputSize.z, 0.0) * _159.y), _177);
    float _192 = _173.x;
    vec3 _199 = vec3((_87 * _192) + (vec2(0.0, parameters.gOutputSize.w) * _173.y), _192);
    vec3 _204 = cross(vec3(dot(parameters.gToShadowX.xyz, _184), dot(parameters.gToShadowY.xyz, _184), dot(parameters.gToShadowZ.xyz, _184)), vec3(dot(parameters.gToShadowX.xyz, _199), dot(parameters.gToShadowY.xyz, _199), dot(parameters.gToShadowZ.xyz, _199)));
    float _205 = _204.z;
    bool _229 = _101 > parameters.gCascadeFar.x;
    bvec3 _230 = bvec3(_229);
    vec3 _231 = mix(vec3(1.0), parameters.gCascadeScale1.xyz, _230);
    float _233 = float(_229);
    vec3 _234 = fma(vec3(dot(parameters.gToShadowX.xyz, _121), dot(parameters.gToShadowY.xyz, _121), dot(parameters.gToShadowZ.xyz, _121)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _231, mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _230));
    float _235 = _231.z;
    vec2 _236 = _231.xy;
    vec2 _239 = clamp((-_204.xy) / vec2((abs(_205) > 9.9999996826552253889678874634872e-21) ? _205 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_235) / _236);
    vec2 _247 = max(parameters.gDisc.xy * _236, vec2(parameters.gDisc.z));
    vec2 _256 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _259 = floor(gl_FragCoord.xy);
    vec2 _261 = floor(_259 * 0.5);
    vec2 _263 = _259 - (_261 * 2.0);
    vec2 _267 = _261 - (floor(_261 * 0.5) * 2.0);
    float _268 = _263.x;
    float _269 = _263.y;
    float _271 = abs(_268 - _269);
    float _272 = _267.y;
    float _277 = _267.x;
    vec2 _289 = vec2(fma(2.0, abs(_277 - _272), fma(8.0, _271, 4.0 * _269)) + _272, fma(2.0, abs(abs(_272 - _269) - _277), fma(4.0, _268, fma(-8.0, _271, 8.0))) + _277) * vec2(0.0625);
    float _294 = floor(parameters.gSubsetCount);
    float _297 = (_294 > 1.0) ? min(_294, 16.0) : 1.0;
    float _301 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _307 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_297, floor((_301 + 0.5) / _297), _301);
    float _311 = 6.283185482025146484375 * (_307.x + _289.x);
    float _312 = cos(_311);
    float _313 = sin(_311);
    float _316 = _307.y + _289.y;
    vec2 _317 = fract(vec2(0.5));
    float _319 = 6.283185482025146484375 * _317.x;
    float _320 = cos(_319);
    float _321 = sin(_319);
    vec2 _328 = _234.xy;
    vec2 _337 = clamp(floor(fma(_247 * sqrt(fract(_317.y + _316)), vec2(fma(_320, _312, -(_321 * _313)), fma(_320, _313, _321 * _312)), _328)) + vec2(0.5), vec2(0.5), _256);
    float _349 = _234.z;
    float _354 = -fma(parameters.gShadowBias.y, _101, parameters.gShadowBias.x);
    vec2 _358 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _360 = 6.283185482025146484375 * _358.x;
    float _361 = cos(_360);
    float _362 = sin(_360);
    vec2 _377 = clamp(floor(fma(_247 * sqrt(fract(_358.y + _316)), vec2(fma(_361, _312, -(_362 * _313)), fma(_361, _313, _362 * _312)), _328)) + vec2(0.5), vec2(0.5), _256);
    vec2 _394 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _396 = 6.283185482025146484375 * _394.x;
    float _397 = cos(_396);
    float _398 = sin(_396);
    vec2 _413 = clamp(floor(fma(_247 * sqrt(fract(_394.y + _316)), vec2(fma(_397, _312, -(_398 * _313)), fma(_397, _313, _398 * _312)), _328)) + vec2(0.5), vec2(0.5), _256);
    vec2 _430 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _432 = 6.283185482025146484375 * _430.x;
    float _433 = cos(_432);
    float _434 = sin(_432);
    vec2 _449 = clamp(floor(fma(_247 * sqrt(fract(_430.y + _316)), vec2(fma(_433, _312, -(_434 * _313)), fma(_433, _313, _434 * _312)), _328)) + vec2(0.5), vec2(0.5), _256);
    float _473 = -(((float(textureLod(gInShadowMap, vec2(fma(_233, parameters.gCascadeSize.x, _337.x), _337.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_354, _235, min(_349 + dot(_239, _337 - _328), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_233, parameters.gCascadeSize.x, _377.x), _377.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_354, _235, min(_349 + dot(_239, _377 - _328), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_233, parameters.gCascadeSize.x, _413.x), _413.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_354, _235, min(_349 + dot(_239, _413 - _328), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_233, parameters.gCascadeSize.x, _449.x), _449.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_354, _235, min(_349 + dot(_239, _449 - _328), 1.0))));
    gOutShadow = vec4((_101 < 65504.0) ? ((all(lessThanEqual(abs((_328 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_101 <= parameters.gCascadeFar.y)) ? fma(_473, 0.25, 1.0) : 1.0) : 1.0, _101, 0.0, 0.0);
}

