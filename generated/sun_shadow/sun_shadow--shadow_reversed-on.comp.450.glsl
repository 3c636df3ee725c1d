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
        vec3 _136 = vec3(_102 * _116, _116);
        bvec2 _158 = greaterThan(_102, parameters.gOutputSize.zw);
        bvec2 _160 = lessThan(_102, vec2(1.0) - parameters.gOutputSize.zw);
        float _166 = _128 - _116;
        vec2 _174 = mix(vec2(_166, _128), vec2(_116 - _120, _120), bvec2((_158.x ? abs(_120 - _116) : 131008.0) < (_160.x ? abs(_166) : 65504.0)));
        float _180 = _132 - _116;
        vec2 _188 = mix(vec2(_180, _132), vec2(_116 - _124, _124), bvec2((_158.y ? abs(_124 - _116) : 131008.0) < (_160.y ? abs(_180) : 65504.0)));
        float _192 = _174.x;
        vec3 _199 = vec3((_102 * _192) + (vec2(parameters.gOutputSize.z, 0.0) * _174.y), _192);
        float _207 = _188.x;
        vec3 _214 = vec3((_102 * _207) + (vec2(0.0, parameters.gOutputSize.w) * _188.y), _207);
        vec3 _219 = cross(vec3(dot(parameters.gToShadowX.xyz, _199), dot(parameters.gToShadowY.xyz, _199), dot(parameters.gToShadowZ.xyz, _199)), vec3(dot(parameters.gToShadowX.xyz, _214), dot(parameters.gToShadowY.xyz, _214), dot(parameters.gToShadowZ.xyz, _214)));
        float _220 = _219.z;
        bool _244 = _116 > parameters.gCascadeFar.x;
        bvec3 _245 = bvec3(_244);
        bool _257 = _116 > parameters.gCascadeFar.y;
        bvec3 _258 = bvec3(_257);
        vec3 _259 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _245), parameters.gCascadeScale2.xyz, _258);
        float _262 = float(_244) + float(_257);
        vec3 _263 = fma(vec3(dot(parameters.gToShadowX.xyz, _136), dot(parameters.gToShadowY.xyz, _136), dot(parameters.gToShadowZ.xyz, _136)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _259, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _245), parameters.gCascadeOffset2.xyz, _258));
        float _264 = _259.z;
        vec2 _265 = _259.xy;
        vec2 _268 = clamp((-_219.xy) / vec2((abs(_220) > 9.9999996826552253889678874634872e-21) ? _220 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_264) / _265);
        vec2 _276 = max(parameters.gDisc.xy * _265, vec2(parameters.gDisc.z));
        float _281 = fma(parameters.gShadowBias.y, _116, parameters.gShadowBias.x);
        vec2 _285 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _288 = floor(_100);
        vec2 _290 = floor(_288 * 0.5);
        vec2 _292 = _288 - (_290 * 2.0);
        vec2 _296 = _290 - (floor(_290 * 0.5) * 2.0);
        float _297 = _292.x;
        float _298 = _292.y;
        float _300 = abs(_297 - _298);
        float _301 = _296.y;
        float _306 = _296.x;
        vec2 _318 = vec2(fma(2.0, abs(_306 - _301), fma(8.0, _300, 4.0 * _298)) + _301, fma(2.0, abs(abs(_301 - _298) - _306), fma(4.0, _297, fma(-8.0, _300, 8.0))) + _306) * vec2(0.0625);
        float _323 = floor(parameters.gSubsetCount);
        float _326 = (_323 > 1.0) ? min(_323, 16.0) : 1.0;
        float _330 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _336 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_326, floor((_330 + 0.5) / _326), _330);
        float _340 = 6.283185482025146484375 * (_336.x + _318.x);
        float _341 = cos(_340);
        float _342 = sin(_340);
        float _345 = _336.y + _318.y;
        vec2 _346 = fract(vec2(0.5));
        float _348 = 6.283185482025146484375 * _346.x;
        float _349 = cos(_348);
        float _350 = sin(_348);
        vec2 _366 = clamp(floor(fma(_276 * sqrt(fract(_346.y + _345)), vec2(fma(_349, _341, -(_350 * _342)), fma(_349, _342, _350 * _341)), _263.xy)) + vec2(0.5), vec2(0.5), _285);
        vec2 _386 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _388 = 6.283185482025146484375 * _386.x;
        float _389 = cos(_388);
        float _390 = sin(_388);
        vec2 _405 = clamp(floor(fma(_276 * sqrt(fract(_386.y + _345)), vec2(fma(_389, _341, -(_390 * _342)), fma(_389, _342, _390 * _341)), _263.xy)) + vec2(0.5), vec2(0.5), _285);
        vec2 _422 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _424 = 6.283185482025146484375 * _422.x;
        float _425 = cos(_424);
        float _426 = sin(_424);
        vec2 _441 = clamp(floor(fma(_276 * sqrt(fract(_422.y + _345)), vec2(fma(_425, _341, -(_426 * _342)), fma(_425, _342, _426 * _341)), _263.xy)) + vec2(0.5), vec2(0.5), _285);
        vec2 _458 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _460 = 6.283185482025146484375 * _458.x;
        float _461 = cos(_460);
        float _462 = sin(_460);
        vec2 _477 = clamp(floor(fma(_276 * sqrt(fract(_458.y + _345)), vec2(fma(_461, _341, -(_462 * _342)), fma(_461, _342, _462 * _341)), _263.xy)) + vec2(0.5), vec2(0.5), _285);
        float _501 = -(((float(textureLod(gInShadowMap, vec2(fma(_262, parameters.gCascadeSize.x, _366.x), _366.y) * parameters.gCascadeSize.zw, 0.0).x > fma(_281, _264, max(_263.z + dot(_268, _366 - _263.xy), 0.0))) + float(textureLod(gInShadowMap, vec2(fma(_262, parameters.gCascadeSize.x, _405.x), _405.y) * parameters.gCascadeSize.zw, 0.0).x > fma(_281, _264, max(_263.z + dot(_268, _405 - _263.xy), 0.0)))) + float(textureLod(gInShadowMap, vec2(fma(_262, parameters.gCascadeSize.x, _441.x), _441.y) * parameters.gCascadeSize.zw, 0.0).x > fma(_281, _264, max(_263.z + dot(_268, _441 - _263.xy), 0.0)))) + float(textureLod(gInShadowMap, vec2(fma(_262, parameters.gCascadeSize.x, _477.x), _477.y) * parameters.gCascadeSize.zw, 0.0).x > fma(_281, _264, max(_263.z + dot(_268, _477 - _263.xy), 0.0))));
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_116 < 65504.0) ? ((all(lessThanEqual(abs((_263.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_116 <= parameters.gCascadeFar.z)) ? fma(_501, 0.25, 1.0) : 1.0) : 1.0, _116, 0.0, 0.0));
        break;
    } while(false);
}

