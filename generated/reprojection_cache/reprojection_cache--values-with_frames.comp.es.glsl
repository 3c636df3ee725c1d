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
    vec2 _90 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _94 = _90 * parameters.gOutputSize.zw;
    vec4 _102 = textureLod(gInCoarseDepth, _94, 0.0);
    float _103 = _102.x;
    vec2 _104 = textureLod(gInFresh, _94, 0.0).xy;
    vec2 _107 = mix(vec2(0.0), _104, lessThanEqual(abs(_104), vec2(65504.0)));
    float _111 = ((_103 > 0.0) && (_103 < 65504.0)) ? _103 : 65504.0;
    vec4 _123 = parameters.gViewToPreviousClip * vec4((_94 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _111, _111, 1.0);
    float _126 = _123.w;
    vec2 _131 = (_123.xy * (1.0 / _126)) * vec2(0.5, -0.5) + vec2(0.5);
    vec2 _137 = mix(vec2(-8.0), _131, bvec2((_126 > 0.0) && all(lessThanEqual(abs(_131), vec2(8.0)))));
    float _139 = dot(_123.zw, parameters.gClipToDepth);
    vec2 _145 = _137 * parameters.gFrameToCoarse;
    float _151 = max(parameters.gMissThreshold.y * _111 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec2 _153 = _145 * parameters.gOutputSize.xy + vec2(-0.5);
    vec2 _154 = floor(_153);
    vec2 _155 = _153 - _154;
    vec2 _156 = vec2(1.0) - _155;
    float _157 = _156.x;
    float _158 = _155.x;
    vec2 _165 = (_154 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _170 = textureGather(gHistoryCache, _165).wzxy;
    vec4 _183 = vec4(_151) - abs(vec4((abs(_139) <= 9.9999996802856924650656260769173e+37) ? _139 : 0.0) - textureGather(gHistoryCoarseDepth, _165).wzxy);
    vec4 _186 = mix(vec4(0.0), _183 * (parameters.gConvergenceTime / _151), greaterThan(_183, vec4(0.0)));
    bvec4 _188 = greaterThan(_186, vec4(0.0));
    bvec4 _193 = bvec4(all(lessThanEqual(abs(_137 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5))));
    bvec4 _196 = greaterThanEqual(_170, vec4(0.0));
    bvec4 _197 = lessThan(_170, vec4(16777216.0));
    vec4 _199 = vec4(bvec4(_196.x && _197.x, _196.y && _197.y, _196.z && _197.z, _196.w && _197.w));
    vec4 _201 = mix(vec4(0.0), _170, greaterThan(_199, vec4(0.5)));
    vec4 _203 = floor(_201 * 9.5367431640625e-07);
    vec4 _205 = _201 - (_203 * 1048576.0);
    vec4 _207 = floor(_205 * 0.0009765625);
    vec4 _213 = mix(vec4(0.0), min(_186, vec4(1.0)), bvec4(_188.x && _193.x, _188.y && _193.y, _188.z && _193.z, _188.w && _193.w)) * _199;
    vec4 _214 = (vec4(_157, _158, _157, _158) * vec4(_156.yy, _155.yy)) * _213;
    vec4 _218 = _214 * (1.0 / max(dot(_214, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _222 = vec2(dot(_218, _207 * 0.000977517105638980865478515625), dot(_218, min((_205 - (_207 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0))));
    float _223 = dot(_218, _203);
    vec2 _227 = abs(_222);
    float _231 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_227, vec2(65504.0)))) ? dot(_218, _213) : 0.0;
    float _243 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _245 = parameters.gSpeedPx.y - abs(length((_90 * parameters.gOutputSize.zw + (-_145)) * parameters.gOutputSize.xy));
    float _249 = ((_245 > 0.0) ? min(_245, _243) : 0.0) / _243;
    float _252 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _257 = _223 * _231;
    float _260 = (_257 > 0.0) ? min(_257, 255.0) : 0.0;
    float _264 = min(min(_260 / (_260 + 1.0), _252), ((_252 * _249) * _249) * ((-2.0) * _249 + 3.0));
    vec2 _269 = mix(vec2(0.0), _107, bvec2(all(lessThanEqual(abs(_107), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _280 = mix(_107, mix(_269, _269 + ((_222 - _269) * clamp(_264, 0.0, 1.0)), bvec2(all(lessThanEqual(_227, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_264 > 0.0));
    float _288 = min(((_223 > 0.0) ? min(_223, 255.0) : 0.0) * ((_231 > 0.0) ? min(_231, 1.0) : 0.0) + 1.0, 255.0);
    float _289 = _280.x;
    float _293 = _280.y;
    vec2 _300 = floor((vec2((_289 > 0.0) ? min(_289, 1.0) : 0.0, (_293 > 0.0) ? min(_293, 1.0) : 0.0) * 1023.0) + vec2(0.5));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((floor(((_288 > 0.0) ? min(_288, 15.0) : 0.0) + 0.5) * 1024.0 + _300.x) * 1024.0 + _300.y, 0.0, 0.0, 0.0));
}

