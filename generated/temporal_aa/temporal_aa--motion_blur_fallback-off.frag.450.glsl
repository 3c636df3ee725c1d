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
layout(binding = 1) uniform sampler2D gInColour;
layout(binding = 4) uniform sampler2D gHistoryColour;

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
    vec4 _157 = textureLodOffset(gInColour, _67, 0.0, ivec2(-1));
    float _158 = _157.x;
    float _161 = _157.y;
    float _164 = _157.z;
    vec3 _168 = min(vec3((_158 > 0.0) ? _158 : 0.0, (_161 > 0.0) ? _161 : 0.0, (_164 > 0.0) ? _164 : 0.0), vec3(65504.0));
    vec4 _170 = textureLodOffset(gInColour, _67, 0.0, ivec2(0, -1));
    float _171 = _170.x;
    float _174 = _170.y;
    float _177 = _170.z;
    vec3 _181 = min(vec3((_171 > 0.0) ? _171 : 0.0, (_174 > 0.0) ? _174 : 0.0, (_177 > 0.0) ? _177 : 0.0), vec3(65504.0));
    vec4 _183 = textureLodOffset(gInColour, _67, 0.0, ivec2(1, -1));
    float _184 = _183.x;
    float _187 = _183.y;
    float _190 = _183.z;
    vec3 _194 = min(vec3((_184 > 0.0) ? _184 : 0.0, (_187 > 0.0) ? _187 : 0.0, (_190 > 0.0) ? _190 : 0.0), vec3(65504.0));
    vec4 _196 = textureLodOffset(gInColour, _67, 0.0, ivec2(-1, 0));
    float _197 = _196.x;
    float _200 = _196.y;
    float _203 = _196.z;
    vec3 _207 = min(vec3((_197 > 0.0) ? _197 : 0.0, (_200 > 0.0) ? _200 : 0.0, (_203 > 0.0) ? _203 : 0.0), vec3(65504.0));
    vec4 _209 = textureLod(gInColour, _67, 0.0);
    float _210 = _209.x;
    float _213 = _209.y;
    float _216 = _209.z;
    vec3 _220 = min(vec3((_210 > 0.0) ? _210 : 0.0, (_213 > 0.0) ? _213 : 0.0, (_216 > 0.0) ? _216 : 0.0), vec3(65504.0));
    vec4 _222 = textureLodOffset(gInColour, _67, 0.0, ivec2(1, 0));
    float _223 = _222.x;
    float _226 = _222.y;
    float _229 = _222.z;
    vec3 _233 = min(vec3((_223 > 0.0) ? _223 : 0.0, (_226 > 0.0) ? _226 : 0.0, (_229 > 0.0) ? _229 : 0.0), vec3(65504.0));
    vec4 _235 = textureLodOffset(gInColour, _67, 0.0, ivec2(-1, 1));
    float _236 = _235.x;
    float _239 = _235.y;
    float _242 = _235.z;
    vec3 _246 = min(vec3((_236 > 0.0) ? _236 : 0.0, (_239 > 0.0) ? _239 : 0.0, (_242 > 0.0) ? _242 : 0.0), vec3(65504.0));
    vec4 _248 = textureLodOffset(gInColour, _67, 0.0, ivec2(0, 1));
    float _249 = _248.x;
    float _252 = _248.y;
    float _255 = _248.z;
    vec3 _259 = min(vec3((_249 > 0.0) ? _249 : 0.0, (_252 > 0.0) ? _252 : 0.0, (_255 > 0.0) ? _255 : 0.0), vec3(65504.0));
    vec4 _261 = textureLodOffset(gInColour, _67, 0.0, ivec2(1));
    float _262 = _261.x;
    float _265 = _261.y;
    float _268 = _261.z;
    vec3 _272 = min(vec3((_262 > 0.0) ? _262 : 0.0, (_265 > 0.0) ? _265 : 0.0, (_268 > 0.0) ? _268 : 0.0), vec3(65504.0));
    float _277 = max(-parameters.gJitterPx.x, 0.0);
    float _279 = 1.0 - abs(parameters.gJitterPx.x);
    float _280 = max(parameters.gJitterPx.x, 0.0);
    vec3 _306 = (((((_168 * _277) + (_181 * _279)) + (_194 * _280)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_207 * _277) + (_220 * _279)) + (_233 * _280)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_246 * _277) + (_259 * _279)) + (_272 * _280)) * max(parameters.gJitterPx.y, 0.0));
    vec3 _310 = min(min(min(_207, _233), _220), min(_181, _259));
    vec3 _314 = max(max(max(_207, _233), _220), max(_181, _259));
    vec3 _324 = (_310 + min(_310, min(min(_168, _194), min(_246, _272)))) * 0.5;
    vec3 _326 = (_314 + max(_314, max(max(_168, _194), max(_246, _272)))) * 0.5;
    vec2 _328 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_108.y, 0.0), vec2(_133.y, _131 ? 1.0 : (-1.0)), bvec2(_133.x < _108.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec4 _332 = textureLod(gHistoryColour, _328, 0.0);
    float _333 = _332.x;
    float _336 = _332.y;
    float _339 = _332.z;
    vec3 _345 = (_326 + _324) * 0.5;
    vec3 _349 = min(vec3((_333 > 0.0) ? _333 : 0.0, (_336 > 0.0) ? _336 : 0.0, (_339 > 0.0) ? _339 : 0.0), vec3(65504.0)) - _345;
    vec3 _352 = max((_326 - _324) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_349) + vec3(1.0000000031710768509710513471353e-30));
    gOutHistory = vec4(min(_306 + (((_345 + (_349 * min(min(_352.x, 1.0), min(_352.y, _352.z)))) - _306) * (all(lessThanEqual(abs(_328 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0)), vec3(65504.0)), 1.0);
}

