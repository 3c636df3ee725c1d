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
layout(binding = 7) uniform sampler2D gInNormal;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;

void main()
{
    do
    {
        vec2 _100 = min(vec2(gl_GlobalInvocationID.xy) + vec2(0.5), parameters.gOutputSize.xy - vec2(0.5));
        vec2 _102 = _100 * parameters.gOutputSize.zw;
        vec4 _106 = textureLod(gInCoarseDepth, _102, 0.0);
        float _107 = _106.x;
        float _110 = (_107 > 0.0) ? min(_107, 65504.0) : 65504.0;
        vec3 _121 = textureLod(gInNormal, fma(_100, parameters.gOutputSize.zw, -(parameters.gOutputSize.zw * 0.125)) / parameters.gFrameToCoarse, 0.0).xyz;
        float _122 = dot(_121, _121);
        vec3 _129 = mix(vec3(0.0, 0.0, -1.0), _121 * inversesqrt(_122), bvec3((_122 > 9.9999999747524270787835121154785e-07) && (_122 < 1000000.0)));
        vec2 _130 = floor(_100);
        vec2 _132 = floor(_130 * 0.5);
        vec2 _134 = _130 - (_132 * 2.0);
        vec2 _138 = _132 - (floor(_132 * 0.5) * 2.0);
        float _139 = _134.x;
        float _140 = _134.y;
        float _142 = abs(_139 - _140);
        float _143 = _138.y;
        float _148 = _138.x;
        vec2 _160 = vec2(fma(2.0, abs(_148 - _143), fma(8.0, _142, 4.0 * _140)) + _143, fma(2.0, abs(abs(_143 - _140) - _148), fma(4.0, _139, fma(-8.0, _142, 8.0))) + _148) * vec2(0.0625);
        float _162 = 6.283185482025146484375 * _160.x;
        float _163 = cos(_162);
        float _164 = sin(_162);
        float _171 = 1.0 / max(fma(parameters.gOcclusionBias.y, _110, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
        vec2 _175 = vec2(1.0) / parameters.gViewRay.xy;
        vec3 _179 = vec3(_102 * _110, _110);
        float _180 = _129.z;
        float _182 = (_180 >= 0.0) ? 1.0 : (-1.0);
        float _184 = (-1.0) / (_182 + _180);
        float _185 = _129.x;
        float _186 = _129.y;
        float _188 = (_185 * _186) * _184;
        vec3 _195 = vec3(fma((_182 * _185) * _185, _184, 1.0), _182 * _188, (-_182) * _185);
        vec3 _199 = vec3(_188, fma(_186 * _186, _184, _182), -_186);
        vec3 _205 = ((_195 * _163) + (_199 * _164)) * parameters.gRadius;
        float _208 = _205.z;
        vec3 _214 = vec3((_205.xy - (parameters.gViewRay.zw * _208)) * _175, _208);
        vec3 _218 = ((_199 * _163) - (_195 * _164)) * parameters.gRadius;
        float _220 = _218.z;
        vec3 _226 = vec3((_218.xy - (parameters.gViewRay.zw * _220)) * _175, _220);
        vec3 _227 = _129 * parameters.gRadius;
        float _229 = _227.z;
        vec3 _235 = vec3((_227.xy - (parameters.gViewRay.zw * _229)) * _175, _229);
        float _247 = _160.y;
        vec3 _252 = _179 + ((((_214 * parameters.gTaps[0].x) + (_226 * parameters.gTaps[0].y)) + (_235 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _247)));
        float _253 = 1.0 / parameters.gRadius;
        float _255 = _252.z;
        vec2 _257 = _252.xy * (1.0 / _255);
        vec4 _265 = textureLod(gInCoarseDepth, _257, 0.0);
        float _266 = _265.x;
        float _270 = _255 - ((_266 > 0.0) ? min(_266, 65504.0) : 65504.0);
        vec3 _295 = _179 + ((((_214 * parameters.gTaps[1].x) + (_226 * parameters.gTaps[1].y)) + (_235 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _247)));
        float _297 = _295.z;
        vec2 _299 = _295.xy * (1.0 / _297);
        vec4 _307 = textureLod(gInCoarseDepth, _299, 0.0);
        float _308 = _307.x;
        float _312 = _297 - ((_308 > 0.0) ? min(_308, 65504.0) : 65504.0);
        vec3 _338 = _179 + ((((_214 * parameters.gTaps[2].x) + (_226 * parameters.gTaps[2].y)) + (_235 * parameters.gTaps[2].z)) * sqrt(fract(parameters.gTaps[2].w + _247)));
        float _340 = _338.z;
        vec2 _342 = _338.xy * (1.0 / _340);
        vec4 _350 = textureLod(gInCoarseDepth, _342, 0.0);
        float _351 = _350.x;
        float _355 = _340 - ((_351 > 0.0) ? min(_351, 65504.0) : 65504.0);
        vec3 _381 = _179 + ((((_214 * parameters.gTaps[3].x) + (_226 * parameters.gTaps[3].y)) + (_235 * parameters.gTaps[3].z)) * sqrt(fract(parameters.gTaps[3].w + _247)));
        float _383 = _381.z;
        vec2 _385 = _381.xy * (1.0 / _383);
        vec4 _393 = textureLod(gInCoarseDepth, _385, 0.0);
        float _394 = _393.x;
        float _398 = _383 - ((_394 > 0.0) ? min(_394, 65504.0) : 65504.0);
        vec2 _408 = ((mix(vec2(0.0), vec2(clamp(fma(_270, _171, -1.0), 0.0, 1.0) * clamp(fma(-_270, _253, 2.0), 0.0, 1.0), 1.0), bvec2((_255 > 0.0) && all(lessThanEqual(abs(_257 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_312, _171, -1.0), 0.0, 1.0) * clamp(fma(-_312, _253, 2.0), 0.0, 1.0), 1.0), bvec2((_297 > 0.0) && all(lessThanEqual(abs(_299 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_355, _171, -1.0), 0.0, 1.0) * clamp(fma(-_355, _253, 2.0), 0.0, 1.0), 1.0), bvec2((_340 > 0.0) && all(lessThanEqual(abs(_342 - vec2(0.5)), vec2(0.5)))))) + mix(vec2(0.0), vec2(clamp(fma(_398, _171, -1.0), 0.0, 1.0) * clamp(fma(-_398, _253, 2.0), 0.0, 1.0), 1.0), bvec2((_383 > 0.0) && all(lessThanEqual(abs(_385 - vec2(0.5)), vec2(0.5)))));
        float _415 = (_110 < 65504.0) ? (1.0 - (_408.x / max(_408.y, 1.0))) : 1.0;
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec4 _428 = parameters.gViewToPreviousClip * vec4(fma(_102, parameters.gViewRay.xy, parameters.gViewRay.zw) * _110, _110, 1.0);
        float _431 = _428.w;
        vec2 _436 = fma(_428.xy * (1.0 / _431), vec2(0.5, -0.5), vec2(0.5));
        vec2 _442 = mix(vec2(-8.0), _436, bvec2((_431 > 0.0) && all(lessThanEqual(abs(_436), vec2(8.0)))));
        float _444 = dot(_428.zw, parameters.gClipToDepth);
        vec2 _448 = _442 * parameters.gFrameToCoarse;
        vec4 _452 = textureLod(gHistoryCacheStateFiltered, _448, 0.0);
        vec4 _456 = textureLod(gHistoryCacheFiltered, _448, 0.0);
        float _457 = _456.x;
        float _459 = _452.x;
        float _462 = (_459 > 0.0) ? min(_459, 255.0) : 0.0;
        float _468 = max(fma(parameters.gMissThreshold.y, _110, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _474 = _468 - abs(((abs(_444) <= 9.9999996802856924650656260769173e+37) ? _444 : 0.0) - _456.y);
        float _477 = (_474 > 0.0) ? (_474 * (parameters.gConvergenceTime / _468)) : 0.0;
        float _489 = abs(_457);
        float _492 = ((parameters.gHistoryValid > 0.5) && (_489 <= 65504.0)) ? (((_477 > 0.0) && all(lessThanEqual(abs(fma(_442, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_477, 1.0) : 0.0) : 0.0;
        float _504 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _506 = parameters.gSpeedPx.y - abs(length(fma(_100, parameters.gOutputSize.zw, -_448) * parameters.gOutputSize.xy));
        float _510 = ((_506 > 0.0) ? min(_506, _504) : 0.0) / _504;
        float _513 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _518 = _462 * _492;
        float _521 = (_518 > 0.0) ? min(_518, 255.0) : 0.0;
        float _525 = min(min(_521 / (_521 + 1.0), _513), ((_513 * _510) * _510) * fma(-2.0, _510, 3.0));
        float _528 = (abs(_415) <= 9.9999996802856924650656260769173e+37) ? _415 : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_525 > 0.0) ? ((_489 <= 9.9999996802856924650656260769173e+37) ? fma(_457 - _528, clamp(_525, 0.0, 1.0), _528) : _528) : _415, _110, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_462 > 0.0) ? min(_462, 255.0) : 0.0, (_492 > 0.0) ? min(_492, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

