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
    vec2 _96 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _100 = parameters.gOutputSize.zw * 0.5;
    vec4 _103 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_100));
    vec4 _106 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _100));
    float _107 = _103.y;
    float _110 = (_107 > 0.0) ? min(_107, 65504.0) : 65504.0;
    float _111 = _103.x;
    float _114 = (_111 > 0.0) ? min(_111, 65504.0) : 65504.0;
    float _115 = _103.z;
    float _118 = (_115 > 0.0) ? min(_115, 65504.0) : 65504.0;
    float _119 = _106.z;
    float _122 = (_119 > 0.0) ? min(_119, 65504.0) : 65504.0;
    float _123 = _106.x;
    float _126 = (_123 > 0.0) ? min(_123, 65504.0) : 65504.0;
    vec3 _130 = vec3(_96 * _110, _110);
    bvec2 _152 = greaterThan(_96, parameters.gOutputSize.zw);
    bvec2 _154 = lessThan(_96, vec2(1.0) - parameters.gOutputSize.zw);
    float _160 = _122 - _110;
    vec2 _168 = mix(vec2(_160, _122), vec2(_110 - _114, _114), bvec2((_152.x ? abs(_114 - _110) : 131008.0) < (_154.x ? abs(_160) : 65504.0)));
    float _174 = _126 - _110;
    vec2 _182 = mix(vec2(_174, _126), vec2(_110 - _118, _118), bvec2((_152.y ? abs(_118 - _110) : 131008.0) < (_154.y ? abs(_174) : 65504.0)));
    float _186 = _168.x;
    vec3 _193 = vec3((_96 * _186) + (vec2(parameters.gOutputSize.z, 0.0) * _168.y), _186);
    float _201 = _182.x;
    vec3 _208 = vec3((_96 * _201) + (vec2(0.0, parameters.gOutputSize.w) * _182.y), _201);
    vec3 _213 = cross(vec3(dot(parameters.gToShadowX.xyz, _193), dot(parameters.gToShadowY.xyz, _193), dot(parameters.gToShadowZ.xyz, _193)), vec3(dot(parameters.gToShadowX.xyz, _208), dot(parameters.gToShadowY.xyz, _208), dot(parameters.gToShadowZ.xyz, _208)));
    float _214 = _213.z;
    bool _238 = _110 > parameters.gCascadeFar.x;
    bvec3 _239 = bvec3(_238);
    bool _251 = _110 > parameters.gCascadeFar.y;
    bvec3 _252 = bvec3(_251);
    vec3 _253 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _239), parameters.gCascadeScale2.xyz, _252);
    float _256 = float(_238) + float(_251);
    vec3 _257 = fma(vec3(dot(parameters.gToShadowX.xyz, _130), dot(parameters.gToShadowY.xyz, _130), dot(parameters.gToShadowZ.xyz, _130)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _253, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _239), parameters.gCascadeOffset2.xyz, _252));
    float _258 = _253.z;
    vec2 _259 = _253.xy;
    vec2 _262 = clamp((-_213.xy) / vec2((abs(_214) > 9.9999996826552253889678874634872e-21) ? _214 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_258) / _259);
    vec2 _270 = max(parameters.gDisc.xy * _259, vec2(parameters.gDisc.z));
    vec2 _279 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _282 = floor(gl_FragCoord.xy);
    vec2 _284 = floor(_282 * 0.5);
    vec2 _286 = _282 - (_284 * 2.0);
    vec2 _290 = _284 - (floor(_284 * 0.5) * 2.0);
    float _291 = _286.x;
    float _292 = _286.y;
    float _294 = abs(_291 - _292);
    float _295 = _290.y;
    float _300 = _290.x;
    vec2 _312 = vec2(fma(2.0, abs(_300 - _295), fma(8.0, _294, 4.0 * _292)) + _295, fma(2.0, abs(abs(_295 - _292) - _300), fma(4.0, _291, fma(-8.0, _294, 8.0))) + _300) * vec2(0.0625);
    float _317 = floor(parameters.gSubsetCount);
    float _320 = (_317 > 1.0) ? min(_317, 16.0) : 1.0;
    float _324 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _330 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_320, floor((_324 + 0.5) / _320), _324);
    float _334 = 6.283185482025146484375 * (_330.x + _312.x);
    float _335 = cos(_334);
    float _336 = sin(_334);
    float _339 = _330.y + _312.y;
    vec2 _340 = fract(vec2(0.5));
    float _342 = 6.283185482025146484375 * _340.x;
    float _343 = cos(_342);
    float _344 = sin(_342);
    vec2 _351 = _257.xy;
    vec2 _360 = clamp(floor(fma(_270 * sqrt(fract(_340.y + _339)), vec2(fma(_343, _335, -(_344 * _336)), fma(_343, _336, _344 * _335)), _351)) + vec2(0.5), vec2(0.5), _279);
    float _372 = _257.z;
    float _377 = -fma(parameters.gShadowBias.y, _110, parameters.gShadowBias.x);
    vec2 _381 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _383 = 6.283185482025146484375 * _381.x;
    float _384 = cos(_383);
    float _385 = sin(_383);
    vec2 _400 = clamp(floor(fma(_270 * sqrt(fract(_381.y + _339)), vec2(fma(_384, _335, -(_385 * _336)), fma(_384, _336, _385 * _335)), _351)) + vec2(0.5), vec2(0.5), _279);
    vec2 _417 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _419 = 6.283185482025146484375 * _417.x;
    float _420 = cos(_419);
    float _421 = sin(_419);
    vec2 _436 = clamp(floor(fma(_270 * sqrt(fract(_417.y + _339)), vec2(fma(_420, _335, -(_421 * _336)), fma(_420, _336, _421 * _335)), _351)) + vec2(0.5), vec2(0.5), _279);
    vec2 _453 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _455 = 6.283185482025146484375 * _453.x;
    float _456 = cos(_455);
    float _457 = sin(_455);
    vec2 _472 = clamp(floor(fma(_270 * sqrt(fract(_453.y + _339)), vec2(fma(_456, _335, -(_457 * _336)), fma(_456, _336, _457 * _335)), _351)) + vec2(0.5), vec2(0.5), _279);
    float _495 = -(((float(textureLod(gInShadowMap, vec2(fma(_256, parameters.gCascadeSize.x, _360.x), _360.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_377, _258, min(_372 + dot(_262, _360 - _351), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_256, parameters.gCascadeSize.x, _400.x), _400.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_377, _258, min(_372 + dot(_262, _400 - _351), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_256, parameters.gCascadeSize.x, _436.x), _436.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_377, _258, min(_372 + dot(_262, _436 - _351), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_256, parameters.gCascadeSize.x, _472.x), _472.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_377, _258, min(_372 + dot(_262, _472 - _351), 1.0))));
    float _499 = (_110 < 65504.0) ? ((all(lessThanEqual(floatBitsToUint(_351 / parameters.gCascadeSize.xy), uvec2(1065353216u))) && (_110 <= parameters.gCascadeFar.z)) ? fma(_495, 0.25, 1.0) : 1.0) : 1.0;
    vec4 _503 = textureLod(gInOcclusion, _96, 0.0);
    float _504 = _503.x;
    gOutShadow = vec4(fma((_504 > 0.0) ? min(_504, 1.0) : 0.0, 0.984375, floor(fma((_499 > 0.0) ? min(_499, 1.0) : 0.0, 31.0, 0.5))), _110, 0.0, 0.0);
}

