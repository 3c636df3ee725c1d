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
        vec2 _112 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _114 = _112 * parameters.gOutputSize.zw;
        vec2 _118 = parameters.gOutputSize.zw * 0.5;
        vec4 _121 = textureGather(gInCoarseDepth, fma(_112, parameters.gOutputSize.zw, -_118));
        vec4 _124 = textureGather(gInCoarseDepth, fma(_112, parameters.gOutputSize.zw, _118));
        float _125 = _121.y;
        float _128 = (_125 > 0.0) ? min(_125, 65504.0) : 65504.0;
        float _129 = _121.x;
        float _132 = (_129 > 0.0) ? min(_129, 65504.0) : 65504.0;
        float _133 = _121.z;
        float _136 = (_133 > 0.0) ? min(_133, 65504.0) : 65504.0;
        float _137 = _124.z;
        float _140 = (_137 > 0.0) ? min(_137, 65504.0) : 65504.0;
        float _141 = _124.x;
        float _144 = (_141 > 0.0) ? min(_141, 65504.0) : 65504.0;
        vec3 _148 = vec3(_114 * _128, _128);
        bvec2 _170 = greaterThan(_114, parameters.gOutputSize.zw);
        bvec2 _172 = lessThan(_114, vec2(1.0) - parameters.gOutputSize.zw);
        float _178 = _140 - _128;
        vec2 _186 = mix(vec2(_178, _140), vec2(_128 - _132, _132), bvec2((_170.x ? abs(_132 - _128) : 131008.0) < (_172.x ? abs(_178) : 65504.0)));
        float _192 = _144 - _128;
        vec2 _200 = mix(vec2(_192, _144), vec2(_128 - _136, _136), bvec2((_170.y ? abs(_136 - _128) : 131008.0) < (_172.y ? abs(_192) : 65504.0)));
        float _204 = _186.x;
        vec3 _211 = vec3((_114 * _204) + (vec2(parameters.gOutputSize.z, 0.0) * _186.y), _204);
        float _219 = _200.x;
        vec3 _226 = vec3((_114 * _219) + (vec2(0.0, parameters.gOutputSize.w) * _200.y), _219);
        vec3 _231 = cross(vec3(dot(parameters.gToShadowX.xyz, _211), dot(parameters.gToShadowY.xyz, _211), dot(parameters.gToShadowZ.xyz, _211)), vec3(dot(parameters.gToShadowX.xyz, _226), dot(parameters.gToShadowY.xyz, _226), dot(parameters.gToShadowZ.xyz, _226)));
        float _232 = _231.z;
        bool _256 = _128 > parameters.gCascadeFar.x;
        bvec3 _257 = bvec3(_256);
        bool _269 = _128 > parameters.gCascadeFar.y;
        bvec3 _270 = bvec3(_269);
        vec3 _271 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _257), parameters.gCascadeScale2.xyz, _270);
        float _274 = float(_256) + float(_269);
        vec3 _275 = fma(vec3(dot(parameters.gToShadowX.xyz, _148), dot(parameters.gToShadowY.xyz, _148), dot(parameters.gToShadowZ.xyz, _148)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _271, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _257), parameters.gCascadeOffset2.xyz, _270));
        float _276 = _271.z;
        vec2 _277 = _271.xy;
        vec2 _280 = clamp((-_231.xy) / vec2((abs(_232) > 9.9999996826552253889678874634872e-21) ? _232 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gShadowBias.z), vec2(parameters.gShadowBias.z)) * (vec2(_276) / _277);
        vec2 _288 = max(parameters.gDisc.xy * _277, vec2(parameters.gDisc.z));
        vec2 _297 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _300 = floor(_112);
        vec2 _302 = floor(_300 * 0.5);
        vec2 _304 = _300 - (_302 * 2.0);
        vec2 _308 = _302 - (floor(_302 * 0.5) * 2.0);
        float _309 = _304.x;
        float _310 = _304.y;
        float _312 = abs(_309 - _310);
        float _313 = _308.y;
        float _318 = _308.x;
        vec2 _330 = vec2(fma(2.0, abs(_318 - _313), fma(8.0, _312, 4.0 * _310)) + _313, fma(2.0, abs(abs(_313 - _310) - _318), fma(4.0, _309, fma(-8.0, _312, 8.0))) + _318) * vec2(0.0625);
        float _335 = floor(parameters.gSubsetCount);
        float _338 = (_335 > 1.0) ? min(_335, 16.0) : 1.0;
        float _342 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _348 = vec2(0.03902132809162139892578125, 0.558722317218780517578125) * fma(-_338, floor((_342 + 0.5) / _338), _342);
        float _352 = 6.283185482025146484375 * (_348.x + _330.x);
        float _353 = cos(_352);
        float _354 = sin(_352);
        float _357 = _348.y + _330.y;
        vec2 _358 = fract(vec2(0.5));
        float _360 = 6.283185482025146484375 * _358.x;
        float _361 = cos(_360);
        float _362 = sin(_360);
        vec2 _378 = clamp(floor(fma(_288 * sqrt(fract(_358.y + _357)), vec2(fma(_361, _353, -(_362 * _354)), fma(_361, _354, _362 * _353)), _275.xy)) + vec2(0.5), vec2(0.5), _297);
        float _395 = -fma(parameters.gShadowBias.y, _128, parameters.gShadowBias.x);
        vec2 _399 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _401 = 6.283185482025146484375 * _399.x;
        float _402 = cos(_401);
        float _403 = sin(_401);
        vec2 _418 = clamp(floor(fma(_288 * sqrt(fract(_399.y + _357)), vec2(fma(_402, _353, -(_403 * _354)), fma(_402, _354, _403 * _353)), _275.xy)) + vec2(0.5), vec2(0.5), _297);
        vec2 _435 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _437 = 6.283185482025146484375 * _435.x;
        float _438 = cos(_437);
        float _439 = sin(_437);
        vec2 _454 = clamp(floor(fma(_288 * sqrt(fract(_435.y + _357)), vec2(fma(_438, _353, -(_439 * _354)), fma(_438, _354, _439 * _353)), _275.xy)) + vec2(0.5), vec2(0.5), _297);
        vec2 _471 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _473 = 6.283185482025146484375 * _471.x;
        float _474 = cos(_473);
        float _475 = sin(_473);
        vec2 _490 = clamp(floor(fma(_288 * sqrt(fract(_471.y + _357)), vec2(fma(_474, _353, -(_475 * _354)), fma(_474, _354, _475 * _353)), _275.xy)) + vec2(0.5), vec2(0.5), _297);
        vec2 _507 = fract(vec2(3.519510746002197265625, 2.779361248016357421875));
        float _509 = 6.283185482025146484375 * _507.x;
        float _510 = cos(_509);
        float _511 = sin(_509);
        vec2 _526 = clamp(floor(fma(_288 * sqrt(fract(_507.y + _357)), vec2(fma(_510, _353, -(_511 * _354)), fma(_510, _354, _511 * _353)), _275.xy)) + vec2(0.5), vec2(0.5), _297);
        float _542 = (((float(textureLod(gInShadowMap, vec2(fma(_274, parameters.gCascadeSize.x, _378.x), _378.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_395, _276, min(_275.z + dot(_280, _378 - _275.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_274, parameters.gCascadeSize.x, _418.x), _418.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_395, _276, min(_275.z + dot(_280, _418 - _275.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_274, parameters.gCascadeSize.x, _454.x), _454.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_395, _276, min(_275.z + dot(_280, _454 - _275.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_274, parameters.gCascadeSize.x, _490.x), _490.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_395, _276, min(_275.z + dot(_280, _490 - _275.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_274, parameters.gCascadeSize.x, _526.x), _526.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_395, _276, min(_275.z + dot(_280, _526 - _275.xy), 1.0)));
        vec2 _543 = fract(vec2(4.27438831329345703125, 3.349201679229736328125));
        float _545 = 6.283185482025146484375 * _543.x;
        float _546 = cos(_545);
        float _547 = sin(_545);
        vec2 _562 = clamp(floor(fma(_288 * sqrt(fract(_543.y + _357)), vec2(fma(_546, _353, -(_547 * _354)), fma(_546, _354, _547 * _353)), _275.xy)) + vec2(0.5), vec2(0.5), _297);
        vec2 _579 = fract(vec2(5.029266357421875, 3.9190418720245361328125));
        float _581 = 6.283185482025146484375 * _579.x;
        float _582 = cos(_581);
        float _583 = sin(_581);
        vec2 _598 = clamp(floor(fma(_288 * sqrt(fract(_579.y + _357)), vec2(fma(_582, _353, -(_583 * _354)), fma(_582, _354, _583 * _353)), _275.xy)) + vec2(0.5), vec2(0.5), _297);
        vec2 _615 = fract(vec2(5.784143924713134765625, 4.4888820648193359375));
        float _617 = 6.283185482025146484375 * _615.x;
        float _618 = cos(_617);
        float _619 = sin(_617);
        vec2 _634 = clamp(floor(fma(_288 * sqrt(fract(_615.y + _357)), vec2(fma(_618, _353, -(_619 * _354)), fma(_618, _354, _619 * _353)), _275.xy)) + vec2(0.5), vec2(0.5), _297);
        float _662 = (_128 < 65504.0) ? ((all(lessThanEqual(abs((_275.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_128 <= parameters.gCascadeFar.z)) ? fma(-(((_542 + float(textureLod(gInShadowMap, vec2(fma(_274, parameters.gCascadeSize.x, _562.x), _562.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_395, _276, min(_275.z + dot(_280, _562 - _275.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_274, parameters.gCascadeSize.x, _598.x), _598.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_395, _276, min(_275.z + dot(_280, _598 - _275.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_274, parameters.gCascadeSize.x, _634.x), _634.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_395, _276, min(_275.z + dot(_280, _634 - _275.xy), 1.0)))), 0.125, 1.0) : 1.0) : 1.0;
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4(_662, _128, 0.0, 0.0));
        break;
    } while(false);
}

