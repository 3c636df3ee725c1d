#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gOcclusionBias;
    vec2 gFrameToCoarse;
    float gRadius;
    vec4 gTaps[32];
} parameters;

uniform highp sampler2D gInCoarseDepth;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _65 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _69 = textureLod(gInCoarseDepth, _65, 0.0);
    float _70 = _69.x;
    float _73 = (_70 > 0.0) ? min(_70, 65504.0) : 65504.0;
    vec2 _76 = vec2(parameters.gOutputSize.z, 0.0);
    vec4 _80 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_76), 0.0);
    float _81 = _80.x;
    float _84 = (_81 > 0.0) ? min(_81, 65504.0) : 65504.0;
    vec2 _87 = vec2(0.0, parameters.gOutputSize.w);
    vec4 _91 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_87), 0.0);
    float _92 = _91.x;
    float _95 = (_92 > 0.0) ? min(_92, 65504.0) : 65504.0;
    vec4 _98 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _76, 0.0);
    float _99 = _98.x;
    float _102 = (_99 > 0.0) ? min(_99, 65504.0) : 65504.0;
    vec4 _105 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _87, 0.0);
    float _106 = _105.x;
    float _109 = (_106 > 0.0) ? min(_106, 65504.0) : 65504.0;
    bvec2 _110 = greaterThan(_65, parameters.gOutputSize.zw);
    bvec2 _112 = lessThan(_65, vec2(1.0) - parameters.gOutputSize.zw);
    float _118 = _102 - _73;
    vec2 _123 = vec2(_73 - _84, _84);
    vec2 _124 = vec2(_118, _102);
    bvec2 _125 = bvec2((_110.x ? abs(_84 - _73) : 131008.0) < (_112.x ? abs(_118) : 65504.0));
    vec2 _126 = vec2(_125.x ? _123.x : _124.x, _125.y ? _123.y : _124.y);
    float _132 = _109 - _73;
    vec2 _137 = vec2(_73 - _95, _95);
    vec2 _138 = vec2(_132, _109);
    bvec2 _139 = bvec2((_110.y ? abs(_95 - _73) : 131008.0) < (_112.y ? abs(_132) : 65504.0));
    vec2 _140 = vec2(_139.x ? _137.x : _138.x, _139.y ? _137.y : _138.y);
    vec2 _152 = vec2(_126.x, _140.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_126.y, _140.y));
    vec3 _160 = normalize(vec3(_152, (-1.0) - dot(_65 * parameters.gViewRay.xy + parameters.gViewRay.zw, _152)));
    vec2 _161 = floor(gl_FragCoord.xy);
    vec2 _163 = floor(_161 * 0.5);
    vec2 _165 = _161 - (_163 * 2.0);
    vec2 _169 = _163 - (floor(_163 * 0.5) * 2.0);
    float _170 = _165.x;
    float _171 = _165.y;
    float _173 = abs(_170 - _171);
    float _174 = _169.y;
    float _179 = _169.x;
    vec2 _191 = vec2((2.0 * abs(_179 - _174) + (8.0 * _173 + (4.0 * _171))) + _174, (2.0 * abs(abs(_174 - _171) - _179) + (4.0 * _170 + ((-8.0) * _173 + 8.0))) + _179) * vec2(0.0625);
    float _193 = 6.283185482025146484375 * _191.x;
    float _194 = cos(_193);
    float _195 = sin(_193);
    float _202 = 1.0 / max(parameters.gOcclusionBias.y * _73 + parameters.gOcclusionBias.x, 9.9999999747524270787835121154785e-07);
    vec2 _203 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _207 = vec3(_65 * _73, _73);
    float _208 = _160.z;
    float _210 = (_208 >= 0.0) ? 1.0 : (-1.0);
    float _212 = (-1.0) / (_210 + _208);
    float _213 = _160.x;
    float _214 = _160.y;
    float _216 = (_213 * _214) * _212;
    vec3 _223 = vec3(((_210 * _213) * _213) * _212 + 1.0, _210 * _216, (-_210) * _213);
    vec3 _227 = vec3(_216, (_214 * _214) * _212 + _210, -_214);
    vec3 _233 = ((_223 * _194) + (_227 * _195)) * parameters.gRadius;
    float _235 = _233.z;
    vec3 _241 = vec3((_233.xy - (parameters.gViewRay.zw * _235)) * _203, _235);
    vec3 _245 = ((_227 * _194) - (_223 * _195)) * parameters.gRadius;
    float _247 = _245.z;
    vec3 _253 = vec3((_245.xy - (parameters.gViewRay.zw * _247)) * _203, _247);
    vec3 _254 = _160 * parameters.gRadius;
    float _256 = _254.z;
    vec3 _262 = vec3((_254.xy - (parameters.gViewRay.zw * _256)) * _203, _256);
    float _274 = _191.y;
    vec3 _279 = _207 + ((((_241 * parameters.gTaps[0].x) + (_253 * parameters.gTaps[0].y)) + (_262 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _274)));
    float _280 = 1.0 / parameters.gRadius;
    float _282 = _279.z;
    vec2 _284 = _279.xy * (1.0 / _282);
    vec4 _291 = textureLod(gInCoarseDepth, _284, 0.0);
    float _292 = _291.x;
    float _296 = _282 - ((_292 > 0.0) ? min(_292, 65504.0) : 65504.0);
    vec2 _303 = vec2(clamp(_296 * _202 + (-1.0), 0.0, 1.0) * clamp((-_296) * _280 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _304 = bvec2((_282 > 0.0) && all(lessThanEqual(floatBitsToUint(_284), uvec2(1065353216u))));
    vec3 _321 = _207 + ((((_241 * parameters.gTaps[1].x) + (_253 * parameters.gTaps[1].y)) + (_262 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _274)));
    float _323 = _321.z;
    vec2 _325 = _321.xy * (1.0 / _323);
    vec4 _332 = textureLod(gInCoarseDepth, _325, 0.0);
    float _333 = _332.x;
    float _337 = _323 - ((_333 > 0.0) ? min(_333, 65504.0) : 65504.0);
    vec2 _344 = vec2(clamp(_337 * _202 + (-1.0), 0.0, 1.0) * clamp((-_337) * _280 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _345 = bvec2((_323 > 0.0) && all(lessThanEqual(floatBitsToUint(_325), uvec2(1065353216u))));
    vec2 _347 = vec2(_304.x ? _303.x : vec2(0.0).x, _304.y ? _303.y : vec2(0.0).y) + vec2(_345.x ? _344.x : vec2(0.0).x, _345.y ? _344.y : vec2(0.0).y);
    gOutOcclusion = vec4((_73 < 65504.0) ? (1.0 - (_347.x / max(_347.y, 1.0))) : 1.0, _73, 0.0, 0.0);
}

