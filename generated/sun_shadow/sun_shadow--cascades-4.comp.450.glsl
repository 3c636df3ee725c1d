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
        vec2 _98 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _100 = _98 * parameters.gOutputSize.zw;
        vec2 _104 = parameters.gOutputSize.zw * 0.5;
        vec4 _107 = textureGather(gInCoarseDepth, fma(_98, parameters.gOutputSize.zw, -_104));
        vec4 _110 = textureGather(gInCoarseDepth, fma(_98, parameters.gOutputSize.zw, _104));
        float _111 = _107.y;
        float _113 = (_111 > 0.0) ? _111 : 65504.0;
        float _115 = (_113 < 65504.0) ? _113 : 65504.0;
        float _116 = _107.x;
        float _118 = (_116 > 0.0) ? _116 : 65504.0;
        float _120 = (_118 < 65504.0) ? _118 : 65504.0;
        float _121 = _107.z;
        float _123 = (_121 > 0.0) ? _121 : 65504.0;
        float _125 = (_123 < 65504.0) ? _123 : 65504.0;
        float _126 = _110.z;
        float _128 = (_126 > 0.0) ? _126 : 65504.0;
        float _130 = (_128 < 65504.0) ? _128 : 65504.0;
        float _131 = _110.x;
        float _133 = (_131 > 0.0) ? _131 : 65504.0;
        float _135 = (_133 < 65504.0) ? _133 : 65504.0;
        vec3 _139 = vec3(_100 * _115, _115);
        vec2 _163 = vec2(parameters.gOutputSize.z, 0.0);
        float _178 = _130 - _115;
        vec2 _186 = mix(vec2(_178, _130), vec2(_115 - _120, _120), bvec2((all(lessThanEqual(abs(fma(_98, parameters.gOutputSize.zw, -_163) - vec2(0.5)), vec2(0.5))) ? abs(_120 - _115) : 131008.0) < (all(lessThanEqual(abs(fma(_98, parameters.gOutputSize.zw, _163) - vec2(0.5)), vec2(0.5))) ? abs(_178) : 65504.0)));
        float _187 = _186.x;
        vec3 _194 = vec3((_100 * _187) + (_163 * _186.y), _187);
        vec2 _201 = vec2(0.0, parameters.gOutputSize.w);
        float _216 = _135 - _115;
        vec2 _224 = mix(vec2(_216, _135), vec2(_115 - _125, _125), bvec2((all(lessThanEqual(abs(fma(_98, parameters.gOutputSize.zw, -_201) - vec2(0.5)), vec2(0.5))) ? abs(_125 - _115) : 131008.0) < (all(lessThanEqual(abs(fma(_98, parameters.gOutputSize.zw, _201) - vec2(0.5)), vec2(0.5))) ? abs(_216) : 65504.0)));
        float _225 = _224.x;
        vec3 _232 = vec3((_100 * _225) + (_201 * _224.y), _225);
        vec3 _237 = cross(vec3(dot(parameters.gToShadowX.xyz, _194), dot(parameters.gToShadowY.xyz, _194), dot(parameters.gToShadowZ.xyz, _194)), vec3(dot(parameters.gToShadowX.xyz, _232), dot(parameters.gToShadowY.xyz, _232), dot(parameters.gToShadowZ.xyz, _232)));
        float _238 = _237.z;
        bool _262 = _115 > parameters.gCascadeFar.x;
        bvec3 _263 = bvec3(_262);
        bool _275 = _115 > parameters.gCascadeFar.y;
        bvec3 _276 = bvec3(_275);
        bool _289 = _115 > parameters.gCascadeFar.z;
        bvec3 _290 = bvec3(_289);
        vec3 _291 = mix(mix(mix(vec3(1.0), parameters.gCascadeScale1.xyz, _263), parameters.gCascadeScale2.xyz, _276), parameters.gCascadeScale3.xyz, _290);
        float _294 = (float(_262) + float(_275)) + float(_289);
        vec3 _295 = fma(vec3(dot(parameters.gToShadowX.xyz, _139), dot(parameters.gToShadowY.xyz, _139), dot(parameters.gToShadowZ.xyz, _139)) + vec3(parameters.gToShadowX.w, parameters.gToShadowY.w, parameters.gToShadowZ.w), _291, mix(mix(mix(vec3(0.0), parameters.gCascadeOffset1.xyz, _263), parameters.gCascadeOffset2.xyz, _276), parameters.gCascadeOffset3.xyz, _290));
        float _296 = _291.z;
        vec2 _297 = _291.xy;
        vec2 _300 = clamp((-_237.xy) / vec2((abs(_238) > 9.9999996826552253889678874634872e-21) ? _238 : 9.9999996826552253889678874634872e-21), vec2(-parameters.gBias.z), vec2(parameters.gBias.z)) * (vec2(_296) / _297);
        vec2 _308 = max(parameters.gDisc.xy * _297, vec2(parameters.gDisc.z));
        vec2 _317 = parameters.gCascadeSize.xy - vec2(0.5);
        vec2 _320 = floor(_98);
        float _325 = floor(parameters.gSubsetCount);
        float _328 = (_325 > 1.0) ? min(_325, 16.0) : 1.0;
        float _332 = floor((parameters.gFrameIndex > 0.0) ? min(parameters.gFrameIndex, 1048576.0) : 0.0);
        vec2 _338 = vec2(0.019510664045810699462890625, 0.2793611586093902587890625) * fma(-_328, floor((_332 + 0.5) / _328), _332);
        vec2 _341 = floor(_320 * 0.5);
        vec2 _343 = _320 - (_341 * 2.0);
        vec2 _347 = _341 - (floor(_320 * 0.25) * 2.0);
        float _349 = _343.y;
        float _352 = _347.y;
        vec2 _358 = (abs(vec2(_343.x - _349, _347.x - _352)) * 2.0) + vec2(_349, _352);
        float _363 = 6.283185482025146484375 * fma(fma(4.0, _358.x, _358.y), 0.0625, _338.x);
        float _364 = cos(_363);
        float _365 = sin(_363);
        vec2 _370 = vec2(_320.y + 1.0, _320.x);
        vec2 _372 = floor(_370 * 0.5);
        vec2 _374 = _370 - (_372 * 2.0);
        vec2 _378 = _372 - (floor(_370 * 0.25) * 2.0);
        float _380 = _374.y;
        float _383 = _378.y;
        vec2 _389 = (abs(vec2(_374.x - _380, _378.x - _383)) * 2.0) + vec2(_380, _383);
        float _393 = fma(fma(4.0, _389.x, _389.y), 0.0625, _338.y);
        vec2 _394 = fract(vec2(0.5));
        float _396 = 6.283185482025146484375 * _394.x;
        float _397 = cos(_396);
        float _398 = sin(_396);
        vec2 _414 = clamp(floor(fma(_308 * sqrt(fract(_394.y + _393)), vec2(fma(_397, _364, -(_398 * _365)), fma(_397, _365, _398 * _364)), _295.xy)) + vec2(0.5), vec2(0.5), _317);
        float _431 = -fma(parameters.gBias.y, _115, parameters.gBias.x);
        vec2 _435 = fract(vec2(1.25487768650054931640625, 1.06984031200408935546875));
        float _437 = 6.283185482025146484375 * _435.x;
        float _438 = cos(_437);
        float _439 = sin(_437);
        vec2 _454 = clamp(floor(fma(_308 * sqrt(fract(_435.y + _393)), vec2(fma(_438, _364, -(_439 * _365)), fma(_438, _365, _439 * _364)), _295.xy)) + vec2(0.5), vec2(0.5), _317);
        vec2 _471 = fract(vec2(2.0097553730010986328125, 1.6396806240081787109375));
        float _473 = 6.283185482025146484375 * _471.x;
        float _474 = cos(_473);
        float _475 = sin(_473);
        vec2 _490 = clamp(floor(fma(_308 * sqrt(fract(_471.y + _393)), vec2(fma(_474, _364, -(_475 * _365)), fma(_474, _365, _475 * _364)), _295.xy)) + vec2(0.5), vec2(0.5), _317);
        vec2 _507 = fract(vec2(2.7646331787109375, 2.209520816802978515625));
        float _509 = 6.283185482025146484375 * _507.x;
        float _510 = cos(_509);
        float _511 = sin(_509);
        vec2 _526 = clamp(floor(fma(_308 * sqrt(fract(_507.y + _393)), vec2(fma(_510, _364, -(_511 * _365)), fma(_510, _365, _511 * _364)), _295.xy)) + vec2(0.5), vec2(0.5), _317);
        float _550 = -(((float(textureLod(gInShadowMap, vec2(fma(_294, parameters.gCascadeSize.x, _414.x), _414.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_431, _296, min(_295.z + dot(_300, _414 - _295.xy), 1.0))) + float(textureLod(gInShadowMap, vec2(fma(_294, parameters.gCascadeSize.x, _454.x), _454.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_431, _296, min(_295.z + dot(_300, _454 - _295.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_294, parameters.gCascadeSize.x, _490.x), _490.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_431, _296, min(_295.z + dot(_300, _490 - _295.xy), 1.0)))) + float(textureLod(gInShadowMap, vec2(fma(_294, parameters.gCascadeSize.x, _526.x), _526.y) * parameters.gCascadeSize.zw, 0.0).x < fma(_431, _296, min(_295.z + dot(_300, _526 - _295.xy), 1.0))));
        imageStore(gOutShadow, ivec2(gl_GlobalInvocationID.xy), vec4((_115 < 65504.0) ? ((all(lessThanEqual(abs((_295.xy / parameters.gCascadeSize.xy) - vec2(0.5)), vec2(0.5))) && (_115 <= parameters.gCascadeFar.w)) ? fma(_550, 0.25, 1.0) : 1.0) : 1.0, _115, 0.0, 0.0));
        break;
    } while(false);
}

