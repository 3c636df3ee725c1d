#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

struct Tap
{
    vec2 values;
    float depth;
};

float _74;

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
        vec4 _116 = textureGather(gInCacheState, _106, 1);
        float _120 = _116.x;
        vec2 _121 = vec4(_110.x, _112.x, _74, _74).xy;
        float _130 = _116.z;
        vec2 _131 = vec4(_110.z, _112.z, _74, _74).xy;
        bvec2 _137 = bvec2(_98);
        vec2 _144 = (_100 + (parameters.gDirection * (-2.0))) * parameters.gOutputSize.zw;
        vec4 _146 = textureGather(gInCache, _144);
        vec4 _148 = textureGather(gInCache, _144, 1);
        vec4 _150 = textureGather(gInCacheState, _144, 1);
        float _154 = _150.x;
        vec2 _155 = vec4(_146.x, _148.x, _74, _74).xy;
        float _164 = _150.z;
        vec2 _165 = vec4(_146.z, _148.z, _74, _74).xy;
        vec2 _175 = _100 * parameters.gOutputSize.zw;
        vec4 _177 = textureGather(gInCache, _175);
        vec4 _179 = textureGather(gInCache, _175, 1);
        vec4 _181 = textureGather(gInCacheState, _175, 1);
        float _185 = _181.x;
        vec2 _186 = vec4(_177.x, _179.x, _74, _74).xy;
        float _195 = _181.z;
        vec2 _196 = vec4(_177.z, _179.z, _74, _74).xy;
        vec2 _208 = (_100 + (parameters.gDirection * 2.0)) * parameters.gOutputSize.zw;
        vec4 _210 = textureGather(gInCache, _208);
        vec4 _212 = textureGather(gInCache, _208, 1);
        vec4 _214 = textureGather(gInCacheState, _208, 1);
        float _218 = _214.x;
        vec2 _219 = vec4(_210.x, _212.x, _74, _74).xy;
        float _228 = _214.z;
        vec2 _229 = vec4(_210.z, _212.z, _74, _74).xy;
        vec2 _241 = (_100 + (parameters.gDirection * 4.0)) * parameters.gOutputSize.zw;
        vec4 _243 = textureGather(gInCache, _241);
        vec4 _245 = textureGather(gInCache, _241, 1);
        vec4 _247 = textureGather(gInCacheState, _241, 1);
        float _251 = _247.x;
        vec2 _252 = vec4(_243.x, _245.x, _74, _74).xy;
        float _261 = _247.z;
        vec2 _262 = vec4(_243.z, _245.z, _74, _74).xy;
        vec4 _273 = textureGather(gInCacheState, _175);
        ivec2 _274 = mix(ivec2(0, 1), ivec2(1, 0), _137);
        Tap _285[10] = Tap[](Tap(vec4(_110.w, _112.w, _74, _74).xy, _116.w), Tap(mix(_121, _131, _137), _98 ? _130 : _120), Tap(vec4(_146.w, _148.w, _74, _74).xy, _150.w), Tap(mix(_155, _165, _137), _98 ? _164 : _154), Tap(vec4(_177.w, _179.w, _74, _74).xy, _181.w), Tap(mix(_186, _196, _137), _98 ? _195 : _185), Tap(vec4(_210.w, _212.w, _74, _74).xy, _214.w), Tap(mix(_219, _229, _137), _98 ? _228 : _218), Tap(vec4(_243.w, _245.w, _74, _74).xy, _247.w), Tap(mix(_252, _262, _137), _98 ? _261 : _251));
        Tap _76[10] = _285;
        int _288 = int(floor(-3.5));
        int _289 = 4 + _288;
        int _291 = int(ceil(-3.5));
        int _292 = 4 + _291;
        vec2 _302 = (_76[_289].values + _76[_292].values) * 0.5;
        int _305 = int(floor(-1.5));
        int _306 = 4 + _305;
        int _308 = int(ceil(-1.5));
        int _309 = 4 + _308;
        vec2 _319 = (_76[_306].values + _76[_309].values) * 0.5;
        int _324 = int(floor(1.5));
        int _325 = 4 + _324;
        int _327 = int(ceil(1.5));
        int _328 = 4 + _327;
        vec2 _338 = (_76[_325].values + _76[_328].values) * 0.5;
        int _341 = int(floor(3.5));
        int _342 = 4 + _341;
        int _344 = int(ceil(3.5));
        int _345 = 4 + _344;
        vec2 _355 = (_76[_342].values + _76[_345].values) * 0.5;
        float _363 = max(parameters.gConverged, 1.0);
        float _364 = _273.w / _363;
        float _372 = ((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0;
        float _377 = (fma(_372, 1.0 - ((_364 > 0.0) ? min(_364, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _380 = (_377 > 0.0) ? min(_377, 16.0) : 0.0;
        float _389 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_76[4].depth > 0.001000000047497451305389404296875) ? min(_76[4].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _390 = -_76[4].depth;
        float _392 = abs(fma(0.5, _76[_289].depth + _76[_292].depth, _390));
        float _396 = (_389 > 0.0) ? min(_389, 9.9999996169031624536541560020822e+35) : 0.0;
        float _401 = 0.0544886849820613861083984375 * (_380 * ((_392 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_396, _392, 1.0)) : 0.0));
        bool _404 = all(lessThanEqual(abs(_302), vec2(65504.0)));
        float _410 = abs(fma(0.5, _76[_306].depth + _76[_309].depth, _390));
        float _416 = 0.24420134723186492919921875 * (_380 * ((_410 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_396, _410, 1.0)) : 0.0));
        bool _419 = all(lessThanEqual(abs(_319), vec2(65504.0)));
        bool _428 = all(lessThanEqual(abs(_76[4].values), vec2(65504.0)));
        float _436 = abs(fma(0.5, _76[_325].depth + _76[_328].depth, _390));
        float _442 = 0.24420134723186492919921875 * (_380 * ((_436 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_396, _436, 1.0)) : 0.0));
        bool _445 = all(lessThanEqual(abs(_338), vec2(65504.0)));
        float _453 = abs(fma(0.5, _76[_342].depth + _76[_345].depth, _390));
        float _459 = 0.0544886849820613861083984375 * (_380 * ((_453 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_396, _453, 1.0)) : 0.0));
        bool _462 = all(lessThanEqual(abs(_355), vec2(65504.0)));
        float _468 = ((((_404 ? _401 : 0.0) + (_419 ? _416 : 0.0)) + (_428 ? 0.40261995792388916015625 : 0.0)) + (_445 ? _442 : 0.0)) + (_462 ? _459 : 0.0);
        if (all(lessThan(_85, _89)))
        {
            imageStore(gOutFiltered, _85, vec4(mix(vec2(0.0), ((((mix(vec2(0.0), _302 * _401, bvec2(_404)) + mix(vec2(0.0), _319 * _416, bvec2(_419))) + mix(vec2(0.0), _76[4].values * 0.40261995792388916015625, bvec2(_428))) + mix(vec2(0.0), _338 * _442, bvec2(_445))) + mix(vec2(0.0), _355 * _459, bvec2(_462))) * (1.0 / _468), bvec2(_468 > 1.0000000031710768509710513471353e-30)), 0.0, 0.0));
        }
        ivec2 _482 = _85 + _274;
        float _483 = _273.z;
        float _484 = _273.x;
        Tap _77[10] = _285;
        int _486 = 5 + _288;
        int _487 = 5 + _291;
        vec2 _497 = (_77[_486].values + _77[_487].values) * 0.5;
        int _499 = 5 + _305;
        int _500 = 5 + _308;
        vec2 _510 = (_77[_499].values + _77[_500].values) * 0.5;
        int _514 = 5 + _324;
        int _515 = 5 + _327;
        vec2 _525 = (_77[_514].values + _77[_515].values) * 0.5;
        int _527 = 5 + _341;
        int _528 = 5 + _344;
        vec2 _538 = (_77[_527].values + _77[_528].values) * 0.5;
        float _542 = (_98 ? _483 : _484) / _363;
        float _549 = (fma(_372, 1.0 - ((_542 > 0.0) ? min(_542, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _552 = (_549 > 0.0) ? min(_549, 16.0) : 0.0;
        float _557 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_77[5].depth > 0.001000000047497451305389404296875) ? min(_77[5].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _558 = -_77[5].depth;
        float _560 = abs(fma(0.5, _77[_486].depth + _77[_487].depth, _558));
        float _564 = (_557 > 0.0) ? min(_557, 9.9999996169031624536541560020822e+35) : 0.0;
        float _569 = 0.0544886849820613861083984375 * (_552 * ((_560 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_564, _560, 1.0)) : 0.0));
        bool _572 = all(lessThanEqual(abs(_497), vec2(65504.0)));
        float _578 = abs(fma(0.5, _77[_499].depth + _77[_500].depth, _558));
        float _584 = 0.24420134723186492919921875 * (_552 * ((_578 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_564, _578, 1.0)) : 0.0));
        bool _587 = all(lessThanEqual(abs(_510), vec2(65504.0)));
        bool _596 = all(lessThanEqual(abs(_77[5].values), vec2(65504.0)));
        float _604 = abs(fma(0.5, _77[_514].depth + _77[_515].depth, _558));
        float _610 = 0.24420134723186492919921875 * (_552 * ((_604 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_564, _604, 1.0)) : 0.0));
        bool _613 = all(lessThanEqual(abs(_525), vec2(65504.0)));
        float _621 = abs(fma(0.5, _77[_527].depth + _77[_528].depth, _558));
        float _627 = 0.0544886849820613861083984375 * (_552 * ((_621 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_564, _621, 1.0)) : 0.0));
        bool _630 = all(lessThanEqual(abs(_538), vec2(65504.0)));
        float _636 = ((((_572 ? _569 : 0.0) + (_587 ? _584 : 0.0)) + (_596 ? 0.40261995792388916015625 : 0.0)) + (_613 ? _610 : 0.0)) + (_630 ? _627 : 0.0);
        if (all(lessThan(_482, _89)))
        {
            imageStore(gOutFiltered, _482, vec4(mix(vec2(0.0), ((((mix(vec2(0.0), _497 * _569, bvec2(_572)) + mix(vec2(0.0), _510 * _584, bvec2(_587))) + mix(vec2(0.0), _77[5].values * 0.40261995792388916015625, bvec2(_596))) + mix(vec2(0.0), _525 * _610, bvec2(_613))) + mix(vec2(0.0), _538 * _627, bvec2(_630))) * (1.0 / _636), bvec2(_636 > 1.0000000031710768509710513471353e-30)), 0.0, 0.0));
        }
        ivec2 _651 = _85 + _274.yx;
        Tap _663[10] = Tap[](Tap(mix(_131, _121, _137), _98 ? _120 : _130), Tap(vec4(_110.y, _112.y, _74, _74).xy, _116.y), Tap(mix(_165, _155, _137), _98 ? _154 : _164), Tap(vec4(_146.y, _148.y, _74, _74).xy, _150.y), Tap(mix(_196, _186, _137), _98 ? _185 : _195), Tap(vec4(_177.y, _179.y, _74, _74).xy, _181.y), Tap(mix(_229, _219, _137), _98 ? _218 : _228), Tap(vec4(_210.y, _212.y, _74, _74).xy, _214.y), Tap(mix(_262, _252, _137), _98 ? _251 : _261), Tap(vec4(_243.y, _245.y, _74, _74).xy, _247.y));
        Tap _78[10] = _663;
        vec2 _673 = (_78[_289].values + _78[_292].values) * 0.5;
        vec2 _684 = (_78[_306].values + _78[_309].values) * 0.5;
        vec2 _697 = (_78[_325].values + _78[_328].values) * 0.5;
        vec2 _708 = (_78[_342].values + _78[_345].values) * 0.5;
        float _712 = (_98 ? _484 : _483) / _363;
        float _719 = (fma(_372, 1.0 - ((_712 > 0.0) ? min(_712, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _722 = (_719 > 0.0) ? min(_719, 16.0) : 0.0;
        float _727 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_78[4].depth > 0.001000000047497451305389404296875) ? min(_78[4].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _728 = -_78[4].depth;
        float _730 = abs(fma(0.5, _78[_289].depth + _78[_292].depth, _728));
        float _734 = (_727 > 0.0) ? min(_727, 9.9999996169031624536541560020822e+35) : 0.0;
        float _739 = 0.0544886849820613861083984375 * (_722 * ((_730 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_734, _730, 1.0)) : 0.0));
        bool _742 = all(lessThanEqual(abs(_673), vec2(65504.0)));
        float _748 = abs(fma(0.5, _78[_306].depth + _78[_309].depth, _728));
        float _754 = 0.24420134723186492919921875 * (_722 * ((_748 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_734, _748, 1.0)) : 0.0));
        bool _757 = all(lessThanEqual(abs(_684), vec2(65504.0)));
        bool _766 = all(lessThanEqual(abs(_78[4].values), vec2(65504.0)));
        float _774 = abs(fma(0.5, _78[_325].depth + _78[_328].depth, _728));
        float _780 = 0.24420134723186492919921875 * (_722 * ((_774 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_734, _774, 1.0)) : 0.0));
        bool _783 = all(lessThanEqual(abs(_697), vec2(65504.0)));
        float _791 = abs(fma(0.5, _78[_342].depth + _78[_345].depth, _728));
        float _797 = 0.0544886849820613861083984375 * (_722 * ((_791 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_734, _791, 1.0)) : 0.0));
        bool _800 = all(lessThanEqual(abs(_708), vec2(65504.0)));
        float _806 = ((((_742 ? _739 : 0.0) + (_757 ? _754 : 0.0)) + (_766 ? 0.40261995792388916015625 : 0.0)) + (_783 ? _780 : 0.0)) + (_800 ? _797 : 0.0);
        if (all(lessThan(_651, _89)))
        {
            imageStore(gOutFiltered, _651, vec4(mix(vec2(0.0), ((((mix(vec2(0.0), _673 * _739, bvec2(_742)) + mix(vec2(0.0), _684 * _754, bvec2(_757))) + mix(vec2(0.0), _78[4].values * 0.40261995792388916015625, bvec2(_766))) + mix(vec2(0.0), _697 * _780, bvec2(_783))) + mix(vec2(0.0), _708 * _797, bvec2(_800))) * (1.0 / _806), bvec2(_806 > 1.0000000031710768509710513471353e-30)), 0.0, 0.0));
        }
        ivec2 _820 = _85 + ivec2(1);
        Tap _79[10] = _663;
        vec2 _831 = (_79[_486].values + _79[_487].values) * 0.5;
        vec2 _842 = (_79[_499].values + _79[_500].values) * 0.5;
        vec2 _855 = (_79[_514].values + _79[_515].values) * 0.5;
        vec2 _866 = (_79[_527].values + _79[_528].values) * 0.5;
        float _870 = _273.y / _363;
        float _877 = (fma(_372, 1.0 - ((_870 > 0.0) ? min(_870, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _880 = (_877 > 0.0) ? min(_877, 16.0) : 0.0;
        float _885 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_79[5].depth > 0.001000000047497451305389404296875) ? min(_79[5].depth, 65504.0) : 0.001000000047497451305389404296875));
        float _886 = -_79[5].depth;
        float _888 = abs(fma(0.5, _79[_486].depth + _79[_487].depth, _886));
        float _892 = (_885 > 0.0) ? min(_885, 9.9999996169031624536541560020822e+35) : 0.0;
        float _897 = 0.0544886849820613861083984375 * (_880 * ((_888 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_892, _888, 1.0)) : 0.0));
        bool _900 = all(lessThanEqual(abs(_831), vec2(65504.0)));
        float _906 = abs(fma(0.5, _79[_499].depth + _79[_500].depth, _886));
        float _912 = 0.24420134723186492919921875 * (_880 * ((_906 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_892, _906, 1.0)) : 0.0));
        bool _915 = all(lessThanEqual(abs(_842), vec2(65504.0)));
        bool _924 = all(lessThanEqual(abs(_79[5].values), vec2(65504.0)));
        float _932 = abs(fma(0.5, _79[_514].depth + _79[_515].depth, _886));
        float _938 = 0.24420134723186492919921875 * (_880 * ((_932 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_892, _932, 1.0)) : 0.0));
        bool _941 = all(lessThanEqual(abs(_855), vec2(65504.0)));
        float _949 = abs(fma(0.5, _79[_527].depth + _79[_528].depth, _886));
        float _955 = 0.0544886849820613861083984375 * (_880 * ((_949 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_892, _949, 1.0)) : 0.0));
        bool _958 = all(lessThanEqual(abs(_866), vec2(65504.0)));
        float _964 = ((((_900 ? _897 : 0.0) + (_915 ? _912 : 0.0)) + (_924 ? 0.40261995792388916015625 : 0.0)) + (_941 ? _938 : 0.0)) + (_958 ? _955 : 0.0);
        if (all(lessThan(_820, _89)))
        {
            imageStore(gOutFiltered, _820, vec4(mix(vec2(0.0), ((((mix(vec2(0.0), _831 * _897, bvec2(_900)) + mix(vec2(0.0), _842 * _912, bvec2(_915))) + mix(vec2(0.0), _79[5].values * 0.40261995792388916015625, bvec2(_924))) + mix(vec2(0.0), _855 * _938, bvec2(_941))) + mix(vec2(0.0), _866 * _955, bvec2(_958))) * (1.0 / _964), bvec2(_964 > 1.0000000031710768509710513471353e-30)), 0.0, 0.0));
        }
        break;
    } while(false);
}

