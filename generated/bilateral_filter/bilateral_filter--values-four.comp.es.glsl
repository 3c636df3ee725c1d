#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

struct Tap
{
    vec4 values;
    float depth;
};

layout(binding = 0, std140) uniform BilateralFilterParameters
{
    vec4 gOutputSize;
    vec2 gDirection;
    vec2 gDepthAmplitude;
    float gConverged;
    float gMaxSmoothing;
    float gMinSmoothing;
} parameters;

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutFiltered;
layout(binding = 1) uniform highp sampler2D gInCache;
layout(binding = 3) uniform highp sampler2D gInCacheState;

void main()
{
    do
    {
        ivec2 _85 = ivec2(2) * ivec2(gl_GlobalInvocationID.xy);
        ivec2 _89 = ivec2(parameters.gOutputSize.xy);
        if (any(greaterThanEqual(_85, _89)))
        {
            break;
        }
        bool _98 = parameters.gDirection.x > parameters.gDirection.y;
        vec2 _100 = vec2(_85) + vec2(1.0);
        vec2 _106 = (_100 + (parameters.gDirection * (-4.0))) * parameters.gOutputSize.zw;
        vec4 _110 = textureGather(gInCache, _106);
        vec4 _112 = textureGather(gInCache, _106, 1);
        vec4 _114 = textureGather(gInCache, _106, 2);
        vec4 _116 = textureGather(gInCache, _106, 3);
        vec4 _120 = textureGather(gInCacheState, _106, 1);
        vec4 _125 = vec4(_110.x, _112.x, _114.x, _116.x);
        float _126 = _120.x;
        vec4 _137 = vec4(_110.z, _112.z, _114.z, _116.z);
        float _138 = _120.z;
        bvec4 _145 = bvec4(_98);
        vec2 _152 = (_100 + (parameters.gDirection * (-2.0))) * parameters.gOutputSize.zw;
        vec4 _154 = textureGather(gInCache, _152);
        vec4 _156 = textureGather(gInCache, _152, 1);
        vec4 _158 = textureGather(gInCache, _152, 2);
        vec4 _160 = textureGather(gInCache, _152, 3);
        vec4 _162 = textureGather(gInCacheState, _152, 1);
        vec4 _167 = vec4(_154.x, _156.x, _158.x, _160.x);
        float _168 = _162.x;
        vec4 _179 = vec4(_154.z, _156.z, _158.z, _160.z);
        float _180 = _162.z;
        vec2 _191 = _100 * parameters.gOutputSize.zw;
        vec4 _193 = textureGather(gInCache, _191);
        vec4 _195 = textureGather(gInCache, _191, 1);
        vec4 _197 = textureGather(gInCache, _191, 2);
        vec4 _199 = textureGather(gInCache, _191, 3);
        vec4 _201 = textureGather(gInCacheState, _191, 1);
        vec4 _206 = vec4(_193.x, _195.x, _197.x, _199.x);
        float _207 = _201.x;
        vec4 _218 = vec4(_193.z, _195.z, _197.z, _199.z);
        float _219 = _201.z;
        vec2 _232 = (_100 + (parameters.gDirection * 2.0)) * parameters.gOutputSize.zw;
        vec4 _234 = textureGather(gInCache, _232);
        vec4 _236 = textureGather(gInCache, _232, 1);
        vec4 _238 = textureGather(gInCache, _232, 2);
        vec4 _240 = textureGather(gInCache, _232, 3);
        vec4 _242 = textureGather(gInCacheState, _232, 1);
        vec4 _247 = vec4(_234.x, _236.x, _238.x, _240.x);
        float _248 = _242.x;
        vec4 _259 = vec4(_234.z, _236.z, _238.z, _240.z);
        float _260 = _242.z;
        vec2 _273 = (_100 + (parameters.gDirection * 4.0)) * parameters.gOutputSize.zw;
        vec4 _275 = textureGather(gInCache, _273);
        vec4 _277 = textureGather(gInCache, _273, 1);
        vec4 _279 = textureGather(gInCache, _273, 2);
        vec4 _281 = textureGather(gInCache, _273, 3);
        vec4 _283 = textureGather(gInCacheState, _273, 1);
        vec4 _288 = vec4(_275.x, _277.x, _279.x, _281.x);
        float _289 = _283.x;
        vec4 _300 = vec4(_275.z, _277.z, _279.z, _281.z);
        float _301 = _283.z;
        vec4 _313 = textureGather(gInCacheState, _191);
        ivec2 _315 = mix(ivec2(0, 1), ivec2(1, 0), bvec2(_98));
        Tap _326[10] = Tap[](Tap(vec4(_110.w, _112.w, _114.w, _116.w), _120.w), Tap(mix(_125, _137, _145), _98 ? _138 : _126), Tap(vec4(_154.w, _156.w, _158.w, _160.w), _162.w), Tap(mix(_167, _179, _145), _98 ? _180 : _168), Tap(vec4(_193.w, _195.w, _197.w, _199.w), _201.w), Tap(mix(_206, _218, _145), _98 ? _219 : _207), Tap(vec4(_234.w, _236.w, _238.w, _240.w), _242.w), Tap(mix(_247, _259, _145), _98 ? _260 : _248), Tap(vec4(_275.w, _277.w, _279.w, _281.w), _283.w), Tap(mix(_288, _300, _145), _98 ? _301 : _289));
        Tap _76[10] = _326;
        float _328 = floor(-3.5);
        int _329 = int(_328);
        int _330 = 4 + _329;
        float _331 = ceil(-3.5);
        int _332 = int(_331);
        int _333 = 4 + _332;
        vec4 _343 = (_76[_330].values + _76[_333].values) * 0.5;
        float _345 = floor(-1.5);
        int _346 = int(_345);
        int _347 = 4 + _346;
        float _348 = ceil(-1.5);
        int _349 = int(_348);
        int _350 = 4 + _349;
        vec4 _360 = (_76[_347].values + _76[_350].values) * 0.5;
        float _364 = floor(1.5);
        int _365 = int(_364);
        int _366 = 4 + _365;
        float _367 = ceil(1.5);
        int _368 = int(_367);
        int _369 = 4 + _368;
        vec4 _379 = (_76[_366].values + _76[_369].values) * 0.5;
        float _381 = floor(3.5);
        int _382 = int(_381);
        int _383 = 4 + _382;
        float _384 = ceil(3.5);
        int _385 = int(_384);
        int _386 = 4 + _385;
        vec4 _396 = (_76[_383].values + _76[_386].values) * 0.5;
        float _404 = max(parameters.gConverged, 1.0);
        float _405 = _313.w / _404;
        float _413 = ((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0;
        float _418 = ((_413 * (1.0 - ((_405 > 0.0) ? min(_405, 1.0) : 0.0)) + 1.0) - 1.0) + parameters.gMinSmoothing;
        float _421 = (_418 > 0.0) ? min(_418, 16.0) : 0.0;
        float _430 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_76[4].depth > 0.001000000047497451305389404296875) ? min(_76[4].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _431 = -_76[4].depth;
        float _433 = abs(0.5 * (_76[_330].depth + _76[_333].depth) + _431);
        float _437 = (_430 > 0.0) ? min(_430, 9.9999996169031624536541560020822e+35) : 0.0;
        float _442 = 0.0544886849820613861083984375 * (_421 * ((_433 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_437 * _433 + 1.0)) : 0.0));
        bool _445 = all(lessThanEqual(abs(_343), vec4(65504.0)));
        float _451 = abs(0.5 * (_76[_347].depth + _76[_350].depth) + _431);
        float _457 = 0.24420134723186492919921875 * (_421 * ((_451 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_437 * _451 + 1.0)) : 0.0));
        bool _460 = all(lessThanEqual(abs(_360), vec4(65504.0)));
        bool _469 = all(lessThanEqual(abs(_76[4].values), vec4(65504.0)));
        float _477 = abs(0.5 * (_76[_366].depth + _76[_369].depth) + _431);
        float _483 = 0.24420134723186492919921875 * (_421 * ((_477 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_437 * _477 + 1.0)) : 0.0));
        bool _486 = all(lessThanEqual(abs(_379), vec4(65504.0)));
        float _494 = abs(0.5 * (_76[_383].depth + _76[_386].depth) + _431);
        float _500 = 0.0544886849820613861083984375 * (_421 * ((_494 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_437 * _494 + 1.0)) : 0.0));
        bool _503 = all(lessThanEqual(abs(_396), vec4(65504.0)));
        float _509 = ((((_445 ? _442 : 0.0) + (_460 ? _457 : 0.0)) + (_469 ? 0.40261995792388916015625 : 0.0)) + (_486 ? _483 : 0.0)) + (_503 ? _500 : 0.0);
        if (all(lessThan(_85, _89)))
        {
            imageStore(gOutFiltered, _85, mix(vec4(0.0), ((((mix(vec4(0.0), _343 * _442, bvec4(_445)) + mix(vec4(0.0), _360 * _457, bvec4(_460))) + mix(vec4(0.0), _76[4].values * 0.40261995792388916015625, bvec4(_469))) + mix(vec4(0.0), _379 * _483, bvec4(_486))) + mix(vec4(0.0), _396 * _500, bvec4(_503))) * (1.0 / _509), bvec4(_509 > 1.0000000031710768509710513471353e-30)));
        }
        ivec2 _520 = _85 + _315;
        float _521 = _313.z;
        float _522 = _313.x;
        Tap _77[10] = _326;
        int _524 = 5 + _329;
        int _525 = 5 + _332;
        vec4 _535 = (_77[_524].values + _77[_525].values) * 0.5;
        int _537 = 5 + _346;
        int _538 = 5 + _349;
        vec4 _548 = (_77[_537].values + _77[_538].values) * 0.5;
        int _552 = 5 + _365;
        int _553 = 5 + _368;
        vec4 _563 = (_77[_552].values + _77[_553].values) * 0.5;
        int _565 = 5 + _382;
        int _566 = 5 + _385;
        vec4 _576 = (_77[_565].values + _77[_566].values) * 0.5;
        float _580 = (_98 ? _521 : _522) / _404;
        float _587 = ((_413 * (1.0 - ((_580 > 0.0) ? min(_580, 1.0) : 0.0)) + 1.0) - 1.0) + parameters.gMinSmoothing;
        float _590 = (_587 > 0.0) ? min(_587, 16.0) : 0.0;
        float _595 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_77[5].depth > 0.001000000047497451305389404296875) ? min(_77[5].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _596 = -_77[5].depth;
        float _598 = abs(0.5 * (_77[_524].depth + _77[_525].depth) + _596);
        float _602 = (_595 > 0.0) ? min(_595, 9.9999996169031624536541560020822e+35) : 0.0;
        float _607 = 0.0544886849820613861083984375 * (_590 * ((_598 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_602 * _598 + 1.0)) : 0.0));
        bool _610 = all(lessThanEqual(abs(_535), vec4(65504.0)));
        float _616 = abs(0.5 * (_77[_537].depth + _77[_538].depth) + _596);
        float _622 = 0.24420134723186492919921875 * (_590 * ((_616 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_602 * _616 + 1.0)) : 0.0));
        bool _625 = all(lessThanEqual(abs(_548), vec4(65504.0)));
        bool _634 = all(lessThanEqual(abs(_77[5].values), vec4(65504.0)));
        float _642 = abs(0.5 * (_77[_552].depth + _77[_553].depth) + _596);
        float _648 = 0.24420134723186492919921875 * (_590 * ((_642 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_602 * _642 + 1.0)) : 0.0));
        bool _651 = all(lessThanEqual(abs(_563), vec4(65504.0)));
        float _659 = abs(0.5 * (_77[_565].depth + _77[_566].depth) + _596);
        float _665 = 0.0544886849820613861083984375 * (_590 * ((_659 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_602 * _659 + 1.0)) : 0.0));
        bool _668 = all(lessThanEqual(abs(_576), vec4(65504.0)));
        float _674 = ((((_610 ? _607 : 0.0) + (_625 ? _622 : 0.0)) + (_634 ? 0.40261995792388916015625 : 0.0)) + (_651 ? _648 : 0.0)) + (_668 ? _665 : 0.0);
        if (all(lessThan(_520, _89)))
        {
            imageStore(gOutFiltered, _520, mix(vec4(0.0), ((((mix(vec4(0.0), _535 * _607, bvec4(_610)) + mix(vec4(0.0), _548 * _622, bvec4(_625))) + mix(vec4(0.0), _77[5].values * 0.40261995792388916015625, bvec4(_634))) + mix(vec4(0.0), _563 * _648, bvec4(_651))) + mix(vec4(0.0), _576 * _665, bvec4(_668))) * (1.0 / _674), bvec4(_674 > 1.0000000031710768509710513471353e-30)));
        }
        ivec2 _686 = _85 + _315.yx;
        Tap _698[10] = Tap[](Tap(mix(_137, _125, _145), _98 ? _126 : _138), Tap(vec4(_110.y, _112.y, _114.y, _116.y), _120.y), Tap(mix(_179, _167, _145), _98 ? _168 : _180), Tap(vec4(_154.y, _156.y, _158.y, _160.y), _162.y), Tap(mix(_218, _206, _145), _98 ? _207 : _219), Tap(vec4(_193.y, _195.y, _197.y, _199.y), _201.y), Tap(mix(_259, _247, _145), _98 ? _248 : _260), Tap(vec4(_234.y, _236.y, _238.y, _240.y), _242.y), Tap(mix(_300, _288, _145), _98 ? _289 : _301), Tap(vec4(_275.y, _277.y, _279.y, _281.y), _283.y));
        Tap _78[10] = _698;
        vec4 _708 = (_78[_330].values + _78[_333].values) * 0.5;
        vec4 _719 = (_78[_347].values + _78[_350].values) * 0.5;
        vec4 _732 = (_78[_366].values + _78[_369].values) * 0.5;
        vec4 _743 = (_78[_383].values + _78[_386].values) * 0.5;
        float _747 = (_98 ? _522 : _521) / _404;
        float _754 = ((_413 * (1.0 - ((_747 > 0.0) ? min(_747, 1.0) : 0.0)) + 1.0) - 1.0) + parameters.gMinSmoothing;
        float _757 = (_754 > 0.0) ? min(_754, 16.0) : 0.0;
        float _762 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_78[4].depth > 0.001000000047497451305389404296875) ? min(_78[4].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _763 = -_78[4].depth;
        float _765 = abs(0.5 * (_78[_330].depth + _78[_333].depth) + _763);
        float _769 = (_762 > 0.0) ? min(_762, 9.9999996169031624536541560020822e+35) : 0.0;
        float _774 = 0.0544886849820613861083984375 * (_757 * ((_765 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_769 * _765 + 1.0)) : 0.0));
        bool _777 = all(lessThanEqual(abs(_708), vec4(65504.0)));
        float _783 = abs(0.5 * (_78[_347].depth + _78[_350].depth) + _763);
        float _789 = 0.24420134723186492919921875 * (_757 * ((_783 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_769 * _783 + 1.0)) : 0.0));
        bool _792 = all(lessThanEqual(abs(_719), vec4(65504.0)));
        bool _801 = all(lessThanEqual(abs(_78[4].values), vec4(65504.0)));
        float _809 = abs(0.5 * (_78[_366].depth + _78[_369].depth) + _763);
        float _815 = 0.24420134723186492919921875 * (_757 * ((_809 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_769 * _809 + 1.0)) : 0.0));
        bool _818 = all(lessThanEqual(abs(_732), vec4(65504.0)));
        float _826 = abs(0.5 * (_78[_383].depth + _78[_386].depth) + _763);
        float _832 = 0.0544886849820613861083984375 * (_757 * ((_826 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_769 * _826 + 1.0)) : 0.0));
        bool _835 = all(lessThanEqual(abs(_743), vec4(65504.0)));
        float _841 = ((((_777 ? _774 : 0.0) + (_792 ? _789 : 0.0)) + (_801 ? 0.40261995792388916015625 : 0.0)) + (_818 ? _815 : 0.0)) + (_835 ? _832 : 0.0);
        if (all(lessThan(_686, _89)))
        {
            imageStore(gOutFiltered, _686, mix(vec4(0.0), ((((mix(vec4(0.0), _708 * _774, bvec4(_777)) + mix(vec4(0.0), _719 * _789, bvec4(_792))) + mix(vec4(0.0), _78[4].values * 0.40261995792388916015625, bvec4(_801))) + mix(vec4(0.0), _732 * _815, bvec4(_818))) + mix(vec4(0.0), _743 * _832, bvec4(_835))) * (1.0 / _841), bvec4(_841 > 1.0000000031710768509710513471353e-30)));
        }
        ivec2 _852 = _85 + ivec2(1);
        Tap _79[10] = _698;
        vec4 _863 = (_79[_524].values + _79[_525].values) * 0.5;
        vec4 _874 = (_79[_537].values + _79[_538].values) * 0.5;
        vec4 _887 = (_79[_552].values + _79[_553].values) * 0.5;
        vec4 _898 = (_79[_565].values + _79[_566].values) * 0.5;
        float _902 = _313.y / _404;
        float _909 = ((_413 * (1.0 - ((_902 > 0.0) ? min(_902, 1.0) : 0.0)) + 1.0) - 1.0) + parameters.gMinSmoothing;
        float _912 = (_909 > 0.0) ? min(_909, 16.0) : 0.0;
        float _917 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_79[5].depth > 0.001000000047497451305389404296875) ? min(_79[5].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _918 = -_79[5].depth;
        float _920 = abs(0.5 * (_79[_524].depth + _79[_525].depth) + _918);
        float _924 = (_917 > 0.0) ? min(_917, 9.9999996169031624536541560020822e+35) : 0.0;
        float _929 = 0.0544886849820613861083984375 * (_912 * ((_920 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_924 * _920 + 1.0)) : 0.0));
        bool _932 = all(lessThanEqual(abs(_863), vec4(65504.0)));
        float _938 = abs(0.5 * (_79[_537].depth + _79[_538].depth) + _918);
        float _944 = 0.24420134723186492919921875 * (_912 * ((_938 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_924 * _938 + 1.0)) : 0.0));
        bool _947 = all(lessThanEqual(abs(_874), vec4(65504.0)));
        bool _956 = all(lessThanEqual(abs(_79[5].values), vec4(65504.0)));
        float _964 = abs(0.5 * (_79[_552].depth + _79[_553].depth) + _918);
        float _970 = 0.24420134723186492919921875 * (_912 * ((_964 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_924 * _964 + 1.0)) : 0.0));
        bool _973 = all(lessThanEqual(abs(_887), vec4(65504.0)));
        float _981 = abs(0.5 * (_79[_565].depth + _79[_566].depth) + _918);
        float _987 = 0.0544886849820613861083984375 * (_912 * ((_981 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_924 * _981 + 1.0)) : 0.0));
        bool _990 = all(lessThanEqual(abs(_898), vec4(65504.0)));
        float _996 = ((((_932 ? _929 : 0.0) + (_947 ? _944 : 0.0)) + (_956 ? 0.40261995792388916015625 : 0.0)) + (_973 ? _970 : 0.0)) + (_990 ? _987 : 0.0);
        if (all(lessThan(_852, _89)))
        {
            imageStore(gOutFiltered, _852, mix(vec4(0.0), ((((mix(vec4(0.0), _863 * _929, bvec4(_932)) + mix(vec4(0.0), _874 * _944, bvec4(_947))) + mix(vec4(0.0), _79[5].values * 0.40261995792388916015625, bvec4(_956))) + mix(vec4(0.0), _887 * _970, bvec4(_973))) + mix(vec4(0.0), _898 * _987, bvec4(_990))) * (1.0 / _996), bvec4(_996 > 1.0000000031710768509710513471353e-30)));
        }
        break;
    } while(false);
}

