#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform AmbientOcclusionParameters
{
    vec4 gOutputSize;
    vec4 gViewRay;
    float gRadius;
    float gFrameIndex;
    float gSubsetCount;
    vec2 gBias;
    vec2 gFrameToCoarse;
} parameters;

uniform highp sampler2D gInCoarseDepth;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _68 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _72 = textureLod(gInCoarseDepth, _68, 0.0);
    float _73 = _72.x;
    float _75 = (_73 > 0.0) ? _73 : 65504.0;
    float _77 = (_75 < 65504.0) ? _75 : 65504.0;
    vec2 _80 = vec2(parameters.gOutputSize.z, 0.0);
    vec2 _82 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-_80);
    vec4 _84 = textureLod(gInCoarseDepth, _82, 0.0);
    float _85 = _84.x;
    float _87 = (_85 > 0.0) ? _85 : 65504.0;
    float _89 = (_87 < 65504.0) ? _87 : 65504.0;
    vec2 _92 = vec2(0.0, parameters.gOutputSize.w);
    vec2 _94 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-_92);
    vec4 _96 = textureLod(gInCoarseDepth, _94, 0.0);
    float _97 = _96.x;
    float _99 = (_97 > 0.0) ? _97 : 65504.0;
    float _101 = (_99 < 65504.0) ? _99 : 65504.0;
    vec2 _102 = gl_FragCoord.xy * parameters.gOutputSize.zw + _80;
    vec4 _104 = textureLod(gInCoarseDepth, _102, 0.0);
    float _105 = _104.x;
    float _107 = (_105 > 0.0) ? _105 : 65504.0;
    float _109 = (_107 < 65504.0) ? _107 : 65504.0;
    vec2 _110 = gl_FragCoord.xy * parameters.gOutputSize.zw + _92;
    vec4 _112 = textureLod(gInCoarseDepth, _110, 0.0);
    float _113 = _112.x;
    float _115 = (_113 > 0.0) ? _113 : 65504.0;
    float _117 = (_115 < 65504.0) ? _115 : 65504.0;
    vec3 _126 = vec3((_68 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _77, _77);
    vec3 _147 = _126 - vec3((_82 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _89, _89);
    vec3 _153 = vec3((_102 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _109, _109) - _126;
    bvec3 _154 = bvec3((all(lessThanEqual(abs(_82 - vec2(0.5)), vec2(0.5))) ? abs(_89 - _77) : 131008.0) < (all(lessThanEqual(abs(_102 - vec2(0.5)), vec2(0.5))) ? abs(_109 - _77) : 65504.0));
    vec3 _176 = _126 - vec3((_94 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _101, _101);
    vec3 _182 = vec3((_110 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _117, _117) - _126;
    bvec3 _183 = bvec3((all(lessThanEqual(abs(_94 - vec2(0.5)), vec2(0.5))) ? abs(_101 - _77) : 131008.0) < (all(lessThanEqual(abs(_110 - vec2(0.5)), vec2(0.5))) ? abs(_117 - _77) : 65504.0));
    vec3 _185 = cross(vec3(_154.x ? _147.x : _153.x, _154.y ? _147.y : _153.y, _154.z ? _147.z : _153.z), vec3(_183.x ? _176.x : _182.x, _183.y ? _176.y : _182.y, _183.z ? _176.z : _182.z));
    vec3 _192 = -_185;
    bvec3 _193 = bvec3((parameters.gViewRay.x * parameters.gViewRay.y) < 0.0);
    vec3 _195 = normalize(vec3(_193.x ? _185.x : _192.x, _193.y ? _185.y : _192.y, _193.z ? _185.z : _192.z));
    vec2 _196 = floor(gl_FragCoord.xy);
    float _201 = floor(parameters.gSubsetCount);
    float _204 = (_201 > 1.0) ? min(_201, 16.0) : 1.0;
    float _208 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
    vec3 _214 = vec3(0.81917250156402587890625, 0.6710436344146728515625, 0.5497004985809326171875) * ((-_204) * floor((_208 + 0.5) / _204) + _208);
    vec2 _217 = floor(_196 * 0.5);
    vec2 _219 = _196 - (_217 * 2.0);
    vec2 _223 = _217 - (floor(_196 * 0.25) * 2.0);
    float _225 = _219.y;
    float _228 = _223.y;
    vec2 _234 = (abs(vec2(_219.x - _225, _223.x - _228)) * 2.0) + vec2(_225, _228);
    float _239 = 6.283185482025146484375 * ((4.0 * _234.x + _234.y) * 0.0625 + _214.x);
    float _240 = cos(_239);
    float _241 = sin(_239);
    vec2 _246 = vec2(_196.y + 1.0, _196.x);
    vec2 _248 = floor(_246 * 0.5);
    vec2 _250 = _246 - (_248 * 2.0);
    vec2 _254 = _248 - (floor(_246 * 0.25) * 2.0);
    float _256 = _250.y;
    float _259 = _254.y;
    vec2 _265 = (abs(vec2(_250.x - _256, _254.x - _259)) * 2.0) + vec2(_256, _259);
    float _276 = _195.z;
    float _278 = (_276 >= 0.0) ? 1.0 : (-1.0);
    float _280 = (-1.0) / (_278 + _276);
    float _281 = _195.x;
    float _282 = _195.y;
    float _284 = (_281 * _282) * _280;
    vec3 _296 = fract(vec3(0.5));
    float _298 = 6.283185482025146484375 * _296.x;
    float _299 = cos(_298);
    float _300 = sin(_298);
    float _310 = fract(_296.y + _214.y);
    vec2 _312 = vec2(_299 * _240 + (-(_300 * _241)), _299 * _241 + (_300 * _240)) * sqrt(_310);
    vec3 _330 = _126 + ((((vec3(((_278 * _281) * _281) * _280 + 1.0, _278 * _284, (-_278) * _281) * _312.x) + (vec3(_284, (_282 * _282) * _280 + _278, -_282) * _312.y)) + (_195 * sqrt(1.0 - _310))) * (parameters.gRadius * sqrt(fract(_296.z + ((4.0 * _265.x + _265.y) * 0.0625 + _214.z)))));
    float _332 = _330.z;
    vec2 _336 = ((_330.xy / vec2(_332)) - parameters.gViewRay.zw) / parameters.gViewRay.xy;
    vec4 _344 = textureLod(gInCoarseDepth, _336, 0.0);
    float _345 = _344.x;
    float _347 = (_345 > 0.0) ? _345 : 65504.0;
    float _350 = _332 - ((_347 < 65504.0) ? _347 : 65504.0);
    vec2 _358 = vec2(clamp((_350 / max(parameters.gBias.y * _77 + parameters.gBias.x, 9.9999999747524270787835121154785e-07)) - 1.0, 0.0, 1.0) * clamp(2.0 - (_350 / parameters.gRadius), 0.0, 1.0), 1.0);
    bvec2 _359 = bvec2((_332 > 0.0) && all(lessThanEqual(abs(_336 - vec2(0.5)), vec2(0.5))));
    vec2 _360 = vec2(_359.x ? _358.x : vec2(0.0).x, _359.y ? _358.y : vec2(0.0).y);
    vec2 _367 = vec2(1.0 - (_360.x / max(_360.y, 1.0)), _77);
    bvec2 _368 = bvec2(_77 < 65504.0);
    gOutOcclusion = vec4(vec2(_368.x ? _367.x : vec2(1.0, 65504.0).x, _368.y ? _367.y : vec2(1.0, 65504.0).y), 0.0, 0.0);
}

