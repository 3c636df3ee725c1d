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
        vec2 _98 = _96 * parameters.gOutputSize.zw;
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
        vec3 _137 = vec3(_98 * _113, _113);
        vec2 _161 = vec2(parameters.gOutputSize.z, 0.0);
        float _176 = _128 - _113;
        vec2 _184 = mix(vec2(_176, _128), vec2(_113 - _118, _118), bvec2((all(lessThanEqual(abs(fma(_96, parameters.gOutputSize.zw, -_161) - vec2(0.5)), vec2(0.5))) ? abs(_118 - _113) : 131008.0) < (all(lessThanEqual(abs(fma(_96, parameters.gOutputSize.zw, _161) - vec2(0.5)), vec2(0.5))) ? abs(_176) : 65504.0)));
        float _185 = _184.x;
        vec3 _192 = vec3((_98 * _185) + (_161 * _184.y), _185);
        vec2 _199 = vec2(0.0, parameters.gOutputSize.w);
        float _214 = _133 - _113;
        vec2 _222 = mix(vec2(_214, _133), vec2(_113 - _123, _123), bvec2((all(lessThanEqual(abs(fma(_96, parameters.gOutputSize.zw, -_199) - vec2(0.5)), vec2(0.5))) ? abs(_123 - _113) : 131008.0) < (all(lessThanEqual(abs(fma(_96, parameters.gOutputSize.zw, _199) - vec2(0.5)), vec2(0.5))) ? abs(_214) : 65504.0)));
        float _223 = _222.x;
        vec3 _230 = vec3((_98 * _223) + (_199 * _222.y), _223);
        vec3 _235 = cross(vec3(dot(parameters.gToShadowX.xyz, _192), dot(parameters.gToShadowY.xyz, _192), dot(parameters.gToShadowZ.xyz, _192)), vec3(dot(parameters.gToShadowX.xyz, _230), dot(parameters.gToShadowY.xyz, _230), dot(parameters.gToShadowZ.xyz, _230)));
        float _236 = _235.z;
        bool _260 = _113 > parameters.gCascadeFar.x;
        bvec3 _261 = bvec3(_260);
        bool _273 = _113 > parameters.gCascadeFar.y;
        bvec3 _274 = bvec3(_273);
        vec3 _275 = mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _261), parameters.gCascadeScale2.xyz, _274);
        float _278 = float(_260) + float(_273);
        vec3 _279 = fma(vec3(dot(parameters.gToShadowX.xyz, _137), dot(parameters.gToShadowY.xyz, _137), dot(parameters.gToShadowZ.xyz, _137)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _275, mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _261), parameters.gCascadeOffset2.xyz, _274));
        float _280 = _275.z;
        vec2 _281 = _275.xy;
        vec2 _284 = clamp((-_235.xy) / vec2((abs(_236) > 9.9999996826552253889678874634872e-21) ? _236 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_280) / _281);
        vec2 _292 = max(parameters.gDisc.xy * _281, vec2(parameters.gDisc.z));
        float _297 = fma(parameters.gBias.y, _113, parameters.gBias.x);
        vec2 _301 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _304 = floor(_96);
        float _309 = floor(parameters.gSubsetCount);
        float _312 = (_309 > 1.0) ? min(_309, 16.0) : 1.0;
        float _316 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _322 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_312, floor((_316 + 0.5) / _312), _316);
        vec2 _325 = floor(_304 * 0.5);
        vec2 _327 = _304 - (_325 * 2.0);
        vec2 _331 = _325 - (floor(_304 * 0.25) * 2.0);
        float _333 = _327.y;
        float _336 = _331.y;
        vec2 _342 = (abs(vec2(_327.x - _333, _331.x - _336)) * 2.0) + vec2(_333, _336);
        float _347 = 6.283185482025146484375 * fma(fma(4.0, _342.x, _342.y), 0.0625, _322.x);
        float _348 = cos(_347);
        float _349 = sin(_347);
        vec2 _354 = vec2(_304.y + 1.0, _304.x);
        vec2 _356 = floor(_354 * 0.5);
        vec2 _358 = _354 - (_356 * 2.0);
        vec2 _362 = _356 - (floor(_354 * 0.25) * 2.0);
        float _364 = _358.y;
        float _367 = _362.y;
        vec2 _373 = (abs(vec2(_358.x - _364, _362.x - _367)) * 2.0) + vec2(_364, _367);
        float _377 = fma(fma(4.0, _373.x, _373.y), 0.0625, _322.y);
        vec2 _378 = fract(vec2(0.5));
        float _380 = 6.283185482025146484375 * _378.x;
        float _381 = cos(_380);
        float _382 = sin(_380);
        vec2 _398 = clamp(floor(fma(_292 * sqrt(fract(_378.y + _377)), vec2(fma(_381, _348, -(_382 * _349)), fma(_381, _349, _382 * _348)), _279.xy)) + vec2(0.5), vec2(0.5), _301);
        vec2 _418 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _420 = 6.283185482025146484375 * _418.x;
        float _421 = cos(_420);
        float _422 = sin(_420);
        vec2 _437 = clamp(floor(fma(_292 * sqrt(fract(_418.y + _377)), vec2(fma(_421, _348, -(_422 * _349)), fma(_421, _349, _422 * _348)), _279.xy)) + vec2(0.5), vec2(0.5), _301);
        vec2 _454 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _456 = 6.283185482025146484375 * _454.x;
        float _457 = cos(_456);
        float _458 = sin(_456);
        vec2 _473 = clamp(floor(fma(_292 * sqrt(fract(_454.y + _377)), vec2(fma(_457, _348, -(_458 * _349)), fma(_457, _349, _458 * _348)), _279.xy)) + vec2(0.5), vec2(0.5), _301);
        vec2 _490 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _492 = 6.283185482025146484375 * _490.x;
        float _493 = cos(_492);
        float _494 = sin(_492);
        vec2 _509 = clamp(floor(fma(_292 * sqrt(fract(_490.y + _377)), vec2(fma(_493, _348, -(_494 * _349)), fma(_493, _349, _494 * _348)), _279.xy)) + vec2(0.5), vec2(0.5), _301);
        float _533 = -(((float(textureLod(gInShadowMap, vec2(fma(_278, parameters.gCascadeSize.x, _398.x), _398.y) * parameters.gCascadeSize.zw, 0.0).x > fma(_297, _280, max(_279.z + dot(_284, _398 - _279.xy), 0.0))) + float(textureLod(gInShadowMap, vec2(fma(_278, parameters.gCascadeSize.x, _437.x), _437.y) * parameters.gCascadeSize.zw, 0.0).x > fma(_297, _280, max(_279.z + dot(_284, _437 - _279.xy), 0.0)))) + float(textureLod(gInShadowMap, vec2(fma(_278, parameters.gCascadeSize.x, _473.x), _473.y) * parameters.gCascadeSize.zw, 0.0).x > fma(_297, _280, max(_279.z + dot(_284, _473 - _279.xy), 0.0)))) + float(textureLod(gInShadowMap, vec2(fma(_278, parameters.gCascadeSize.x, _509.x), _509.y) * parameters.gCascadeSize.zw, 0.0).x > fma(_297, _280, max(_279.z + dot(_284, _509 - _279.xy), 0.0))));
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_113 < 65504.0) ? ((all(lessThanEqual(abs((_279.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_113 <= parameters.gCascadeFar.z)) ? fma(_533, 0.25, 1.0) : 1.0) : 1.0, _113, 0.0, 0.0));
        break;
    } while(false);
}

