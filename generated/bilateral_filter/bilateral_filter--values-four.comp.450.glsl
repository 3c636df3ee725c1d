#version 450
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
        vec4 _116 = textureGather(gInCache, _108, 2);
        vec4 _118 = textureGather(gInCache, _108, 3);
        vec4 _122 = textureGather(gInCacheState, _108, 1);
        vec4 _127 = vec4(_112.x, _114.x, _116.x, _118.x);
        float _128 = _122.x;
        vec4 _139 = vec4(_112.z, _114.z, _116.z, _118.z);
        float _140 = _122.z;
        bvec4 _147 = bvec4(_100);
        vec2 _154 = (_102 + (parameters.gDirection * (-2.0))) * parameters.gOutputSize.zw;
        vec4 _156 = textureGather(gInCache, _154);
        vec4 _158 = textureGather(gInCache, _154, 1);
        vec4 _160 = textureGather(gInCache, _154, 2);
        vec4 _162 = textureGather(gInCache, _154, 3);
        vec4 _164 = textureGather(gInCacheState, _154, 1);
        vec4 _169 = vec4(_156.x, _158.x, _160.x, _162.x);
        float _170 = _164.x;
        vec4 _181 = vec4(_156.z, _158.z, _160.z, _162.z);
        float _182 = _164.z;
        vec2 _193 = _102 * parameters.gOutputSize.zw;
        vec4 _195 = textureGather(gInCache, _193);
        vec4 _197 = textureGather(gInCache, _193, 1);
        vec4 _199 = textureGather(gInCache, _193, 2);
        vec4 _201 = textureGather(gInCache, _193, 3);
        vec4 _203 = textureGather(gInCacheState, _193, 1);
        vec4 _208 = vec4(_195.x, _197.x, _199.x, _201.x);
        float _209 = _203.x;
        vec4 _220 = vec4(_195.z, _197.z, _199.z, _201.z);
        float _221 = _203.z;
        vec2 _234 = (_102 + (parameters.gDirection * 2.0)) * parameters.gOutputSize.zw;
        vec4 _236 = textureGather(gInCache, _234);
        vec4 _238 = textureGather(gInCache, _234, 1);
        vec4 _240 = textureGather(gInCache, _234, 2);
        vec4 _242 = textureGather(gInCache, _234, 3);
        vec4 _244 = textureGather(gInCacheState, _234, 1);
        vec4 _249 = vec4(_236.x, _238.x, _240.x, _242.x);
        float _250 = _244.x;
        vec4 _261 = vec4(_236.z, _238.z, _240.z, _242.z);
        float _262 = _244.z;
        vec2 _275 = (_102 + (parameters.gDirection * 4.0)) * parameters.gOutputSize.zw;
        vec4 _277 = textureGather(gInCache, _275);
        vec4 _279 = textureGather(gInCache, _275, 1);
        vec4 _281 = textureGather(gInCache, _275, 2);
        vec4 _283 = textureGather(gInCache, _275, 3);
        vec4 _285 = textureGather(gInCacheState, _275, 1);
        vec4 _290 = vec4(_277.x, _279.x, _281.x, _283.x);
        float _291 = _285.x;
        vec4 _302 = vec4(_277.z, _279.z, _281.z, _283.z);
        float _303 = _285.z;
        vec4 _315 = textureGather(gInCacheState, _193);
        ivec2 _317 = mix(ivec2(0, 1), ivec2(1, 0), bvec2(_100));
        Tap _328[10] = Tap[](Tap(vec4(_112.w, _114.w, _116.w, _118.w), _122.w), Tap(mix(_127, _139, _147), _100 ? _140 : _128), Tap(vec4(_156.w, _158.w, _160.w, _162.w), _164.w), Tap(mix(_169, _181, _147), _100 ? _182 : _170), Tap(vec4(_195.w, _197.w, _199.w, _201.w), _203.w), Tap(mix(_208, _220, _147), _100 ? _221 : _209), Tap(vec4(_236.w, _238.w, _240.w, _242.w), _244.w), Tap(mix(_249, _261, _147), _100 ? _262 : _250), Tap(vec4(_277.w, _279.w, _281.w, _283.w), _285.w), Tap(mix(_290, _302, _147), _100 ? _303 : _291));
        Tap _78[10] = _328;
        int _331 = int(floor(-3.5));
        int _332 = 4 + _331;
        int _334 = int(ceil(-3.5));
        int _335 = 4 + _334;
        vec4 _341 = (_78[_332].values + _78[_335].values) * 0.5;
        int _348 = int(floor(-1.5));
        int _349 = 4 + _348;
        int _351 = int(ceil(-1.5));
        int _352 = 4 + _351;
        vec4 _358 = (_78[_349].values + _78[_352].values) * 0.5;
        int _367 = int(floor(1.5));
        int _368 = 4 + _367;
        int _370 = int(ceil(1.5));
        int _371 = 4 + _370;
        vec4 _377 = (_78[_368].values + _78[_371].values) * 0.5;
        int _384 = int(floor(3.5));
        int _385 = 4 + _384;
        int _387 = int(ceil(3.5));
        int _388 = 4 + _387;
        vec4 _394 = (_78[_385].values + _78[_388].values) * 0.5;
        float _406 = max(parameters.gConverged, 1.0);
        float _407 = _315.w / _406;
        float _415 = ((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0;
        float _420 = (fma(_415, 1.0 - ((_407 > 0.0) ? min(_407, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _423 = (_420 > 0.0) ? min(_420, 16.0) : 0.0;
        float _432 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_78[4].depth > 0.001000000047497451305389404296875) ? min(_78[4].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _433 = -_78[4].depth;
        float _435 = abs(fma(0.5, _78[_332].depth + _78[_335].depth, _433));
        float _439 = (_432 > 0.0) ? min(_432, 9.9999996169031624536541560020822e+35) : 0.0;
        float _444 = 0.0544886849820613861083984375 * (_423 * ((_435 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_439, _435, 1.0)) : 0.0));
        bool _447 = all(lessThanEqual(abs(_341), vec4(65504.0)));
        float _453 = abs(fma(0.5, _78[_349].depth + _78[_352].depth, _433));
        float _459 = 0.24420134723186492919921875 * (_423 * ((_453 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_439, _453, 1.0)) : 0.0));
        bool _462 = all(lessThanEqual(abs(_358), vec4(65504.0)));
        bool _471 = all(lessThanEqual(abs(_78[4].values), vec4(65504.0)));
        float _479 = abs(fma(0.5, _78[_368].depth + _78[_371].depth, _433));
        float _485 = 0.24420134723186492919921875 * (_423 * ((_479 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_439, _479, 1.0)) : 0.0));
        bool _488 = all(lessThanEqual(abs(_377), vec4(65504.0)));
        float _496 = abs(fma(0.5, _78[_385].depth + _78[_388].depth, _433));
        float _502 = 0.0544886849820613861083984375 * (_423 * ((_496 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_439, _496, 1.0)) : 0.0));
        bool _505 = all(lessThanEqual(abs(_394), vec4(65504.0)));
        float _511 = ((((_447 ? _444 : 0.0) + (_462 ? _459 : 0.0)) + (_471 ? 0.40261995792388916015625 : 0.0)) + (_488 ? _485 : 0.0)) + (_505 ? _502 : 0.0);
        if (all(lessThan(_87, _91)))
        {
            imageStore(gOutFiltered, _87, mix(vec4(0.0), ((((mix(vec4(0.0), _341 * _444, bvec4(_447)) + mix(vec4(0.0), _358 * _459, bvec4(_462))) + mix(vec4(0.0), _78[4].values * 0.40261995792388916015625, bvec4(_471))) + mix(vec4(0.0), _377 * _485, bvec4(_488))) + mix(vec4(0.0), _394 * _502, bvec4(_505))) * (1.0 / _511), bvec4(_511 > 1.0000000031710768509710513471353e-30)));
        }
        ivec2 _522 = _87 + _317;
        float _523 = _315.z;
        float _524 = _315.x;
        Tap _79[10] = _328;
        int _526 = 5 + _331;
        int _527 = 5 + _334;
        vec4 _533 = (_79[_526].values + _79[_527].values) * 0.5;
        int _539 = 5 + _348;
        int _540 = 5 + _351;
        vec4 _546 = (_79[_539].values + _79[_540].values) * 0.5;
        int _554 = 5 + _367;
        int _555 = 5 + _370;
        vec4 _561 = (_79[_554].values + _79[_555].values) * 0.5;
        int _567 = 5 + _384;
        int _568 = 5 + _387;
        vec4 _574 = (_79[_567].values + _79[_568].values) * 0.5;
        float _582 = (_100 ? _523 : _524) / _406;
        float _589 = (fma(_415, 1.0 - ((_582 > 0.0) ? min(_582, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _592 = (_589 > 0.0) ? min(_589, 16.0) : 0.0;
        float _597 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_79[5].depth > 0.001000000047497451305389404296875) ? min(_79[5].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _598 = -_79[5].depth;
        float _600 = abs(fma(0.5, _79[_526].depth + _79[_527].depth, _598));
        float _604 = (_597 > 0.0) ? min(_597, 9.9999996169031624536541560020822e+35) : 0.0;
        float _609 = 0.0544886849820613861083984375 * (_592 * ((_600 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_604, _600, 1.0)) : 0.0));
        bool _612 = all(lessThanEqual(abs(_533), vec4(65504.0)));
        float _618 = abs(fma(0.5, _79[_539].depth + _79[_540].depth, _598));
        float _624 = 0.24420134723186492919921875 * (_592 * ((_618 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_604, _618, 1.0)) : 0.0));
        bool _627 = all(lessThanEqual(abs(_546), vec4(65504.0)));
        bool _636 = all(lessThanEqual(abs(_79[5].values), vec4(65504.0)));
        float _644 = abs(fma(0.5, _79[_554].depth + _79[_555].depth, _598));
        float _650 = 0.24420134723186492919921875 * (_592 * ((_644 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_604, _644, 1.0)) : 0.0));
        bool _653 = all(lessThanEqual(abs(_561), vec4(65504.0)));
        float _661 = abs(fma(0.5, _79[_567].depth + _79[_568].depth, _598));
        float _667 = 0.0544886849820613861083984375 * (_592 * ((_661 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_604, _661, 1.0)) : 0.0));
        bool _670 = all(lessThanEqual(abs(_574), vec4(65504.0)));
        float _676 = ((((_612 ? _609 : 0.0) + (_627 ? _624 : 0.0)) + (_636 ? 0.40261995792388916015625 : 0.0)) + (_653 ? _650 : 0.0)) + (_670 ? _667 : 0.0);
        if (all(lessThan(_522, _91)))
        {
            imageStore(gOutFiltered, _522, mix(vec4(0.0), ((((mix(vec4(0.0), _533 * _609, bvec4(_612)) + mix(vec4(0.0), _546 * _624, bvec4(_627))) + mix(vec4(0.0), _79[5].values * 0.40261995792388916015625, bvec4(_636))) + mix(vec4(0.0), _561 * _650, bvec4(_653))) + mix(vec4(0.0), _574 * _667, bvec4(_670))) * (1.0 / _676), bvec4(_676 > 1.0000000031710768509710513471353e-30)));
        }
        ivec2 _688 = _87 + _317.yx;
        Tap _700[10] = Tap[](Tap(mix(_139, _127, _147), _100 ? _128 : _140), Tap(vec4(_112.y, _114.y, _116.y, _118.y), _122.y), Tap(mix(_181, _169, _147), _100 ? _170 : _182), Tap(vec4(_156.y, _158.y, _160.y, _162.y), _164.y), Tap(mix(_220, _208, _147), _100 ? _209 : _221), Tap(vec4(_195.y, _197.y, _199.y, _201.y), _203.y), Tap(mix(_261, _249, _147), _100 ? _250 : _262), Tap(vec4(_236.y, _238.y, _240.y, _242.y), _244.y), Tap(mix(_302, _290, _147), _100 ? _291 : _303), Tap(vec4(_277.y, _279.y, _281.y, _283.y), _285.y));
        Tap _80[10] = _700;
        vec4 _706 = (_80[_332].values + _80[_335].values) * 0.5;
        vec4 _717 = (_80[_349].values + _80[_352].values) * 0.5;
        vec4 _730 = (_80[_368].values + _80[_371].values) * 0.5;
        vec4 _741 = (_80[_385].values + _80[_388].values) * 0.5;
        float _749 = (_100 ? _524 : _523) / _406;
        float _756 = (fma(_415, 1.0 - ((_749 > 0.0) ? min(_749, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _759 = (_756 > 0.0) ? min(_756, 16.0) : 0.0;
        float _764 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_80[4].depth > 0.001000000047497451305389404296875) ? min(_80[4].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _765 = -_80[4].depth;
        float _767 = abs(fma(0.5, _80[_332].depth + _80[_335].depth, _765));
        float _771 = (_764 > 0.0) ? min(_764, 9.9999996169031624536541560020822e+35) : 0.0;
        float _776 = 0.0544886849820613861083984375 * (_759 * ((_767 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_771, _767, 1.0)) : 0.0));
        bool _779 = all(lessThanEqual(abs(_706), vec4(65504.0)));
        float _785 = abs(fma(0.5, _80[_349].depth + _80[_352].depth, _765));
        float _791 = 0.24420134723186492919921875 * (_759 * ((_785 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_771, _785, 1.0)) : 0.0));
        bool _794 = all(lessThanEqual(abs(_717), vec4(65504.0)));
        bool _803 = all(lessThanEqual(abs(_80[4].values), vec4(65504.0)));
        float _811 = abs(fma(0.5, _80[_368].depth + _80[_371].depth, _765));
        float _817 = 0.24420134723186492919921875 * (_759 * ((_811 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_771, _811, 1.0)) : 0.0));
        bool _820 = all(lessThanEqual(abs(_730), vec4(65504.0)));
        float _828 = abs(fma(0.5, _80[_385].depth + _80[_388].depth, _765));
        float _834 = 0.0544886849820613861083984375 * (_759 * ((_828 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_771, _828, 1.0)) : 0.0));
        bool _837 = all(lessThanEqual(abs(_741), vec4(65504.0)));
        float _843 = ((((_779 ? _776 : 0.0) + (_794 ? _791 : 0.0)) + (_803 ? 0.40261995792388916015625 : 0.0)) + (_820 ? _817 : 0.0)) + (_837 ? _834 : 0.0);
        if (all(lessThan(_688, _91)))
        {
            imageStore(gOutFiltered, _688, mix(vec4(0.0), ((((mix(vec4(0.0), _706 * _776, bvec4(_779)) + mix(vec4(0.0), _717 * _791, bvec4(_794))) + mix(vec4(0.0), _80[4].values * 0.40261995792388916015625, bvec4(_803))) + mix(vec4(0.0), _730 * _817, bvec4(_820))) + mix(vec4(0.0), _741 * _834, bvec4(_837))) * (1.0 / _843), bvec4(_843 > 1.0000000031710768509710513471353e-30)));
        }
        ivec2 _854 = _87 + ivec2(1);
        Tap _81[10] = _700;
        vec4 _861 = (_81[_526].values + _81[_527].values) * 0.5;
        vec4 _872 = (_81[_539].values + _81[_540].values) * 0.5;
        vec4 _885 = (_81[_554].values + _81[_555].values) * 0.5;
        vec4 _896 = (_81[_567].values + _81[_568].values) * 0.5;
        float _904 = _315.y / _406;
        float _911 = (fma(_415, 1.0 - ((_904 > 0.0) ? min(_904, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _914 = (_911 > 0.0) ? min(_911, 16.0) : 0.0;
        float _919 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_81[5].depth > 0.001000000047497451305389404296875) ? min(_81[5].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _920 = -_81[5].depth;
        float _922 = abs(fma(0.5, _81[_526].depth + _81[_527].depth, _920));
        float _926 = (_919 > 0.0) ? min(_919, 9.9999996169031624536541560020822e+35) : 0.0;
        float _931 = 0.0544886849820613861083984375 * (_914 * ((_922 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_926, _922, 1.0)) : 0.0));
        bool _934 = all(lessThanEqual(abs(_861), vec4(65504.0)));
        float _940 = abs(fma(0.5, _81[_539].depth + _81[_540].depth, _920));
        float _946 = 0.24420134723186492919921875 * (_914 * ((_940 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_926, _940, 1.0)) : 0.0));
        bool _949 = all(lessThanEqual(abs(_872), vec4(65504.0)));
        bool _958 = all(lessThanEqual(abs(_81[5].values), vec4(65504.0)));
        float _966 = abs(fma(0.5, _81[_554].depth + _81[_555].depth, _920));
        float _972 = 0.24420134723186492919921875 * (_914 * ((_966 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_926, _966, 1.0)) : 0.0));
        bool _975 = all(lessThanEqual(abs(_885), vec4(65504.0)));
        float _983 = abs(fma(0.5, _81[_567].depth + _81[_568].depth, _920));
        float _989 = 0.0544886849820613861083984375 * (_914 * ((_983 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_926, _983, 1.0)) : 0.0));
        bool _992 = all(lessThanEqual(abs(_896), vec4(65504.0)));
        float _998 = ((((_934 ? _931 : 0.0) + (_949 ? _946 : 0.0)) + (_958 ? 0.40261995792388916015625 : 0.0)) + (_975 ? _972 : 0.0)) + (_992 ? _989 : 0.0);
        if (all(lessThan(_854, _91)))
        {
            imageStore(gOutFiltered, _854, mix(vec4(0.0), ((((mix(vec4(0.0), _861 * _931, bvec4(_934)) + mix(vec4(0.0), _872 * _946, bvec4(_949))) + mix(vec4(0.0), _81[5].values * 0.40261995792388916015625, bvec4(_958))) + mix(vec4(0.0), _885 * _972, bvec4(_975))) + mix(vec4(0.0), _896 * _989, bvec4(_992))) * (1.0 / _998), bvec4(_998 > 1.0000000031710768509710513471353e-30)));
        }
        break;
    } while(false);
}

