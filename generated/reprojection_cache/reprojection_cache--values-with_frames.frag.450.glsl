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
layout(binding = 7) uniform sampler2D gInCoarseDepth;
layout(binding = 3) uniform sampler2D gHistoryCache;
layout(binding = 10) uniform sampler2D gHistoryCoarseDepth;

layout(location = 0) out vec4 gOutCache;

void main()
{
    vec2 _92 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _100 = textureLod(gInCoarseDepth, _92, 0.0);
    float _101 = _100.x;
    vec2 _102 = textureLod(gInFresh, _92, 0.0).xy;
    vec2 _105 = mix(vec2(0.0), _102, lessThanEqual(abs(_102), vec2(65504.0)));
    float _109 = ((_101 > 0.0) && (_101 < 65504.0)) ? _101 : 65504.0;
    vec4 _121 = parameters.gViewToPreviousClip * vec4(fma(_92, parameters.gViewRay.xy, parameters.gViewRay.zw) * _109, _109, 1.0);
    float _124 = _121.w;
    vec2 _129 = fma(_121.xy * (1.0 / _124), vec2(0.5, -0.5), vec2(0.5));
    float _137 = dot(_121.zw, parameters.gClipToDepth);
    vec2 _143 = mix(vec2(-8.0), _129, bvec2((_124 > 0.0) && all(lessThanEqual(abs(_129), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _149 = max(fma(parameters.gMissThreshold.y, _109, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec2 _151 = fma(_143, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _152 = floor(_151);
    vec2 _153 = _151 - _152;
    vec2 _154 = vec2(1.0) - _153;
    float _155 = _154.x;
    float _156 = _153.x;
    vec2 _163 = (_152 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _168 = textureGather(gHistoryCache, _163).wzxy;
    vec4 _181 = vec4(_149) - abs(vec4((abs(_137) <= 9.9999996802856924650656260769173e+37) ? _137 : 0.0) - textureGather(gHistoryCoarseDepth, _163).wzxy);
    vec4 _184 = mix(vec4(0.0), _181 * (parameters.gConvergenceTime / _149), greaterThan(_181, vec4(0.0)));
    bvec4 _186 = greaterThan(_184, vec4(0.0));
    bvec4 _190 = bvec4(all(lessThanEqual(floatBitsToUint(_143), uvec2(1065353216u))));
    bvec4 _193 = greaterThanEqual(_168, vec4(0.0));
    bvec4 _194 = lessThan(_168, vec4(16777216.0));
    vec4 _196 = vec4(bvec4(_193.x && _194.x, _193.y && _194.y, _193.z && _194.z, _193.w && _194.w));
    vec4 _198 = mix(vec4(0.0), _168, greaterThan(_196, vec4(0.5)));
    vec4 _200 = floor(_198 * 9.5367431640625e-07);
    vec4 _202 = _198 - (_200 * 1048576.0);
    vec4 _204 = floor(_202 * 0.0009765625);
    vec4 _210 = mix(vec4(0.0), min(_184, vec4(1.0)), bvec4(_186.x && _190.x, _186.y && _190.y, _186.z && _190.z, _186.w && _190.w)) * _196;
    vec4 _211 = (vec4(_155, _156, _155, _156) * vec4(_154.yy, _153.yy)) * _210;
    vec4 _215 = _211 * (1.0 / max(dot(_211, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _219 = vec2(dot(_215, _204 * 0.000977517105638980865478515625), dot(_215, min((_202 - (_204 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0))));
    float _220 = dot(_215, _200);
    vec2 _224 = abs(_219);
    float _228 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_224, vec2(65504.0)))) ? dot(_215, _210) : 0.0;
    float _240 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _242 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_143) * parameters.gOutputSize.xy));
    float _246 = ((_242 > 0.0) ? min(_242, _240) : 0.0) / _240;
    float _249 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _254 = _220 * _228;
    float _257 = (_254 > 0.0) ? min(_254, 255.0) : 0.0;
    float _261 = min(min(_257 / (_257 + 1.0), _249), ((_249 * _246) * _246) * fma(-2.0, _246, 3.0));
    vec2 _266 = mix(vec2(0.0), _105, bvec2(all(lessThanEqual(abs(_105), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _277 = mix(_105, mix(_266, _266 + ((_219 - _266) * clamp(_261, 0.0, 1.0)), bvec2(all(lessThanEqual(_224, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_261 > 0.0));
    float _285 = min(fma((_220 > 0.0) ? min(_220, 255.0) : 0.0, (_228 > 0.0) ? min(_228, 1.0) : 0.0, 1.0), 255.0);
    float _286 = _277.x;
    float _290 = _277.y;
    vec2 _297 = floor((vec2((_286 > 0.0) ? min(_286, 1.0) : 0.0, (_290 > 0.0) ? min(_290, 1.0) : 0.0) * 1023.0) + vec2(0.5));
    gOutCache = vec4(fma(fma(floor(((_285 > 0.0) ? min(_285, 15.0) : 0.0) + 0.5), 1024.0, _297.x), 1024.0, _297.y), 0.0, 0.0, 0.0);
}

