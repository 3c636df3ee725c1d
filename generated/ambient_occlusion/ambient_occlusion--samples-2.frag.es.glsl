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
    vec2 _63 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _67 = textureLod(gInCoarseDepth, _63, 0.0);
    float _68 = _67.x;
    float _71 = (_68 > 0.0) ? min(_68, 65504.0) : 65504.0;
    vec2 _74 = vec2(parameters.gOutputSize.z, 0.0);
    vec4 _78 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_74), 0.0);
    float _79 = _78.x;
    float _82 = (_79 > 0.0) ? min(_79, 65504.0) : 65504.0;
    vec2 _85 = vec2(0.0, parameters.gOutputSize.w);
    vec4 _89 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + (-_85), 0.0);
    float _90 = _89.x;
    float _93 = (_90 > 0.0) ? min(_90, 65504.0) : 65504.0;
    vec4 _96 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _74, 0.0);
    float _97 = _96.x;
    float _100 = (_97 > 0.0) ? min(_97, 65504.0) : 65504.0;
    vec4 _103 = textureLod(gInCoarseDepth, gl_FragCoord.xy * parameters.gOutputSize.zw + _85, 0.0);
    float _104 = _103.x;
    float _107 = (_104 > 0.0) ? min(_104, 65504.0) : 65504.0;
    bvec2 _108 = greaterThan(_63, parameters.gOutputSize.zw);
    bvec2 _110 = lessThan(_63, vec2(1.0) - parameters.gOutputSize.zw);
    float _116 = _100 - _71;
    vec2 _121 = vec2(_71 - _82, _82);
    vec2 _122 = vec2(_116, _100);
    bvec2 _123 = bvec2((_108.x ? abs(_82 - _71) : 131008.0) < (_110.x ? abs(_116) : 65504.0));
    vec2 _124 = vec2(_123.x ? _121.x : _122.x, _123.y ? _121.y : _122.y);
    float _130 = _107 - _71;
    vec2 _135 = vec2(_71 - _93, _93);
    vec2 _136 = vec2(_130, _107);
    bvec2 _137 = bvec2((_108.y ? abs(_93 - _71) : 131008.0) < (_110.y ? abs(_130) : 65504.0));
    vec2 _138 = vec2(_137.x ? _135.x : _136.x, _137.y ? _135.y : _136.y);
    vec2 _150 = vec2(_124.x, _138.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_124.y, _138.y));
    vec3 _158 = normalize(vec3(_150, (-1.0) - dot(_63 * parameters.gViewRay.xy + parameters.gViewRay.zw, _150)));
    vec2 _159 = floor(gl_FragCoord.xy);
    vec2 _161 = floor(_159 * 0.5);
    vec2 _163 = _159 - (_161 * 2.0);
    vec2 _167 = _161 - (floor(_161 * 0.5) * 2.0);
    float _168 = _163.x;
    float _169 = _163.y;
    float _171 = abs(_168 - _169);
    float _172 = _167.y;
    float _177 = _167.x;
    vec2 _189 = vec2((2.0 * abs(_177 - _172) + (8.0 * _171 + (4.0 * _169))) + _172, (2.0 * abs(abs(_172 - _169) - _177) + (4.0 * _168 + ((-8.0) * _171 + 8.0))) + _177) * vec2(0.0625);
    float _191 = 6.283185482025146484375 * _189.x;
    float _192 = cos(_191);
    float _193 = sin(_191);
    float _200 = 1.0 / max(parameters.gOcclusionBias.y * _71 + parameters.gOcclusionBias.x, 9.9999999747524270787835121154785e-07);
    vec2 _201 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _205 = vec3(_63 * _71, _71);
    float _206 = _158.z;
    float _208 = (_206 >= 0.0) ? 1.0 : (-1.0);
    float _210 = (-1.0) / (_208 + _206);
    float _211 = _158.x;
    float _212 = _158.y;
    float _214 = (_211 * _212) * _210;
    vec3 _221 = vec3(((_208 * _211) * _211) * _210 + 1.0, _208 * _214, (-_208) * _211);
    vec3 _225 = vec3(_214, (_212 * _212) * _210 + _208, -_212);
    vec3 _231 = ((_221 * _192) + (_225 * _193)) * parameters.gRadius;
    float _233 = _231.z;
    vec3 _239 = vec3((_231.xy - (parameters.gViewRay.zw * _233)) * _201, _233);
    vec3 _243 = ((_225 * _192) - (_221 * _193)) * parameters.gRadius;
    float _245 = _243.z;
    vec3 _251 = vec3((_243.xy - (parameters.gViewRay.zw * _245)) * _201, _245);
    vec3 _252 = _158 * parameters.gRadius;
    float _254 = _252.z;
    vec3 _260 = vec3((_252.xy - (parameters.gViewRay.zw * _254)) * _201, _254);
    float _272 = _189.y;
    vec3 _277 = _205 + ((((_239 * parameters.gTaps[0].x) + (_251 * parameters.gTaps[0].y)) + (_260 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _272)));
    float _278 = 1.0 / parameters.gRadius;
    float _280 = _277.z;
    vec2 _282 = _277.xy * (1.0 / _280);
    vec4 _290 = textureLod(gInCoarseDepth, _282, 0.0);
    float _291 = _290.x;
    float _295 = _280 - ((_291 > 0.0) ? min(_291, 65504.0) : 65504.0);
    vec2 _302 = vec2(clamp(_295 * _200 + (-1.0), 0.0, 1.0) * clamp((-_295) * _278 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _303 = bvec2((_280 > 0.0) && all(lessThanEqual(abs(_282 - vec2(0.5)), vec2(0.5))));
    vec3 _320 = _205 + ((((_239 * parameters.gTaps[1].x) + (_251 * parameters.gTaps[1].y)) + (_260 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _272)));
    float _322 = _320.z;
    vec2 _324 = _320.xy * (1.0 / _322);
    vec4 _332 = textureLod(gInCoarseDepth, _324, 0.0);
    float _333 = _332.x;
    float _337 = _322 - ((_333 > 0.0) ? min(_333, 65504.0) : 65504.0);
    vec2 _344 = vec2(clamp(_337 * _200 + (-1.0), 0.0, 1.0) * clamp((-_337) * _278 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _345 = bvec2((_322 > 0.0) && all(lessThanEqual(abs(_324 - vec2(0.5)), vec2(0.5))));
    vec2 _347 = vec2(_303.x ? _302.x : vec2(0.0).x, _303.y ? _302.y : vec2(0.0).y) + vec2(_345.x ? _344.x : vec2(0.0).x, _345.y ? _344.y : vec2(0.0).y);
    gOutOcclusion = vec4((_71 < 65504.0) ? (1.0 - (_347.x / max(_347.y, 1.0))) : 1.0, _71, 0.0, 0.0);
}

