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

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _102 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _104 = _102 * parameters.gOutputSize.zw;
        vec2 _108 = parameters.gOutputSize.zw * 0.5;
        vec4 _111 = textureGather(gInCoarseDepth, fma(_102, parameters.gOutputSize.zw, -_108));
        vec4 _114 = textureGather(gInCoarseDepth, fma(_102, parameters.gOutputSize.zw, _108));
        float _115 = _111.y;
        float _118 = (_115 > 0.0) ? min(_115, 65504.0) : 65504.0;
        float _119 = _111.x;
        float _122 = (_119 > 0.0) ? min(_119, 65504.0) : 65504.0;
        float _123 = _111.z;
        float _126 = (_123 > 0.0) ? min(_123, 65504.0) : 65504.0;
        float _127 = _114.z;
        float _130 = (_127 > 0.0) ? min(_127, 65504.0) : 65504.0;
        float _131 = _114.x;
        float _134 = (_131 > 0.0) ? min(_131, 65504.0) : 65504.0;
        vec3 _138 = vec3(_104 * _118, _118);
        bvec2 _160 = greaterThan(_104, parameters.gOutputSize.zw);
        bvec2 _162 = lessThan(_104, vec2(1.0) - parameters.gOutputSize.zw);
        float _168 = _130 - _118;
        vec2 _176 = mix(vec2(_168, _130), vec2(_118 - _122, _122), bvec2((_160.x ? abs(_122 - _118) : 131008.0) < (_162.x ? abs(_168) : 65504.0)));
        float _182 = _134 - _118;
        vec2 _190 = mix(vec2(_182, _134), vec2(_118 - _126, _126), bvec2((_160.y ? abs(_126 - _118) : 131008.0) < (_162.y ? abs(_182) : 65504.0)));
        float _194 = _176.x;
        vec3 _201 = vec3((_104 * _194) + (vec2(parameters.gOutputSize.z, 0.0) * _176.y), _194);
        float _209 = _190.x;
        vec3 _216 = vec3((_104 * _209) + (vec2(0.0, parameters.gOutputSize.w) * _190.y), _209);
        vec3 _221 = cross(vec3(dot(parameters.gToShadowX.xyz, _201), dot(parameters.gToShadowY.xyz, _201), dot(parameters.gToShadowZ.xyz, _201)), vec3(dot(parameters.gToShadowX.xyz, _216), dot(parameters.gToShadowY.xyz, _216), dot(parameters.gToShadowZ.xyz, _216)));
        float _222 = _221.z;
        bool _246 = _118 > parameters.gCascadeFar.x;
        bvec3 _247 = bvec3(_246);
        bool _259 = _118 > parameters.gCascadeFar.y;
        bvec3 _260 = bvec3(_259);
        bool _273 = _118 > parameters.gCascadeFar.z;
        bvec3 _274 = bvec3(_273);
        vec3 _275 = mix(mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _247), parameters.gCascadeScale2.xyz, _260), parameters.gCascadeScale3.xyz, _274);
        float _278 = (float(_246) + float(_259)) + float(_273);
        vec3 _279 = fma(vec3(dot(parameters.gToShadowX.xyz, _138), dot(parameters.gToShadowY.xyz, _138), dot(parameters.gToShadowZ.xyz, _138)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _275, mix(mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _247), parameters.gCascadeOffset2.xyz, _260), parameters.gCascadeOffset3.xyz, _274));
        float _280 = _275.z;
        vec2 _281 = _275.xy;
        vec2 _284 = clamp((-_221.xy) / vec2((abs(_222) > 9.9999996826552253889678874634872e-21) ? _222 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_280) / _281);
        vec2 _292 = max(parameters.gDisc.xy * _281, vec2(parameters.gDisc.z));
        vec2 _301 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _304 = floor(_102);
        vec2 _306 = floor(_304 * 0.5);
        vec2 _308 = _304 - (_306 * 2.0);
        vec2 _312 = _306 - (floor(_306 * 0.5) * 2.0);
        float _313 = _308.x;
        float _314 = _308.y;
        float _316 = abs(_313 - _314);
        float _317 = _312.y;
        float _322 = _312.x;
        vec2 _334 = vec2(fma(2.0, abs(_322 - _317), fma(8.0, _316, 4.0 * _314)) + _317, fma(2.0, abs(abs(_317 - _314) - _322), fma(4.0, _313, fma(-8.0, _316, 8.0))) + _322) * vec2(0.0625);
        float _339 = floor(parameters.gSubsetCount);
        float _342 = (_339 > 1.0) ? min(_339, 16.0) : 1.0;
        float _346 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _352 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_342, floor((_346 + 0.5) / _342), _346);
        float _356 = 6.283185482025146484375 * (_352.x + _334.x);
        float _357 = cos(_356);
        float _358 = sin(_356);
        float _361 = _352.y + _334.y;
        vec2 _362 = fract(vec2(0.5));
        float _364 = 6.283185482025146484375 * _362.x;
        float _365 = cos(_364);
        float _366 = sin(_364);
        vec2 _382 = clamp(floor(fma(_292 * sqrt(fract(_362.y + _361)), vec2(fma(_365, _357, -(_366 * _358)), fma(_365, _358, _366 * _357)), _279.xy)) + vec2(0.5), vec2(0.5), _301);
        float _399 = -fma(parameters.gShadowBias.y, _118, parameters.gShadowBias.x);
        vec2 _403 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _405 = 6.283185482025146484375 * _403.x;
        float _406 = cos(_405);
        float _407 = sin(_405);
        vec2 _422 = clamp(floor(fma(_292 * sqrt(fract(_403.y + _361)), vec2(fma(_406, _357, -(_407 * _358)), fma(_406, _358, _407 * _357)), _279.xy)) + vec2(0.5), vec2(0.5), _301);
        vec2 _439 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _441 = 6.283185482025146484375 * _439.x;
        float _442 = cos(_441);
        float _443 = sin(_441);
        vec2 _458 = clamp(floor(fma(_292 * sqrt(fract(_439.y + _361)), vec2(fma(_442, _357, -(_443 * _358)), fma(_442, _358, _443 * _357)), _279.xy)) + vec2(0.5), vec2(0.5), _301);
        vec2 _475 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _477 = 6.283185482025146484375 * _475.x;
        float _478 = cos(_477);
        float _479 = sin(_477);
        vec2 _494 = clamp(floor(fma(_292 * sqrt(fract(_475.y + _361)), vec2(fma(_478, _357, -(_479 * _358)), fma(_478, _358, _479 * _357)), _279.xy)) + vec2(0.5), vec2(0.5), _301);
        float _518 = -(((float(textureLod(gInShadowMap, vec2(fma(_278, parameters.gCascadeSize.x, _382.x), _382.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_399, _280, min(_279.z + dot(_284, _382 - _279.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_278, parameters.gCascadeSize.x, _422.x), _422.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_399, _280, min(_279.z + dot(_284, _422 - _279.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_278, parameters.gCascadeSize.x, _458.x), _458.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_399, _280, min(_279.z + dot(_284, _458 - _279.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_278, parameters.gCascadeSize.x, _494.x), _494.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_399, _280, min(_279.z + dot(_284, _494 - _279.xy), 1.0))));
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_118 < 65504.0) ? ((all(lessThanEqual(abs((_279.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_118 <= parameters.gCascadeFar.w)) ? fma(_518, 0.25, 1.0) : 1.0) : 1.0, _118, 0.0, 0.0));
        break;
    } while(false);
}

