#version 450

layout(binding = 0, std140) uniform TemporalAaParameters
{
    vec4 gOutputSize;
    vec2 gJitterPx;
    vec2 gMotionToUv;
    float gHistoryValid;
    float gFeedbackMin;
    float gFeedbackMax;
    float gBlurFromPx;
    float gBlurToPx;
} parameters;

layout(binding = 2) uniform sampler2D gInDepth;
layout(binding = 3) uniform sampler2D gInVelocity;
layout(binding = 4) uniform sampler2D gHistoryColour;
layout(binding = 1) uniform sampler2D gInColour;

layout(location = 0) out vec4 gOutHistory;

void main()
{
    vec2 _67 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _70 = parameters.gOutputSize.zw * 0.5;
    vec4 _74 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_70));
    float _76 = _70.x;
    float _77 = _70.y;
    vec4 _81 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_76, -_77)));
    vec4 _86 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_76, _77)));
    vec4 _89 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _70));
    float _90 = _74.w;
    float _91 = _74.z;
    float _92 = _74.x;
    float _93 = _74.y;
    float _94 = _81.z;
    float _95 = _81.y;
    float _96 = _86.x;
    float _97 = _86.y;
    float _98 = _89.y;
    vec2 _103 = mix(vec2(_92, -1.0), vec2(_95, 1.0), bvec2(_95 < _92));
    vec2 _108 = mix(vec2(_93, 0.0), _103, bvec2(_103.x < _93));
    vec2 _113 = mix(vec2(_90, -1.0), vec2(_94, 1.0), bvec2(_94 < _90));
    vec2 _118 = mix(vec2(_91, 0.0), _113, bvec2(_113.x < _91));
    vec2 _123 = mix(vec2(_96, -1.0), vec2(_98, 1.0), bvec2(_98 < _96));
    vec2 _128 = mix(vec2(_97, 0.0), _123, bvec2(_123.x < _97));
    bool _131 = _128.x < _118.x;
    vec2 _133 = mix(_118, _128, bvec2(_131));
    vec2 _155 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_108.y, 0.0), vec2(_133.y, _131 ? 1.0 : (-1.0)), bvec2(_133.x < _108.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec4 _159 = textureLod(gHistoryColour, _155, 0.0);
    float _160 = _159.x;
    float _163 = _159.y;
    float _166 = _159.z;
    vec4 _174 = textureLodOffset(gInColour, _67, 0.0, ivec2(-1));
    float _175 = _174.x;
    float _178 = _174.y;
    float _181 = _174.z;
    vec3 _185 = min(vec3((_175 > 0.0) ? _175 : 0.0, (_178 > 0.0) ? _178 : 0.0, (_181 > 0.0) ? _181 : 0.0), vec3(65504.0));
    vec4 _187 = textureLodOffset(gInColour, _67, 0.0, ivec2(0, -1));
    float _188 = _187.x;
    float _191 = _187.y;
    float _194 = _187.z;
    vec3 _198 = min(vec3((_188 > 0.0) ? _188 : 0.0, (_191 > 0.0) ? _191 : 0.0, (_194 > 0.0) ? _194 : 0.0), vec3(65504.0));
    vec4 _200 = textureLodOffset(gInColour, _67, 0.0, ivec2(1, -1));
    float _201 = _200.x;
    float _204 = _200.y;
    float _207 = _200.z;
    vec3 _211 = min(vec3((_201 > 0.0) ? _201 : 0.0, (_204 > 0.0) ? _204 : 0.0, (_207 > 0.0) ? _207 : 0.0), vec3(65504.0));
    vec4 _213 = textureLodOffset(gInColour, _67, 0.0, ivec2(-1, 0));
    float _214 = _213.x;
    float _217 = _213.y;
    float _220 = _213.z;
    vec3 _224 = min(vec3((_214 > 0.0) ? _214 : 0.0, (_217 > 0.0) ? _217 : 0.0, (_220 > 0.0) ? _220 : 0.0), vec3(65504.0));
    vec4 _226 = textureLod(gInColour, _67, 0.0);
    float _227 = _226.x;
    float _230 = _226.y;
    float _233 = _226.z;
    vec3 _237 = min(vec3((_227 > 0.0) ? _227 : 0.0, (_230 > 0.0) ? _230 : 0.0, (_233 > 0.0) ? _233 : 0.0), vec3(65504.0));
    vec4 _239 = textureLodOffset(gInColour, _67, 0.0, ivec2(1, 0));
    float _240 = _239.x;
    float _243 = _239.y;
    float _246 = _239.z;
    vec3 _250 = min(vec3((_240 > 0.0) ? _240 : 0.0, (_243 > 0.0) ? _243 : 0.0, (_246 > 0.0) ? _246 : 0.0), vec3(65504.0));
    vec4 _252 = textureLodOffset(gInColour, _67, 0.0, ivec2(-1, 1));
    float _253 = _252.x;
    float _256 = _252.y;
    float _259 = _252.z;
    vec3 _263 = min(vec3((_253 > 0.0) ? _253 : 0.0, (_256 > 0.0) ? _256 : 0.0, (_259 > 0.0) ? _259 : 0.0), vec3(65504.0));
    vec4 _265 = textureLodOffset(gInColour, _67, 0.0, ivec2(0, 1));
    float _266 = _265.x;
    float _269 = _265.y;
    float _272 = _265.z;
    vec3 _276 = min(vec3((_266 > 0.0) ? _266 : 0.0, (_269 > 0.0) ? _269 : 0.0, (_272 > 0.0) ? _272 : 0.0), vec3(65504.0));
    vec4 _278 = textureLodOffset(gInColour, _67, 0.0, ivec2(1));
    float _279 = _278.x;
    float _282 = _278.y;
    float _285 = _278.z;
    vec3 _289 = min(vec3((_279 > 0.0) ? _279 : 0.0, (_282 > 0.0) ? _282 : 0.0, (_285 > 0.0) ? _285 : 0.0), vec3(65504.0));
    float _294 = max(-parameters.gJitterPx.x, 0.0);
    float _296 = 1.0 - abs(parameters.gJitterPx.x);
    float _297 = max(parameters.gJitterPx.x, 0.0);
    vec3 _323 = (((((_185 * _294) + (_198 * _296)) + (_211 * _297)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_224 * _294) + (_237 * _296)) + (_250 * _297)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_263 * _294) + (_276 * _296)) + (_289 * _297)) * max(parameters.gJitterPx.y, 0.0));
    vec3 _327 = min(min(min(_224, _250), _237), min(_198, _276));
    vec3 _331 = max(max(max(_224, _250), _237), max(_198, _276));
    vec3 _341 = (_327 + min(_327, min(min(_185, _211), min(_263, _289)))) * 0.5;
    vec3 _343 = (_331 + max(_331, max(max(_185, _211), max(_263, _289)))) * 0.5;
    vec3 _345 = (_343 + _341) * 0.5;
    vec3 _349 = min(vec3((_160 > 0.0) ? _160 : 0.0, (_163 > 0.0) ? _163 : 0.0, (_166 > 0.0) ? _166 : 0.0), vec3(65504.0)) - _345;
    vec3 _352 = max((_343 - _341) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_349) + vec3(1.0000000031710768509710513471353e-30));
    gOutHistory = vec4(min(_323 + (((_345 + (_349 * min(min(_352.x, 1.0), min(_352.y, _352.z)))) - _323) * (all(lessThanEqual(abs(_155 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0)), vec3(65504.0)), 1.0);
}

