#version 450

float _77;

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
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;

layout(location = 0) out vec4 gOutCache;

void main()
{
    vec2 _84 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _88 = textureLod(gInFresh, _84, 0.0);
    float _89 = _88.y;
    float _93 = ((_89 > 0.0) && (_89 < 65504.0)) ? _89 : 65504.0;
    float _94 = _88.x;
    vec2 _99 = mix(vec2(0.0), vec2(_94, 0.0), bvec2(abs(_94) <= 65504.0));
    vec4 _111 = parameters.gViewToPreviousClip * vec4(fma(_84, parameters.gViewRay.xy, parameters.gViewRay.zw) * _93, _93, 1.0);
    float _114 = _111.w;
    vec2 _119 = fma(_111.xy * (1.0 / _114), vec2(0.5, -0.5), vec2(0.5));
    vec2 _125 = mix(vec2(-8.0), _119, bvec2((_114 > 0.0) && all(lessThanEqual(abs(_119), vec2(8.0)))));
    float _127 = dot(_111.zw, parameters.gClipToDepth);
    vec2 _133 = _125 * parameters.gFrameToCoarse;
    vec4 _137 = textureLod(gHistoryCacheFiltered, _133, 0.0);
    float _138 = _137.x;
    vec2 _143 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_138, 0.0), bvec2(abs(_138) <= 65504.0));
    float _144 = _143.x;
    float _146 = _137.z;
    float _155 = max(fma(parameters.gMissThreshold.y, _93, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _161 = _155 - abs(((abs(_127) <= 9.9999996802856924650656260769173e+37) ? _127 : 0.0) - _137.w);
    float _164 = (_161 > 0.0) ? (_161 * (parameters.gConvergenceTime / _155)) : 0.0;
    float _180 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_144, _143.y, _146, _137.w).xy), vec2(65504.0)))) ? (((_164 > 0.0) && all(lessThanEqual(abs(fma(_125, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_164, 1.0) : 0.0) : 0.0;
    vec4 _186 = textureGather(gInFresh, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(parameters.gOutputSize.zw * 0.5)));
    vec4 _189 = mix(vec4(0.0), _186, lessThanEqual(abs(_186), vec4(65504.0)));
    vec4 _193 = textureGather(gInFresh, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(1.5, -0.5) * parameters.gOutputSize.zw));
    vec4 _196 = mix(vec4(0.0), _193, lessThanEqual(abs(_193), vec4(65504.0)));
    vec4 _200 = textureGather(gInFresh, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-0.5, 1.5) * parameters.gOutputSize.zw));
    vec4 _203 = mix(vec4(0.0), _200, lessThanEqual(abs(_200), vec4(65504.0)));
    vec4 _207 = textureGather(gInFresh, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gOutputSize.zw * 1.5));
    vec4 _210 = mix(vec4(0.0), _207, lessThanEqual(abs(_207), vec4(65504.0)));
    float _214 = dot(((_189 + _196) + _203) + _210, vec4(0.0625));
    vec4 _215 = vec4(_214);
    vec4 _216 = _189 - _215;
    vec4 _217 = _196 - _215;
    vec4 _218 = _203 - _215;
    vec4 _219 = _210 - _215;
    float _238 = (_180 > 0.0) ? (_180 * clamp(2.0 - (abs(_144 - _214) / max(fma(parameters.gChange.x, sqrt(dot(fma(_219, _219, fma(_218, _218, fma(_216, _216, _217 * _217))), vec4(0.0625))), parameters.gChange.y), 9.9999997473787516355514526367188e-05)), 0.0, 1.0)) : 0.0;
    float _251 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _253 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_133) * parameters.gOutputSize.xy));
    float _257 = ((_253 > 0.0) ? min(_253, _251) : 0.0) / _251;
    float _260 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _267 = (_146 > 0.0) ? min(_146, 255.0) : 0.0;
    float _268 = _267 * _238;
    float _271 = (_268 > 0.0) ? min(_268, 255.0) : 0.0;
    float _275 = min(min(_271 / (_271 + 1.0), _260), ((_260 * _257) * _257) * fma(-2.0, _257, 3.0));
    float _276 = _99.x;
    bool _277 = _275 > 0.0;
    float _279 = _277 ? min(_275, 1.0) : 0.0;
    gOutCache = vec4(mix(_99, vec2((abs(_144) <= 9.9999996802856924650656260769173e+37) ? fma(_144, _279, _276 * (1.0 - _279)) : _276, _77), bvec2(_277)).x, 0.0, min(fma(_267, (_238 > 0.0) ? min(_238, 1.0) : 0.0, 1.0), 255.0), _93);
}

