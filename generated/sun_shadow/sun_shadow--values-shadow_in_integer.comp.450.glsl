#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform SunShadowParameters
{
    vec4 gOutputSize;
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
} parameters;

layout(binding = 16) uniform writeonly image2D gOutShadow;
layout(binding = 1) uniform sampler2D gInCoarseDepth;
layout(binding = 2) uniform sampler2D gInShadowMap;
layout(binding = 3) uniform sampler2D gInOcclusion;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _104 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _106 = _104 * parameters.gOutputSize.zw;
        vec2 _110 = parameters.gOutputSize.zw * 0.5;
        vec4 _113 = textureGather(gInCoarseDepth, fma(_104, parameters.gOutputSize.zw, -_110));
        vec4 _116 = textureGather(gInCoarseDepth, fma(_104, parameters.gOutputSize.zw, _110));
        float _117 = _113.y;
        float _120 = (_117 > 0.0) ? min(_117, 65504.0) : 65504.0;
        float _121 = _113.x;
        float _124 = (_121 > 0.0) ? min(_121, 65504.0) : 65504.0;
        float _125 = _113.z;
        float _128 = (_125 > 0.0) ? min(_125, 65504.0) : 65504.0;
        float _129 = _116.z;
        float _132 = (_129 > 0.0) ? min(_129, 65504.0) : 65504.0;
        float _133 = _116.x;
        float _136 = (_133 > 0.0) ? min(_133, 65504.0) : 65504.0;
        vec3 _140 = vec3(_106 * _120, _120);
        bvec2 _162 = greaterThan(_106, parameters.gOutputSize.zw);
        bvec2 _164 = lessThan(_106, vec2(1.0) - parameters.gOutputSize.zw);
        float _170 = _132 - _120;
        vec2 _178 = mix(vec2(_170, _132), vec2(_120 - _124, _124), bvec2((_162.x ? abs(_124 - _120) : 131008.0) < (_164.x ? abs(_170) : 65504.0)));
        float _184 = _136 - _120;
        vec2 _192 = mix(vec2(_184, _136), vec2(_120 - _128, _128), bvec2((_162.y ? abs(_128 - _120) : 131008.0) < (_164.y ? abs(_184) : 65504.0)));
        float _196 = _178.x;
        vec3 _203 = vec3((_106 * _196) + (vec2(parameters.gOutputSize.z, 0.0) * _178.y), _196);
        float _211 = _192.x;
        vec3 _218 = vec3((_106 * _211) + (vec2(0.0, parameters.gOutputSize.w) * _192.y), _211);
        vec3 _223 = cross(vec3(dot(parameters.gToShadowX.xyz, _203), dot(parameters.gToShadowY.xyz, _203), dot(parameters.gToShadowZ.xyz, _203)), vec3(dot(parameters.gToShadowX.xyz, _218), dot(parameters.gToShadowY.xyz, _218), dot(parameters.gToShadowZ.xyz, _218)));
        float _224 = _223.z;
        bool _248 = _120 > parameters.gCascadeFar.x;
        bvec3 _249 = bvec3(_248);
        bool _261 = _120 > parameters.gCascadeFar.y;
        bvec3 _262 = bvec3(_261);
        vec3 _263 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _249), parameters.gCascadeScale2.xyz, _262);
        float _266 = float(_248) + float(_261);
        vec3 _267 = fma(vec3(dot(parameters.gToShadowX.xyz, _140), dot(parameters.gToShadowY.xyz, _140), dot(parameters.gToShadowZ.xyz, _140)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _263, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _249), parameters.gCascadeOffset2.xyz, _262));
        float _268 = _263.z;
        vec2 _269 = _263.xy;
        vec2 _272 = clamp((-_223.xy) / vec2((abs(_224) > 9.9999996826552253889678874634872e-21) ? _224 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_268) / _269);
        vec2 _280 = max(parameters.gDisc.xy * _269, vec2(parameters.gDisc.z));
        vec2 _289 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _292 = floor(_104);
        vec2 _294 = floor(_292 * 0.5);
        vec2 _296 = _292 - (_294 * 2.0);
        vec2 _300 = _294 - (floor(_294 * 0.5) * 2.0);
        float _301 = _296.x;
        float _302 = _296.y;
        float _304 = abs(_301 - _302);
        float _305 = _300.y;
        float _310 = _300.x;
        vec2 _322 = vec2(fma(2.0, abs(_310 - _305), fma(8.0, _304, 4.0 * _302)) + _305, fma(2.0, abs(abs(_305 - _302) - _310), fma(4.0, _301, fma(-8.0, _304, 8.0))) + _310) * vec2(0.0625);
        float _327 = floor(parameters.gSubsetCount);
        float _330 = (_327 > 1.0) ? min(_327, 16.0) : 1.0;
        float _334 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _340 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_330, floor((_334 + 0.5) / _330), _334);
        float _344 = 6.283185482025146484375 * (_340.x + _322.x);
        float _345 = cos(_344);
        float _346 = sin(_344);
        float _349 = _340.y + _322.y;
        vec2 _350 = fract(vec2(0.5));
        float _352 = 6.283185482025146484375 * _350.x;
        float _353 = cos(_352);
        float _354 = sin(_352);
        vec2 _370 = clamp(floor(fma(_280 * sqrt(fract(_350.y + _349)), vec2(fma(_353, _345, -(_354 * _346)), fma(_353, _346, _354 * _345)), _267.xy)) + vec2(0.5), vec2(0.5), _289);
        float _387 = -fma(parameters.gShadowBias.y, _120, parameters.gShadowBias.x);
        vec2 _391 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _393 = 6.283185482025146484375 * _391.x;
        float _394 = cos(_393);
        float _395 = sin(_393);
        vec2 _410 = clamp(floor(fma(_280 * sqrt(fract(_391.y + _349)), vec2(fma(_394, _345, -(_395 * _346)), fma(_394, _346, _395 * _345)), _267.xy)) + vec2(0.5), vec2(0.5), _289);
        vec2 _427 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _429 = 6.283185482025146484375 * _427.x;
        float _430 = cos(_429);
        float _431 = sin(_429);
        vec2 _446 = clamp(floor(fma(_280 * sqrt(fract(_427.y + _349)), vec2(fma(_430, _345, -(_431 * _346)), fma(_430, _346, _431 * _345)), _267.xy)) + vec2(0.5), vec2(0.5), _289);
        vec2 _463 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _465 = 6.283185482025146484375 * _463.x;
        float _466 = cos(_465);
        float _467 = sin(_465);
        vec2 _482 = clamp(floor(fma(_280 * sqrt(fract(_463.y + _349)), vec2(fma(_466, _345, -(_467 * _346)), fma(_466, _346, _467 * _345)), _267.xy)) + vec2(0.5), vec2(0.5), _289);
        float _506 = -(((float(textureLod(gInShadowMap, vec2(fma(_266, parameters.gCascadeSize.x, _370.x), _370.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_387, _268, min(_267.z + dot(_272, _370 - _267.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_266, parameters.gCascadeSize.x, _410.x), _410.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_387, _268, min(_267.z + dot(_272, _410 - _267.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_266, parameters.gCascadeSize.x, _446.x), _446.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_387, _268, min(_267.z + dot(_272, _446 - _267.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_266, parameters.gCascadeSize.x, _482.x), _482.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_387, _268, min(_267.z + dot(_272, _482 - _267.xy), 1.0))));
        float _510 = (_120 < 65504.0) ? ((all(lessThanEqual(abs((_267.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_120 <= parameters.gCascadeFar.z)) ? fma(_506, 0.25, 1.0) : 1.0) : 1.0;
        vec4 _514 = textureLod(gInOcclusion, _106, 0.0);
        float _515 = _514.x;
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_515 > 0.0) ? min(_515, 1.0) : 0.0, 0.984375, floor(fma((_510 > 0.0) ? min(_510, 1.0) : 0.0, 31.0, 0.5))), _120, 0.0, 0.0));
        break;
    } while(false);
}

