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
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;

void main()
{
    do
    {
        vec2 _95 = min(vec2(gl_GlobalInvocationID.xy) + vec2(0.5), parameters.gOutputSize.xy - vec2(0.5));
        vec2 _97 = _95 * parameters.gOutputSize.zw;
        vec2 _101 = parameters.gOutputSize.zw * 0.5;
        vec4 _104 = textureGather(gInCoarseDepth, fma(_95, parameters.gOutputSize.zw, -_101));
        vec4 _107 = textureGather(gInCoarseDepth, fma(_95, parameters.gOutputSize.zw, _101));
        float _108 = _104.y;
        float _111 = (_108 > 0.0) ? min(_108, 65504.0) : 65504.0;
        float _112 = _104.x;
        float _115 = (_112 > 0.0) ? min(_112, 65504.0) : 65504.0;
        float _116 = _104.z;
        float _119 = (_116 > 0.0) ? min(_116, 65504.0) : 65504.0;
        float _120 = _107.z;
        float _123 = (_120 > 0.0) ? min(_120, 65504.0) : 65504.0;
        float _124 = _107.x;
        float _127 = (_124 > 0.0) ? min(_124, 65504.0) : 65504.0;
        bvec2 _128 = greaterThan(_97, parameters.gOutputSize.zw);
        bvec2 _130 = lessThan(_97, vec2(1.0) - parameters.gOutputSize.zw);
        float _136 = _123 - _111;
        float _150 = _127 - _111;
        vec3 _170 = normalize(vec3(vec2(mix(vec2(_136, _123), vec2(_111 - _115, _115), bvec2((_128.x ? abs(_115 - _111) : 131008.0) < (_130.x ? abs(_136) : 65504.0))).x, mix(vec2(_150, _127), vec2(_111 - _119, _119), bvec2((_128.y ? abs(_119 - _111) : 131008.0) < (_130.y ? abs(_150) : 65504.0))).x) / (parameters.gViewRay.xy * parameters.gOutputSize.zw), -1.0));
        vec2 _171 = floor(_95);
        vec2 _173 = floor(_171 * 0.5);
        vec2 _175 = _171 - (_173 * 2.0);
        vec2 _179 = _173 - (floor(_173 * 0.5) * 2.0);
        float _180 = _175.x;
        float _181 = _175.y;
        float _183 = abs(_180 - _181);
        float _184 = _179.y;
        float _189 = _179.x;
        vec2 _201 = vec2(fma(2.0, abs(_189 - _184), fma(8.0, _183, 4.0 * _181)) + _184, fma(2.0, abs(abs(_184 - _181) - _189), fma(4.0, _180, fma(-8.0, _183, 8.0))) + _189) * vec2(0.0625);
        float _203 = 6.283185482025146484375 * _201.x;
        float _204 = cos(_203);
        float _205 = sin(_203);
        float _212 = 1.0 / max(fma(parameters.gOcclusionBias.y, _111, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
        vec2 _213 = vec2(1.0) / parameters.gViewRay.xy;
        vec3 _216 = vec3(_97, _111);
        float _217 = _170.z;
        float _219 = (_217 >= 0.0) ? 1.0 : (-1.0);
        float _221 = (-1.0) / (_219 + _217);
        float _222 = _170.x;
        float _223 = _170.y;
        float _225 = (_222 * _223) * _221;
        vec3 _232 = vec3(fma((_219 * _222) * _222, _221, 1.0), _219 * _225, (-_219) * _222);
        vec3 _236 = vec3(_225, fma(_223 * _223, _221, _219), -_223);
        vec3 _242 = ((_232 * _204) + (_236 * _205)) * parameters.gRadius;
        vec3 _248 = vec3(_242.xy * _213, _242.z);
        vec3 _252 = ((_236 * _204) - (_232 * _205)) * parameters.gRadius;
        vec3 _258 = vec3(_252.xy * _213, _252.z);
        vec3 _259 = _170 * parameters.gRadius;
        vec3 _265 = vec3(_259.xy * _213, _259.z);
        float _277 = _201.y;
        vec3 _282 = _216 + ((((_248 * parameters.gTaps[0].x) + (_258 * parameters.gTaps[0].y)) + (_265 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _277)));
        float _283 = 1.0 / parameters.gRadius;
        vec2 _284 = _282.xy;
        float _285 = _282.z;
        vec4 _293 = textureLod(gInCoarseDepth, _284, 0.0);
        float _294 = _293.x;
        float _298 = _285 - ((_294 > 0.0) ? min(_294, 65504.0) : 65504.0);
        vec3 _323 = _216 + ((((_248 * parameters.gTaps[1].x) + (_258 * parameters.gTaps[1].y)) + (_265 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _277)));
        vec2 _324 = _323.xy;
        float _325 = _323.z;
        vec4 _333 = textureLod(gInCoarseDepth, _324, 0.0);
        float _334 = _333.x;
        float _338 = _325 - ((_334 > 0.0) ? min(_334, 65504.0) : 65504.0);
        vec3 _364 = _216 + ((((_248 * parameters.gTaps[2].x) + (_258 * parameters.gTaps[2].y)) + (_265 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _277)));
        vec2 _365 = _364.xy;
        float _366 = _364.z;
        vec4 _374 = textureLod(gInCoarseDepth, _365, 0.0);
        float _375 = _374.x;
        float _379 = _366 - ((_375 > 0.0) ? min(_375, 65504.0) : 65504.0);
        vec3 _405 = _216 + ((((_248 * parameters.gTaps[3].x) + (_258 * parameters.gTaps[3].y)) + (_265 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _277)));
        vec2 _406 = _405.xy;
        float _407 = _405.z;
        vec4 _415 = textureLod(gInCoarseDepth, _406, 0.0);
        float _416 = _415.x;
        float _420 = _407 - ((_416 > 0.0) ? min(_416, 65504.0) : 65504.0);
        vec2 _430 = ((mix(vec2(0.0), vec2(clamp(fma(_298, _212, -1.0), 0.0, 1.0) * clamp(fma(-_298, _283, 2.0), 0.0, 1.0), 1.0), bvec2((_285 > 0.0) && all(lessThanEqual(abs(_284 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_338, _212, -1.0), 0.0, 1.0) * clamp(fma(-_338, _283, 2.0), 0.0, 1.0), 1.0), bvec2((_325 > 0.0) && all(lessThanEqual(abs(_324 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_379, _212, -1.0), 0.0, 1.0) * clamp(fma(-_379, _283, 2.0), 0.0, 1.0), 1.0), bvec2((_366 > 0.0) && all(lessThanEqual(abs(_365 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_420, _212, -1.0), 0.0, 1.0) * clamp(fma(-_420, _283, 2.0), 0.0, 1.0), 1.0), bvec2((_407 > 0.0) && all(lessThanEqual(abs(_406 - vec2(0.5)), vec2(0.5)))));
        float _437 = (_111 < 65504.0) ? (1.0 - (_430.x / max(_430.y, 1.0))) : 1.0;
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec4 _450 = parameters.gViewToPreviousClip * vec4(fma(_97, parameters.gViewRay.xy, parameters.gViewRay.zw), _111, 1.0);
        float _453 = _450.w;
        vec2 _458 = fma(_450.xy * (1.0 / _453), vec2(0.5, -0.5), vec2(0.5));
        vec2 _464 = mix(vec2(-8.0), _458, bvec2((_453 > 0.0) && all(lessThanEqual(abs(_458), vec2(8.0)))));
        float _466 = dot(_450.zw, parameters.gClipToDepth);
        vec2 _472 = _464 * parameters.gFrameToCoarse;
        vec4 _476 = textureLod(gHistoryCacheStateFiltered, _472, 0.0);
        vec4 _480 = textureLod(gHistoryCacheFiltered, _472, 0.0);
        float _481 = _480.x;
        float _483 = _476.x;
        float _486 = (_483 > 0.0) ? min(_483, 255.0) : 0.0;
        float _492 = max(fma(parameters.gMissThreshold.y, _111, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _498 = _492 - abs(((abs(_466) <= 9.9999996802856924650656260769173e+37) ? _466 : 0.0) - _480.y);
        float _501 = (_498 > 0.0) ? (_498 * (parameters.gConvergenceTime / _492)) : 0.0;
        float _513 = abs(_481);
        float _516 = ((parameters.gHistoryValid > 0.5) && (_513 <= 65504.0)) ? (((_501 > 0.0) && all(lessThanEqual(abs(fma(_464, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_501, 1.0) : 0.0) : 0.0;
        float _528 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _530 = parameters.gSpeedPx.y - abs(length(fma(_95, parameters.gOutputSize.zw, -_472) * parameters.gOutputSize.xy));
        float _534 = ((_530 > 0.0) ? min(_530, _528) : 0.0) / _528;
        float _537 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _542 = _486 * _516;
        float _545 = (_542 > 0.0) ? min(_542, 255.0) : 0.0;
        float _549 = min(min(_545 / (_545 + 1.0), _537), ((_537 * _534) * _534) * fma(-2.0, _534, 3.0));
        float _552 = (abs(_437) <= 9.9999996802856924650656260769173e+37) ? _437 : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_549 > 0.0) ? ((_513 <= 9.9999996802856924650656260769173e+37) ? fma(_481 - _552, clamp(_549, 0.0, 1.0), _552) : _552) : _437, _111, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_486 > 0.0) ? min(_486, 255.0) : 0.0, (_516 > 0.0) ? min(_516, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

