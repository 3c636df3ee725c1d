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
    vec2 _82 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _86 = parameters.gOutputSize.zw * 0.5;
    vec4 _89 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_86));
    vec4 _92 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _86));
    float _93 = _89.y;
    float _96 = (_93 > 0.0) ? min(_93, 65504.0) : 65504.0;
    float _97 = _89.x;
    float _100 = (_97 > 0.0) ? min(_97, 65504.0) : 65504.0;
    float _101 = _89.z;
    float _104 = (_101 > 0.0) ? min(_101, 65504.0) : 65504.0;
    float _105 = _92.z;
    float _108 = (_105 > 0.0) ? min(_105, 65504.0) : 65504.0;
    float _109 = _92.x;
    float _112 = (_109 > 0.0) ? min(_109, 65504.0) : 65504.0;
    vec3 _116 = vec3(_82 * _96, _96);
    vec3 _137 = vec3(dot(parameters.gToShadowX.xyz, _116), dot(parameters.gToShadowY.xyz, _116), dot(parameters.gToShadowZ.xyz, _116)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w);
    bvec2 _138 = greaterThan(_82, parameters.gOutputSize.zw);
    bvec2 _140 = lessThan(_82, vec2(1.0) - parameters.gOutputSize.zw);
    float _146 = _108 - _96;
    vec2 _154 = mix(vec2(_146, _108), vec2(_96 - _100, _100), bvec2((_138.x ? abs(_100 - _96) : 131008.0) < (_140.x ? abs(_146) : 65504.0)));
    float _160 = _112 - _96;
    vec2 _168 = mix(vec2(_160, _112), vec2(_96 - _104, _104), bvec2((_138.y ? abs(_104 - _96) : 131008.0) < (_140.y ? abs(_160) : 65504.0)));
    float _172 = _154.x;
    vec3 _179 = vec3((_82 * _172) + (vec2(parameters.gOutputSize.z, 0.0) * _154.y), _172);
    float _187 = _168.x;
    vec3 _194 = vec3((_82 * _187) + (vec2(0.0, parameters.gOutputSize.w) * _168.y), _187);
    vec3 _199 = cross(vec3(dot(parameters.gToShadowX.xyz, _179), dot(parameters.gToShadowY.xyz, _179), dot(parameters.gToShadowZ.xyz, _179)), vec3(dot(parameters.gToShadowX.xyz, _194), dot(parameters.gToShadowY.xyz, _194), dot(parameters.gToShadowZ.xyz, _194)));
    float _200 = _199.z;
    vec2 _213 = clamp((-_199.xy) / vec2((abs(_200) > 9.9999996826552253889678874634872e-21) ? _200 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z));
    vec2 _222 = max(parameters.gDisc.xy, vec2(parameters.gDisc.z));
    vec2 _231 = parameters.gCascadeSize.xy - vec2(0.5);
    vec2 _232 = floor(gl_FragCoord.xy);
    vec2 _234 = floor(_232 * 0.5);
    vec2 _236 = _232 - (_234 * 2.0);
    vec2 _240 = _234 - (floor(_234 * 0.5) * 2.0);
    float _241 = _236.x;
    float _242 = _236.y;
    float _244 = abs(_241 - _242);
    float _245 = _240.y;
    float _250 = _240.x;
    vec2 _262 = vec2(fma(2.0, abs(_250 - _245), fma(8.0, _244, 4.0 * _242)) + _245, fma(2.0, abs(abs(_245 - _242) - _250), fma(4.0, _241, fma(-8.0, _244, 8.0))) + _250) * vec2(0.0625);
    float _267 = floor(parameters.gSubsetCount);
    float _270 = (_267 > 1.0) ? min(_267, 16.0) : 1.0;
    float _274 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec2 _280 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_270, floor((_274 + 0.5) / _270), _274);
    float _284 = 6.283185482025146484375 * (_280.x + _262.x);
    float _285 = cos(_284);
    float _286 = sin(_284);
    float _289 = _280.y + _262.y;
    vec2 _290 = fract(vec2(0.5));
    float _292 = 6.283185482025146484375 * _290.x;
    float _293 = cos(_292);
    float _294 = sin(_292);
    vec2 _301 = _137.xy;
    vec2 _310 = clamp(floor(fma(_222 * sqrt(fract(_290.y + _289)), vec2(fma(_293, _285, -(_294 * _286)), fma(_293, _286, _294 * _285)), _301)) + vec2(0.5), vec2(0.5), _231);
    float _318 = _137.z;
    float _323 = -fma(parameters.gShadowBias.y, _96, parameters.gShadowBias.x);
    vec2 _327 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
    float _329 = 6.283185482025146484375 * _327.x;
    float _330 = cos(_329);
    float _331 = sin(_329);
    vec2 _346 = clamp(floor(fma(_222 * sqrt(fract(_327.y + _289)), vec2(fma(_330, _285, -(_331 * _286)), fma(_330, _286, _331 * _285)), _301)) + vec2(0.5), vec2(0.5), _231);
    vec2 _359 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
    float _361 = 6.283185482025146484375 * _359.x;
    float _362 = cos(_361);
    float _363 = sin(_361);
    vec2 _378 = clamp(floor(fma(_222 * sqrt(fract(_359.y + _289)), vec2(fma(_362, _285, -(_363 * _286)), fma(_362, _286, _363 * _285)), _301)) + vec2(0.5), vec2(0.5), _231);
    vec2 _391 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
    float _393 = 6.283185482025146484375 * _391.x;
    float _394 = cos(_393);
    float _395 = sin(_393);
    vec2 _410 = clamp(floor(fma(_222 * sqrt(fract(_391.y + _289)), vec2(fma(_394, _285, -(_395 * _286)), fma(_394, _286, _395 * _285)), _301)) + vec2(0.5), vec2(0.5), _231);
    float _434 = (_96 < 65504.0) ? ((all(lessThanEqual(abs((_301 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_96 <= parameters.gCascadeFar.x)) ? fma(-(((float(textureLod(gInShadowMap, _310 * parameters.gCascadeSize.zw, 0.0).x < fma(_323, 1.0, min(_318 + dot(_213, _310 - _301), 1.0))) + float(textureLod(gInShadowMap, _346 * parameters.gCascadeSize.zw, 0.0).x < fma(_323, 1.0, min(_318 + dot(_213, _346 - _301), 1.0)))) + float(textureLod(gInShadowMap, _378 * parameters.gCascadeSize.zw, 0.0).x < fma(_323, 1.0, min(_318 + dot(_213, _378 - _301), 1.0)))) + float(textureLod(gInShadowMap, _410 * parameters.gCascadeSize.zw, 0.0).x < fma(_323, 1.0, min(_318 + dot(_213, _410 - _301), 1.0)))), 0.25, 1.0) : 1.0) : 1.0;
    gOutShadow = vec4(_434, _96, 0.0, 0.0);
}

