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
        vec2 _94 = min(vec2(gl_GlobalInvocationID.xy) + vec2(0.5), parameters.gOutputSize.xy - vec2(0.5));
        vec2 _96 = _94 * parameters.gOutputSize.zw;
        vec2 _100 = parameters.gOutputSize.zw * 0.5;
        vec4 _103 = textureGather(gInCoarseDepth, fma(_94, parameters.gOutputSize.zw, -_100));
        vec4 _106 = textureGather(gInCoarseDepth, fma(_94, parameters.gOutputSize.zw, _100));
        float _107 = _103.y;
        float _110 = (_107 > 0.0) ? min(_107, 65504.0) : 65504.0;
        float _111 = _103.x;
        float _114 = (_111 > 0.0) ? min(_111, 65504.0) : 65504.0;
        float _115 = _103.z;
        float _118 = (_115 > 0.0) ? min(_115, 65504.0) : 65504.0;
        float _119 = _106.z;
        float _122 = (_119 > 0.0) ? min(_119, 65504.0) : 65504.0;
        float _123 = _106.x;
        float _126 = (_123 > 0.0) ? min(_123, 65504.0) : 65504.0;
        bvec2 _127 = greaterThan(_96, parameters.gOutputSize.zw);
        bvec2 _129 = lessThan(_96, vec2(1.0) - parameters.gOutputSize.zw);
        float _135 = _122 - _110;
        vec2 _143 = mix(vec2(_135, _122), vec2(_110 - _114, _114), bvec2((_127.x ? abs(_114 - _110) : 131008.0) < (_129.x ? abs(_135) : 65504.0)));
        float _149 = _126 - _110;
        vec2 _157 = mix(vec2(_149, _126), vec2(_110 - _118, _118), bvec2((_127.y ? abs(_118 - _110) : 131008.0) < (_129.y ? abs(_149) : 65504.0)));
        vec2 _169 = vec2(_143.x, _157.x) / ((parameters.gViewRay.xy * parameters.gOutputSize.zw) * vec2(_143.y, _157.y));
        vec2 _171 = fma(_96, parameters.gViewRay.xy, parameters.gViewRay.zw);
        vec3 _177 = normalize(vec3(_169, (-1.0) - dot(_171, _169)));
        vec2 _178 = floor(_94);
        vec2 _180 = floor(_178 * 0.5);
        vec2 _182 = _178 - (_180 * 2.0);
        vec2 _186 = _180 - (floor(_180 * 0.5) * 2.0);
        float _187 = _182.x;
        float _188 = _182.y;
        float _190 = abs(_187 - _188);
        float _191 = _186.y;
        float _196 = _186.x;
        vec2 _208 = vec2(fma(2.0, abs(_196 - _191), fma(8.0, _190, 4.0 * _188)) + _191, fma(2.0, abs(abs(_191 - _188) - _196), fma(4.0, _187, fma(-8.0, _190, 8.0))) + _196) * vec2(0.0625);
        float _210 = 6.283185482025146484375 * _208.x;
        float _211 = cos(_210);
        float _212 = sin(_210);
        float _219 = 1.0 / max(fma(parameters.gOcclusionBias.y, _110, parameters.gOcclusionBias.x), 9.9999999747524270787835121154785e-07);
        vec2 _220 = vec2(1.0) / parameters.gViewRay.xy;
        vec3 _224 = vec3(_96 * _110, _110);
        float _225 = _177.z;
        float _227 = (_225 >= 0.0) ? 1.0 : (-1.0);
        float _229 = (-1.0) / (_227 + _225);
        float _230 = _177.x;
        float _231 = _177.y;
        float _233 = (_230 * _231) * _229;
        vec3 _240 = vec3(fma((_227 * _230) * _230, _229, 1.0), _227 * _233, (-_227) * _230);
        vec3 _244 = vec3(_233, fma(_231 * _231, _229, _227), -_231);
        vec3 _250 = ((_240 * _211) + (_244 * _212)) * parameters.gRadius;
        float _252 = _250.z;
        vec3 _258 = vec3((_250.xy - (parameters.gViewRay.zw * _252)) * _220, _252);
        vec3 _262 = ((_244 * _211) - (_240 * _212)) * parameters.gRadius;
        float _264 = _262.z;
        vec3 _270 = vec3((_262.xy - (parameters.gViewRay.zw * _264)) * _220, _264);
        vec3 _271 = _177 * parameters.gRadius;
        float _273 = _271.z;
        vec3 _279 = vec3((_271.xy - (parameters.gViewRay.zw * _273)) * _220, _273);
        float _291 = _208.y;
        vec3 _296 = _224 + ((((_258 * parameters.gTaps[0].x) + (_270 * parameters.gTaps[0].y)) + (_279 * parameters.gTaps[0].z)) * sqrt(fract(parameters.gTaps[0].w + _291)));
        float _297 = 1.0 / parameters.gRadius;
        float _299 = _296.z;
        vec2 _301 = _296.xy * (1.0 / _299);
        vec4 _309 = textureLod(gInCoarseDepth, _301, 0.0);
        float _310 = _309.x;
        float _314 = _299 - ((_310 > 0.0) ? min(_310, 65504.0) : 65504.0);
        vec3 _339 = _224 + ((((_258 * parameters.gTaps[1].x) + (_270 * parameters.gTaps[1].y)) + (_279 * parameters.gTaps[1].z)) * sqrt(fract(parameters.gTaps[1].w + _291)));
        float _341 = _339.z;
        vec2 _343 = _339.xy * (1.0 / _341);
        vec4 _351 = textureLod(gInCoarseDepth, _343, 0.0);
        float _352 = _351.x;
        float _356 = _341 - ((_352 > 0.0) ? min(_352, 65504.0) : 65504.0);
        vec2 _366 = mix(vec2(0.0), vec2(clamp(fma(_314, _219, -1.0), 0.0, 1.0) * clamp(fma(-_314, _297, 2.0), 0.0, 1.0), 1.0), bvec2((_299 > 0.0) && all(lessThanEqual(abs(_301 - vec2(0.5)), vec2(0.5))))) + mix(vec2(0.0), vec2(clamp(fma(_356, _219, -1.0), 0.0, 1.0) * clamp(fma(-_356, _297, 2.0), 0.0, 1.0), 1.0), bvec2((_341 > 0.0) && all(lessThanEqual(abs(_343 - vec2(0.5)), vec2(0.5)))));
        float _373 = (_110 < 65504.0) ? (1.0 - (_366.x / max(_366.y, 1.0))) : 1.0;
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec4 _385 = parameters.gViewToPreviousClip * vec4(_171 * _110, _110, 1.0);
        float _388 = _385.w;
        vec2 _393 = fma(_385.xy * (1.0 / _388), vec2(0.5, -0.5), vec2(0.5));
        vec2 _399 = mix(vec2(-8.0), _393, bvec2((_388 > 0.0) && all(lessThanEqual(abs(_393), vec2(8.0)))));
        float _401 = dot(_385.zw, parameters.gClipToDepth);
        vec2 _407 = _399 * parameters.gFrameToCoarse;
        vec4 _411 = textureLod(gHistoryCacheStateFiltered, _407, 0.0);
        vec4 _415 = textureLod(gHistoryCacheFiltered, _407, 0.0);
        float _416 = _415.x;
        float _418 = _411.x;
        float _421 = (_418 > 0.0) ? min(_418, 255.0) : 0.0;
        float _427 = max(fma(parameters.gMissThreshold.y, _110, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _433 = _427 - abs(((abs(_401) <= 9.9999996802856924650656260769173e+37) ? _401 : 0.0) - _415.y);
        float _436 = (_433 > 0.0) ? (_433 * (parameters.gConvergenceTime / _427)) : 0.0;
        float _448 = abs(_416);
        float _451 = ((parameters.gHistoryValid > 0.5) && (_448 <= 65504.0)) ? (((_436 > 0.0) && all(lessThanEqual(abs(fma(_399, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_436, 1.0) : 0.0) : 0.0;
        float _463 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _465 = parameters.gSpeedPx.y - abs(length(fma(_94, parameters.gOutputSize.zw, -_407) * parameters.gOutputSize.xy));
        float _469 = ((_465 > 0.0) ? min(_465, _463) : 0.0) / _463;
        float _472 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _477 = _421 * _451;
        float _480 = (_477 > 0.0) ? min(_477, 255.0) : 0.0;
        float _484 = min(min(_480 / (_480 + 1.0), _472), ((_472 * _469) * _469) * fma(-2.0, _469, 3.0));
        float _487 = (abs(_373) <= 9.9999996802856924650656260769173e+37) ? _373 : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_484 > 0.0) ? ((_448 <= 9.9999996802856924650656260769173e+37) ? fma(_416 - _487, clamp(_484, 0.0, 1.0), _487) : _487) : _373, _110, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_421 > 0.0) ? min(_421, 255.0) : 0.0, (_451 > 0.0) ? min(_451, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

