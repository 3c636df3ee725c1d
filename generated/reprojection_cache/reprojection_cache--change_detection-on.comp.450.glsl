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
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _98 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _100 = _98 * parameters.gOutputSize.zw;
        vec4 _104 = textureLod(gInFresh, _100, 0.0);
        float _105 = _104.y;
        float _106 = _104.x;
        float _109 = (abs(_106) <= 65504.0) ? _106 : 0.0;
        float _113 = ((_105 > 0.0) && (_105 < 65504.0)) ? _105 : 65504.0;
        vec2 _114 = floor(_98);
        float _115 = _114.x;
        vec4 _125 = vec4(lessThan(abs((vec4(_115) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(fma(16.0, floor(_115 * 0.0625), 7.5))), vec4(8.0)));
        float _126 = _114.y;
        vec4 _136 = vec4(lessThan(abs((vec4(_126) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(fma(16.0, floor(_126 * 0.0625), 7.5))), vec4(8.0)));
        vec4 _139 = textureGather(gInFresh, _114 * parameters.gOutputSize.zw);
        vec4 _142 = mix(vec4(0.0), _139, lessThanEqual(abs(_139), vec4(65504.0)));
        vec4 _146 = textureGather(gInFresh, (_114 + vec2(2.0, 0.0)) * parameters.gOutputSize.zw);
        vec4 _149 = mix(vec4(0.0), _146, lessThanEqual(abs(_146), vec4(65504.0)));
        vec4 _153 = textureGather(gInFresh, (_114 + vec2(0.0, 2.0)) * parameters.gOutputSize.zw);
        vec4 _156 = mix(vec4(0.0), _153, lessThanEqual(abs(_153), vec4(65504.0)));
        vec4 _160 = textureGather(gInFresh, (_114 + vec2(2.0)) * parameters.gOutputSize.zw);
        vec4 _163 = mix(vec4(0.0), _160, lessThanEqual(abs(_160), vec4(65504.0)));
        vec4 _168 = vec4(_142.wz, _149.wz);
        vec4 _173 = vec4(_142.xy, _149.xy);
        vec4 _178 = vec4(_156.wz, _163.wz);
        vec4 _183 = vec4(_156.xy, _163.xy);
        float _184 = _136.x;
        float _186 = _136.y;
        float _189 = _136.z;
        float _192 = _136.w;
        float _198 = 1.0 / (dot(_125, vec4(1.0)) * dot(_136, vec4(1.0)));
        float _199 = dot((((_168 * _184) + (_173 * _186)) + (_178 * _189)) + (_183 * _192), _125);
        vec4 _201 = vec4(_199 * _198);
        vec4 _202 = _168 - _201;
        vec4 _205 = _173 - _201;
        vec4 _209 = _178 - _201;
        vec4 _213 = _183 - _201;
        vec4 _231 = parameters.gViewToPreviousClip * vec4(fma(_100, parameters.gViewRay.xy, parameters.gViewRay.zw) * _113, _113, 1.0);
        float _234 = _231.w;
        vec2 _239 = fma(_231.xy * (1.0 / _234), vec2(0.5, -0.5), vec2(0.5));
        vec2 _245 = mix(vec2(-8.0), _239, bvec2((_234 > 0.0) && all(lessThanEqual(abs(_239), vec2(8.0)))));
        float _247 = dot(_231.zw, parameters.gClipToDepth);
        vec2 _253 = _245 * parameters.gFrameToCoarse;
        vec4 _257 = textureLod(gHistoryCacheStateFiltered, _253, 0.0);
        vec4 _261 = textureLod(gHistoryCacheFiltered, _253, 0.0);
        float _262 = _261.x;
        float _264 = _257.x;
        float _267 = (_264 > 0.0) ? min(_264, 255.0) : 0.0;
        float _273 = max(fma(parameters.gMissThreshold.y, _113, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _279 = _273 - abs(((abs(_247) <= 9.9999996802856924650656260769173e+37) ? _247 : 0.0) - _261.y);
        float _282 = (_279 > 0.0) ? (_279 * (parameters.gConvergenceTime / _273)) : 0.0;
        float _294 = abs(_262);
        float _297 = ((parameters.gHistoryValid > 0.5) && (_294 <= 65504.0)) ? (((_282 > 0.0) && all(lessThanEqual(abs(fma(_245, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_282, 1.0) : 0.0) : 0.0;
        float _312 = (_297 > 0.0) ? (_297 * clamp(2.0 - (abs(fma(-_199, _198, _262)) / max(fma(parameters.gChange.x, sqrt(dot(((((_202 * _202) * _184) + ((_205 * _205) * _186)) + ((_209 * _209) * _189)) + ((_213 * _213) * _192), _125) * _198), parameters.gChange.y), 9.9999997473787516355514526367188e-05)), 0.0, 1.0)) : 0.0;
        float _324 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _326 = parameters.gSpeedPx.y - abs(length(fma(_98, parameters.gOutputSize.zw, -_253) * parameters.gOutputSize.xy));
        float _330 = ((_326 > 0.0) ? min(_326, _324) : 0.0) / _324;
        float _333 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _338 = _267 * _312;
        float _341 = (_338 > 0.0) ? min(_338, 255.0) : 0.0;
        float _345 = min(min(_341 / (_341 + 1.0), _333), ((_333 * _330) * _330) * fma(-2.0, _330, 3.0));
        float _348 = (abs(_109) <= 9.9999996802856924650656260769173e+37) ? _109 : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_345 > 0.0) ? ((_294 <= 9.9999996802856924650656260769173e+37) ? fma(_262 - _348, clamp(_345, 0.0, 1.0), _348) : _348) : _109, _113, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_267 > 0.0) ? min(_267, 255.0) : 0.0, (_312 > 0.0) ? min(_312, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

