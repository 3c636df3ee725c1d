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

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _89 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _91 = _89 * parameters.gOutputSize.zw;
        vec2 _95 = parameters.gOutputSize.zw * 0.5;
        vec4 _98 = textureGather(gInCoarseDepth, fma(_89, parameters.gOutputSize.zw, -_95));
        vec4 _101 = textureGather(gInCoarseDepth, fma(_89, parameters.gOutputSize.zw, _95));
        float _102 = _98.y;
        float _104 = (_102 > 0.0) ? _102 : 65504.0;
        float _106 = (_104 < 65504.0) ? _104 : 65504.0;
        float _107 = _98.x;
        float _109 = (_107 > 0.0) ? _107 : 65504.0;
        float _111 = (_109 < 65504.0) ? _109 : 65504.0;
        float _112 = _98.z;
        float _114 = (_112 > 0.0) ? _112 : 65504.0;
        float _116 = (_114 < 65504.0) ? _114 : 65504.0;
        float _117 = _101.z;
        float _119 = (_117 > 0.0) ? _117 : 65504.0;
        float _121 = (_119 < 65504.0) ? _119 : 65504.0;
        float _122 = _101.x;
        float _124 = (_122 > 0.0) ? _122 : 65504.0;
        float _126 = (_124 < 65504.0) ? _124 : 65504.0;
        vec3 _130 = vec3(_91 * _106, _106);
        vec3 _151 = vec3(dot(parameters.gToShadowX.xyz, _130), dot(parameters.gToShadowY.xyz, _130), dot(parameters.gToShadowZ.xyz, _130)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w);
        vec2 _154 = vec2(parameters.gOutputSize.z, 0.0);
        float _169 = _121 - _106;
        vec2 _177 = mix(vec2(_169, _121), vec2(_106 - _111, _111), bvec2((all(lessThanEqual(abs(fma(_89, parameters.gOutputSize.zw, -_154) - vec2(0.5)), vec2(0.5))) ? abs(_111 - _106) : 131008.0) < (all(lessThanEqual(abs(fma(_89, parameters.gOutputSize.zw, _154) - vec2(0.5)), vec2(0.5))) ? abs(_169) : 65504.0)));
        float _178 = _177.x;
        vec3 _185 = vec3((_91 * _178) + (_154 * _177.y), _178);
        vec2 _192 = vec2(0.0, parameters.gOutputSize.w);
        float _207 = _126 - _106;
        vec2 _215 = mix(vec2(_207, _126), vec2(_106 - _116, _116), bvec2((all(lessThanEqual(abs(fma(_89, parameters.gOutputSize.zw, -_192) - vec2(0.5)), vec2(0.5))) ? abs(_116 - _106) : 131008.0) < (all(lessThanEqual(abs(fma(_89, parameters.gOutputSize.zw, _192) - vec2(0.5)), vec2(0.5))) ? abs(_207) : 65504.0)));
        float _216 = _215.x;
        vec3 _223 = vec3((_91 * _216) + (_192 * _215.y), _216);
        vec3 _228 = cross(vec3(dot(parameters.gToShadowX.xyz, _185), dot(parameters.gToShadowY.xyz, _185), dot(parameters.gToShadowZ.xyz, _185)), vec3(dot(parameters.gToShadowX.xyz, _223), dot(parameters.gToShadowY.xyz, _223), dot(parameters.gToShadowZ.xyz, _223)));
        float _229 = _228.z;
        vec2 _242 = clamp((-_228.xy) / vec2((abs(_229) > 9.9999996826552253889678874634872e-21) ? _229 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z));
        vec2 _251 = max(parameters.gDisc.xy, vec2(parameters.gDisc.z));
        vec2 _260 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _261 = floor(_89);
        float _266 = floor(parameters.gSubsetCount);
        float _269 = (_266 > 1.0) ? min(_266, 16.0) : 1.0;
        float _273 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _279 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_269, floor((_273 + 0.5) / _269), _273);
        vec2 _282 = floor(_261 * 0.5);
        vec2 _284 = _261 - (_282 * 2.0);
        vec2 _288 = _282 - (floor(_261 * 0.25) * 2.0);
        float _290 = _284.y;
        float _293 = _288.y;
        vec2 _299 = (abs(vec2(_284.x - _290, _288.x - _293)) * 2.0) + vec2(_290, _293);
        float _304 = 6.283185482025146484375 * fma(fma(4.0, _299.x, _299.y), 0.0625, _279.x);
        float _305 = cos(_304);
        float _306 = sin(_304);
        vec2 _311 = vec2(_261.y + 1.0, _261.x);
        vec2 _313 = floor(_311 * 0.5);
        vec2 _315 = _311 - (_313 * 2.0);
        vec2 _319 = _313 - (floor(_311 * 0.25) * 2.0);
        float _321 = _315.y;
        float _324 = _319.y;
        vec2 _330 = (abs(vec2(_315.x - _321, _319.x - _324)) * 2.0) + vec2(_321, _324);
        float _334 = fma(fma(4.0, _330.x, _330.y), 0.0625, _279.y);
        vec2 _335 = fract(vec2(0.5));
        float _337 = 6.283185482025146484375 * _335.x;
        float _338 = cos(_337);
        float _339 = sin(_337);
        vec2 _346 = _151.xy;
        vec2 _355 = clamp(floor(fma(_251 * sqrt(fract(_335.y + _334)), vec2(fma(_338, _305, -(_339 * _306)), fma(_338, _306, _339 * _305)), _346)) + vec2(0.5), vec2(0.5), _260);
        float _363 = _151.z;
        float _368 = -fma(parameters.gBias.y, _106, parameters.gBias.x);
        vec2 _372 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _374 = 6.283185482025146484375 * _372.x;
        float _375 = cos(_374);
        float _376 = sin(_374);
        vec2 _391 = clamp(floor(fma(_251 * sqrt(fract(_372.y + _334)), vec2(fma(_375, _305, -(_376 * _306)), fma(_375, _306, _376 * _305)), _346)) + vec2(0.5), vec2(0.5), _260);
        vec2 _404 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _406 = 6.283185482025146484375 * _404.x;
        float _407 = cos(_406);
        float _408 = sin(_406);
        vec2 _423 = clamp(floor(fma(_251 * sqrt(fract(_404.y + _334)), vec2(fma(_407, _305, -(_408 * _306)), fma(_407, _306, _408 * _305)), _346)) + vec2(0.5), vec2(0.5), _260);
        vec2 _436 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _438 = 6.283185482025146484375 * _436.x;
        float _439 = cos(_438);
        float _440 = sin(_438);
        vec2 _455 = clamp(floor(fma(_251 * sqrt(fract(_436.y + _334)), vec2(fma(_439, _305, -(_440 * _306)), fma(_439, _306, _440 * _305)), _346)) + vec2(0.5), vec2(0.5), _260);
        float _479 = (_106 < 65504.0) ? ((all(lessThanEqual(abs((_346 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_106 <= parameters.gCascadeFar.x)) ? fma(-(((float(textureLod(gInShadowMap, _355 * parameters.gCascadeSize.zw, 0.0).x < fma(_368, 1.0, min(_363 + dot(_242, _355 - _346), 1.0))) + float(textureLod(gInShadowMap, _391 * parameters.gCascadeSize.zw, 0.0).x < fma(_368, 1.0, min(_363 + dot(_242, _391 - _346), 1.0)))) + float(textureLod(gInShadowMap, _423 * parameters.gCascadeSize.zw, 0.0).x < fma(_368, 1.0, min(_363 + dot(_242, _423 - _346), 1.0)))) + float(textureLod(gInShadowMap, _455 * parameters.gCascadeSize.zw, 0.0).x < fma(_368, 1.0, min(_363 + dot(_242, _455 - _346), 1.0)))), 0.25, 1.0) : 1.0) : 1.0;
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(_479, _106, 0.0, 0.0));
        break;
    } while(false);
}

