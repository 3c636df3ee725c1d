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
    vec2 _109 = mix(vec2(_101, _88), vec2(_76 - _80, _80), bvec2((_93.x ? abs(_80 - _76) : 131008.0) < (_95.x ? abs(_101) : 65504.0)));
    float _115 = _92 - _76;
    vec2 _123 = mix(vec2(_115, _92), vec2(_76 - _84, _84), bvec2((_93.y ? abs(_84 - _76) : 131008.0) < (_95.y ? abs(_115) : 65504.0)));
    vec2 _135 = vec2(_109.x, _123.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_109.y, _123.y));
    vec3 _143 = normalize(vec3(_135, (-1.0) - dot(fma(_62, parameters.gViewRay.xy, parameters.gViewRay.zw), _135)));
    vec2 _144 = floor(gl_FragCoord.xy);
    vec2 _146 = floor(_144 * 0.5);
    vec2 _148 = _144 - (_146 * 2.0);
    vec2 _152 = _146 - (floor(_146 * 0.5) * 2.0);
    float _153 = _148.x;
    float _154 = _148.y;
    float _156 = abs(_153 - _154);
    float _157 = _152.y;
    float _162 = _152.x;
    vec2 _174 = vec2(fma(2.0, abs(_162 - _157), fma(8.0, _156, 4.0 * _154)) + _157, fma(2.0, abs(abs(_157 - _154) - _162), fma(4.0, _153, fma(-8.0, _156, 8.0))) + _162) * vec2(0.0625);
    float _176 = 6.283185482025146484375 * _174.x;
    float _177 = cos(_176);
    float _178 = sin(_176);
    float _185 = 1.0 / max(fma(parameters.gOcclusionBias.y, _76, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
    vec2 _186 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _190 = vec3(_62 * _76, _76);
    float _191 = _143.z;
    float _193 = (_191 >= 0.0) ? 1.0 : (-1.0);
    float _195 = (-1.0) / (_193 + _191);
    float _196 = _143.x;
    float _197 = _143.y;
    float _199 = (_196 * _197) * _195;
    vec3 _206 = vec3(fma((_193 * _196) * _196, _195, 1.0), _193 * _199, (-_193) * _196);
    vec3 _210 = vec3(_199, fma(_197 * _197, _195, _193), -_197);
    vec3 _216 = ((_206 * _177) + (_210 * _178)) * parameters.gRadius;
    float _218 = _216.z;
    vec3 _224 = vec3((_216.xy - (parameters.gViewRay.zw * _218)) * _186, _218);
    vec3 _228 = ((_210 * _177) - (_206 * _178)) * parameters.gRadius;
    float _230 = _228.z;
    vec3 _236 = vec3((_228.xy - (parameters.gViewRay.zw * _230)) * _186, _230);
    vec3 _237 = _143 * parameters.gRadius;
    float _239 = _237.z;
    vec3 _245 = vec3((_237.xy - (parameters.gViewRay.zw * _239)) * _186, _239);
    float _257 = _174.y;
    vec3 _262 = _190 + ((((_224 * parameters.gTaps[0].x) + (_236 * parameters.gTaps[0].y)) + (_245 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _257)));
    float _263 = 1.0 / parameters.gRadius;
    float _265 = _262.z;
    vec2 _267 = _262.xy * (1.0 / _265);
    vec4 _275 = textureLod(gInCoarseDepth, _267, 0.0);
    float _276 = _275.x;
    float _280 = _265 - ((_276 > 0.0) ? min(_276, 65504.0) : 65504.0);
    vec3 _305 = _190 + ((((_224 * parameters.gTaps[1].x) + (_236 * parameters.gTaps[1].y)) + (_245 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _257)));
    float _307 = _305.z;
    vec2 _309 = _305.xy * (1.0 / _307);
    vec4 _317 = textureLod(gInCoarseDepth, _309, 0.0);
    float _318 = _317.x;
    float _322 = _307 - ((_318 > 0.0) ? min(_318, 65504.0) : 65504.0);
    vec3 _348 = _190 + ((((_224 * parameters.gTaps[2].x) + (_236 * parameters.gTaps[2].y)) + (_245 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _257)));
    float _350 = _348.z;
    vec2 _352 = _348.xy * (1.0 / _350);
    vec4 _360 = textureLod(gInCoarseDepth, _352, 0.0);
    float _361 = _360.x;
    float _365 = _350 - ((_361 > 0.0) ? min(_361, 65504.0) : 65504.0);
    vec3 _391 = _190 + ((((_224 * parameters.gTaps[3].x) + (_236 * parameters.gTaps[3].y)) + (_245 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _257)));
    float _393 = _391.z;
    vec2 _395 = _391.xy * (1.0 / _393);
    vec4 _403 = textureLod(gInCoarseDepth, _395, 0.0);
    float _404 = _403.x;
    float _408 = _393 - ((_404 > 0.0) ? min(_404, 65504.0) : 65504.0);
    vec2 _418 = ((mix(vec2(0.0), vec2(clamp(fma(_280, _185, -1.0), 0.0, 1.0) * clamp(fma(-_280, _263, 2.0), 0.0, 1.0), 1.0), bvec2((_265 > 0.0) && all(lessThanEqual(abs(_267 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_322, _185, -1.0), 0.0, 1.0) * clamp(fma(-_322, _263, 2.0), 0.0, 1.0), 1.0), bvec2((_307 > 0.0) && all(lessThanEqual(abs(_309 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_365, _185, -1.0), 0.0, 1.0) * clamp(fma(-_365, _263, 2.0), 0.0, 1.0), 1.0), bvec2((_350 > 0.0) && all(lessThanEqual(abs(_352 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_408, _185, -1.0), 0.0, 1.0) * clamp(fma(-_408, _263, 2.0), 0.0, 1.0), 1.0), bvec2((_393 > 0.0) && all(lessThanEqual(abs(_395 - vec2(0.5)), vec2(0.5)))));
    gOutOcclusion = vec4((_76 < 65504.0) ? (1.0 - (_418.x / max(_418.y, 1.0))) : 1.0, _76, 0.0, 0.0);
}

