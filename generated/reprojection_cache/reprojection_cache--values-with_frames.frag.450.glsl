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
    vec2 _89 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _97 = textureLod(gInCoarseDepth, _89, 0.0);
    float _98 = _97.x;
    vec2 _99 = textureLod(gInFresh, _89, 0.0).xy;
    vec2 _102 = mix(vec2(0.0), _99, lessThanEqual(abs(_99), vec2(65504.0)));
    float _106 = ((_98 > 0.0) && (_98 < 65504.0)) ? _98 : 65504.0;
    vec4 _118 = parameters.gViewToPreviousClip * vec4(fma(_89, parameters.gViewRay.xy, parameters.gViewRay.zw) * _106, _106, 1.0);
    float _121 = _118.w;
    vec2 _126 = fma(_118.xy * (1.0 / _121), vec2(0.5, -0.5), vec2(0.5));
    vec2 _132 = mix(vec2(-8.0), _126, bvec2((_121 > 0.0) && all(lessThanEqual(abs(_126), vec2(8.0)))));
    float _134 = dot(_118.zw, parameters.gClipToDepth);
    vec2 _140 = _132 * parameters.gFrameToCoarse;
    float _146 = max(fma(parameters.gMissThreshold.y, _106, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec2 _148 = fma(_140, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _149 = floor(_148);
    vec2 _150 = _148 - _149;
    vec2 _151 = vec2(1.0) - _150;
    float _152 = _151.x;
    float _153 = _150.x;
    vec2 _160 = (_149 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _165 = textureGather(gHistoryCache, _160).wzxy;
    vec4 _178 = vec4(_146) - abs(vec4((abs(_134) <= 9.9999996802856924650656260769173e+37) ? _134 : 0.0) - textureGather(gHistoryCoarseDepth, _160).wzxy);
    vec4 _181 = mix(vec4(0.0), _178 * (parameters.gConvergenceTime / _146), greaterThan(_178, vec4(0.0)));
    bvec4 _183 = greaterThan(_181, vec4(0.0));
    bvec4 _188 = bvec4(all(lessThanEqual(abs(fma(_132, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5))));
    bvec4 _191 = greaterThanEqual(_165, vec4(0.0));
    bvec4 _192 = lessThan(_165, vec4(16777216.0));
    vec4 _194 = vec4(bvec4(_191.x && _192.x, _191.y && _192.y, _191.z && _192.z, _191.w && _192.w));
    vec4 _196 = mix(vec4(0.0), _165, greaterThan(_194, vec4(0.5)));
    vec4 _198 = floor(_196 * 9.5367431640625e-07);
    vec4 _200 = _196 - (_198 * 1048576.0);
    vec4 _202 = floor(_200 * 0.0009765625);
    vec4 _208 = mix(vec4(0.0), min(_181, vec4(1.0)), bvec4(_183.x && _188.x, _183.y && _188.y, _183.z && _188.z, _183.w && _188.w)) * _194;
    vec4 _209 = (vec4(_152, _153, _152, _153) * vec4(_151.yy, _150.yy)) * _208;
    vec4 _213 = _209 * (1.0 / max(dot(_209, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _217 = vec2(dot(_213, _202 * 0.000977517105638980865478515625), dot(_213, min((_200 - (_202 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0))));
    float _218 = dot(_213, _198);
    vec2 _222 = abs(_217);
    float _226 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_222, vec2(65504.0)))) ? dot(_213, _208) : 0.0;
    float _238 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _240 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_140) * parameters.gOutputSize.xy));
    float _244 = ((_240 > 0.0) ? min(_240, _238) : 0.0) / _238;
    float _247 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _252 = _218 * _226;
    float _255 = (_252 > 0.0) ? min(_252, 255.0) : 0.0;
    float _259 = min(min(_255 / (_255 + 1.0), _247), ((_247 * _244) * _244) * fma(-2.0, _244, 3.0));
    vec2 _264 = mix(vec2(0.0), _102, bvec2(all(lessThanEqual(abs(_102), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _275 = mix(_102, mix(_264, _264 + ((_217 - _264) * clamp(_259, 0.0, 1.0)), bvec2(all(lessThanEqual(_222, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_259 > 0.0));
    float _283 = min(fma((_218 > 0.0) ? min(_218, 255.0) : 0.0, (_226 > 0.0) ? min(_226, 1.0) : 0.0, 1.0), 255.0);
    float _284 = _275.x;
    float _288 = _275.y;
    vec2 _295 = floor((vec2((_284 > 0.0) ? min(_284, 1.0) : 0.0, (_288 > 0.0) ? min(_288, 1.0) : 0.0) * 1023.0) + vec2(0.5));
    gOutCache = vec4(fma(fma(floor(((_283 > 0.0) ? min(_283, 15.0) : 0.0) + 0.5), 1024.0, _295.x), 1024.0, _295.y), 0.0, 0.0, 0.0);
}

