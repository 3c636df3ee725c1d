#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

struct Tap
{
    vec2 values;
    float depth;
};

float _76;

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
layout(binding = 1) uniform sampler2D gInCache;
layout(binding = 3) uniform sampler2D gInCacheState;

void main()
{
    do
    {
        ivec2 _87 = ivec2(2) * ivec2(gl_GlobalInvocationID.xy);
        ivec2 _91 = ivec2(parameters.gOutputSize.xy);
        if (any(greaterThanEqual(_87, _91)))
        {
            break;
        }
        bool _100 = parameters.gDirection.x > parameters.gDirection.y;
        vec2 _102 = vec2(_87) + vec2(1.0);
        vec2 _108 = (_102 + (parameters.gDirection * (-4.0))) * parameters.gOutputSize.zw;
        vec4 _112 = textureGather(gInCache, _108);
        vec4 _114 = textureGather(gInCache, _108, 1);
        vec4 _118 = textureGather(gInCacheState, _108, 1);
        float _122 = _118.x;
        vec2 _123 = vec4(_112.x, _114.x, _76, _76).xy;
        float _132 = _118.z;
        vec2 _133 = vec4(_112.z, _114.z, _76, _76).xy;
        bvec2 _139 = bvec2(_100);
        vec2 _146 = (_102 + (parameters.gDirection * (-2.0))) * parameters.gOutputSize.zw;
        vec4 _148 = textureGather(gInCache, _146);
        vec4 _150 = textureGather(gInCache, _146, 1);
        vec4 _152 = textureGather(gInCacheState, _146, 1);
        float _156 = _152.x;
        vec2 _157 = vec4(_148.x, _150.x, _76, _76).xy;
        float _166 = _152.z;
        vec2 _167 = vec4(_148.z, _150.z, _76, _76).xy;
        vec2 _177 = _102 * parameters.gOutputSize.zw;
        vec4 _179 = textureGather(gInCache, _177);
        vec4 _181 = textureGather(gInCache, _177, 1);
        vec4 _183 = textureGather(gInCacheState, _177, 1);
        float _187 = _183.x;
        vec2 _188 = vec4(_179.x, _181.x, _76, _76).xy;
        float _197 = _183.z;
        vec2 _198 = vec4(_179.z, _181.z, _76, _76).xy;
        vec2 _210 = (_102 + (parameters.gDirection * 2.0)) * parameters.gOutputSize.zw;
        vec4 _212 = textureGather(gInCache, _210);
        vec4 _214 = textureGather(gInCache, _210, 1);
        vec4 _216 = textureGather(gInCacheState, _210, 1);
        float _220 = _216.x;
        vec2 _221 = vec4(_212.x, _214.x, _76, _76).xy;
        float _230 = _216.z;
        vec2 _231 = vec4(_212.z, _214.z, _76, _76).xy;
        vec2 _243 = (_102 + (parameters.gDirection * 4.0)) * parameters.gOutputSize.zw;
        vec4 _245 = textureGather(gInCache, _243);
        vec4 _247 = textureGather(gInCache, _243, 1);
        vec4 _249 = textureGather(gInCacheState, _243, 1);
        float _253 = _249.x;
        vec2 _254 = vec4(_245.x, _247.x, _76, _76).xy;
        float _263 = _249.z;
        vec2 _264 = vec4(_245.z, _247.z, _76, _76).xy;
        vec4 _275 = textureGather(gInCacheState, _177);
        ivec2 _276 = mix(ivec2(0, 1), ivec2(1, 0), _139);
        Tap _287[10] = Tap[](Tap(vec4(_112.w, _114.w, _76, _76).xy, _118.w), Tap(mix(_123, _133, _139), _100 ? _132 : _122), Tap(vec4(_148.w, _150.w, _76, _76).xy, _152.w), Tap(mix(_157, _167, _139), _100 ? _166 : _156), Tap(vec4(_179.w, _181.w, _76, _76).xy, _183.w), Tap(mix(_188, _198, _139), _100 ? _197 : _187), Tap(vec4(_212.w, _214.w, _76, _76).xy, _216.w), Tap(mix(_221, _231, _139), _100 ? _230 : _220), Tap(vec4(_245.w, _247.w, _76, _76).xy, _249.w), Tap(mix(_254, _264, _139), _100 ? _263 : _253));
        Tap _78[10] = _287;
        int _290 = int(floor(-3.5));
        int _291 = 4 + _290;
        int _293 = int(ceil(-3.5));
        int _294 = 4 + _293;
        vec2 _300 = (_78[_291].values + _78[_294].values) * 0.5;
        int _307 = int(floor(-1.5));
        int _308 = 4 + _307;
        int _310 = int(ceil(-1.5));
        int _311 = 4 + _310;
        vec2 _317 = (_78[_308].values + _78[_311].values) * 0.5;
        int _326 = int(floor(1.5));
        int _327 = 4 + _326;
        int _329 = int(ceil(1.5));
        int _330 = 4 + _329;
        vec2 _336 = (_78[_327].values + _78[_330].values) * 0.5;
        int _343 = int(floor(3.5));
        int _344 = 4 + _343;
        int _346 = int(ceil(3.5));
        int _347 = 4 + _346;
        vec2 _353 = (_78[_344].values + _78[_347].values) * 0.5;
        float _365 = max(parameters.gConverged, 1.0);
        float _366 = _275.w / _365;
        float _374 = ((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0;
        float _379 = (fma(_374, 1.0 - ((_366 > 0.0) ? min(_366, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _382 = (_379 > 0.0) ? min(_379, 16.0) : 0.0;
        float _391 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_78[4].depth > 0.001000000047497451305389404296875) ? min(_78[4].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _392 = -_78[4].depth;
        float _394 = abs(fma(0.5, _78[_291].depth + _78[_294].depth, _392));
        float _398 = (_391 > 0.0) ? min(_391, 9.9999996169031624536541560020822e+35) : 0.0;
        float _403 = 0.0544886849820613861083984375 * (_382 * ((_394 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_398, _394, 1.0)) : 0.0));
        bool _406 = all(lessThanEqual(abs(_300), vec2(65504.0)));
        float _412 = abs(fma(0.5, _78[_308].depth + _78[_311].depth, _392));
        float _418 = 0.24420134723186492919921875 * (_382 * ((_412 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_398, _412, 1.0)) : 0.0));
        bool _421 = all(lessThanEqual(abs(_317), vec2(65504.0)));
        bool _430 = all(lessThanEqual(abs(_78[4].values), vec2(65504.0)));
        float _438 = abs(fma(0.5, _78[_327].depth + _78[_330].depth, _392));
        float _444 = 0.24420134723186492919921875 * (_382 * ((_438 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_398, _438, 1.0)) : 0.0));
        bool _447 = all(lessThanEqual(abs(_336), vec2(65504.0)));
        float _455 = abs(fma(0.5, _78[_344].depth + _78[_347].depth, _392));
        float _461 = 0.0544886849820613861083984375 * (_382 * ((_455 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_398, _455, 1.0)) : 0.0));
        bool _464 = all(lessThanEqual(abs(_353), vec2(65504.0)));
        float _470 = ((((_406 ? _403 : 0.0) + (_421 ? _418 : 0.0)) + (_430 ? 0.40261995792388916015625 : 0.0)) + (_447 ? _444 : 0.0)) + (_464 ? _461 : 0.0);
        vec2 _475 = mix(vec2(0.0), ((((mix(vec2(0.0), _300 * _403, bvec2(_406)) + mix(vec2(0.0), _317 * _418, bvec2(_421))) + mix(vec2(0.0), _78[4].values * 0.40261995792388916015625, bvec2(_430))) + mix(vec2(0.0), _336 * _444, bvec2(_447))) + mix(vec2(0.0), _353 * _461, bvec2(_464))) * (1.0 / _470), bvec2(_470 > 1.0000000031710768509710513471353e-30));
        if (all(lessThan(_87, _91)))
        {
            imageStore(gOutFiltered, _87, vec4(_475, 0.0, 0.0));
        }
        ivec2 _484 = _87 + _276;
        float _485 = _275.z;
        float _486 = _275.x;
        Tap _79[10] = _287;
        int _488 = 5 + _290;
        int _489 = 5 + _293;
        vec2 _495 = (_79[_488].values + _79[_489].values) * 0.5;
        int _501 = 5 + _307;
        int _502 = 5 + _310;
        vec2 _508 = (_79[_501].values + _79[_502].values) * 0.5;
        int _516 = 5 + _326;
        int _517 = 5 + _329;
        vec2 _523 = (_79[_516].values + _79[_517].values) * 0.5;
        int _529 = 5 + _343;
        int _530 = 5 + _346;
        vec2 _536 = (_79[_529].values + _79[_530].values) * 0.5;
        float _544 = (_100 ? _485 : _486) / _365;
        float _551 = (fma(_374, 1.0 - ((_544 > 0.0) ? min(_544, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _554 = (_551 > 0.0) ? min(_551, 16.0) : 0.0;
        float _559 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_79[5].depth > 0.001000000047497451305389404296875) ? min(_79[5].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _560 = -_79[5].depth;
        float _562 = abs(fma(0.5, _79[_488].depth + _79[_489].depth, _560));
        float _566 = (_559 > 0.0) ? min(_559, 9.9999996169031624536541560020822e+35) : 0.0;
        float _571 = 0.0544886849820613861083984375 * (_554 * ((_562 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_566, _562, 1.0)) : 0.0));
        bool _574 = all(lessThanEqual(abs(_495), vec2(65504.0)));
        float _580 = abs(fma(0.5, _79[_501].depth + _79[_502].depth, _560));
        float _586 = 0.24420134723186492919921875 * (_554 * ((_580 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_566, _580, 1.0)) : 0.0));
        bool _589 = all(lessThanEqual(abs(_508), vec2(65504.0)));
        bool _598 = all(lessThanEqual(abs(_79[5].values), vec2(65504.0)));
        float _606 = abs(fma(0.5, _79[_516].depth + _79[_517].depth, _560));
        float _612 = 0.24420134723186492919921875 * (_554 * ((_606 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_566, _606, 1.0)) : 0.0));
        bool _615 = all(lessThanEqual(abs(_523), vec2(65504.0)));
        float _623 = abs(fma(0.5, _79[_529].depth + _79[_530].depth, _560));
        float _629 = 0.0544886849820613861083984375 * (_554 * ((_623 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_566, _623, 1.0)) : 0.0));
        bool _632 = all(lessThanEqual(abs(_536), vec2(65504.0)));
        float _638 = ((((_574 ? _571 : 0.0) + (_589 ? _586 : 0.0)) + (_598 ? 0.40261995792388916015625 : 0.0)) + (_615 ? _612 : 0.0)) + (_632 ? _629 : 0.0);
        vec2 _643 = mix(vec2(0.0), ((((mix(vec2(0.0), _495 * _571, bvec2(_574)) + mix(vec2(0.0), _508 * _586, bvec2(_589))) + mix(vec2(0.0), _79[5].values * 0.40261995792388916015625, bvec2(_598))) + mix(vec2(0.0), _523 * _612, bvec2(_615))) + mix(vec2(0.0), _536 * _629, bvec2(_632))) * (1.0 / _638), bvec2(_638 > 1.0000000031710768509710513471353e-30));
        if (all(lessThan(_484, _91)))
        {
            imageStore(gOutFiltered, _484, vec4(_643, 0.0, 0.0));
        }
        ivec2 _653 = _87 + _276.yx;
        Tap _665[10] = Tap[](Tap(mix(_133, _123, _139), _100 ? _122 : _132), Tap(vec4(_112.y, _114.y, _76, _76).xy, _118.y), Tap(mix(_167, _157, _139), _100 ? _156 : _166), Tap(vec4(_148.y, _150.y, _76, _76).xy, _152.y), Tap(mix(_198, _188, _139), _100 ? _187 : _197), Tap(vec4(_179.y, _181.y, _76, _76).xy, _183.y), Tap(mix(_231, _221, _139), _100 ? _220 : _230), Tap(vec4(_212.y, _214.y, _76, _76).xy, _216.y), Tap(mix(_264, _254, _139), _100 ? _253 : _263), Tap(vec4(_245.y, _247.y, _76, _76).xy, _249.y));
        Tap _80[10] = _665;
        vec2 _671 = (_80[_291].values + _80[_294].values) * 0.5;
        vec2 _682 = (_80[_308].values + _80[_311].values) * 0.5;
        vec2 _695 = (_80[_327].values + _80[_330].values) * 0.5;
        vec2 _706 = (_80[_344].values + _80[_347].values) * 0.5;
        float _714 = (_100 ? _486 : _485) / _365;
        float _721 = (fma(_374, 1.0 - ((_714 > 0.0) ? min(_714, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _724 = (_721 > 0.0) ? min(_721, 16.0) : 0.0;
        float _729 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_80[4].depth > 0.001000000047497451305389404296875) ? min(_80[4].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _730 = -_80[4].depth;
        float _732 = abs(fma(0.5, _80[_291].depth + _80[_294].depth, _730));
        float _736 = (_729 > 0.0) ? min(_729, 9.9999996169031624536541560020822e+35) : 0.0;
        float _741 = 0.0544886849820613861083984375 * (_724 * ((_732 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_736, _732, 1.0)) : 0.0));
        bool _744 = all(lessThanEqual(abs(_671), vec2(65504.0)));
        float _750 = abs(fma(0.5, _80[_308].depth + _80[_311].depth, _730));
        float _756 = 0.24420134723186492919921875 * (_724 * ((_750 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_736, _750, 1.0)) : 0.0));
        bool _759 = all(lessThanEqual(abs(_682), vec2(65504.0)));
        bool _768 = all(lessThanEqual(abs(_80[4].values), vec2(65504.0)));
        float _776 = abs(fma(0.5, _80[_327].depth + _80[_330].depth, _730));
        float _782 = 0.24420134723186492919921875 * (_724 * ((_776 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_736, _776, 1.0)) : 0.0));
        bool _785 = all(lessThanEqual(abs(_695), vec2(65504.0)));
        float _793 = abs(fma(0.5, _80[_344].depth + _80[_347].depth, _730));
        float _799 = 0.0544886849820613861083984375 * (_724 * ((_793 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_736, _793, 1.0)) : 0.0));
        bool _802 = all(lessThanEqual(abs(_706), vec2(65504.0)));
        float _808 = ((((_744 ? _741 : 0.0) + (_759 ? _756 : 0.0)) + (_768 ? 0.40261995792388916015625 : 0.0)) + (_785 ? _782 : 0.0)) + (_802 ? _799 : 0.0);
        vec2 _813 = mix(vec2(0.0), ((((mix(vec2(0.0), _671 * _741, bvec2(_744)) + mix(vec2(0.0), _682 * _756, bvec2(_759))) + mix(vec2(0.0), _80[4].values * 0.40261995792388916015625, bvec2(_768))) + mix(vec2(0.0), _695 * _782, bvec2(_785))) + mix(vec2(0.0), _706 * _799, bvec2(_802))) * (1.0 / _808), bvec2(_808 > 1.0000000031710768509710513471353e-30));
        if (all(lessThan(_653, _91)))
        {
            imageStore(gOutFiltered, _653, vec4(_813, 0.0, 0.0));
        }
        ivec2 _822 = _87 + ivec2(1);
        Tap _81[10] = _665;
        vec2 _829 = (_81[_488].values + _81[_489].values) * 0.5;
        vec2 _840 = (_81[_501].values + _81[_502].values) * 0.5;
        vec2 _853 = (_81[_516].values + _81[_517].values) * 0.5;
        vec2 _864 = (_81[_529].values + _81[_530].values) * 0.5;
        float _872 = _275.y / _365;
        float _879 = (fma(_374, 1.0 - ((_872 > 0.0) ? min(_872, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _882 = (_879 > 0.0) ? min(_879, 16.0) : 0.0;
        float _887 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_81[5].depth > 0.001000000047497451305389404296875) ? min(_81[5].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _888 = -_81[5].depth;
        float _890 = abs(fma(0.5, _81[_488].depth + _81[_489].depth, _888));
        float _894 = (_887 > 0.0) ? min(_887, 9.9999996169031624536541560020822e+35) : 0.0;
        float _899 = 0.0544886849820613861083984375 * (_882 * ((_890 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_894, _890, 1.0)) : 0.0));
        bool _902 = all(lessThanEqual(abs(_829), vec2(65504.0)));
        float _908 = abs(fma(0.5, _81[_501].depth + _81[_502].depth, _888));
        float _914 = 0.24420134723186492919921875 * (_882 * ((_908 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_894, _908, 1.0)) : 0.0));
        bool _917 = all(lessThanEqual(abs(_840), vec2(65504.0)));
        bool _926 = all(lessThanEqual(abs(_81[5].values), vec2(65504.0)));
        float _934 = abs(fma(0.5, _81[_516].depth + _81[_517].depth, _888));
        float _940 = 0.24420134723186492919921875 * (_882 * ((_934 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_894, _934, 1.0)) : 0.0));
        bool _943 = all(lessThanEqual(abs(_853), vec2(65504.0)));
        float _951 = abs(fma(0.5, _81[_529].depth + _81[_530].depth, _888));
        float _957 = 0.0544886849820613861083984375 * (_882 * ((_951 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_894, _951, 1.0)) : 0.0));
        bool _960 = all(lessThanEqual(abs(_864), vec2(65504.0)));
        float _966 = ((((_902 ? _899 : 0.0) + (_917 ? _914 : 0.0)) + (_926 ? 0.40261995792388916015625 : 0.0)) + (_943 ? _940 : 0.0)) + (_960 ? _957 : 0.0);
        vec2 _971 = mix(vec2(0.0), ((((mix(vec2(0.0), _829 * _899, bvec2(_902)) + mix(vec2(0.0), _840 * _914, bvec2(_917))) + mix(vec2(0.0), _81[5].values * 0.40261995792388916015625, bvec2(_926))) + mix(vec2(0.0), _853 * _940, bvec2(_943))) + mix(vec2(0.0), _864 * _957, bvec2(_960))) * (1.0 / _966), bvec2(_966 > 1.0000000031710768509710513471353e-30));
        if (all(lessThan(_822, _91)))
        {
            imageStore(gOutFiltered, _822, vec4(_971, 0.0, 0.0));
        }
        break;
    } while(false);
}

