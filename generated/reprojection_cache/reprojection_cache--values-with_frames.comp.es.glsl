#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

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

layout(binding = 16, r32f) uniform writeonly highp image2D gOutCache;
layout(binding = 1) uniform highp sampler2D gInFresh;
layout(binding = 7) uniform highp sampler2D gInCoarseDepth;
layout(binding = 3) uniform highp sampler2D gHistoryCache;
layout(binding = 10) uniform highp sampler2D gHistoryCoarseDepth;

void main()
{
    vec2 _92 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _96 = _92 * parameters.gOutputSize.zw;
    vec4 _104 = textureLod(gInCoarseDepth, _96, 0.0);
    float _105 = _104.x;
    vec2 _106 = textureLod(gInFresh, _96, 0.0).xy;
    vec2 _109 = mix(vec2(0.0), _106, lessThanEqual(abs(_106), vec2(65504.0)));
    float _113 = ((_105 > 0.0) && (_105 < 65504.0)) ? _105 : 65504.0;
    vec4 _125 = parameters.gViewToPreviousClip * vec4((_96 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _113, _113, 1.0);
    float _128 = _125.w;
    vec2 _133 = (_125.xy * (1.0 / _128)) * vec2(0.5, -0.5) + vec2(0.5);
    float _141 = dot(_125.zw, parameters.gClipToDepth);
    vec2 _147 = mix(vec2(-8.0), _133, bvec2((_128 > 0.0) && all(lessThanEqual(abs(_133), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _153 = max(parameters.gMissThreshold.y * _113 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec2 _155 = _147 * parameters.gOutputSize.xy + vec2(-0.5);
    vec2 _156 = floor(_155);
    vec2 _157 = _155 - _156;
    vec2 _158 = vec2(1.0) - _157;
    float _159 = _158.x;
    float _160 = _157.x;
    vec2 _167 = (_156 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _172 = textureGather(gHistoryCache, _167).wzxy;
    vec4 _185 = vec4(_153) - abs(vec4((abs(_141) <= 9.9999996802856924650656260769173e+37) ? _141 : 0.0) - textureGather(gHistoryCoarseDepth, _167).wzxy);
    vec4 _188 = mix(vec4(0.0), _185 * (parameters.gConvergenceTime / _153), greaterThan(_185, vec4(0.0)));
    bvec4 _190 = greaterThan(_188, vec4(0.0));
    bvec4 _194 = bvec4(all(lessThanEqual(floatBitsToUint(_147), uvec2(1065353216u))));
    bvec4 _197 = greaterThanEqual(_172, vec4(0.0));
    bvec4 _198 = lessThan(_172, vec4(16777216.0));
    vec4 _200 = vec4(bvec4(_197.x && _198.x, _197.y && _198.y, _197.z && _198.z, _197.w && _198.w));
    vec4 _202 = mix(vec4(0.0), _172, greaterThan(_200, vec4(0.5)));
    vec4 _204 = floor(_202 * 9.5367431640625e-07);
    vec4 _206 = _202 - (_204 * 1048576.0);
    vec4 _208 = floor(_206 * 0.0009765625);
    vec4 _214 = mix(vec4(0.0), min(_188, vec4(1.0)), bvec4(_190.x && _194.x, _190.y && _194.y, _190.z && _194.z, _190.w && _194.w)) * _200;
    vec4 _215 = (vec4(_159, _160, _159, _160) * vec4(_158.yy, _157.yy)) * _214;
    vec4 _219 = _215 * (1.0 / max(dot(_215, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _223 = vec2(dot(_219, _208 * 0.000977517105638980865478515625), dot(_219, min((_206 - (_208 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0))));
    float _224 = dot(_219, _204);
    vec2 _228 = abs(_223);
    float _232 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_228, vec2(65504.0)))) ? dot(_219, _214) : 0.0;
    float _244 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _246 = parameters.gSpeedPx.y - abs(length((_92 * parameters.gOutputSize.zw + (-_147)) * parameters.gOutputSize.xy));
    float _250 = ((_246 > 0.0) ? min(_246, _244) : 0.0) / _244;
    float _253 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _258 = _224 * _232;
    float _261 = (_258 > 0.0) ? min(_258, 255.0) : 0.0;
    float _265 = min(min(_261 / (_261 + 1.0), _253), ((_253 * _250) * _250) * ((-2.0) * _250 + 3.0));
    vec2 _270 = mix(vec2(0.0), _109, bvec2(all(lessThanEqual(abs(_109), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _281 = mix(_109, mix(_270, _270 + ((_223 - _270) * clamp(_265, 0.0, 1.0)), bvec2(all(lessThanEqual(_228, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_265 > 0.0));
    float _289 = min(((_224 > 0.0) ? min(_224, 255.0) : 0.0) * ((_232 > 0.0) ? min(_232, 1.0) : 0.0) + 1.0, 255.0);
    float _290 = _281.x;
    float _294 = _281.y;
    vec2 _301 = floor((vec2((_290 > 0.0) ? min(_290, 1.0) : 0.0, (_294 > 0.0) ? min(_294, 1.0) : 0.0) * 1023.0) + vec2(0.5));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((floor(((_289 > 0.0) ? min(_289, 15.0) : 0.0) + 0.5) * 1024.0 + _301.x) * 1024.0 + _301.y, 0.0, 0.0, 0.0));
}

