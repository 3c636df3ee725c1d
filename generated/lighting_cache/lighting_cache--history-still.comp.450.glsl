#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform LightingCacheParameters
{
    mat4 gViewToPreviousClip;
    vec4 gOutputSize;
    vec4 gViewRay;
    vec4 gToShadowX;
    vec4 gToShadowY;
    vec4 gToShadowZ;
    vec4 gCascadeScale1;
    vec4 gCascadeOffset1;
    vec4 gCascadeScale2;
    vec4 gCascadeOffset2;
    vec4 gCascadeScale3;
    vec4 gCascadeOffset3;
    vec4 gCascadeFar;
    vec4 gCascadeSize;
    vec3 gDisc;
    float gFrameIndex;
    vec3 gShadowBias;
    float gSubsetCount;
    vec2 gOcclusionBias;
    vec2 gFrameToCoarse;
    vec2 gMotionToUv;
    vec2 gClipToDepth;
    vec2 gMissThreshold;
    vec2 gSpeedPx;
    vec2 gChange;
    float gRadius;
    float gConvergenceTime;
    float gMaxWeight;
    float gHistoryValid;
    vec4 gTaps[32];
} parameters;

layout(binding = 16) uniform writeonly image2D gOutCache;
layout(binding = 17) uniform writeonly image2D gOutCacheState;
layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 5) uniform sampler2D gHistoryCacheState;
layout(binding = 3) uniform sampler2D gHistoryCache;

void main()
{
    do
    {
        vec2 _88 = min(vec2(gl_GlobalInvocationID.xy) + vec2(0.5), parameters.gOutputSize.xy - vec2(0.5));
        vec2 _90 = _88 * parameters.gOutputSize.zw;
        vec2 _94 = parameters.gOutputSize.zw * 0.5;
        vec4 _97 = textureGather(gInCoarseDepth, fma(_88, parameters.gOutputSize.zw, -_94));
        vec4 _100 = textureGather(gInCoarseDepth, fma(_88, parameters.gOutputSize.zw, _94));
        float _101 = _97.y;
        float _104 = (_101 > 0.0) ? min(_101, 65504.0) : 65504.0;
        float _105 = _97.x;
        float _108 = (_105 > 0.0) ? min(_105, 65504.0) : 65504.0;
        float _109 = _97.z;
        float _112 = (_109 > 0.0) ? min(_109, 65504.0) : 65504.0;
        float _113 = _100.z;
        float _116 = (_113 > 0.0) ? min(_113, 65504.0) : 65504.0;
        float _117 = _100.x;
        float _120 = (_117 > 0.0) ? min(_117, 65504.0) : 65504.0;
        bvec2 _121 = greaterThan(_90, parameters.gOutputSize.zw);
        bvec2 _123 = lessThan(_90, vec2(1.0) - parameters.gOutputSize.zw);
        float _129 = _116 - _104;
        vec2 _137 = mix(vec2(_129, _116), vec2(_104 - _108, _108), bvec2((_121.x ? abs(_108 - _104) : 131008.0) < (_123.x ? abs(_129) : 65504.0)));
        float _143 = _120 - _104;
        vec2 _151 = mix(vec2(_143, _120), vec2(_104 - _112, _112), bvec2((_121.y ? abs(_112 - _104) : 131008.0) < (_123.y ? abs(_143) : 65504.0)));
        vec2 _163 = vec2(_137.x, _151.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_137.y, _151.y));
        vec3 _171 = normalize(vec3(_163, (-1.0) - dot(fma(_90, parameters.gViewRay.xy, parameters.gViewRay.zw), _163)));
        vec2 _172 = floor(_88);
        vec2 _174 = floor(_172 * 0.5);
        vec2 _176 = _172 - (_174 * 2.0);
        vec2 _180 = _174 - (floor(_174 * 0.5) * 2.0);
        float _181 = _176.x;
        float _182 = _176.y;
        float _184 = abs(_181 - _182);
        float _185 = _180.y;
        float _190 = _180.x;
        vec2 _202 = vec2(fma(2.0, abs(_190 - _185), fma(8.0, _184, 4.0 * _182)) + _185, fma(2.0, abs(abs(_185 - _182) - _190), fma(4.0, _181, fma(-8.0, _184, 8.0))) + _190) * vec2(0.0625);
        float _204 = 6.283185482025146484375 * _202.x;
        float _205 = cos(_204);
        float _206 = sin(_204);
        float _213 = 1.0 / max(fma(parameters.gOcclusionBias.y, _104, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
        vec2 _214 = vec2(1.0) / parameters.gViewRay.xy;
        vec3 _218 = vec3(_90 * _104, _104);
        float _219 = _171.z;
        float _221 = (_219 >= 0.0) ? 1.0 : (-1.0);
        float _223 = (-1.0) / (_221 + _219);
        float _224 = _171.x;
        float _225 = _171.y;
        float _227 = (_224 * _225) * _223;
        vec3 _234 = vec3(fma((_221 * _224) * _224, _223, 1.0), _221 * _227, (-_221) * _224);
        vec3 _238 = vec3(_227, fma(_225 * _225, _223, _221), -_225);
        vec3 _244 = ((_234 * _205) + (_238 * _206)) * parameters.gRadius;
        float _246 = _244.z;
        vec3 _252 = vec3((_244.xy - (parameters.gViewRay.zw * _246)) * _214, _246);
        vec3 _256 = ((_238 * _205) - (_234 * _206)) * parameters.gRadius;
        float _258 = _256.z;
        vec3 _264 = vec3((_256.xy - (parameters.gViewRay.zw * _258)) * _214, _258);
        vec3 _265 = _171 * parameters.gRadius;
        float _267 = _265.z;
        vec3 _273 = vec3((_265.xy - (parameters.gViewRay.zw * _267)) * _214, _267);
        float _285 = _202.y;
        vec3 _290 = _218 + ((((_252 * parameters.gTaps[0].x) + (_264 * parameters.gTaps[0].y)) + (_273 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _285)));
        float _291 = 1.0 / parameters.gRadius;
        float _293 = _290.z;
        vec2 _295 = _290.xy * (1.0 / _293);
        vec4 _303 = textureLod(gInCoarseDepth, _295, 0.0);
        float _304 = _303.x;
        float _308 = _293 - ((_304 > 0.0) ? min(_304, 65504.0) : 65504.0);
        vec3 _333 = _218 + ((((_252 * parameters.gTaps[1].x) + (_264 * parameters.gTaps[1].y)) + (_273 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _285)));
        float _335 = _333.z;
        vec2 _337 = _333.xy * (1.0 / _335);
        vec4 _345 = textureLod(gInCoarseDepth, _337, 0.0);
        float _346 = _345.x;
        float _350 = _335 - ((_346 > 0.0) ? min(_346, 65504.0) : 65504.0);
        vec3 _376 = _218 + ((((_252 * parameters.gTaps[2].x) + (_264 * parameters.gTaps[2].y)) + (_273 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _285)));
        float _378 = _376.z;
        vec2 _380 = _376.xy * (1.0 / _378);
        vec4 _388 = textureLod(gInCoarseDepth, _380, 0.0);
        float _389 = _388.x;
        float _393 = _378 - ((_389 > 0.0) ? min(_389, 65504.0) : 65504.0);
        vec3 _419 = _218 + ((((_252 * parameters.gTaps[3].x) + (_264 * parameters.gTaps[3].y)) + (_273 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _285)));
        float _421 = _419.z;
        vec2 _423 = _419.xy * (1.0 / _421);
        vec4 _431 = textureLod(gInCoarseDepth, _423, 0.0);
        float _432 = _431.x;
        float _436 = _421 - ((_432 > 0.0) ? min(_432, 65504.0) : 65504.0);
        vec2 _446 = ((mix(vec2(0.0), vec2(clamp(fma(_308, _213, -1.0), 0.0, 1.0) * clamp(fma(-_308, _291, 2.0), 0.0, 1.0), 1.0), bvec2((_293 > 0.0) && all(lessThanEqual(abs(_295 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_350, _213, -1.0), 0.0, 1.0) * clamp(fma(-_350, _291, 2.0), 0.0, 1.0), 1.0), bvec2((_335 > 0.0) && all(lessThanEqual(abs(_337 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_393, _213, -1.0), 0.0, 1.0) * clamp(fma(-_393, _291, 2.0), 0.0, 1.0), 1.0), bvec2((_378 > 0.0) && all(lessThanEqual(abs(_380 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_436, _213, -1.0), 0.0, 1.0) * clamp(fma(-_436, _291, 2.0), 0.0, 1.0), 1.0), bvec2((_421 > 0.0) && all(lessThanEqual(abs(_423 - vec2(0.5)), vec2(0.5)))));
        float _453 = (_104 < 65504.0) ? (1.0 - (_446.x / max(_446.y, 1.0))) : 1.0;
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec4 _462 = textureLod(gHistoryCacheState, _90, 0.0);
        vec4 _466 = textureLod(gHistoryCache, _90, 0.0);
        float _467 = _466.x;
        float _469 = _462.x;
        float _472 = (_469 > 0.0) ? min(_469, 255.0) : 0.0;
        float _478 = max(fma(parameters.gMissThreshold.y, _104, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _484 = _478 - abs(_104 - _466.y);
        float _487 = (_484 > 0.0) ? (_484 * (parameters.gConvergenceTime / _478)) : 0.0;
        float _499 = abs(_467);
        float _502 = ((parameters.gHistoryValid > 0.5) && (_499 <= 65504.0)) ? (((_487 > 0.0) && all(lessThanEqual(abs(fma(_88, parameters.gOutputSize.zw, vec2(-0.5))), vec2(0.5)))) ? min(_487, 1.0) : 0.0) : 0.0;
        float _514 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _516 = parameters.gSpeedPx.y - abs(length(fma(_88, parameters.gOutputSize.zw, -_90) * parameters.gOutputSize.xy));
        float _520 = ((_516 > 0.0) ? min(_516, _514) : 0.0) / _514;
        float _523 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _528 = _472 * _502;
        float _531 = (_528 > 0.0) ? min(_528, 255.0) : 0.0;
        float _535 = min(min(_531 / (_531 + 1.0), _523), ((_523 * _520) * _520) * fma(-2.0, _520, 3.0));
        float _538 = (abs(_453) <= 9.9999996802856924650656260769173e+37) ? _453 : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_535 > 0.0) ? ((_499 <= 9.9999996802856924650656260769173e+37) ? fma(_467 - _538, clamp(_535, 0.0, 1.0), _538) : _538) : _453, _104, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_472 > 0.0) ? min(_472, 255.0) : 0.0, (_502 > 0.0) ? min(_502, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

