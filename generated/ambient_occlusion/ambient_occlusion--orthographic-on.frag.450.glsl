#version 450

layout(binding = 0, std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gOcclusionBias;
    vec2 gFrameToCoarse;
    float gRadius;
    vec4 gTaps[32];
} parameters;

layout(binding = 1) uniform sampler2D gInCoarseDepth;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _64 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _68 = parameters.gOutputSize.zw * 0.5;
    vec4 _71 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_68));
    vec4 _74 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _68));
    float _75 = _71.y;
    float _78 = (_75 > 0.0) ? min(_75, 65504.0) : 65504.0;
    float _79 = _71.x;
    float _82 = (_79 > 0.0) ? min(_79, 65504.0) : 65504.0;
    float _83 = _71.z;
    float _86 = (_83 > 0.0) ? min(_83, 65504.0) : 65504.0;
    float _87 = _74.z;
    float _90 = (_87 > 0.0) ? min(_87, 65504.0) : 65504.0;
    float _91 = _74.x;
    float _94 = (_91 > 0.0) ? min(_91, 65504.0) : 65504.0;
    bvec2 _95 = greaterThan(_64, parameters.gOutputSize.zw);
    bvec2 _97 = lessThan(_64, vec2(1.0) - parameters.gOutputSize.zw);
    float _103 = _90 - _78;
    float _117 = _94 - _78;
    vec3 _137 = normalize(vec3(vec2(mix(vec2(_103, _90), vec2(_78 - _82, _82), bvec2((_95.x ? abs(_82 - _78) : 131008.0) < (_97.x ? abs(_103) : 65504.0))).x, mix(vec2(_117, _94), vec2(_78 - _86, _86), bvec2((_95.y ? abs(_86 - _78) : 131008.0) < (_97.y ? abs(_117) : 65504.0))).x) / (parameters.gViewRay.xy * parameters.gOutputSize.zw), -1.0));
    vec2 _138 = floor(gl_FragCoord.xy);
    vec2 _140 = floor(_138 * 0.5);
    vec2 _142 = _138 - (_140 * 2.0);
    vec2 _146 = _140 - (floor(_140 * 0.5) * 2.0);
    float _147 = _142.x;
    float _148 = _142.y;
    float _150 = abs(_147 - _148);
    float _151 = _146.y;
    float _156 = _146.x;
    vec2 _168 = vec2(fma(2.0, abs(_156 - _151), fma(8.0, _150, 4.0 * _148)) + _151, fma(2.0, abs(abs(_151 - _148) - _156), fma(4.0, _147, fma(-8.0, _150, 8.0))) + _156) * vec2(0.0625);
    float _170 = 6.283185482025146484375 * _168.x;
    float _171 = cos(_170);
    float _172 = sin(_170);
    float _179 = 1.0 / max(fma(parameters.gOcclusionBias.y, _78, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _180 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _183 = vec3(_64, _78);
    float _184 = _137.z;
    float _186 = (_184 >= 0.0) ? 1.0 : (-1.0);
    float _188 = (-1.0) / (_186 + _184);
    float _189 = _137.x;
    float _190 = _137.y;
    float _192 = (_189 * _190) * _188;
    vec3 _199 = vec3(fma((_186 * _189) * _189, _188, 1.0), _186 * _192, (-_186) * _189);
    vec3 _203 = vec3(_192, fma(_190 * _190, _188, _186), -_190);
    vec3 _209 = ((_199 * _171) + (_203 * _172)) * parameters.gRadius;
    vec3 _215 = vec3(_209.xy * _180, _209.z);
    vec3 _219 = ((_203 * _171) - (_199 * _172)) * parameters.gRadius;
    vec3 _225 = vec3(_219.xy * _180, _219.z);
    vec3 _226 = _137 * parameters.gRadius;
    vec3 _232 = vec3(_226.xy * _180, _226.z);
    float _244 = _168.y;
    vec3 _249 = _183 + ((((_215 * parameters.gTaps[0].x) + (_225 * parameters.gTaps[0].y)) + (_232 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _244)));
    float _250 = 1.0 / parameters.gRadius;
    vec2 _251 = _249.xy;
    float _252 = _249.z;
    vec4 _259 = textureLod(gInCoarseDepth, _251, 0.0);
    float _260 = _259.x;
    float _264 = _252 - ((_260 > 0.0) ? min(_260, 65504.0) : 65504.0);
    vec3 _289 = _183 + ((((_215 * parameters.gTaps[1].x) + (_225 * parameters.gTaps[1].y)) + (_232 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _244)));
    vec2 _290 = _289.xy;
    float _291 = _289.z;
    vec4 _298 = textureLod(gInCoarseDepth, _290, 0.0);
    float _299 = _298.x;
    float _303 = _291 - ((_299 > 0.0) ? min(_299, 65504.0) : 65504.0);
    vec3 _329 = _183 + ((((_215 * parameters.gTaps[2].x) + (_225 * parameters.gTaps[2].y)) + (_232 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _244)));
    vec2 _330 = _329.xy;
    float _331 = _329.z;
    vec4 _338 = textureLod(gInCoarseDepth, _330, 0.0);
    float _339 = _338.x;
    float _343 = _331 - ((_339 > 0.0) ? min(_339, 65504.0) : 65504.0);
    vec3 _369 = _183 + ((((_215 * parameters.gTaps[3].x) + (_225 * parameters.gTaps[3].y)) + (_232 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _244)));
    vec2 _370 = _369.xy;
    float _371 = _369.z;
    vec4 _378 = textureLod(gInCoarseDepth, _370, 0.0);
    float _379 = _378.x;
    float _383 = _371 - ((_379 > 0.0) ? min(_379, 65504.0) : 65504.0);
    vec2 _393 = ((mix(vec2(0.0), vec2(clamp(fma(_264, _179, -1.0), 0.0, 1.0) * clamp(fma(-_264, _250, 2.0), 0.0, 1.0), 1.0), bvec2((_252 > 0.0) && all(lessThanEqual(floatBitsToUint(_251), uvec2(1065353216u))))) + mix(vec2(0.0), vec2(clamp(fma(_303, _179, -1.0), 0.0, 1.0) * clamp(fma(-_303, _250, 2.0), 0.0, 1.0), 1.0), bvec2((_291 > 0.0) && all(lessThanEqual(floatBitsToUint(_290), uvec2(1065353216u)))))) + mix(vec2(0.0), vec2(clamp(fma(_343, _179, -1.0), 0.0, 1.0) * clamp(fma(-_343, _250, 2.0), 0.0, 1.0), 1.0), bvec2((_331 > 0.0) && all(lessThanEqual(floatBitsToUint(_330), uvec2(1065353216u)))))) + mix(vec2(0.0), vec2(clamp(fma(_383, _179, -1.0), 0.0, 1.0) * clamp(fma(-_383, _250, 2.0), 0.0, 1.0), 1.0), bvec2((_371 > 0.0) && all(lessThanEqual(floatBitsToUint(_370), uvec2(1065353216u)))));
    gOutOcclusion = vec4((_78 < 65504.0) ? (1.0 - (_393.x / max(_393.y, 1.0))) : 1.0, _78, 0.0, 0.0);
}

