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
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _89 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _93 = textureLod(gInFresh, _89, 0.0);
    float _94 = _93.y;
    float _95 = _93.x;
    float _98 = (abs(_95) <= 65504.0) ? _95 : 0.0;
    float _102 = ((_94 > 0.0) && (_94 < 65504.0)) ? _94 : 65504.0;
    vec2 _103 = floor(gl_FragCoord.xy);
    float _104 = _103.x;
    vec4 _114 = vec4(lessThan(abs((vec4(_104) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(fma(16.0, floor(_104 * 0.0625), 7.5))), vec4(8.0)));
    float _115 = _103.y;
    vec4 _125 = vec4(lessThan(abs((vec4(_115) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(fma(16.0, floor(_115 * 0.0625), 7.5))), vec4(8.0)));
    vec4 _128 = textureGather(gInFresh, _103 * parameters.gOutputSize.zw);
    vec4 _131 = mix(vec4(0.0), _128, lessThanEqual(abs(_128), vec4(65504.0)));
    vec4 _135 = textureGather(gInFresh, (_103 + vec2(2.0, 0.0)) * parameters.gOutputSize.zw);
    vec4 _138 = mix(vec4(0.0), _135, lessThanEqual(abs(_135), vec4(65504.0)));
    vec4 _142 = textureGather(gInFresh, (_103 + vec2(0.0, 2.0)) * parameters.gOutputSize.zw);
    vec4 _145 = mix(vec4(0.0), _142, lessThanEqual(abs(_142), vec4(65504.0)));
    vec4 _149 = textureGather(gInFresh, (_103 + vec2(2.0)) * parameters.gOutputSize.zw);
    vec4 _152 = mix(vec4(0.0), _149, lessThanEqual(abs(_149), vec4(65504.0)));
    vec4 _157 = vec4(_131.wz, _138.wz);
    vec4 _162 = vec4(_131.xy, _138.xy);
    vec4 _167 = vec4(_145.wz, _152.wz);
    vec4 _172 = vec4(_145.xy, _152.xy);
    float _173 = _125.x;
    float _175 = _125.y;
    float _178 = _125.z;
    float _181 = _125.w;
    float _187 = 1.0 / (dot(_114, vec4(1.0)) * dot(_125, vec4(1.0)));
    float _188 = dot((((_157 * _173) + (_162 * _175)) + (_167 * _178)) + (_172 * _181), _114);
    vec4 _190 = vec4(_188 * _187);
    vec4 _191 = _157 - _190;
    vec4 _194 = _162 - _190;
    vec4 _198 = _167 - _190;
    vec4 _202 = _172 - _190;
    vec4 _220 = parameters.gViewToPreviousClip * vec4(fma(_89, parameters.gViewRay.xy, parameters.gViewRay.zw) * _102, _102, 1.0);
    float _223 = _220.w;
    vec2 _228 = fma(_220.xy * (1.0 / _223), vec2(0.5, -0.5), vec2(0.5));
    float _236 = dot(_220.zw, parameters.gClipToDepth);
    vec2 _242 = mix(vec2(-8.0), _228, bvec2((_223 > 0.0) && all(lessThanEqual(abs(_228), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _248 = max(fma(parameters.gMissThreshold.y, _102, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _252 = textureLod(gHistoryCacheFiltered, _242, 0.0);
    vec4 _256 = textureLod(gHistoryCacheStateFiltered, _242, 0.0);
    float _257 = _252.x;
    float _258 = _256.x;
    float _261 = (_258 > 0.0) ? min(_258, 255.0) : 0.0;
    float _268 = _248 - abs(((abs(_236) <= 9.9999996802856924650656260769173e+37) ? _236 : 0.0) - _252.y);
    float _271 = (_268 > 0.0) ? (_268 * (parameters.gConvergenceTime / _248)) : 0.0;
    float _282 = abs(_257);
    float _285 = ((parameters.gHistoryValid > 0.5) && (_282 <= 65504.0)) ? (((_271 > 0.0) && all(lessThanEqual(floatBitsToUint(_242), uvec2(1065353216u)))) ? min(_271, 1.0) : 0.0) : 0.0;
    float _300 = (_285 > 0.0) ? (_285 * clamp(2.0 - (abs(fma(-_188, _187, _257)) / max(fma(parameters.gChange.x, sqrt(dot(((((_191 * _191) * _173) + ((_194 * _194) * _175)) + ((_198 * _198) * _178)) + ((_202 * _202) * _181), _114) * _187), parameters.gChange.y), 9.9999997473787516355514526367188e-05)), 0.0, 1.0)) : 0.0;
    float _313 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _315 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_242) * parameters.gOutputSize.xy));
    float _319 = ((_315 > 0.0) ? min(_315, _313) : 0.0) / _313;
    float _322 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _327 = _261 * _300;
    float _330 = (_327 > 0.0) ? min(_327, 255.0) : 0.0;
    float _334 = min(min(_330 / (_330 + 1.0), _322), ((_322 * _319) * _319) * fma(-2.0, _319, 3.0));
    float _337 = (abs(_98) <= 9.9999996802856924650656260769173e+37) ? _98 : 0.0;
    gOutCache = vec4((_334 > 0.0) ? ((_282 <= 9.9999996802856924650656260769173e+37) ? fma(_257 - _337, clamp(_334, 0.0, 1.0), _337) : _337) : _98, _102, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_261 > 0.0) ? min(_261, 255.0) : 0.0, (_300 > 0.0) ? min(_300, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

