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
    vec3 gBias;
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
        vec2 _100 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _102 = _100 * parameters.gOutputSize.zw;
        vec2 _106 = parameters.gOutputSize.zw * 0.5;
        vec4 _109 = textureGather(gInCoarseDepth, fma(_100, parameters.gOutputSize.zw, -_106));
        vec4 _112 = textureGather(gInCoarseDepth, fma(_100, parameters.gOutputSize.zw, _106));
        float _113 = _109.y;
        float _115 = (_113 > 0.0) ? _113 : 65504.0;
        float _117 = (_115 < 65504.0) ? _115 : 65504.0;
        float _118 = _109.x;
        float _120 = (_118 > 0.0) ? _118 : 65504.0;
        float _122 = (_120 < 65504.0) ? _120 : 65504.0;
        float _123 = _109.z;
        float _125 = (_123 > 0.0) ? _123 : 65504.0;
        float _127 = (_125 < 65504.0) ? _125 : 65504.0;
        float _128 = _112.z;
        float _130 = (_128 > 0.0) ? _128 : 65504.0;
        float _132 = (_130 < 65504.0) ? _130 : 65504.0;
        float _133 = _112.x;
        float _135 = (_133 > 0.0) ? _133 : 65504.0;
        float _137 = (_135 < 65504.0) ? _135 : 65504.0;
        vec3 _141 = vec3(_102 * _117, _117);
        vec2 _165 = vec2(parameters.gOutputSize.z, 0.0);
        float _180 = _132 - _117;
        vec2 _188 = mix(vec2(_180, _132), vec2(_117 - _122, _122), bvec2((all(lessThanEqual(abs(fma(_100, parameters.gOutputSize.zw, -_165) - vec2(0.5)), vec2(0.5))) ? abs(_122 - _117) : 131008.0) < (all(lessThanEqual(abs(fma(_100, parameters.gOutputSize.zw, _165) - vec2(0.5)), vec2(0.5))) ? abs(_180) : 65504.0)));
        float _189 = _188.x;
        vec3 _196 = vec3((_102 * _189) + (_165 * _188.y), _189);
        vec2 _203 = vec2(0.0, parameters.gOutputSize.w);
        float _218 = _137 - _117;
        vec2 _226 = mix(vec2(_218, _137), vec2(_117 - _127, _127), bvec2((all(lessThanEqual(abs(fma(_100, parameters.gOutputSize.zw, -_203) - vec2(0.5)), vec2(0.5))) ? abs(_127 - _117) : 131008.0) < (all(lessThanEqual(abs(fma(_100, parameters.gOutputSize.zw, _203) - vec2(0.5)), vec2(0.5))) ? abs(_218) : 65504.0)));
        float _227 = _226.x;
        vec3 _234 = vec3((_102 * _227) + (_203 * _226.y), _227);
        vec3 _239 = cross(vec3(dot(parameters.gToShadowX.xyz, _196), dot(parameters.gToShadowY.xyz, _196), dot(parameters.gToShadowZ.xyz, _196)), vec3(dot(parameters.gToShadowX.xyz, _234), dot(parameters.gToShadowY.xyz, _234), dot(parameters.gToShadowZ.xyz, _234)));
        float _240 = _239.z;
        bool _264 = _117 > parameters.gCascadeFar.x;
        bvec3 _265 = bvec3(_264);
        bool _277 = _117 > parameters.gCascadeFar.y;
        bvec3 _278 = bvec3(_277);
        vec3 _279 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _265), parameters.gCascadeScale2.xyz, _278);
        float _282 = float(_264) + float(_277);
        vec3 _283 = fma(vec3(dot(parameters.gToShadowX.xyz, _141), dot(parameters.gToShadowY.xyz, _141), dot(parameters.gToShadowZ.xyz, _141)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _279, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _265), parameters.gCascadeOffset2.xyz, _278));
        float _284 = _279.z;
        vec2 _285 = _279.xy;
        vec2 _288 = clamp((-_239.xy) / vec2((abs(_240) > 9.9999996826552253889678874634872e-21) ? _240 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_284) / _285);
        vec2 _296 = max(parameters.gDisc.xy * _285, vec2(parameters.gDisc.z));
        vec2 _305 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _308 = floor(_100);
        float _313 = floor(parameters.gSubsetCount);
        float _316 = (_313 > 1.0) ? min(_313, 16.0) : 1.0;
        float _320 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _326 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_316, floor((_320 + 0.5) / _316), _320);
        vec2 _329 = floor(_308 * 0.5);
        vec2 _331 = _308 - (_329 * 2.0);
        vec2 _335 = _329 - (floor(_308 * 0.25) * 2.0);
        float _337 = _331.y;
        float _340 = _335.y;
        vec2 _346 = (abs(vec2(_331.x - _337, _335.x - _340)) * 2.0) + vec2(_337, _340);
        float _351 = 6.283185482025146484375 * fma(fma(4.0, _346.x, _346.y), 0.0625, _326.x);
        float _352 = cos(_351);
        float _353 = sin(_351);
        vec2 _358 = vec2(_308.y + 1.0, _308.x);
        vec2 _360 = floor(_358 * 0.5);
        vec2 _362 = _358 - (_360 * 2.0);
        vec2 _366 = _360 - (floor(_358 * 0.25) * 2.0);
        float _368 = _362.y;
        float _371 = _366.y;
        vec2 _377 = (abs(vec2(_362.x - _368, _366.x - _371)) * 2.0) + vec2(_368, _371);
        float _381 = fma(fma(4.0, _377.x, _377.y), 0.0625, _326.y);
        vec2 _382 = fract(vec2(0.5));
        float _384 = 6.283185482025146484375 * _382.x;
        float _385 = cos(_384);
        float _386 = sin(_384);
        vec2 _402 = clamp(floor(fma(_296 * sqrt(fract(_382.y + _381)), vec2(fma(_385, _352, -(_386 * _353)), fma(_385, _353, _386 * _352)), _283.xy)) + vec2(0.5), vec2(0.5), _305);
        float _419 = -fma(parameters.gBias.y, _117, parameters.gBias.x);
        vec2 _423 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _425 = 6.283185482025146484375 * _423.x;
        float _426 = cos(_425);
        float _427 = sin(_425);
        vec2 _442 = clamp(floor(fma(_296 * sqrt(fract(_423.y + _381)), vec2(fma(_426, _352, -(_427 * _353)), fma(_426, _353, _427 * _352)), _283.xy)) + vec2(0.5), vec2(0.5), _305);
        vec2 _459 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _461 = 6.283185482025146484375 * _459.x;
        float _462 = cos(_461);
        float _463 = sin(_461);
        vec2 _478 = clamp(floor(fma(_296 * sqrt(fract(_459.y + _381)), vec2(fma(_462, _352, -(_463 * _353)), fma(_462, _353, _463 * _352)), _283.xy)) + vec2(0.5), vec2(0.5), _305);
        vec2 _495 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _497 = 6.283185482025146484375 * _495.x;
        float _498 = cos(_497);
        float _499 = sin(_497);
        vec2 _514 = clamp(floor(fma(_296 * sqrt(fract(_495.y + _381)), vec2(fma(_498, _352, -(_499 * _353)), fma(_498, _353, _499 * _352)), _283.xy)) + vec2(0.5), vec2(0.5), _305);
        float _538 = -(((float(textureLod(gInShadowMap, vec2(fma(_282, parameters.gCascadeSize.x, _402.x), _402.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_419, _284, min(_283.z + dot(_288, _402 - _283.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_282, parameters.gCascadeSize.x, _442.x), _442.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_419, _284, min(_283.z + dot(_288, _442 - _283.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_282, parameters.gCascadeSize.x, _478.x), _478.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_419, _284, min(_283.z + dot(_288, _478 - _283.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_282, parameters.gCascadeSize.x, _514.x), _514.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_419, _284, min(_283.z + dot(_288, _514 - _283.xy), 1.0))));
        float _542 = (_117 < 65504.0) ? ((all(lessThanEqual(abs((_283.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_117 <= parameters.gCascadeFar.z)) ? fma(_538, 0.25, 1.0) : 1.0) : 1.0;
        vec4 _546 = textureLod(gInOcclusion, _102, 0.0);
        float _547 = _546.x;
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_542 > 0.0) ? min(_542, 1.0) : 0.0, 0.984375, floor(fma((_547 > 0.0) ? min(_547, 1.0) : 0.0, 31.0, 0.5))), _117, 0.0, 0.0));
        break;
    } while(false);
}

