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
        vec2 _93 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _95 = _93 * parameters.gOutputSize.zw;
        vec2 _99 = parameters.gOutputSize.zw * 0.5;
        vec4 _102 = textureGather(gInCoarseDepth, fma(_93, parameters.gOutputSize.zw, -_99));
        vec4 _105 = textureGather(gInCoarseDepth, fma(_93, parameters.gOutputSize.zw, _99));
        float _106 = _102.y;
        float _109 = (_106 > 0.0) ? min(_106, 65504.0) : 65504.0;
        float _110 = _102.x;
        float _113 = (_110 > 0.0) ? min(_110, 65504.0) : 65504.0;
        float _114 = _102.z;
        float _117 = (_114 > 0.0) ? min(_114, 65504.0) : 65504.0;
        float _118 = _105.z;
        float _121 = (_118 > 0.0) ? min(_118, 65504.0) : 65504.0;
        float _122 = _105.x;
        float _125 = (_122 > 0.0) ? min(_122, 65504.0) : 65504.0;
        vec3 _129 = vec3(_95 * _109, _109);
        vec3 _150 = vec3(dot(parameters.gToShadowX.xyz, _129), dot(parameters.gToShadowY.xyz, _129), dot(parameters.gToShadowZ.xyz, _129)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w);
        bvec2 _151 = greaterThan(_95, parameters.gOutputSize.zw);
        bvec2 _153 = lessThan(_95, vec2(1.0) - parameters.gOutputSize.zw);
        float _159 = _121 - _109;
        vec2 _167 = mix(vec2(_159, _121), vec2(_109 - _113, _113), bvec2((_151.x ? abs(_113 - _109) : 131008.0) < (_153.x ? abs(_159) : 65504.0)));
        float _173 = _125 - _109;
        vec2 _181 = mix(vec2(_173, _125), vec2(_109 - _117, _117), bvec2((_151.y ? abs(_117 - _109) : 131008.0) < (_153.y ? abs(_173) : 65504.0)));
        float _185 = _167.x;
        vec3 _192 = vec3((_95 * _185) + (vec2(parameters.gOutputSize.z, 0.0) * _167.y), _185);
        float _200 = _181.x;
        vec3 _207 = vec3((_95 * _200) + (vec2(0.0, parameters.gOutputSize.w) * _181.y), _200);
        vec3 _212 = cross(vec3(dot(parameters.gToShadowX.xyz, _192), dot(parameters.gToShadowY.xyz, _192), dot(parameters.gToShadowZ.xyz, _192)), vec3(dot(parameters.gToShadowX.xyz, _207), dot(parameters.gToShadowY.xyz, _207), dot(parameters.gToShadowZ.xyz, _207)));
        float _213 = _212.z;
        vec2 _226 = clamp((-_212.xy) / vec2((abs(_213) > 9.9999996826552253889678874634872e-21) ? _213 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z));
        vec2 _235 = max(parameters.gDisc.xy, vec2(parameters.gDisc.z));
        vec2 _244 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _245 = floor(_93);
        vec2 _247 = floor(_245 * 0.5);
        vec2 _249 = _245 - (_247 * 2.0);
        vec2 _253 = _247 - (floor(_247 * 0.5) * 2.0);
        float _254 = _249.x;
        float _255 = _249.y;
        float _257 = abs(_254 - _255);
        float _258 = _253.y;
        float _263 = _253.x;
        vec2 _275 = vec2(fma(2.0, abs(_263 - _258), fma(8.0, _257, 4.0 * _255)) + _258, fma(2.0, abs(abs(_258 - _255) - _263), fma(4.0, _254, fma(-8.0, _257, 8.0))) + _263) * vec2(0.0625);
        float _280 = floor(parameters.gSubsetCount);
        float _283 = (_280 > 1.0) ? min(_280, 16.0) : 1.0;
        float _287 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _293 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_283, floor((_287 + 0.5) / _283), _287);
        float _297 = 6.283185482025146484375 * (_293.x + _275.x);
        float _298 = cos(_297);
        float _299 = sin(_297);
        float _302 = _293.y + _275.y;
        vec2 _303 = fract(vec2(0.5));
        float _305 = 6.283185482025146484375 * _303.x;
        float _306 = cos(_305);
        float _307 = sin(_305);
        vec2 _314 = _150.xy;
        vec2 _323 = clamp(floor(fma(_235 * sqrt(fract(_303.y + _302)), vec2(fma(_306, _298, -(_307 * _299)), fma(_306, _299, _307 * _298)), _314)) + vec2(0.5), vec2(0.5), _244);
        float _331 = _150.z;
        float _336 = -fma(parameters.gShadowBias.y, _109, parameters.gShadowBias.x);
        vec2 _340 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _342 = 6.283185482025146484375 * _340.x;
        float _343 = cos(_342);
        float _344 = sin(_342);
        vec2 _359 = clamp(floor(fma(_235 * sqrt(fract(_340.y + _302)), vec2(fma(_343, _298, -(_344 * _299)), fma(_343, _299, _344 * _298)), _314)) + vec2(0.5), vec2(0.5), _244);
        vec2 _372 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _374 = 6.283185482025146484375 * _372.x;
        float _375 = cos(_374);
        float _376 = sin(_374);
        vec2 _391 = clamp(floor(fma(_235 * sqrt(fract(_372.y + _302)), vec2(fma(_375, _298, -(_376 * _299)), fma(_375, _299, _376 * _298)), _314)) + vec2(0.5), vec2(0.5), _244);
        vec2 _404 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _406 = 6.283185482025146484375 * _404.x;
        float _407 = cos(_406);
        float _408 = sin(_406);
        vec2 _423 = clamp(floor(fma(_235 * sqrt(fract(_404.y + _302)), vec2(fma(_407, _298, -(_408 * _299)), fma(_407, _299, _408 * _298)), _314)) + vec2(0.5), vec2(0.5), _244);
        float _447 = (_109 < 65504.0) ? ((all(lessThanEqual(abs((_314 / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_109 <= parameters.gCascadeFar.x)) ? fma(-(((float(textureLod(gInShadowMap, _323 * parameters.gCascadeSize.zw, 0.0).x < fma(_336, 1.0, min(_331 + dot(_226, _323 - _314), 1.0))) + float(textureLod(gInShadowMap, _359 * parameters.gCascadeSize.zw, 0.0).x < fma(_336, 1.0, min(_331 + dot(_226, _359 - _314), 1.0)))) + float(textureLod(gInShadowMap, _391 * parameters.gCascadeSize.zw, 0.0).x < fma(_336, 1.0, min(_331 + dot(_226, _391 - _314), 1.0)))) + float(textureLod(gInShadowMap, _423 * parameters.gCascadeSize.zw, 0.0).x < fma(_336, 1.0, min(_331 + dot(_226, _423 - _314), 1.0)))), 0.25, 1.0) : 1.0) : 1.0;
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(_447, _109, 0.0, 0.0));
        break;
    } while(false);
}

