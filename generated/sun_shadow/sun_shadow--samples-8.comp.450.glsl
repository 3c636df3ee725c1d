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
        vec2 _109 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _111 = _109 * parameters.gOutputSize.zw;
        vec2 _115 = parameters.gOutputSize.zw * 0.5;
        vec4 _118 = textureGather(gInCoarseDepth, fma(_109, parameters.gOutputSize.zw, -_115));
        vec4 _121 = textureGather(gInCoarseDepth, fma(_109, parameters.gOutputSize.zw, _115));
        float _122 = _118.y;
        float _124 = (_122 > 0.0) ? _122 : 65504.0;
        float _126 = (_124 < 65504.0) ? _124 : 65504.0;
        float _127 = _118.x;
        float _129 = (_127 > 0.0) ? _127 : 65504.0;
        float _131 = (_129 < 65504.0) ? _129 : 65504.0;
        float _132 = _118.z;
        float _134 = (_132 > 0.0) ? _132 : 65504.0;
        float _136 = (_134 < 65504.0) ? _134 : 65504.0;
        float _137 = _121.z;
        float _139 = (_137 > 0.0) ? _137 : 65504.0;
        float _141 = (_139 < 65504.0) ? _139 : 65504.0;
        float _142 = _121.x;
        float _144 = (_142 > 0.0) ? _142 : 65504.0;
        float _146 = (_144 < 65504.0) ? _144 : 65504.0;
        vec3 _150 = vec3(_111 * _126, _126);
        vec2 _174 = vec2(parameters.gOutputSize.z, 0.0);
        float _189 = _141 - _126;
        vec2 _197 = mix(vec2(_189, _141), vec2(_126 - _131, _131), bvec2((all(lessThanEqual(abs(fma(_109, parameters.gOutputSize.zw, -_174) - vec2(0.5)), vec2(0.5))) ? abs(_131 - _126) : 131008.0) < (all(lessThanEqual(abs(fma(_109, parameters.gOutputSize.zw, _174) - vec2(0.5)), vec2(0.5))) ? abs(_189) : 65504.0)));
        float _198 = _197.x;
        vec3 _205 = vec3((_111 * _198) + (_174 * _197.y), _198);
        vec2 _212 = vec2(0.0, parameters.gOutputSize.w);
        float _227 = _146 - _126;
        vec2 _235 = mix(vec2(_227, _146), vec2(_126 - _136, _136), bvec2((all(lessThanEqual(abs(fma(_109, parameters.gOutputSize.zw, -_212) - vec2(0.5)), vec2(0.5))) ? abs(_136 - _126) : 131008.0) < (all(lessThanEqual(abs(fma(_109, parameters.gOutputSize.zw, _212) - vec2(0.5)), vec2(0.5))) ? abs(_227) : 65504.0)));
        float _236 = _235.x;
        vec3 _243 = vec3((_111 * _236) + (_212 * _235.y), _236);
        vec3 _248 = cross(vec3(dot(parameters.gToShadowX.xyz, _205), dot(parameters.gToShadowY.xyz, _205), dot(parameters.gToShadowZ.xyz, _205)), vec3(dot(parameters.gToShadowX.xyz, _243), dot(parameters.gToShadowY.xyz, _243), dot(parameters.gToShadowZ.xyz, _243)));
        float _249 = _248.z;
        bool _273 = _126 > parameters.gCascadeFar.x;
        bvec3 _274 = bvec3(_273);
        bool _286 = _126 > parameters.gCascadeFar.y;
        bvec3 _287 = bvec3(_286);
        vec3 _288 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _274), parameters.gCascadeScale2.xyz, _287);
        float _291 = float(_273) + float(_286);
        vec3 _292 = fma(vec3(dot(parameters.gToShadowX.xyz, _150), dot(parameters.gToShadowY.xyz, _150), dot(parameters.gToShadowZ.xyz, _150)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _288, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _274), parameters.gCascadeOffset2.xyz, _287));
        float _293 = _288.z;
        vec2 _294 = _288.xy;
        vec2 _297 = clamp((-_248.xy) / vec2((abs(_249) > 9.9999996826552253889678874634872e-21) ? _249 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_293) / _294);
        vec2 _305 = max(parameters.gDisc.xy * _294, vec2(parameters.gDisc.z));
        vec2 _314 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _317 = floor(_109);
        float _322 = floor(parameters.gSubsetCount);
        float _325 = (_322 > 1.0) ? min(_322, 16.0) : 1.0;
        float _329 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _335 = vec2(0.03902132809162139892578125, 0.558722317218780517578125) * fma(-_325, floor((_329 + 0.5) / _325), _329);
        vec2 _338 = floor(_317 * 0.5);
        vec2 _340 = _317 - (_338 * 2.0);
        vec2 _344 = _338 - (floor(_317 * 0.25) * 2.0);
        float _346 = _340.y;
        float _349 = _344.y;
        vec2 _355 = (abs(vec2(_340.x - _346, _344.x - _349)) * 2.0) + vec2(_346, _349);
        float _360 = 6.283185482025146484375 * fma(fma(4.0, _355.x, _355.y), 0.0625, _335.x);
        float _361 = cos(_360);
        float _362 = sin(_360);
        vec2 _367 = vec2(_317.y + 1.0, _317.x);
        vec2 _369 = floor(_367 * 0.5);
        vec2 _371 = _367 - (_369 * 2.0);
        vec2 _375 = _369 - (floor(_367 * 0.25) * 2.0);
        float _377 = _371.y;
        float _380 = _375.y;
        vec2 _386 = (abs(vec2(_371.x - _377, _375.x - _380)) * 2.0) + vec2(_377, _380);
        float _390 = fma(fma(4.0, _386.x, _386.y), 0.0625, _335.y);
        vec2 _391 = fract(vec2(0.5));
        float _393 = 6.283185482025146484375 * _391.x;
        float _394 = cos(_393);
        float _395 = sin(_393);
        vec2 _411 = clamp(floor(fma(_305 * sqrt(fract(_391.y + _390)), vec2(fma(_394, _361, -(_395 * _362)), fma(_394, _362, _395 * _361)), _292.xy)) + vec2(0.5), vec2(0.5), _314);
        float _428 = -fma(parameters.gBias.y, _126, parameters.gBias.x);
        vec2 _432 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _434 = 6.283185482025146484375 * _432.x;
        float _435 = cos(_434);
        float _436 = sin(_434);
        vec2 _451 = clamp(floor(fma(_305 * sqrt(fract(_432.y + _390)), vec2(fma(_435, _361, -(_436 * _362)), fma(_435, _362, _436 * _361)), _292.xy)) + vec2(0.5), vec2(0.5), _314);
        vec2 _468 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _470 = 6.283185482025146484375 * _468.x;
        float _471 = cos(_470);
        float _472 = sin(_470);
        vec2 _487 = clamp(floor(fma(_305 * sqrt(fract(_468.y + _390)), vec2(fma(_471, _361, -(_472 * _362)), fma(_471, _362, _472 * _361)), _292.xy)) + vec2(0.5), vec2(0.5), _314);
        vec2 _504 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _506 = 6.283185482025146484375 * _504.x;
        float _507 = cos(_506);
        float _508 = sin(_506);
        vec2 _523 = clamp(floor(fma(_305 * sqrt(fract(_504.y + _390)), vec2(fma(_507, _361, -(_508 * _362)), fma(_507, _362, _508 * _361)), _292.xy)) + vec2(0.5), vec2(0.5), _314);
        vec2 _540 = fract(vec2(3.519510746002197265625, 2.779361248016357421875));
        float _542 = 6.283185482025146484375 * _540.x;
        float _543 = cos(_542);
        float _544 = sin(_542);
        vec2 _559 = clamp(floor(fma(_305 * sqrt(fract(_540.y + _390)), vec2(fma(_543, _361, -(_544 * _362)), fma(_543, _362, _544 * _361)), _292.xy)) + vec2(0.5), vec2(0.5), _314);
        float _575 = (((float(textureLod(gInShadowMap, vec2(fma(_291, parameters.gCascadeSize.x, _411.x), _411.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_428, _293, min(_292.z + dot(_297, _411 - _292.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_291, parameters.gCascadeSize.x, _451.x), _451.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_428, _293, min(_292.z + dot(_297, _451 - _292.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_291, parameters.gCascadeSize.x, _487.x), _487.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_428, _293, min(_292.z + dot(_297, _487 - _292.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_291, parameters.gCascadeSize.x, _523.x), _523.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_428, _293, min(_292.z + dot(_297, _523 - _292.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_291, parameters.gCascadeSize.x, _559.x), _559.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_428, _293, min(_292.z + dot(_297, _559 - _292.xy), 1.0)));
        vec2 _576 = fract(vec2(4.27438831329345703125, 3.349201679229736328125));
        float _578 = 6.283185482025146484375 * _576.x;
        float _579 = cos(_578);
        float _580 = sin(_578);
        vec2 _595 = clamp(floor(fma(_305 * sqrt(fract(_576.y + _390)), vec2(fma(_579, _361, -(_580 * _362)), fma(_579, _362, _580 * _361)), _292.xy)) + vec2(0.5), vec2(0.5), _314);
        vec2 _612 = fract(vec2(5.029266357421875, 3.9190418720245361328125));
        float _614 = 6.283185482025146484375 * _612.x;
        float _615 = cos(_614);
        float _616 = sin(_614);
        vec2 _631 = clamp(floor(fma(_305 * sqrt(fract(_612.y + _390)), vec2(fma(_615, _361, -(_616 * _362)), fma(_615, _362, _616 * _361)), _292.xy)) + vec2(0.5), vec2(0.5), _314);
        vec2 _648 = fract(vec2(5.784143924713134765625, 4.4888820648193359375));
        float _650 = 6.283185482025146484375 * _648.x;
        float _651 = cos(_650);
        float _652 = sin(_650);
        vec2 _667 = clamp(floor(fma(_305 * sqrt(fract(_648.y + _390)), vec2(fma(_651, _361, -(_652 * _362)), fma(_651, _362, _652 * _361)), _292.xy)) + vec2(0.5), vec2(0.5), _314);
        float _695 = (_126 < 65504.0) ? ((all(lessThanEqual(abs((_292.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_126 <= parameters.gCascadeFar.z)) ? fma(-(((_575 + float(textureLod(gInShadowMap, vec2(fma(_291, parameters.gCascadeSize.x, _595.x), _595.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_428, _293, min(_292.z + dot(_297, _595 - _292.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_291, parameters.gCascadeSize.x, _631.x), _631.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_428, _293, min(_292.z + dot(_297, _631 - _292.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_291, parameters.gCascadeSize.x, _667.x), _667.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_428, _293, min(_292.z + dot(_297, _667 - _292.xy), 1.0)))), 0.125, 1.0) : 1.0) : 1.0;
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(_695, _126, 0.0, 0.0));
        break;
    } while(false);
}

