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
uniform highp sampler2D gInNormal;

layout(location = 0) out vec4 gOutOcclusion;

void main()
{
    vec2 _68 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _72 = textureLod(gInCoarseDepth, _68, 0.0);
    float _73 = _72.x;
    float _76 = (_73 > 0.0) ? min(_73, 65504.0) : 65504.0;
    vec3 _87 = textureLod(gInNormal, (gl_FragCoord.xy * parameters.gOutputSize.zw + (-(parameters.gOutputSize.zw * 0.125))) / parameters.gFrameToCoarse, 0.0).xyz;
    float _88 = dot(_87, _87);
    vec3 _93 = _87 * inversesqrt(_88);
    bvec3 _94 = bvec3((_88 > 9.9999999747524270787835121154785e-07) && (_88 < 1000000.0));
    vec3 _95 = vec3(_94.x ? _93.x : vec3(0.0, 0.0, -1.0).x, _94.y ? _93.y : vec3(0.0, 0.0, -1.0).y, _94.z ? _93.z : vec3(0.0, 0.0, -1.0).z);
    vec2 _96 = floor(gl_FragCoord.xy);
    vec2 _98 = floor(_96 * 0.5);
    vec2 _100 = _96 - (_98 * 2.0);
    vec2 _104 = _98 - (floor(_98 * 0.5) * 2.0);
    float _105 = _100.x;
    float _106 = _100.y;
    float _108 = abs(_105 - _106);
    float _109 = _104.y;
    float _114 = _104.x;
    vec2 _126 = vec2((2.0 * abs(_114 - _109) + (8.0 * _108 + (4.0 * _106))) + _109, (2.0 * abs(abs(_109 - _106) - _114) + (4.0 * _105 + ((-8.0) * _108 + 8.0))) + _114) * vec2(0.0625);
    float _128 = 6.283185482025146484375 * _126.x;
    float _129 = cos(_128);
    float _130 = sin(_128);
    float _137 = 1.0 / max(parameters.gOcclusionBias.y * _76 + parameters.gOcclusionBias.x, 9.9999999747524270787835121154785e-07);
    vec2 _141 = vec2(1.0) / parameters.gViewRay.xy;
    vec3 _145 = vec3(_68 * _76, _76);
    float _146 = _95.z;
    float _148 = (_146 >= 0.0) ? 1.0 : (-1.0);
    float _150 = (-1.0) / (_148 + _146);
    float _151 = _95.x;
    float _152 = _95.y;
    float _154 = (_151 * _152) * _150;
    vec3 _161 = vec3(((_148 * _151) * _151) * _150 + 1.0, _148 * _154, (-_148) * _151);
    vec3 _165 = vec3(_154, (_152 * _152) * _150 + _148, -_152);
    vec3 _171 = ((_161 * _129) + (_165 * _130)) * parameters.gRadius;
    float _174 = _171.z;
    vec3 _180 = vec3((_171.xy - (parameters.gViewRay.zw * _174)) * _141, _174);
    vec3 _184 = ((_165 * _129) - (_161 * _130)) * parameters.gRadius;
    float _186 = _184.z;
    vec3 _192 = vec3((_184.xy - (parameters.gViewRay.zw * _186)) * _141, _186);
    vec3 _193 = _95 * parameters.gRadius;
    float _195 = _193.z;
    vec3 _201 = vec3((_193.xy - (parameters.gViewRay.zw * _195)) * _141, _195);
    float _213 = _126.y;
    vec3 _218 = _145 + ((((_180 * parameters.gTaps[0].x) + (_192 * parameters.gTaps[0].y)) + (_201 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _213)));
    float _219 = 1.0 / parameters.gRadius;
    float _221 = _218.z;
    vec2 _223 = _218.xy * (1.0 / _221);
    vec4 _231 = textureLod(gInCoarseDepth, _223, 0.0);
    float _232 = _231.x;
    float _236 = _221 - ((_232 > 0.0) ? min(_232, 65504.0) : 65504.0);
    vec2 _243 = vec2(clamp(_236 * _137 + (-1.0), 0.0, 1.0) * clamp((-_236) * _219 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _244 = bvec2((_221 > 0.0) && all(lessThanEqual(abs(_223 - vec2(0.5)), vec2(0.5))));
    vec3 _261 = _145 + ((((_180 * parameters.gTaps[1].x) + (_192 * parameters.gTaps[1].y)) + (_201 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _213)));
    float _263 = _261.z;
    vec2 _265 = _261.xy * (1.0 / _263);
    vec4 _273 = textureLod(gInCoarseDepth, _265, 0.0);
    float _274 = _273.x;
    float _278 = _263 - ((_274 > 0.0) ? min(_274, 65504.0) : 65504.0);
    vec2 _285 = vec2(clamp(_278 * _137 + (-1.0), 0.0, 1.0) * clamp((-_278) * _219 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _286 = bvec2((_263 > 0.0) && all(lessThanEqual(abs(_265 - vec2(0.5)), vec2(0.5))));
    vec3 _304 = _145 + ((((_180 * parameters.gTaps[2].x) + (_192 * parameters.gTaps[2].y)) + (_201 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _213)));
    float _306 = _304.z;
    vec2 _308 = _304.xy * (1.0 / _306);
    vec4 _316 = textureLod(gInCoarseDepth, _308, 0.0);
    float _317 = _316.x;
    float _321 = _306 - ((_317 > 0.0) ? min(_317, 65504.0) : 65504.0);
    vec2 _328 = vec2(clamp(_321 * _137 + (-1.0), 0.0, 1.0) * clamp((-_321) * _219 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _329 = bvec2((_306 > 0.0) && all(lessThanEqual(abs(_308 - vec2(0.5)), vec2(0.5))));
    vec3 _347 = _145 + ((((_180 * parameters.gTaps[3].x) + (_192 * parameters.gTaps[3].y)) + (_201 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _213)));
    float _349 = _347.z;
    vec2 _351 = _347.xy * (1.0 / _349);
    vec4 _359 = textureLod(gInCoarseDepth, _351, 0.0);
    float _360 = _359.x;
    float _364 = _349 - ((_360 > 0.0) ? min(_360, 65504.0) : 65504.0);
    vec2 _371 = vec2(clamp(_364 * _137 + (-1.0), 0.0, 1.0) * clamp((-_364) * _219 + 2.0, 0.0, 1.0), 1.0);
    bvec2 _372 = bvec2((_349 > 0.0) && all(lessThanEqual(abs(_351 - vec2(0.5)), vec2(0.5))));
    vec2 _374 = ((vec2(_244.x ? _243.x : vec2(0.0).x, _244.y ? _243.y : vec2(0.0).y) + vec2(_286.x ? _285.x : vec2(0.0).x, _286.y ? _285.y : vec2(0.0).y)) + vec2(_329.x ? _328.x : vec2(0.0).x, _329.y ? _328.y : vec2(0.0).y)) + vec2(_372.x ? _371.x : vec2(0.0).x, _372.y ? _371.y : vec2(0.0).y);
    gOutOcclusion = vec4((_76 < 65504.0) ? (1.0 - (_374.x / max(_374.y, 1.0))) : 1.0, _76, 0.0, 0.0);
}

