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
    vec2 _70 = (fract(floor(gl_FragCoord.xy) * 0.5) * 4.0) - vec2(1.0);
    vec4 _77 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, (_70 * 0.5) * parameters.gOutputSize.zw));
    float _78 = _70.x;
    vec4 _82 = mix(_77.yxwz, _77, bvec4(_78 > 0.0));
    float _83 = _70.y;
    vec4 _87 = mix(_82.wzyx, _82, bvec4(_83 > 0.0));
    vec3 _88 = _87.wxx;
    vec3 _91 = _88 - (dFdxFine(_88) * _78);
    float _92 = _87.w;
    float _93 = _87.z;
    float _94 = _91.x;
    vec3 _95 = vec3(_92, _93, _94);
    vec3 _98 = _95 - (dFdyFine(_95) * _83);
    float _99 = _87.x;
    float _100 = _87.y;
    float _101 = _91.y;
    float _102 = _98.x;
    float _103 = _98.y;
    float _104 = _98.z;
    vec2 _109 = mix(vec2(_94, -1.0), vec2(_93, 1.0), bvec2(_93 < _94));
    vec2 _114 = mix(vec2(_92, 0.0), _109, bvec2(_109.x < _92));
    vec2 _119 = mix(vec2(_104, -1.0), vec2(_103, 1.0), bvec2(_103 < _104));
    vec2 _124 = mix(vec2(_102, 0.0), _119, bvec2(_119.x < _102));
    vec2 _129 = mix(vec2(_101, -1.0), vec2(_100, 1.0), bvec2(_100 < _101));
    vec2 _134 = mix(vec2(_99, 0.0), _129, bvec2(_129.x < _99));
    bool _137 = _134.x < _124.x;
    vec2 _139 = mix(_124, _134, bvec2(_137));
    vec2 _162 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, (mix(vec2(_114.y, 0.0), vec2(_139.y, _137 ? 1.0 : (-1.0)), bvec2(_139.x < _114.x)) * _70) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec4 _166 = textureLod(gHistoryColour, _162, 0.0);
    float _167 = _166.x;
    float _170 = _166.y;
    float _173 = _166.z;
    vec2 _178 = _70 * parameters.gOutputSize.zw;
    vec4 _182 = textureLod(gInColour, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _183 = _182.x;
    float _186 = _182.y;
    float _189 = _182.z;
    vec3 _193 = min(vec3((_183 > 0.0) ? _183 : 0.0, (_186 > 0.0) ? _186 : 0.0, (_189 > 0.0) ? _189 : 0.0), vec3(65504.0));
    vec4 _198 = textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_178.x, 0.0)), 0.0);
    float _199 = _198.x;
    float _202 = _198.y;
    float _205 = _198.z;
    vec3 _209 = min(vec3((_199 > 0.0) ? _199 : 0.0, (_202 > 0.0) ? _202 : 0.0, (_205 > 0.0) ? _205 : 0.0), vec3(65504.0));
    vec4 _214 = textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(0.0, _178.y)), 0.0);
    float _215 = _214.x;
    float _218 = _214.y;
    float _221 = _214.z;
    vec3 _225 = min(vec3((_215 > 0.0) ? _215 : 0.0, (_218 > 0.0) ? _218 : 0.0, (_221 > 0.0) ? _221 : 0.0), vec3(65504.0));
    vec4 _228 = textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _178), 0.0);
    float _229 = _228.x;
    float _232 = _228.y;
    float _235 = _228.z;
    vec3 _239 = min(vec3((_229 > 0.0) ? _229 : 0.0, (_232 > 0.0) ? _232 : 0.0, (_235 > 0.0) ? _235 : 0.0), vec3(65504.0));
    vec3 _242 = _193 - (dFdxFine(_193) * _78);
    vec3 _245 = _225 - (dFdxFine(_225) * _78);
    vec3 _248 = _193 - (dFdyFine(_193) * _83);
    vec3 _251 = _209 - (dFdyFine(_209) * _83);
    vec3 _254 = _248 - (dFdxFine(_248) * _78);
    vec3 _258 = min(min(min(_242, _209), _193), min(_248, _225));
    vec3 _262 = max(max(max(_242, _209), _193), max(_248, _225));
    vec3 _272 = (_258 + min(_258, min(min(_254, _251), min(_245, _239)))) * 0.5;
    vec3 _274 = (_262 + max(_262, max(max(_254, _251), max(_245, _239)))) * 0.5;
    vec3 _276 = (_274 + _272) * 0.5;
    vec3 _280 = min(vec3((_167 > 0.0) ? _167 : 0.0, (_170 > 0.0) ? _170 : 0.0, (_173 > 0.0) ? _173 : 0.0), vec3(65504.0)) - _276;
    vec3 _283 = max((_274 - _272) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_280) + vec3(1.0000000031710768509710513471353e-30));
    vec3 _291 = _276 + (_280 * min(min(_283.x, 1.0), min(_283.y, _283.z)));
    float _292 = dot(_193, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
    float _293 = dot(_291, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
    float _304 = max(1.0 - (abs(_292 - _293) / max(max(_292, _293), 0.20000000298023223876953125)), 0.0);
    gOutHistory = vec4(min(_193 + ((_291 - _193) * (all(lessThanEqual(abs(_162 - vec2(0.5)), vec2(0.5))) ? (mix(parameters.gFeedbackMin, parameters.gFeedbackMax, _304 * _304) * parameters.gHistoryValid) : 0.0)), vec3(65504.0)), 1.0);
}

