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
        vec2 _100 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _102 = _100 * parameters.gOutputSize.zw;
        vec2 _106 = parameters.gOutputSize.zw * 0.5;
        vec4 _109 = textureGather(gInCoarseDepth, fma(_100, parameters.gOutputSize.zw, -_106));
        vec4 _112 = textureGather(gInCoarseDepth, fma(_100, parameters.gOutputSize.zw, _106));
        float _113 = _109.y;
        float _116 = (_113 > 0.0) ? min(_113, 65504.0) : 65504.0;
        float _117 = _109.x;
        float _120 = (_117 > 0.0) ? min(_117, 65504.0) : 65504.0;
        float _121 = _109.z;
        float _124 = (_121 > 0.0) ? min(_121, 65504.0) : 65504.0;
        float _125 = _112.z;
        float _128 = (_125 > 0.0) ? min(_125, 65504.0) : 65504.0;
        float _129 = _112.x;
        float _132 = (_129 > 0.0) ? min(_129, 65504.0) : 65504.0;
        vec3 _135 = vec3(_102, _116);
        bvec2 _157 = greaterThan(_102, parameters.gOutputSize.zw);
        bvec2 _159 = lessThan(_102, vec2(1.0) - parameters.gOutputSize.zw);
        float _165 = _128 - _116;
        float _179 = _132 - _116;
        vec3 _191 = vec3(parameters.gOutputSize.z, 0.0, mix(vec2(_165, _128), vec2(_116 - _120, _120), bvec2((_157.x ? abs(_120 - _116) : 131008.0) < (_159.x ? abs(_165) : 65504.0))).x);
        vec3 _199 = vec3(0.0, parameters.gOutputSize.w, mix(vec2(_179, _132), vec2(_116 - _124, _124), bvec2((_157.y ? abs(_124 - _116) : 131008.0) < (_159.y ? abs(_179) : 65504.0))).x);
        vec3 _204 = cross(vec3(dot(parameters.gToShadowX.xyz, _191), dot(parameters.gToShadowY.xyz, _191), dot(parameters.gToShadowZ.xyz, _191)), vec3(dot(parameters.gToShadowX.xyz, _199), dot(parameters.gToShadowY.xyz, _199), dot(parameters.gToShadowZ.xyz, _199)));
        bool _229 = _116 > parameters.gCascadeFar.x;
        bvec3 _230 = bvec3(_229);
        bool _242 = _116 > parameters.gCascadeFar.y;
        bvec3 _243 = bvec3(_242);
        vec3 _244 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _230), parameters.gCascadeScale2.xyz, _243);
        float _247 = float(_229) + float(_242);
        vec3 _248 = fma(vec3(dot(parameters.gToShadowX.xyz, _135), dot(parameters.gToShadowY.xyz, _135), dot(parameters.gToShadowZ.xyz, _135)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _244, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _230), parameters.gCascadeOffset2.xyz, _243));
        float _249 = _244.z;
        vec2 _250 = _244.xy;
        vec2 _253 = clamp((-_204.xy) / vec2((abs(_204.z) > 9.9999996826552253889678874634872e-21) ? _204.z : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_249) / _250);
        vec2 _261 = max(parameters.gDisc.xy * _250, vec2(parameters.gDisc.z));
        vec2 _270 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _273 = floor(_100);
        vec2 _275 = floor(_273 * 0.5);
        vec2 _277 = _273 - (_275 * 2.0);
        vec2 _281 = _275 - (floor(_275 * 0.5) * 2.0);
        float _282 = _277.x;
        float _283 = _277.y;
        float _285 = abs(_282 - _283);
        float _286 = _281.y;
        float _291 = _281.x;
        vec2 _303 = vec2(fma(2.0, abs(_291 - _286), fma(8.0, _285, 4.0 * _283)) + _286, fma(2.0, abs(abs(_286 - _283) - _291), fma(4.0, _282, fma(-8.0, _285, 8.0))) + _291) * vec2(0.0625);
        float _308 = floor(parameters.gSubsetCount);
        float _311 = (_308 > 1.0) ? min(_308, 16.0) : 1.0;
        float _315 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _321 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_311, floor((_315 + 0.5) / _311), _315);
        float _325 = 6.283185482025146484375 * (_321.x + _303.x);
        float _326 = cos(_325);
        float _327 = sin(_325);
        float _330 = _321.y + _303.y;
        vec2 _331 = fract(vec2(0.5));
        float _333 = 6.283185482025146484375 * _331.x;
        float _334 = cos(_333);
        float _335 = sin(_333);
        vec2 _351 = clamp(floor(fma(_261 * sqrt(fract(_331.y + _330)), vec2(fma(_334, _326, -(_335 * _327)), fma(_334, _327, _335 * _326)), _248.xy)) + vec2(0.5), vec2(0.5), _270);
        float _368 = -fma(parameters.gShadowBias.y, _116, parameters.gShadowBias.x);
        vec2 _372 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _374 = 6.283185482025146484375 * _372.x;
        float _375 = cos(_374);
        float _376 = sin(_374);
        vec2 _391 = clamp(floor(fma(_261 * sqrt(fract(_372.y + _330)), vec2(fma(_375, _326, -(_376 * _327)), fma(_375, _327, _376 * _326)), _248.xy)) + vec2(0.5), vec2(0.5), _270);
        vec2 _408 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _410 = 6.283185482025146484375 * _408.x;
        float _411 = cos(_410);
        float _412 = sin(_410);
        vec2 _427 = clamp(floor(fma(_261 * sqrt(fract(_408.y + _330)), vec2(fma(_411, _326, -(_412 * _327)), fma(_411, _327, _412 * _326)), _248.xy)) + vec2(0.5), vec2(0.5), _270);
        vec2 _444 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _446 = 6.283185482025146484375 * _444.x;
        float _447 = cos(_446);
        float _448 = sin(_446);
        vec2 _463 = clamp(floor(fma(_261 * sqrt(fract(_444.y + _330)), vec2(fma(_447, _326, -(_448 * _327)), fma(_447, _327, _448 * _326)), _248.xy)) + vec2(0.5), vec2(0.5), _270);
        float _487 = -(((float(textureLod(gInShadowMap, vec2(fma(_247, parameters.gCascadeSize.x, _351.x), _351.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_368, _249, min(_248.z + dot(_253, _351 - _248.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_247, parameters.gCascadeSize.x, _391.x), _391.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_368, _249, min(_248.z + dot(_253, _391 - _248.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_247, parameters.gCascadeSize.x, _427.x), _427.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_368, _249, min(_248.z + dot(_253, _427 - _248.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_247, parameters.gCascadeSize.x, _463.x), _463.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_368, _249, min(_248.z + dot(_253, _463 - _248.xy), 1.0))));
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_116 < 65504.0) ? ((all(lessThanEqual(abs((_248.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_116 <= parameters.gCascadeFar.z)) ? fma(_487, 0.25, 1.0) : 1.0) : 1.0, _116, 0.0, 0.0));
        break;
    } while(false);
}

