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
        vec2 _96 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _102 = parameters.gOutputSize.zw * 0.5;
        vec4 _105 = textureGather(gInCoarseDepth, fma(_96, parameters.gOutputSize.zw, -_102));
        vec4 _108 = textureGather(gInCoarseDepth, fma(_96, parameters.gOutputSize.zw, _102));
        float _109 = _105.y;
        float _111 = (_109 > 0.0) ? _109 : 65504.0;
        float _113 = (_111 < 65504.0) ? _111 : 65504.0;
        float _114 = _105.x;
        float _116 = (_114 > 0.0) ? _114 : 65504.0;
        float _118 = (_116 < 65504.0) ? _116 : 65504.0;
        float _119 = _105.z;
        float _121 = (_119 > 0.0) ? _119 : 65504.0;
        float _123 = (_121 < 65504.0) ? _121 : 65504.0;
        float _124 = _108.z;
        float _126 = (_124 > 0.0) ? _124 : 65504.0;
        float _128 = (_126 < 65504.0) ? _126 : 65504.0;
        float _129 = _108.x;
        float _131 = (_129 > 0.0) ? _129 : 65504.0;
        float _133 = (_131 < 65504.0) ? _131 : 65504.0;
        vec3 _136 = vec3(_96 * parameters.gOutputSize.zw, _113);
        vec2 _160 = vec2(parameters.gOutputSize.z, 0.0);
        float _175 = _128 - _113;
        vec3 _185 = vec3(parameters.gOutputSize.z, 0.0, mix(vec2(_175, _128), vec2(_113 - _118, _118), bvec2((all(lessThanEqual(abs(fma(_96, parameters.gOutputSize.zw, -_160) - vec2(0.5)), vec2(0.5))) ? abs(_118 - _113) : 131008.0) < (all(lessThanEqual(abs(fma(_96, parameters.gOutputSize.zw, _160) - vec2(0.5)), vec2(0.5))) ? abs(_175) : 65504.0))).x);
        vec2 _192 = vec2(0.0, parameters.gOutputSize.w);
        float _207 = _133 - _113;
        vec3 _217 = vec3(0.0, parameters.gOutputSize.w, mix(vec2(_207, _133), vec2(_113 - _123, _123), bvec2((all(lessThanEqual(abs(fma(_96, parameters.gOutputSize.zw, -_192) - vec2(0.5)), vec2(0.5))) ? abs(_123 - _113) : 131008.0) < (all(lessThanEqual(abs(fma(_96, parameters.gOutputSize.zw, _192) - vec2(0.5)), vec2(0.5))) ? abs(_207) : 65504.0))).x);
        vec3 _222 = cross(vec3(dot(parameters.gToShadowX.xyz, _185), dot(parameters.gToShadowY.xyz, _185), dot(parameters.gToShadowZ.xyz, _185)), vec3(dot(parameters.gToShadowX.xyz, _217), dot(parameters.gToShadowY.xyz, _217), dot(parameters.gToShadowZ.xyz, _217)));
        float _223 = _222.z;
        bool _247 = _113 > parameters.gCascadeFar.x;
        bvec3 _248 = bvec3(_247);
        bool _260 = _113 > parameters.gCascadeFar.y;
        bvec3 _261 = bvec3(_260);
        vec3 _262 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _248), parameters.gCascadeScale2.xyz, _261);
        float _265 = float(_247) + float(_260);
        vec3 _266 = fma(vec3(dot(parameters.gToShadowX.xyz, _136), dot(parameters.gToShadowY.xyz, _136), dot(parameters.gToShadowZ.xyz, _136)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _262, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _248), parameters.gCascadeOffset2.xyz, _261));
        float _267 = _262.z;
        vec2 _268 = _262.xy;
        vec2 _271 = clamp((-_222.xy) / vec2((abs(_223) > 9.9999996826552253889678874634872e-21) ? _223 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_267) / _268);
        vec2 _279 = max(parameters.gDisc.xy * _268, vec2(parameters.gDisc.z));
        vec2 _288 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _291 = floor(_96);
        float _296 = floor(parameters.gSubsetCount);
        float _299 = (_296 > 1.0) ? min(_296, 16.0) : 1.0;
        float _303 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _309 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_299, floor((_303 + 0.5) / _299), _303);
        vec2 _312 = floor(_291 * 0.5);
        vec2 _314 = _291 - (_312 * 2.0);
        vec2 _318 = _312 - (floor(_291 * 0.25) * 2.0);
        float _320 = _314.y;
        float _323 = _318.y;
        vec2 _329 = (abs(vec2(_314.x - _320, _318.x - _323)) * 2.0) + vec2(_320, _323);
        float _334 = 6.283185482025146484375 * fma(fma(4.0, _329.x, _329.y), 0.0625, _309.x);
        float _335 = cos(_334);
        float _336 = sin(_334);
        vec2 _341 = vec2(_291.y + 1.0, _291.x);
        vec2 _343 = floor(_341 * 0.5);
        vec2 _345 = _341 - (_343 * 2.0);
        vec2 _349 = _343 - (floor(_341 * 0.25) * 2.0);
        float _351 = _345.y;
        float _354 = _349.y;
        vec2 _360 = (abs(vec2(_345.x - _351, _349.x - _354)) * 2.0) + vec2(_351, _354);
        float _364 = fma(fma(4.0, _360.x, _360.y), 0.0625, _309.y);
        vec2 _365 = fract(vec2(0.5));
        float _367 = 6.283185482025146484375 * _365.x;
        float _368 = cos(_367);
        float _369 = sin(_367);
        vec2 _385 = clamp(floor(fma(_279 * sqrt(fract(_365.y + _364)), vec2(fma(_368, _335, -(_369 * _336)), fma(_368, _336, _369 * _335)), _266.xy)) + vec2(0.5), vec2(0.5), _288);
        float _402 = -fma(parameters.gBias.y, _113, parameters.gBias.x);
        vec2 _406 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _408 = 6.283185482025146484375 * _406.x;
        float _409 = cos(_408);
        float _410 = sin(_408);
        vec2 _425 = clamp(floor(fma(_279 * sqrt(fract(_406.y + _364)), vec2(fma(_409, _335, -(_410 * _336)), fma(_409, _336, _410 * _335)), _266.xy)) + vec2(0.5), vec2(0.5), _288);
        vec2 _442 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _444 = 6.283185482025146484375 * _442.x;
        float _445 = cos(_444);
        float _446 = sin(_444);
        vec2 _461 = clamp(floor(fma(_279 * sqrt(fract(_442.y + _364)), vec2(fma(_445, _335, -(_446 * _336)), fma(_445, _336, _446 * _335)), _266.xy)) + vec2(0.5), vec2(0.5), _288);
        vec2 _478 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _480 = 6.283185482025146484375 * _478.x;
        float _481 = cos(_480);
        float _482 = sin(_480);
        vec2 _497 = clamp(floor(fma(_279 * sqrt(fract(_478.y + _364)), vec2(fma(_481, _335, -(_482 * _336)), fma(_481, _336, _482 * _335)), _266.xy)) + vec2(0.5), vec2(0.5), _288);
        float _521 = -(((float(textureLod(gInShadowMap, vec2(fma(_265, parameters.gCascadeSize.x, _385.x), _385.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_402, _267, min(_266.z + dot(_271, _385 - _266.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_265, parameters.gCascadeSize.x, _425.x), _425.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_402, _267, min(_266.z + dot(_271, _425 - _266.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_265, parameters.gCascadeSize.x, _461.x), _461.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_402, _267, min(_266.z + dot(_271, _461 - _266.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_265, parameters.gCascadeSize.x, _497.x), _497.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_402, _267, min(_266.z + dot(_271, _497 - _266.xy), 1.0))));
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_113 < 65504.0) ? ((all(lessThanEqual(abs((_266.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_113 <= parameters.gCascadeFar.z)) ? fma(_521, 0.25, 1.0) : 1.0) : 1.0, _113, 0.0, 0.0));
        break;
    } while(false);
}

