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
    vec2 _161 = _70 * parameters.gOutputSize.zw;
    vec4 _165 = textureLod(gInColour, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _166 = _165.x;
    float _169 = _165.y;
    float _172 = _165.z;
    vec3 _176 = min(vec3((_166 > 0.0) ? _166 : 0.0, (_169 > 0.0) ? _169 : 0.0, (_172 > 0.0) ? _172 : 0.0), vec3(65504.0));
    vec4 _181 = textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_161.x, 0.0)), 0.0);
    float _182 = _181.x;
    float _185 = _181.y;
    float _188 = _181.z;
    vec3 _192 = min(vec3((_182 > 0.0) ? _182 : 0.0, (_185 > 0.0) ? _185 : 0.0, (_188 > 0.0) ? _188 : 0.0), vec3(65504.0));
    vec4 _197 = textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(0.0, _161.y)), 0.0);
    float _198 = _197.x;
    float _201 = _197.y;
    float _204 = _197.z;
    vec3 _208 = min(vec3((_198 > 0.0) ? _198 : 0.0, (_201 > 0.0) ? _201 : 0.0, (_204 > 0.0) ? _204 : 0.0), vec3(65504.0));
    vec4 _211 = textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _161), 0.0);
    float _212 = _211.x;
    float _215 = _211.y;
    float _218 = _211.z;
    vec3 _222 = min(vec3((_212 > 0.0) ? _212 : 0.0, (_215 > 0.0) ? _215 : 0.0, (_218 > 0.0) ? _218 : 0.0), vec3(65504.0));
    vec3 _225 = _176 - (dFdxFine(_176) * _78);
    vec3 _228 = _208 - (dFdxFine(_208) * _78);
    vec3 _231 = _176 - (dFdyFine(_176) * _83);
    vec3 _234 = _192 - (dFdyFine(_192) * _83);
    vec3 _237 = _231 - (dFdxFine(_231) * _78);
    vec3 _241 = min(min(min(_225, _192), _176), min(_231, _208));
    vec3 _245 = max(max(max(_225, _192), _176), max(_231, _208));
    vec3 _255 = (_241 + min(_241, min(min(_237, _234), min(_228, _222)))) * 0.5;
    vec3 _257 = (_245 + max(_245, max(max(_237, _234), max(_228, _222)))) * 0.5;
    vec2 _259 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, (mix(vec2(_114.y, 0.0), vec2(_139.y, _137 ? 1.0 : (-1.0)), bvec2(_139.x < _114.x)) * _70) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec4 _263 = textureLod(gHistoryColour, _259, 0.0);
    float _264 = _263.x;
    float _267 = _263.y;
    float _270 = _263.z;
    vec3 _276 = (_257 + _255) * 0.5;
    vec3 _280 = min(vec3((_264 > 0.0) ? _264 : 0.0, (_267 > 0.0) ? _267 : 0.0, (_270 > 0.0) ? _270 : 0.0), vec3(65504.0)) - _276;
    vec3 _283 = max((_257 - _255) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_280) + vec3(1.0000000031710768509710513471353e-30));
    vec3 _291 = _276 + (_280 * min(min(_283.x, 1.0), min(_283.y, _283.z)));
    float _292 = dot(_176, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
    float _293 = dot(_291, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
    float _303 = 1.0 - (abs(_292 - _293) / max(max(_292, _293), 0.20000000298023223876953125));
    gOutHistory = vec4(min(_176 + ((_291 - _176) * (all(lessThanEqual(abs(_259 - vec2(0.5)), vec2(0.5))) ? (mix(parameters.gFeedbackMin, parameters.gFeedbackMax, _303 * _303) * parameters.gHistoryValid) : 0.0)), vec3(65504.0)), 1.0);
}

