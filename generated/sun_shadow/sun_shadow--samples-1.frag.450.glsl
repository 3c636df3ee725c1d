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
    vec2 _76 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _80 = parameters.gOutputSize.zw * 0.5;
    vec4 _83 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_80));
    vec4 _86 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _80));
    float _87 = _83.y;
    float _89 = (_87 > 0.0) ? _87 : 65504.0;
    float _91 = (_89 < 65504.0) ? _89 : 65504.0;
    float _92 = _83.x;
    float _94 = (_92 > 0.0) ? _92 : 65504.0;
    float _96 = (_94 < 65504.0) ? _94 : 65504.0;
    float _97 = _83.z;
    float _99 = (_97 > 0.0) ? _97 : 65504.0;
    float _101 = (_99 < 65504.0) ? _99 : 65504.0;
    float _102 = _86.z;
    float _104 = (_102 > 0.0) ? _102 : 65504.0;
    float _106 = (_104 < 65504.0) ? _104 : 65504.0;
    float _107 = _86.x;
    float _109 = (_107 > 0.0) ? _107 : 65504.0;
    float _111 = (_109 < 65504.0) ? _109 : 65504.0;
    vec3 _115 = vec3(_76 * _91, _91);
    vec2 _139 = vec2(parameters.gOutputSize.z, 0.0);
    float _154 = _106 - _91;
    vec2 _162 = mix(vec2(_154, _106), vec2(_91 - _96, _96), bvec2((all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_139) - vec2(0.5)), vec2(0.5))) ? abs(_96 - _91) : 131008.0) < (all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _139) - vec2(0.5)), vec2(0.5))) ? abs(_154) : 65504.0)));
    float _163 = _162.x;
    vec3 _170 = vec3((_76 * _163) + (_139 * _162.y), _163);
    vec2 _177 = vec2(0.0, parameters.gOutputSize.w);
    float _192 = _111 - _91;
    vec2 _200 = mix(vec2(_192, _111), vec2(_91 - _101, _101), bvec2((all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_177) - vec2(0.5)), vec2(0.5))) ? abs(_101 - _91) : 131008.0) < (all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _177) - vec2(0.5)), vec2(0.5))) ? abs(_192) : 65504.0)));
    float _201 = _200.x;
    vec3 _208 = vec3((_76 * _201) + (_177 * _200.y), _201);
    vec3 _213 = cross(vec3(dot(parameters.gToShadowX.xyz, _170), dot(parameters.gToShadowY.xyz, _170), dot(parameters.gToShadowZ.xyz, _170)), vec3(dot(parameters.gToShadowX.xyz, _208), dot(parameters.gToShadowY.xyz, _208), dot(parameters.gToShadowZ.xyz, _208)));
    float _214 = _213.z;
    bool _238 = _91 > parameters.gCascadeFar.x;
    bvec3 _239 = bvec3(_238);
    bool _251 = _91 > parameters.gCascadeFar.y;
    bvec3 _252 = bvec3(_251);
    vec3 _253 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _239), parameters.gCascadeScale2.xyz, _252);
    vec3 _257 = fma(vec3(dot(parameters.gToShadowX.xyz, _115), dot(parameters.gToShadowY.xyz, _115), dot(parameters.gToShadowZ.xyz, _115)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _253, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _239), parameters.gCascadeOffset2.xyz, _252));
    float _258 = _253.z;
    vec2 _259 = _253.xy;
    vec2 _282 = floor(gl_FragCoord.xy);
    float _287 = floor(parameters.gSubsetCount);
    float _290 = (_287 > 1.0) ? min(_287, 16.0) : 1.0;
    float _294 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _300 = vec2(0.75487768650054931640625, 0.56984031200408935546875) * fma(-_290, floor((_294 + 0.5) / _290), _294);
    vec2 _303 = floor(_282 * 0.5);
    vec2 _305 = _282 - (_303 * 2.0);
    vec2 _309 = _303 - (floor(_282 * 0.25) * 2.0);
    float _311 = _305.y;
    float _314 = _309.y;
    vec2 _320 = (abs(vec2(_305.x - _311, _309.x - _314)) * 2.0) + vec2(_311, _314);
    float _325 = 6.283185482025146484375 * fma(fma(4.0, _320.x, _320.y), 0.0625, _300.x);
    float _326 = cos(_325);
    float _327 = sin(_325);
    vec2 _332 = vec2(_282.y + 1.0, _282.x);
    vec2 _334 = floor(_332 * 0.5);
    vec2 _336 = _332 - (_334 * 2.0);
    vec2 _340 = _334 - (floor(_332 * 0.25) * 2.0);
    float _342 = _336.y;
    float _345 = _340.y;
    vec2 _351 = (abs(vec2(_336.x - _342, _340.x - _345)) * 2.0) + vec2(_342, _345);
    vec2 _356 = fract(vec2(0.5));
    float _358 = 6.283185482025146484375 * _356.x;
    float _359 = cos(_358);
    float _360 = sin(_358);
    vec2 _376 = clamp(floor(fma(max(parameters.gDisc.xy * _259, vec2(parameters.gDisc.z)) * sqrt(fract(_356.y + fma(fma(4.0, _351.x, _351.y), 0.0625, _300.y))), vec2(fma(_359, _326, -(_360 * _327)), fma(_359, _327, _360 * _326)), _257.xy)) + vec2(0.5), vec2(0.5), parameters.gCascadeSize.xy - vec2(0.5));
    float _407 = (_91 < 65504.0) ? ((all(lessThanEqual(abs((_257.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_91 <= parameters.gCascadeFar.z)) ? (1.0 - float(textureLod(gInShadowMap, vec2(fma(float(_238) + float(_251), parameters.gCascadeSize.x, _376.x), _376.y) * parameters.gCascadeSize.zw, 0.0).x < fma(-fma(parameters.gBias.y, _91, parameters.gBias.x), _258, min(_257.z + dot(clamp((-_213.xy) / vec2((abs(_214) > 9.9999996826552253889678874634872e-21) ? _214 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_258) / _259), _376 - _257.xy), 1.0)))) : 1.0) : 1.0;
    gOutShadow = vec4(_407, _91, 0.0, 0.0);
}

