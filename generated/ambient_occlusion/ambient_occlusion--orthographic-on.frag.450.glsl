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
    vec2 _62 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _66 = parameters.gOutputSize.zw * 0.5;
    vec4 _69 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_66));
    vec4 _72 = textureGather(gInCoarseDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _66));
    float _73 = _69.y;
    float _76 = (_73 > 0.0) ? min(_73, 65504.0) : 65504.0;
    float _77 = _69.x;
    float _80 = (_77 > 0.0) ? min(_77, 65504.0) : 65504.0;
    float _81 = _69.z;
    float _84 = (_81 > 0.0) ? min(_81, 65504.0) : 65504.0;
    float _85 = _72.z;
    float _88 = (_85 > 0.0) ? min(_85, 65504.0) : 65504.0;
    float _89 = _72.x;
    float _92 = (_89 > 0.0) ? min(_89, 65504.0) : 65504.0;
    bvec2 _93 = greaterThan(_62, parameters.gOutputSize.zw);
    bvec2 _95 = lessThan(_62, vec2(1.0) - parameters.gOutputSize.zw);
    float _101 = _88 - _76;
    float _115 = _92 - _76;
    vec3 _135 = normalize(vec3(vec2(mix(vec2(_101, _88), vec2(_76 - _80, _80), bvec2((_93.x ? abs(_80 - _76) : 131008.0) < (_95.x ? abs(_101) : 65504.0))).x, mix(vec2(_115, _92), vec2(_76 - _84, _84), bvec2((_93.y ? abs(_84 - _76) : 131008.0) < (_95.y ? abs(_115) : 65504.0))).x) / (parameters.gViewRay.xy * parameters.gOutputSize.zw), -1.0));
    vec2 _136 = floor(gl_FragCoord.xy);
    vec2 _138 = floor(_136 * 0.5);
    vec2 _140 = _136 - (_138 * 2.0);
    vec2 _144 = _138 - (floor(_138 * 0.5) * 2.0);
    float _145 = _140.x;
    float _146 = _140.y;
    float _148 = abs(_145 - _146);
    float _149 = _144.y;
    float _154 = _144.x;
    vec2 _166 = vec2(fma(2.0, abs(_154 - _149), fma(8.0, _148, 4.0 * _146)) + _149, fma(2.0, abs(abs(_149 - _146) - _154), fma(4.0, _145, fma(-8.0, _148, 8.0))) + _154) * vec2(0.0625);
    float _168 = 6.283185482025146484375 * _166.x;
    float _169 = cos(_168);
    float _170 = sin(_168);
    float _177 = 1.0 / max(fma(parameters.gOcclusionBias.y, _76, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _178 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _181 = vec3(_62, _76);
    float _182 = _135.z;
    float _184 = (_182 >= 0.0) ? 1.0 : (-1.0);
    float _186 = (-1.0) / (_184 + _182);
    float _187 = _135.x;
    float _188 = _135.y;
    float _190 = (_187 * _188) * _186;
    vec3 _197 = vec3(fma((_184 * _187) * _187, _186, 1.0), _184 * _190, (-_184) * _187);
    vec3 _201 = vec3(_190, fma(_188 * _188, _186, _184), -_188);
    vec3 _207 = ((_197 * _169) + (_201 * _170)) * parameters.gRadius;
    vec3 _213 = vec3(_207.xy * _178, _207.z);
    vec3 _217 = ((_201 * _169) - (_197 * _170)) * parameters.gRadius;
    vec3 _223 = vec3(_217.xy * _178, _217.z);
    vec3 _224 = _135 * parameters.gRadius;
    vec3 _230 = vec3(_224.xy * _178, _224.z);
    float _242 = _166.y;
    vec3 _247 = _181 + ((((_213 * parameters.gTaps[0].x) + (_223 * parameters.gTaps[0].y)) + (_230 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _242)));
    float _248 = 1.0 / parameters.gRadius;
    vec2 _249 = _247.xy;
    float _250 = _247.z;
    vec4 _258 = textureLod(gInCoarseDepth, _249, 0.0);
    float _259 = _258.x;
    float _263 = _250 - ((_259 > 0.0) ? min(_259, 65504.0) : 65504.0);
    vec3 _288 = _181 + ((((_213 * parameters.gTaps[1].x) + (_223 * parameters.gTaps[1].y)) + (_230 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _242)));
    vec2 _289 = _288.xy;
    float _290 = _288.z;
    vec4 _298 = textureLod(gInCoarseDepth, _289, 0.0);
    float _299 = _298.x;
    float _303 = _290 - ((_299 > 0.0) ? min(_299, 65504.0) : 65504.0);
    vec3 _329 = _181 + ((((_213 * parameters.gTaps[2].x) + (_223 * parameters.gTaps[2].y)) + (_230 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _242)));
    vec2 _330 = _329.xy;
    float _331 = _329.z;
    vec4 _339 = textureLod(gInCoarseDepth, _330, 0.0);
    float _340 = _339.x;
    float _344 = _331 - ((_340 > 0.0) ? min(_340, 65504.0) : 65504.0);
    vec3 _370 = _181 + ((((_213 * parameters.gTaps[3].x) + (_223 * parameters.gTaps[3].y)) + (_230 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _242)));
    vec2 _371 = _370.xy;
    float _372 = _370.z;
    vec4 _380 = textureLod(gInCoarseDepth, _371, 0.0);
    float _381 = _380.x;
    float _385 = _372 - ((_381 > 0.0) ? min(_381, 65504.0) : 65504.0);
    vec2 _395 = ((mix(vec2(0.0), vec2(clamp(fma(_263, _177, -1.0), 0.0, 1.0) * clamp(fma(-_263, _248, 2.0), 0.0, 1.0), 1.0), bvec2((_250 > 0.0) && all(lessThanEqual(abs(_249 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_303, _177, -1.0), 0.0, 1.0) * clamp(fma(-_303, _248, 2.0), 0.0, 1.0), 1.0), bvec2((_290 > 0.0) && all(lessThanEqual(abs(_289 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_344, _177, -1.0), 0.0, 1.0) * clamp(fma(-_344, _248, 2.0), 0.0, 1.0), 1.0), bvec2((_331 > 0.0) && all(lessThanEqual(abs(_330 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_385, _177, -1.0), 0.0, 1.0) * clamp(fma(-_385, _248, 2.0), 0.0, 1.0), 1.0), bvec2((_372 > 0.0) && all(lessThanEqual(abs(_371 - vec2(0.5)), vec2(0.5)))));
    gOutOcclusion = vec4((_76 < 65504.0) ? (1.0 - (_395.x / max(_395.y, 1.0))) : 1.0, _76, 0.0, 0.0);
}

