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
        vec3 _261 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _247), parameters.gCascadeScale2.xyz, _260);
        float _264 = float(_246) + float(_259);
        vec3 _265 = fma(vec3(dot(parameters.gToShadowX.xyz, _138), dot(parameters.gToShadowY.xyz, _138), dot(parameters.gToShadowZ.xyz, _138)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _261, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _247), parameters.gCascadeOffset2.xyz, _260));
        float _266 = _261.z;
        vec2 _267 = _261.xy;
        vec2 _270 = clamp((-_221.xy) / vec2((abs(_222) > 9.9999996826552253889678874634872e-21) ? _222 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_266) / _267);
        vec2 _278 = max(parameters.gDisc.xy * _267, vec2(parameters.gDisc.z));
        vec2 _287 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _290 = floor(_102);
        vec2 _292 = floor(_290 * 0.5);
        vec2 _294 = _290 - (_292 * 2.0);
        vec2 _298 = _292 - (floor(_292 * 0.5) * 2.0);
        float _299 = _294.x;
        float _300 = _294.y;
        float _302 = abs(_299 - _300);
        float _303 = _298.y;
        float _308 = _298.x;
        vec2 _320 = vec2(fma(2.0, abs(_308 - _303), fma(8.0, _302, 4.0 * _300)) + _303, fma(2.0, abs(abs(_303 - _300) - _308), fma(4.0, _299, fma(-8.0, _302, 8.0))) + _308) * vec2(0.0625);
        float _325 = floor(parameters.gSubsetCount);
        float _328 = (_325 > 1.0) ? min(_325, 16.0) : 1.0;
        float _332 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _338 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_328, floor((_332 + 0.5) / _328), _332);
        float _342 = 6.283185482025146484375 * (_338.x + _320.x);
        float _343 = cos(_342);
        float _344 = sin(_342);
        float _347 = _338.y + _320.y;
        vec2 _348 = fract(vec2(0.5));
        float _350 = 6.283185482025146484375 * _348.x;
        float _351 = cos(_350);
        float _352 = sin(_350);
        vec2 _368 = clamp(floor(fma(_278 * sqrt(fract(_348.y + _347)), vec2(fma(_351, _343, -(_352 * _344)), fma(_351, _344, _352 * _343)), _265.xy)) + vec2(0.5), vec2(0.5), _287);
        float _385 = -fma(parameters.gShadowBias.y, _118, parameters.gShadowBias.x);
        vec2 _389 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _391 = 6.283185482025146484375 * _389.x;
        float _392 = cos(_391);
        float _393 = sin(_391);
        vec2 _408 = clamp(floor(fma(_278 * sqrt(fract(_389.y + _347)), vec2(fma(_392, _343, -(_393 * _344)), fma(_392, _344, _393 * _343)), _265.xy)) + vec2(0.5), vec2(0.5), _287);
        vec2 _425 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _427 = 6.283185482025146484375 * _425.x;
        float _428 = cos(_427);
        float _429 = sin(_427);
        vec2 _444 = clamp(floor(fma(_278 * sqrt(fract(_425.y + _347)), vec2(fma(_428, _343, -(_429 * _344)), fma(_428, _344, _429 * _343)), _265.xy)) + vec2(0.5), vec2(0.5), _287);
        vec2 _461 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _463 = 6.283185482025146484375 * _461.x;
        float _464 = cos(_463);
        float _465 = sin(_463);
        vec2 _480 = clamp(floor(fma(_278 * sqrt(fract(_461.y + _347)), vec2(fma(_464, _343, -(_465 * _344)), fma(_464, _344, _465 * _343)), _265.xy)) + vec2(0.5), vec2(0.5), _287);
        float _504 = -(((float(textureLod(gInShadowMap, vec2(fma(_264, parameters.gCascadeSize.x, _368.x), _368.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_385, _266, min(_265.z + dot(_270, _368 - _265.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_264, parameters.gCascadeSize.x, _408.x), _408.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_385, _266, min(_265.z + dot(_270, _408 - _265.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_264, parameters.gCascadeSize.x, _444.x), _444.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_385, _266, min(_265.z + dot(_270, _444 - _265.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_264, parameters.gCascadeSize.x, _480.x), _480.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_385, _266, min(_265.z + dot(_270, _480 - _265.xy), 1.0))));
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(textureLod(gInOcclusion, _104, 0.0).x, (_118 < 65504.0) ? ((all(lessThanEqual(abs((_265.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_118 <= parameters.gCascadeFar.z)) ? fma(_504, 0.25, 1.0) : 1.0) : 1.0, 0.0, 0.0));
        break;
    } while(false);
}

