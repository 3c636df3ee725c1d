#version 450

layout(binding = 0, std140) uniform ReprojectionCacheParameters
{
    mat4 gViewToPreviousClip;
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gFrameToCoarse;
    vec2 gMotionToUv;
    vec2 gClipToDepth;
    vec2 gMissThreshold;
    vec2 gSpeedPx;
    vec2 gChange;
    float gConvergenceTime;
    float gMaxWeight;
    float gHistoryValid;
} parameters;

layout(binding = 1) uniform sampler2D gInFresh;
layout(binding = 3) uniform sampler2D gHistoryCache;

layout(location = 0) out vec4 gOutCache;

void main()
{
    vec2 _82 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _86 = textureLod(gInFresh, _82, 0.0);
    float _87 = _86.y;
    float _91 = ((_87 > 0.0) && (_87 < 65504.0)) ? _87 : 65504.0;
    float _92 = _86.x;
    float _97 = (_92 > 0.0) ? min(_92, 31.984375) : 0.0;
    float _98 = floor(_97);
    vec2 _105 = mix(vec2(0.0), min(vec2(_98 * 0.0322580635547637939453125, (_97 - _98) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_92) <= 65504.0));
    vec4 _117 = parameters.gViewToPreviousClip * vec4(fma(_82, parameters.gViewRay.xy, parameters.gViewRay.zw) * _91, _91, 1.0);
    float _120 = _117.w;
    vec2 _125 = fma(_117.xy * (1.0 / _120), vec2(0.5, -0.5), vec2(0.5));
    vec2 _131 = mix(vec2(-8.0), _125, bvec2((_120 > 0.0) && all(lessThanEqual(abs(_125), vec2(8.0)))));
    float _133 = dot(_117.zw, parameters.gClipToDepth);
    vec2 _139 = _131 * parameters.gFrameToCoarse;
    vec2 _141 = fma(_139, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _143 = floor(_141) + vec2(0.5);
    vec2 _144 = _143 * parameters.gOutputSize.zw;
    vec2 _145 = fma(_143, parameters.gOutputSize.zw, parameters.gOutputSize.zw);
    vec2 _146 = fract(_141);
    vec2 _147 = vec2(1.0) - _146;
    vec4 _151 = textureLod(gHistoryCache, _144, 0.0);
    float _152 = _151.x;
    float _157 = (_152 > 0.0) ? min(_152, 31.984375) : 0.0;
    float _158 = floor(_157);
    vec4 _170 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_158 * 0.0322580635547637939453125, (_157 - _158) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_152) <= 65504.0)), _151.zw);
    vec4 _175 = textureLod(gHistoryCache, vec2(_145.x, _144.y), 0.0);
    float _176 = _175.x;
    float _181 = (_176 > 0.0) ? min(_176, 31.984375) : 0.0;
    float _182 = floor(_181);
    vec4 _194 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_182 * 0.0322580635547637939453125, (_181 - _182) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_176) <= 65504.0)), _175.zw);
    vec4 _199 = textureLod(gHistoryCache, vec2(_144.x, _145.y), 0.0);
    float _200 = _199.x;
    float _205 = (_200 > 0.0) ? min(_200, 31.984375) : 0.0;
    float _206 = floor(_205);
    vec4 _218 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_206 * 0.0322580635547637939453125, (_205 - _206) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_200) <= 65504.0)), _199.zw);
    vec4 _220 = textureLod(gHistoryCache, _145, 0.0);
    float _221 = _220.x;
    float _226 = (_221 > 0.0) ? min(_221, 31.984375) : 0.0;
    float _227 = floor(_226);
    vec4 _239 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_227 * 0.0322580635547637939453125, (_226 - _227) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_221) <= 65504.0)), _220.zw);
    float _240 = _147.x;
    float _241 = _146.x;
    bool _249 = all(lessThanEqual(abs(_170), vec4(9.9999996802856924650656260769173e+37)));
    bool _253 = all(lessThanEqual(abs(_194), vec4(9.9999996802856924650656260769173e+37)));
    bool _257 = all(lessThanEqual(abs(_218), vec4(9.9999996802856924650656260769173e+37)));
    bool _261 = all(lessThanEqual(abs(_239), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _264 = (vec4(_240, _241, _240, _241) * vec4(_147.yy, _146.yy)) * vec4(float(_249), float(_253), float(_257), float(_261));
    float _284 = dot(_264, vec4(1.0));
    vec4 _289 = mix(vec4(0.0), ((((mix(vec4(0.0), _170, bvec4(_249)) * _264.x) + (mix(vec4(0.0), _194, bvec4(_253)) * _264.y)) + (mix(vec4(0.0), _218, bvec4(_257)) * _264.z)) + (mix(vec4(0.0), _239, bvec4(_261)) * _264.w)) / vec4(_284), bvec4(_284 > 9.9999999747524270787835121154785e-07));
    float _291 = _289.z;
    float _298 = max(fma(parameters.gMissThreshold.y, _91, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _304 = _298 - abs(((abs(_133) <= 9.9999996802856924650656260769173e+37) ? _133 : 0.0) - _289.w);
    float _307 = (_304 > 0.0) ? (_304 * (parameters.gConvergenceTime / _298)) : 0.0;
    float _323 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(_289.xy), vec2(65504.0)))) ? (((_307 > 0.0) && all(lessThanEqual(abs(fma(_131, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_307, 1.0) : 0.0) : 0.0;
    float _335 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _337 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_139) * parameters.gOutputSize.xy));
    float _341 = ((_337 > 0.0) ? min(_337, _335) : 0.0) / _335;
    float _344 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _351 = (_291 > 0.0) ? min(_291, 255.0) : 0.0;
    float _352 = _351 * _323;
    float _355 = (_352 > 0.0) ? min(_352, 255.0) : 0.0;
    float _359 = min(min(_355 / (_355 + 1.0), _344), ((_344 * _341) * _341) * fma(-2.0, _341, 3.0));
    float _360 = _289.x;
    float _361 = _105.x;
    bool _362 = _359 > 0.0;
    float _364 = _362 ? min(_359, 1.0) : 0.0;
    float _367 = 1.0 - _364;
    float _371 = _289.y;
    float _372 = _105.y;
    vec2 _380 = mix(_105, vec2((abs(_360) <= 9.9999996802856924650656260769173e+37) ? fma(_360, _364, _361 * _367) : _361, (abs(_371) <= 9.9999996802856924650656260769173e+37) ? fma(_371, _364, _372 * _367) : _372), bvec2(_362));
    float _381 = _380.x;
    float _382 = _380.y;
    gOutCache = vec4(fma((_382 > 0.0) ? min(_382, 1.0) : 0.0, 0.984375, floor(fma((_381 > 0.0) ? min(_381, 1.0) : 0.0, 31.0, 0.5))), 0.0, min(fma(_351, (_323 > 0.0) ? min(_323, 1.0) : 0.0, 1.0), 255.0), _91);
}

