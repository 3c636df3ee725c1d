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

void main()
{
    do
    {
        vec2 _74 = min(vec2(gl_GlobalInvocationID.xy) + vec2(0.5), parameters.gOutputSize.xy - vec2(0.5));
        vec2 _76 = _74 * parameters.gOutputSize.zw;
        vec2 _80 = parameters.gOutputSize.zw * 0.5;
        vec4 _83 = textureGather(gInCoarseDepth, fma(_74, parameters.gOutputSize.zw, -_80));
        vec4 _86 = textureGather(gInCoarseDepth, fma(_74, parameters.gOutputSize.zw, _80));
        float _87 = _83.y;
        float _90 = (_87 > 0.0) ? min(_87, 65504.0) : 65504.0;
        float _91 = _83.x;
        float _94 = (_91 > 0.0) ? min(_91, 65504.0) : 65504.0;
        float _95 = _83.z;
        float _98 = (_95 > 0.0) ? min(_95, 65504.0) : 65504.0;
        float _99 = _86.z;
        float _102 = (_99 > 0.0) ? min(_99, 65504.0) : 65504.0;
        float _103 = _86.x;
        float _106 = (_103 > 0.0) ? min(_103, 65504.0) : 65504.0;
        bvec2 _107 = greaterThan(_76, parameters.gOutputSize.zw);
        bvec2 _109 = lessThan(_76, vec2(1.0) - parameters.gOutputSize.zw);
        float _115 = _102 - _90;
        vec2 _123 = mix(vec2(_115, _102), vec2(_90 - _94, _94), bvec2((_107.x ? abs(_94 - _90) : 131008.0) < (_109.x ? abs(_115) : 65504.0)));
        float _129 = _106 - _90;
        vec2 _137 = mix(vec2(_129, _106), vec2(_90 - _98, _98), bvec2((_107.y ? abs(_98 - _90) : 131008.0) < (_109.y ? abs(_129) : 65504.0)));
        vec2 _149 = vec2(_123.x, _137.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_123.y, _137.y));
        vec3 _157 = normalize(vec3(_149, (-1.0) - dot(fma(_76, parameters.gViewRay.xy, parameters.gViewRay.zw), _149)));
        vec2 _158 = floor(_74);
        vec2 _160 = floor(_158 * 0.5);
        vec2 _162 = _158 - (_160 * 2.0);
        vec2 _166 = _160 - (floor(_160 * 0.5) * 2.0);
        float _167 = _162.x;
        float _168 = _162.y;
        float _170 = abs(_167 - _168);
        float _171 = _166.y;
        float _176 = _166.x;
        vec2 _188 = vec2(fma(2.0, abs(_176 - _171), fma(8.0, _170, 4.0 * _168)) + _171, fma(2.0, abs(abs(_171 - _168) - _176), fma(4.0, _167, fma(-8.0, _170, 8.0))) + _176) * vec2(0.0625);
        float _190 = 6.283185482025146484375 * _188.x;
        float _191 = cos(_190);
        float _192 = sin(_190);
        float _199 = 1.0 / max(fma(parameters.gOcclusionBias.y, _90, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
        vec2 _200 = vec2(1.0) / parameters.gViewRay.xy;
        vec3 _204 = vec3(_76 * _90, _90);
        float _205 = _157.z;
        float _207 = (_205 >= 0.0) ? 1.0 : (-1.0);
        float _209 = (-1.0) / (_207 + _205);
        float _210 = _157.x;
        float _211 = _157.y;
        float _213 = (_210 * _211) * _209;
        vec3 _220 = vec3(fma((_207 * _210) * _210, _209, 1.0), _207 * _213, (-_207) * _210);
        vec3 _224 = vec3(_213, fma(_211 * _211, _209, _207), -_211);
        vec3 _230 = ((_220 * _191) + (_224 * _192)) * parameters.gRadius;
        float _232 = _230.z;
        vec3 _238 = vec3((_230.xy - (parameters.gViewRay.zw * _232)) * _200, _232);
        vec3 _242 = ((_224 * _191) - (_220 * _192)) * parameters.gRadius;
        float _244 = _242.z;
        vec3 _250 = vec3((_242.xy - (parameters.gViewRay.zw * _244)) * _200, _244);
        vec3 _251 = _157 * parameters.gRadius;
        float _253 = _251.z;
        vec3 _259 = vec3((_251.xy - (parameters.gViewRay.zw * _253)) * _200, _253);
        float _271 = _188.y;
        vec3 _276 = _204 + ((((_238 * parameters.gTaps[0].x) + (_250 * parameters.gTaps[0].y)) + (_259 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _271)));
        float _277 = 1.0 / parameters.gRadius;
        float _279 = _276.z;
        vec2 _281 = _276.xy * (1.0 / _279);
        vec4 _289 = textureLod(gInCoarseDepth, _281, 0.0);
        float _290 = _289.x;
        float _294 = _279 - ((_290 > 0.0) ? min(_290, 65504.0) : 65504.0);
        vec3 _319 = _204 + ((((_238 * parameters.gTaps[1].x) + (_250 * parameters.gTaps[1].y)) + (_259 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _271)));
        float _321 = _319.z;
        vec2 _323 = _319.xy * (1.0 / _321);
        vec4 _331 = textureLod(gInCoarseDepth, _323, 0.0);
        float _332 = _331.x;
        float _336 = _321 - ((_332 > 0.0) ? min(_332, 65504.0) : 65504.0);
        vec3 _362 = _204 + ((((_238 * parameters.gTaps[2].x) + (_250 * parameters.gTaps[2].y)) + (_259 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _271)));
        float _364 = _362.z;
        vec2 _366 = _362.xy * (1.0 / _364);
        vec4 _374 = textureLod(gInCoarseDepth, _366, 0.0);
        float _375 = _374.x;
        float _379 = _364 - ((_375 > 0.0) ? min(_375, 65504.0) : 65504.0);
        vec3 _405 = _204 + ((((_238 * parameters.gTaps[3].x) + (_250 * parameters.gTaps[3].y)) + (_259 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _271)));
        float _407 = _405.z;
        vec2 _409 = _405.xy * (1.0 / _407);
        vec4 _417 = textureLod(gInCoarseDepth, _409, 0.0);
        float _418 = _417.x;
        float _422 = _407 - ((_418 > 0.0) ? min(_418, 65504.0) : 65504.0);
        vec2 _432 = ((mix(vec2(0.0), vec2(clamp(fma(_294, _199, -1.0), 0.0, 1.0) * clamp(fma(-_294, _277, 2.0), 0.0, 1.0), 1.0), bvec2((_279 > 0.0) && all(lessThanEqual(abs(_281 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_336, _199, -1.0), 0.0, 1.0) * clamp(fma(-_336, _277, 2.0), 0.0, 1.0), 1.0), bvec2((_321 > 0.0) && all(lessThanEqual(abs(_323 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_379, _199, -1.0), 0.0, 1.0) * clamp(fma(-_379, _277, 2.0), 0.0, 1.0), 1.0), bvec2((_364 > 0.0) && all(lessThanEqual(abs(_366 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_422, _199, -1.0), 0.0, 1.0) * clamp(fma(-_422, _277, 2.0), 0.0, 1.0), 1.0), bvec2((_407 > 0.0) && all(lessThanEqual(abs(_409 - vec2(0.5)), vec2(0.5)))));
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_90 < 65504.0) ? (1.0 - (_432.x / max(_432.y, 1.0))) : 1.0, _90, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(1.0, 0.0, 0.0, 0.0));
        break;
    } while(false);
}

