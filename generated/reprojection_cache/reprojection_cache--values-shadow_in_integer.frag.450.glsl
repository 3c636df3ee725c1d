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
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _90 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _94 = textureLod(gInFresh, _90, 0.0);
    float _95 = _94.y;
    float _96 = _94.x;
    float _101 = (_96 > 0.0) ? min(_96, 31.984375) : 0.0;
    float _102 = floor(_101);
    vec2 _110 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_102 * 0.0322580635547637939453125, min((_101 - _102) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_96) <= 65504.0));
    vec2 _113 = mix(vec2(0.0), _110, lessThanEqual(abs(_110), vec2(65504.0)));
    float _117 = ((_95 > 0.0) && (_95 < 65504.0)) ? _95 : 65504.0;
    vec4 _129 = parameters.gViewToPreviousClip * vec4(fma(_90, parameters.gViewRay.xy, parameters.gViewRay.zw) * _117, _117, 1.0);
    float _132 = _129.w;
    vec2 _137 = fma(_129.xy * (1.0 / _132), vec2(0.5, -0.5), vec2(0.5));
    float _145 = dot(_129.zw, parameters.gClipToDepth);
    vec2 _151 = mix(vec2(-8.0), _137, bvec2((_132 > 0.0) && all(lessThanEqual(abs(_137), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _157 = max(fma(parameters.gMissThreshold.y, _117, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec2 _159 = fma(_151, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _160 = floor(_159);
    vec2 _161 = _159 - _160;
    vec2 _162 = vec2(1.0) - _161;
    float _163 = _162.x;
    float _164 = _161.x;
    vec2 _171 = (_160 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _175 = textureGather(gHistoryCache, _171);
    vec4 _187 = vec4(_157) - abs(vec4((abs(_145) <= 9.9999996802856924650656260769173e+37) ? _145 : 0.0) - textureGather(gHistoryCache, _171, 1).wzxy);
    vec4 _190 = mix(vec4(0.0), _187 * (parameters.gConvergenceTime / _157), greaterThan(_187, vec4(0.0)));
    bvec4 _192 = greaterThan(_190, vec4(0.0));
    bvec4 _196 = bvec4(all(lessThanEqual(floatBitsToUint(_151), uvec2(1065353216u))));
    vec4 _201 = mix(vec4(0.0), mix(vec4(0.0), min(_190, vec4(1.0)), bvec4(_192.x && _196.x, _192.y && _196.y, _192.z && _196.z, _192.w && _196.w)), lessThanEqual(abs(_175.wzxy), vec4(65504.0)));
    vec4 _202 = (vec4(_163, _164, _163, _164) * vec4(_162.yy, _161.yy)) * _201;
    vec4 _206 = _202 * (1.0 / max(dot(_202, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    float _208 = _175.w;
    float _212 = _175.z;
    float _216 = _175.x;
    float _220 = _175.y;
    vec4 _224 = vec4((_208 > 0.0) ? min(_208, 31.984375) : 0.0, (_212 > 0.0) ? min(_212, 31.984375) : 0.0, (_216 > 0.0) ? min(_216, 31.984375) : 0.0, (_220 > 0.0) ? min(_220, 31.984375) : 0.0);
    vec4 _225 = floor(_224);
    float _231 = dot(_206, min(_224 - _225, vec4(0.984375))) * 1.01587307453155517578125;
    vec2 _233 = vec2(dot(_206, _225) * 0.0322580635547637939453125, _231).yx;
    vec4 _237 = textureLod(gHistoryCacheStateFiltered, _151, 0.0);
    float _238 = _237.x;
    float _241 = (_238 > 0.0) ? min(_238, 255.0) : 0.0;
    float _248 = ((parameters.gHistoryValid > 0.5) && (abs(_231) <= 65504.0)) ? dot(_206, _201) : 0.0;
    float _260 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _262 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_151) * parameters.gOutputSize.xy));
    float _266 = ((_262 > 0.0) ? min(_262, _260) : 0.0) / _260;
    float _269 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _274 = _241 * _248;
    float _277 = (_274 > 0.0) ? min(_274, 255.0) : 0.0;
    float _281 = min(min(_277 / (_277 + 1.0), _269), ((_269 * _266) * _266) * fma(-2.0, _266, 3.0));
    vec2 _286 = mix(vec2(0.0), _113, bvec2(all(lessThanEqual(abs(_113), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _298 = mix(_113, mix(_286, _286 + ((_233 - _286) * clamp(_281, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_233), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_281 > 0.0));
    float _307 = _298.x;
    float _308 = _298.y;
    gOutCache = vec4(fma((_307 > 0.0) ? min(_307, 1.0) : 0.0, 0.984375, floor(fma((_308 > 0.0) ? min(_308, 1.0) : 0.0, 31.0, 0.5))), _117, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_241 > 0.0) ? min(_241, 255.0) : 0.0, (_248 > 0.0) ? min(_248, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

