#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralFilterParameters
{
    vec4 gOutputSize;
    vec2 gDirection;
    vec2 gDepthAmplitude;
    float gConverged;
    float gMaxSmoothing;
    float gMinSmoothing;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutFiltered;
layout(binding = 3) uniform sampler2D gInCacheState;
layout(binding = 1) uniform sampler2D gInCache;
layout(binding = 2) uniform sampler2D gInCacheFiltered;

void main()
{
    do
    {
        ivec2 _71 = ivec2(2) * ivec2(gl_GlobalInvocationID.xy);
        ivec2 _75 = ivec2(parameters.gOutputSize.xy);
        if (any(greaterThanEqual(_71, _75)))
        {
            break;
        }
        vec2 _81 = vec2(_71) + vec2(0.5);
        vec2 _83 = _81 * parameters.gOutputSize.zw;
        vec2 _86 = parameters.gDirection * parameters.gOutputSize.zw;
        vec4 _94 = textureLod(gInCache, _83, 0.0);
        float _95 = _94.x;
        float _96 = _94.y;
        vec2 _97 = _86 * (-3.5);
        vec4 _102 = textureLod(gInCacheFiltered, fma(_81, parameters.gOutputSize.zw, _97), 0.0);
        float _103 = _102.x;
        vec2 _105 = _86 * (-1.5);
        vec4 _108 = textureLod(gInCacheFiltered, fma(_81, parameters.gOutputSize.zw, _105), 0.0);
        float _109 = _108.x;
        vec2 _111 = _86 * 1.5;
        vec4 _114 = textureLod(gInCacheFiltered, fma(_81, parameters.gOutputSize.zw, _111), 0.0);
        float _115 = _114.x;
        vec2 _117 = _86 * 3.5;
        vec4 _120 = textureLod(gInCacheFiltered, fma(_81, parameters.gOutputSize.zw, _117), 0.0);
        float _121 = _120.x;
        float _128 = max(parameters.gConverged, 1.0);
        float _129 = textureLod(gInCacheState, _83, 0.0).x / _128;
        float _137 = ((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0;
        float _142 = (fma(_137, 1.0 - ((_129 > 0.0) ? min(_129, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _145 = (_142 > 0.0) ? min(_142, 16.0) : 0.0;
        float _151 = min(_96, 65504.0);
        float _154 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_96 > 0.001000000047497451305389404296875) ? _151 : 0.001000000047497451305389404296875));
        float _156 = abs(_102.y - _96);
        float _160 = (_154 > 0.0) ? min(_154, 9.9999996169031624536541560020822e+35) : 0.0;
        float _165 = 0.0544886849820613861083984375 * (_145 * ((_156 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _156, 1.0)) : 0.0));
        bool _167 = abs(_103) <= 65504.0;
        float _172 = abs(_108.y - _96);
        float _178 = 0.24420134723186492919921875 * (_145 * ((_172 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _172, 1.0)) : 0.0));
        bool _180 = abs(_109) <= 65504.0;
        bool _187 = abs(_95) <= 65504.0;
        float _194 = abs(_114.y - _96);
        float _200 = 0.24420134723186492919921875 * (_145 * ((_194 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _194, 1.0)) : 0.0));
        bool _202 = abs(_115) <= 65504.0;
        float _209 = abs(_120.y - _96);
        float _215 = 0.0544886849820613861083984375 * (_145 * ((_209 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_160, _209, 1.0)) : 0.0));
        bool _217 = abs(_121) <= 65504.0;
        float _222 = ((((_167 ? _165 : 0.0) + (_180 ? _178 : 0.0)) + (_187 ? 0.40261995792388916015625 : 0.0)) + (_202 ? _200 : 0.0)) + (_217 ? _215 : 0.0);
        if (all(lessThan(_71, _75)))
        {
            imageStore(gOutFiltered, _71, vec4((_222 > 1.0000000031710768509710513471353e-30) ? ((((((_167 ? (_165 * _103) : 0.0) + (_180 ? (_178 * _109) : 0.0)) + (_187 ? (0.40261995792388916015625 * _95) : 0.0)) + (_202 ? (_200 * _115) : 0.0)) + (_217 ? (_215 * _121) : 0.0)) * (1.0 / _222)) : 0.0, (_96 > 0.0) ? _151 : 0.0, 0.0, 0.0));
        }
        ivec2 _235 = _71 + ivec2(1, 0);
        vec2 _237 = vec2(_235) + vec2(0.5);
        vec2 _238 = _237 * parameters.gOutputSize.zw;
        vec4 _242 = textureLod(gInCache, _238, 0.0);
        float _243 = _242.x;
        float _244 = _242.y;
        vec4 _247 = textureLod(gInCacheFiltered, fma(_237, parameters.gOutputSize.zw, _97), 0.0);
        float _248 = _247.x;
        vec4 _252 = textureLod(gInCacheFiltered, fma(_237, parameters.gOutputSize.zw, _105), 0.0);
        float _253 = _252.x;
        vec4 _257 = textureLod(gInCacheFiltered, fma(_237, parameters.gOutputSize.zw, _111), 0.0);
        float _258 = _257.x;
        vec4 _262 = textureLod(gInCacheFiltered, fma(_237, parameters.gOutputSize.zw, _117), 0.0);
        float _263 = _262.x;
        float _266 = textureLod(gInCacheState, _238, 0.0).x / _128;
        float _273 = (fma(_137, 1.0 - ((_266 > 0.0) ? min(_266, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _276 = (_273 > 0.0) ? min(_273, 16.0) : 0.0;
        float _278 = min(_244, 65504.0);
        float _281 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_244 > 0.001000000047497451305389404296875) ? _278 : 0.001000000047497451305389404296875));
        float _283 = abs(_247.y - _244);
        float _287 = (_281 > 0.0) ? min(_281, 9.9999996169031624536541560020822e+35) : 0.0;
        float _292 = 0.0544886849820613861083984375 * (_276 * ((_283 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_287, _283, 1.0)) : 0.0));
        bool _294 = abs(_248) <= 65504.0;
        float _299 = abs(_252.y - _244);
        float _305 = 0.24420134723186492919921875 * (_276 * ((_299 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_287, _299, 1.0)) : 0.0));
        bool _307 = abs(_253) <= 65504.0;
        bool _314 = abs(_243) <= 65504.0;
        float _321 = abs(_257.y - _244);
        float _327 = 0.24420134723186492919921875 * (_276 * ((_321 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_287, _321, 1.0)) : 0.0));
        bool _329 = abs(_258) <= 65504.0;
        float _336 = abs(_262.y - _244);
        float _342 = 0.0544886849820613861083984375 * (_276 * ((_336 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_287, _336, 1.0)) : 0.0));
        bool _344 = abs(_263) <= 65504.0;
        float _349 = ((((_294 ? _292 : 0.0) + (_307 ? _305 : 0.0)) + (_314 ? 0.40261995792388916015625 : 0.0)) + (_329 ? _327 : 0.0)) + (_344 ? _342 : 0.0);
        if (all(lessThan(_235, _75)))
        {
            imageStore(gOutFiltered, _235, vec4((_349 > 1.0000000031710768509710513471353e-30) ? ((((((_294 ? (_292 * _248) : 0.0) + (_307 ? (_305 * _253) : 0.0)) + (_314 ? (0.40261995792388916015625 * _243) : 0.0)) + (_329 ? (_327 * _258) : 0.0)) + (_344 ? (_342 * _263) : 0.0)) * (1.0 / _349)) : 0.0, (_244 > 0.0) ? _278 : 0.0, 0.0, 0.0));
        }
        ivec2 _362 = _71 + ivec2(0, 1);
        vec2 _364 = vec2(_362) + vec2(0.5);
        vec2 _365 = _364 * parameters.gOutputSize.zw;
        vec4 _369 = textureLod(gInCache, _365, 0.0);
        float _370 = _369.x;
        float _371 = _369.y;
        vec4 _374 = textureLod(gInCacheFiltered, fma(_364, parameters.gOutputSize.zw, _97), 0.0);
        float _375 = _374.x;
        vec4 _379 = textureLod(gInCacheFiltered, fma(_364, parameters.gOutputSize.zw, _105), 0.0);
        float _380 = _379.x;
        vec4 _384 = textureLod(gInCacheFiltered, fma(_364, parameters.gOutputSize.zw, _111), 0.0);
        float _385 = _384.x;
        vec4 _389 = textureLod(gInCacheFiltered, fma(_364, parameters.gOutputSize.zw, _117), 0.0);
        float _390 = _389.x;
        float _393 = textureLod(gInCacheState, _365, 0.0).x / _128;
        float _400 = (fma(_137, 1.0 - ((_393 > 0.0) ? min(_393, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _403 = (_400 > 0.0) ? min(_400, 16.0) : 0.0;
        float _405 = min(_371, 65504.0);
        float _408 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_371 > 0.001000000047497451305389404296875) ? _405 : 0.001000000047497451305389404296875));
        float _410 = abs(_374.y - _371);
        float _414 = (_408 > 0.0) ? min(_408, 9.9999996169031624536541560020822e+35) : 0.0;
        float _419 = 0.0544886849820613861083984375 * (_403 * ((_410 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_414, _410, 1.0)) : 0.0));
        bool _421 = abs(_375) <= 65504.0;
        float _426 = abs(_379.y - _371);
        float _432 = 0.24420134723186492919921875 * (_403 * ((_426 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_414, _426, 1.0)) : 0.0));
        bool _434 = abs(_380) <= 65504.0;
        bool _441 = abs(_370) <= 65504.0;
        float _448 = abs(_384.y - _371);
        float _454 = 0.24420134723186492919921875 * (_403 * ((_448 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_414, _448, 1.0)) : 0.0));
        bool _456 = abs(_385) <= 65504.0;
        float _463 = abs(_389.y - _371);
        float _469 = 0.0544886849820613861083984375 * (_403 * ((_463 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_414, _463, 1.0)) : 0.0));
        bool _471 = abs(_390) <= 65504.0;
        float _476 = ((((_421 ? _419 : 0.0) + (_434 ? _432 : 0.0)) + (_441 ? 0.40261995792388916015625 : 0.0)) + (_456 ? _454 : 0.0)) + (_471 ? _469 : 0.0);
        if (all(lessThan(_362, _75)))
        {
            imageStore(gOutFiltered, _362, vec4((_476 > 1.0000000031710768509710513471353e-30) ? ((((((_421 ? (_419 * _375) : 0.0) + (_434 ? (_432 * _380) : 0.0)) + (_441 ? (0.40261995792388916015625 * _370) : 0.0)) + (_456 ? (_454 * _385) : 0.0)) + (_471 ? (_469 * _390) : 0.0)) * (1.0 / _476)) : 0.0, (_371 > 0.0) ? _405 : 0.0, 0.0, 0.0));
        }
        ivec2 _489 = _71 + ivec2(1);
        vec2 _491 = vec2(_489) + vec2(0.5);
        vec2 _492 = _491 * parameters.gOutputSize.zw;
        vec4 _496 = textureLod(gInCache, _492, 0.0);
        float _497 = _496.x;
        float _498 = _496.y;
        vec4 _501 = textureLod(gInCacheFiltered, fma(_491, parameters.gOutputSize.zw, _97), 0.0);
        float _502 = _501.x;
        vec4 _506 = textureLod(gInCacheFiltered, fma(_491, parameters.gOutputSize.zw, _105), 0.0);
        float _507 = _506.x;
        vec4 _511 = textureLod(gInCacheFiltered, fma(_491, parameters.gOutputSize.zw, _111), 0.0);
        float _512 = _511.x;
        vec4 _516 = textureLod(gInCacheFiltered, fma(_491, parameters.gOutputSize.zw, _117), 0.0);
        float _517 = _516.x;
        float _520 = textureLod(gInCacheState, _492, 0.0).x / _128;
        float _527 = (fma(_137, 1.0 - ((_520 > 0.0) ? min(_520, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _530 = (_527 > 0.0) ? min(_527, 16.0) : 0.0;
        float _532 = min(_498, 65504.0);
        float _535 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_498 > 0.001000000047497451305389404296875) ? _532 : 0.001000000047497451305389404296875));
        float _537 = abs(_501.y - _498);
        float _541 = (_535 > 0.0) ? min(_535, 9.9999996169031624536541560020822e+35) : 0.0;
        float _546 = 0.0544886849820613861083984375 * (_530 * ((_537 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_541, _537, 1.0)) : 0.0));
        bool _548 = abs(_502) <= 65504.0;
        float _553 = abs(_506.y - _498);
        float _559 = 0.24420134723186492919921875 * (_530 * ((_553 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_541, _553, 1.0)) : 0.0));
        bool _561 = abs(_507) <= 65504.0;
        bool _568 = abs(_497) <= 65504.0;
        float _575 = abs(_511.y - _498);
        float _581 = 0.24420134723186492919921875 * (_530 * ((_575 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_541, _575, 1.0)) : 0.0));
        bool _583 = abs(_512) <= 65504.0;
        float _590 = abs(_516.y - _498);
        float _596 = 0.0544886849820613861083984375 * (_530 * ((_590 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_541, _590, 1.0)) : 0.0));
        bool _598 = abs(_517) <= 65504.0;
        float _603 = ((((_548 ? _546 : 0.0) + (_561 ? _559 : 0.0)) + (_568 ? 0.40261995792388916015625 : 0.0)) + (_583 ? _581 : 0.0)) + (_598 ? _596 : 0.0);
        if (all(lessThan(_489, _75)))
        {
            imageStore(gOutFiltered, _489, vec4((_603 > 1.0000000031710768509710513471353e-30) ? ((((((_548 ? (_546 * _502) : 0.0) + (_561 ? (_559 * _507) : 0.0)) + (_568 ? (0.40261995792388916015625 * _497) : 0.0)) + (_583 ? (_581 * _512) : 0.0)) + (_598 ? (_596 * _517) : 0.0)) * (1.0 / _603)) : 0.0, (_498 > 0.0) ? _532 : 0.0, 0.0, 0.0));
        }
        break;
    } while(false);
}

