#version 450
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

layout(binding = 16) uniform writeonly image2D gOutCache;
layout(binding = 17) uniform writeonly image2D gOutCacheState;
layout(binding = 1) uniform sampler2D gInFresh;
layout(binding = 3) uniform sampler2D gHistoryCache;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

void main()
{
    vec2 _88 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _92 = _88 * parameters.gOutputSize.zw;
    vec4 _96 = textureLod(gInFresh, _92, 0.0);
    float _97 = _96.y;
    float _98 = _96.x;
    float _103 = (_98 > 0.0) ? min(_98, 31.984375) : 0.0;
    float _104 = floor(_103);
    vec2 _112 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_104 * 0.0322580635547637939453125, min((_103 - _104) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_98) <= 65504.0));
    vec2 _115 = mix(vec2(0.0), _112, lessThanEqual(abs(_112), vec2(65504.0)));
    float _119 = ((_97 > 0.0) && (_97 < 65504.0)) ? _97 : 65504.0;
    vec4 _131 = parameters.gViewToPreviousClip * vec4(fma(_92, parameters.gViewRay.xy, parameters.gViewRay.zw) * _119, _119, 1.0);
    float _134 = _131.w;
    vec2 _139 = fma(_131.xy * (1.0 / _134), vec2(0.5, -0.5), vec2(0.5));
    vec2 _145 = mix(vec2(-8.0), _139, bvec2((_134 > 0.0) && all(lessThanEqual(abs(_139), vec2(8.0)))));
    float _147 = dot(_131.zw, parameters.gClipToDepth);
    vec2 _153 = _145 * parameters.gFrameToCoarse;
    float _159 = max(fma(parameters.gMissThreshold.y, _119, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec2 _161 = fma(_153, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _162 = floor(_161);
    vec2 _163 = _161 - _162;
    vec2 _164 = vec2(1.0) - _163;
    float _165 = _164.x;
    float _166 = _163.x;
    vec2 _173 = (_162 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _177 = textureGather(gHistoryCache, _173);
    vec4 _189 = vec4(_159) - abs(vec4((abs(_147) <= 9.9999996802856924650656260769173e+37) ? _147 : 0.0) - textureGather(gHistoryCache, _173, 1).wzxy);
    vec4 _192 = mix(vec4(0.0), _189 * (parameters.gConvergenceTime / _159), greaterThan(_189, vec4(0.0)));
    bvec4 _194 = greaterThan(_192, vec4(0.0));
    bvec4 _199 = bvec4(all(lessThanEqual(abs(fma(_145, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5))));
    vec4 _204 = mix(vec4(0.0), mix(vec4(0.0), min(_192, vec4(1.0)), bvec4(_194.x && _199.x, _194.y && _199.y, _194.z && _199.z, _194.w && _199.w)), lessThanEqual(abs(_177.wzxy), vec4(65504.0)));
    vec4 _205 = (vec4(_165, _166, _165, _166) * vec4(_164.yy, _163.yy)) * _204;
    vec4 _209 = _205 * (1.0 / max(dot(_205, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    float _211 = _177.w;
    float _215 = _177.z;
    float _219 = _177.x;
    float _223 = _177.y;
    vec4 _227 = vec4((_211 > 0.0) ? min(_211, 31.984375) : 0.0, (_215 > 0.0) ? min(_215, 31.984375) : 0.0, (_219 > 0.0) ? min(_219, 31.984375) : 0.0, (_223 > 0.0) ? min(_223, 31.984375) : 0.0);
    vec4 _228 = floor(_227);
    float _234 = dot(_209, min(_227 - _228, vec4(0.984375))) * 1.01587307453155517578125;
    vec2 _236 = vec2(dot(_209, _228) * 0.0322580635547637939453125, _234).yx;
    vec4 _240 = textureLod(gHistoryCacheStateFiltered, _153, 0.0);
    float _241 = _240.x;
    float _244 = (_241 > 0.0) ? min(_241, 255.0) : 0.0;
    float _251 = ((parameters.gHistoryValid > 0.5) && (abs(_234) <= 65504.0)) ? dot(_209, _204) : 0.0;
    float _263 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _265 = parameters.gSpeedPx.y - abs(length(fma(_88, parameters.gOutputSize.zw, -_153) * parameters.gOutputSize.xy));
    float _269 = ((_265 > 0.0) ? min(_265, _263) : 0.0) / _263;
    float _272 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _277 = _244 * _251;
    float _280 = (_277 > 0.0) ? min(_277, 255.0) : 0.0;
    float _284 = min(min(_280 / (_280 + 1.0), _272), ((_272 * _269) * _269) * fma(-2.0, _269, 3.0));
    vec2 _289 = mix(vec2(0.0), _115, bvec2(all(lessThanEqual(abs(_115), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _301 = mix(_115, mix(_289, _289 + ((_236 - _289) * clamp(_284, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_236), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_284 > 0.0));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_301.x > 0.0) ? min(_301.x, 1.0) : 0.0, 0.984375, floor(fma((_301.y > 0.0) ? min(_301.y, 1.0) : 0.0, 31.0, 0.5))), _119, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_244 > 0.0) ? min(_244, 255.0) : 0.0, (_251 > 0.0) ? min(_251, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

