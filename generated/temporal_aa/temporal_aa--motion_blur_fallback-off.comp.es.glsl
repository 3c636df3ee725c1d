#version 310 es
layout(local_size_x = 16, local_size_y = 4, local_size_z = 1) in;

layout(binding = 0, std140) uniform TemporalAaParameters
{
    vec4 gOutputSize;
    vec2 gJitterPx;
    vec2 gMotionToUv;
    float gHistoryValid;
    float gFeedbackMin;
    float gFeedbackMax;
    float gBlurFromPx;
    float gBlurToPx;
} parameters;

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutHistory;
layout(binding = 2) uniform highp sampler2D gInDepth;
layout(binding = 1) uniform highp sampler2D gInColour;
layout(binding = 3) uniform highp sampler2D gInVelocity;
layout(binding = 4) uniform highp sampler2D gHistoryColour;

void main()
{
    do
    {
        uvec2 _83 = uvec2(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y * 4u);
        uvec2 _87 = uvec2(parameters.gOutputSize.xy);
        bool _89 = any(greaterThanEqual(_83, _87));
        if (_89)
        {
            break;
        }
        vec2 _93 = vec2(_83) + vec2(0.5);
        vec2 _95 = _93 * parameters.gOutputSize.zw;
        vec2 _97 = _93 * parameters.gOutputSize.zw + (vec2(-0.5) * parameters.gOutputSize.zw);
        vec4 _101 = textureGather(gInDepth, _97);
        vec2 _105 = vec2(parameters.gOutputSize.z, 0.0);
        vec4 _107 = textureGather(gInDepth, _97 + _105);
        float _108 = _101.w;
        float _109 = _101.z;
        float _110 = _107.z;
        float _111 = _101.x;
        float _112 = _101.y;
        float _113 = _107.y;
        vec2 _115 = _93 * parameters.gOutputSize.zw + (vec2(-0.5, 1.5) * parameters.gOutputSize.zw);
        vec4 _117 = textureGather(gInDepth, _115);
        vec4 _120 = textureGather(gInDepth, _115 + _105);
        float _121 = _117.w;
        float _122 = _117.z;
        float _123 = _120.z;
        float _124 = _117.x;
        float _125 = _117.y;
        float _126 = _120.y;
        vec2 _128 = _93 * parameters.gOutputSize.zw + (vec2(-0.5, 3.5) * parameters.gOutputSize.zw);
        vec4 _130 = textureGather(gInDepth, _128);
        vec4 _133 = textureGather(gInDepth, _128 + _105);
        float _134 = _130.w;
        float _135 = _130.z;
        float _136 = _133.z;
        float _137 = _130.x;
        float _138 = _130.y;
        float _139 = _133.y;
        vec2 _144 = _93 * parameters.gOutputSize.zw + vec2(0.0, (-1.0) * parameters.gOutputSize.w);
        vec4 _148 = textureLodOffset(gInColour, _144, 0.0, ivec2(-1, 0));
        float _149 = _148.x;
        float _152 = _148.y;
        float _155 = _148.z;
        vec3 _159 = min(vec3((_149 > 0.0) ? _149 : 0.0, (_152 > 0.0) ? _152 : 0.0, (_155 > 0.0) ? _155 : 0.0), vec3(65504.0));
        vec4 _161 = textureLod(gInColour, _144, 0.0);
        float _162 = _161.x;
        float _165 = _161.y;
        float _168 = _161.z;
        vec3 _172 = min(vec3((_162 > 0.0) ? _162 : 0.0, (_165 > 0.0) ? _165 : 0.0, (_168 > 0.0) ? _168 : 0.0), vec3(65504.0));
        vec4 _174 = textureLodOffset(gInColour, _144, 0.0, ivec2(1, 0));
        float _175 = _174.x;
        float _178 = _174.y;
        float _181 = _174.z;
        vec3 _185 = min(vec3((_175 > 0.0) ? _175 : 0.0, (_178 > 0.0) ? _178 : 0.0, (_181 > 0.0) ? _181 : 0.0), vec3(65504.0));
        vec4 _187 = textureLodOffset(gInColour, _95, 0.0, ivec2(-1, 0));
        float _188 = _187.x;
        float _191 = _187.y;
        float _194 = _187.z;
        vec3 _198 = min(vec3((_188 > 0.0) ? _188 : 0.0, (_191 > 0.0) ? _191 : 0.0, (_194 > 0.0) ? _194 : 0.0), vec3(65504.0));
        vec4 _200 = textureLod(gInColour, _95, 0.0);
        float _201 = _200.x;
        float _204 = _200.y;
        float _207 = _200.z;
        vec3 _211 = min(vec3((_201 > 0.0) ? _201 : 0.0, (_204 > 0.0) ? _204 : 0.0, (_207 > 0.0) ? _207 : 0.0), vec3(65504.0));
        vec4 _213 = textureLodOffset(gInColour, _95, 0.0, ivec2(1, 0));
        float _214 = _213.x;
        float _217 = _213.y;
        float _220 = _213.z;
        vec3 _224 = min(vec3((_214 > 0.0) ? _214 : 0.0, (_217 > 0.0) ? _217 : 0.0, (_220 > 0.0) ? _220 : 0.0), vec3(65504.0));
        vec2 _226 = _93 * parameters.gOutputSize.zw + vec2(0.0, parameters.gOutputSize.w);
        vec4 _228 = textureLodOffset(gInColour, _226, 0.0, ivec2(-1, 0));
        float _229 = _228.x;
        float _232 = _228.y;
        float _235 = _228.z;
        vec3 _239 = min(vec3((_229 > 0.0) ? _229 : 0.0, (_232 > 0.0) ? _232 : 0.0, (_235 > 0.0) ? _235 : 0.0), vec3(65504.0));
        vec4 _241 = textureLod(gInColour, _226, 0.0);
        float _242 = _241.x;
        float _245 = _241.y;
        float _248 = _241.z;
        vec3 _252 = min(vec3((_242 > 0.0) ? _242 : 0.0, (_245 > 0.0) ? _245 : 0.0, (_248 > 0.0) ? _248 : 0.0), vec3(65504.0));
        vec4 _254 = textureLodOffset(gInColour, _226, 0.0, ivec2(1, 0));
        float _255 = _254.x;
        float _258 = _254.y;
        float _261 = _254.z;
        vec3 _265 = min(vec3((_255 > 0.0) ? _255 : 0.0, (_258 > 0.0) ? _258 : 0.0, (_261 > 0.0) ? _261 : 0.0), vec3(65504.0));
        vec2 _268 = _93 * parameters.gOutputSize.zw + vec2(0.0, 2.0 * parameters.gOutputSize.w);
        vec4 _270 = textureLodOffset(gInColour, _268, 0.0, ivec2(-1, 0));
        float _271 = _270.x;
        float _274 = _270.y;
        float _277 = _270.z;
        vec3 _281 = min(vec3((_271 > 0.0) ? _271 : 0.0, (_274 > 0.0) ? _274 : 0.0, (_277 > 0.0) ? _277 : 0.0), vec3(65504.0));
        vec4 _283 = textureLod(gInColour, _268, 0.0);
        float _284 = _283.x;
        float _287 = _283.y;
        float _290 = _283.z;
        vec3 _294 = min(vec3((_284 > 0.0) ? _284 : 0.0, (_287 > 0.0) ? _287 : 0.0, (_290 > 0.0) ? _290 : 0.0), vec3(65504.0));
        vec4 _296 = textureLodOffset(gInColour, _268, 0.0, ivec2(1, 0));
        float _297 = _296.x;
        float _300 = _296.y;
        float _303 = _296.z;
        vec3 _307 = min(vec3((_297 > 0.0) ? _297 : 0.0, (_300 > 0.0) ? _300 : 0.0, (_303 > 0.0) ? _303 : 0.0), vec3(65504.0));
        vec2 _310 = _93 * parameters.gOutputSize.zw + vec2(0.0, 3.0 * parameters.gOutputSize.w);
        vec4 _312 = textureLodOffset(gInColour, _310, 0.0, ivec2(-1, 0));
        float _313 = _312.x;
        float _316 = _312.y;
        float _319 = _312.z;
        vec3 _323 = min(vec3((_313 > 0.0) ? _313 : 0.0, (_316 > 0.0) ? _316 : 0.0, (_319 > 0.0) ? _319 : 0.0), vec3(65504.0));
        vec4 _325 = textureLod(gInColour, _310, 0.0);
        float _326 = _325.x;
        float _329 = _325.y;
        float _332 = _325.z;
        vec3 _336 = min(vec3((_326 > 0.0) ? _326 : 0.0, (_329 > 0.0) ? _329 : 0.0, (_332 > 0.0) ? _332 : 0.0), vec3(65504.0));
        vec4 _338 = textureLodOffset(gInColour, _310, 0.0, ivec2(1, 0));
        float _339 = _338.x;
        float _342 = _338.y;
        float _345 = _338.z;
        vec3 _349 = min(vec3((_339 > 0.0) ? _339 : 0.0, (_342 > 0.0) ? _342 : 0.0, (_345 > 0.0) ? _345 : 0.0), vec3(65504.0));
        vec2 _352 = _93 * parameters.gOutputSize.zw + vec2(0.0, 4.0 * parameters.gOutputSize.w);
        vec4 _354 = textureLodOffset(gInColour, _352, 0.0, ivec2(-1, 0));
        float _355 = _354.x;
        float _358 = _354.y;
        float _361 = _354.z;
        vec3 _365 = min(vec3((_355 > 0.0) ? _355 : 0.0, (_358 > 0.0) ? _358 : 0.0, (_361 > 0.0) ? _361 : 0.0), vec3(65504.0));
        vec4 _367 = textureLod(gInColour, _352, 0.0);
        float _368 = _367.x;
        float _371 = _367.y;
        float _374 = _367.z;
        vec3 _378 = min(vec3((_368 > 0.0) ? _368 : 0.0, (_371 > 0.0) ? _371 : 0.0, (_374 > 0.0) ? _374 : 0.0), vec3(65504.0));
        vec4 _380 = textureLodOffset(gInColour, _352, 0.0, ivec2(1, 0));
        float _381 = _380.x;
        float _384 = _380.y;
        float _387 = _380.z;
        vec3 _391 = min(vec3((_381 > 0.0) ? _381 : 0.0, (_384 > 0.0) ? _384 : 0.0, (_387 > 0.0) ? _387 : 0.0), vec3(65504.0));
        vec2 _396 = mix(vec2(_111, -1.0), vec2(_113, 1.0), bvec2(_113 < _111));
        vec2 _401 = mix(vec2(_112, 0.0), _396, bvec2(_396.x < _112));
        vec2 _406 = mix(vec2(_108, -1.0), vec2(_110, 1.0), bvec2(_110 < _108));
        vec2 _411 = mix(vec2(_109, 0.0), _406, bvec2(_406.x < _109));
        vec2 _416 = mix(vec2(_121, -1.0), vec2(_123, 1.0), bvec2(_123 < _121));
        vec2 _421 = mix(vec2(_122, 0.0), _416, bvec2(_416.x < _122));
        float _422 = _421.x;
        bool _424 = _422 < _411.x;
        vec2 _426 = mix(_411, _421, bvec2(_424));
        float _429 = _401.x;
        float _451 = max(-parameters.gJitterPx.x, 0.0);
        float _453 = 1.0 - abs(parameters.gJitterPx.x);
        float _454 = max(parameters.gJitterPx.x, 0.0);
        float _457 = max(-parameters.gJitterPx.y, 0.0);
        float _459 = 1.0 - abs(parameters.gJitterPx.y);
        float _460 = max(parameters.gJitterPx.y, 0.0);
        vec3 _471 = ((_198 * _451) + (_211 * _453)) + (_224 * _454);
        vec3 _478 = ((_239 * _451) + (_252 * _453)) + (_265 * _454);
        vec3 _480 = (((((_159 * _451) + (_172 * _453)) + (_185 * _454)) * _457) + (_471 * _459)) + (_478 * _460);
        vec3 _481 = min(_198, _224);
        vec3 _484 = min(min(_481, _211), min(_172, _252));
        vec3 _485 = max(_198, _224);
        vec3 _488 = max(max(_485, _211), max(_172, _252));
        vec3 _490 = min(_239, _265);
        vec3 _494 = max(_239, _265);
        vec3 _498 = (_484 + min(_484, min(min(_159, _185), _490))) * 0.5;
        vec3 _500 = (_488 + max(_488, max(max(_159, _185), _494))) * 0.5;
        vec2 _502 = _93 * parameters.gOutputSize.zw + (-(textureLod(gInVelocity, _93 * parameters.gOutputSize.zw + (mix(vec2(_401.y, 0.0), vec2(_426.y, _424 ? 1.0 : (-1.0)), bvec2(_426.x < _429)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
        vec4 _506 = textureLod(gHistoryColour, _502, 0.0);
        float _507 = _506.x;
        float _510 = _506.y;
        float _513 = _506.z;
        vec3 _519 = (_500 + _498) * 0.5;
        vec3 _523 = min(vec3((_507 > 0.0) ? _507 : 0.0, (_510 > 0.0) ? _510 : 0.0, (_513 > 0.0) ? _513 : 0.0), vec3(65504.0)) - _519;
        vec3 _526 = max((_500 - _498) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_523) + vec3(1.0000000031710768509710513471353e-30));
        float _543 = parameters.gFeedbackMax * parameters.gHistoryValid;
        do
        {
            if (_89)
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_83), vec4(min(_480 + (((_519 + (_523 * min(min(_526.x, 1.0), min(_526.y, _526.z)))) - _480) * (all(lessThanEqual(abs(_502 - vec2(0.5)), vec2(0.5))) ? _543 : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _562 = mix(vec2(_124, -1.0), vec2(_126, 1.0), bvec2(_126 < _124));
        vec2 _567 = mix(vec2(_125, 0.0), _562, bvec2(_562.x < _125));
        float _568 = _567.x;
        bool _569 = _568 < _429;
        vec2 _571 = mix(_401, _567, bvec2(_569));
        vec3 _592 = ((_281 * _451) + (_294 * _453)) + (_307 * _454);
        vec3 _594 = ((_471 * _457) + (_478 * _459)) + (_592 * _460);
        vec3 _597 = min(min(_490, _252), min(_211, _294));
        vec3 _600 = max(max(_494, _252), max(_211, _294));
        vec3 _601 = min(_281, _307);
        vec3 _604 = max(_281, _307);
        vec3 _608 = (_597 + min(_597, min(_481, _601))) * 0.5;
        vec3 _610 = (_600 + max(_600, max(_485, _604))) * 0.5;
        vec2 _612 = (-textureLod(gInVelocity, mix(vec2(_421.y, 0.0), vec2(_571.y, _569 ? 1.0 : (-1.0)), bvec2(_571.x < _422)) * parameters.gOutputSize.zw + _226, 0.0).xy) * parameters.gMotionToUv + _226;
        vec4 _614 = textureLod(gHistoryColour, _612, 0.0);
        float _615 = _614.x;
        float _618 = _614.y;
        float _621 = _614.z;
        vec3 _627 = (_610 + _608) * 0.5;
        vec3 _631 = min(vec3((_615 > 0.0) ? _615 : 0.0, (_618 > 0.0) ? _618 : 0.0, (_621 > 0.0) ? _621 : 0.0), vec3(65504.0)) - _627;
        vec3 _634 = max((_610 - _608) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_631) + vec3(1.0000000031710768509710513471353e-30));
        uvec2 _652 = _83 + uvec2(0u, 1u);
        do
        {
            if (any(greaterThanEqual(_652, _87)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_652), vec4(min(_594 + (((_627 + (_631 * min(min(_634.x, 1.0), min(_634.y, _634.z)))) - _594) * (all(lessThanEqual(abs(_612 - vec2(0.5)), vec2(0.5))) ? _543 : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _668 = mix(vec2(_134, -1.0), vec2(_136, 1.0), bvec2(_136 < _134));
        vec2 _673 = mix(vec2(_135, 0.0), _668, bvec2(_668.x < _135));
        float _674 = _673.x;
        bool _675 = _674 < _422;
        vec2 _677 = mix(_421, _673, bvec2(_675));
        vec3 _698 = ((_323 * _451) + (_336 * _453)) + (_349 * _454);
        vec3 _700 = ((_478 * _457) + (_592 * _459)) + (_698 * _460);
        vec3 _703 = min(min(_601, _294), min(_252, _336));
        vec3 _706 = max(max(_604, _294), max(_252, _336));
        vec3 _707 = min(_323, _349);
        vec3 _710 = max(_323, _349);
        vec3 _714 = (_703 + min(_703, min(_490, _707))) * 0.5;
        vec3 _716 = (_706 + max(_706, max(_494, _710))) * 0.5;
        vec2 _718 = (-textureLod(gInVelocity, mix(vec2(_567.y, 0.0), vec2(_677.y, _675 ? 1.0 : (-1.0)), bvec2(_677.x < _568)) * parameters.gOutputSize.zw + _268, 0.0).xy) * parameters.gMotionToUv + _268;
        vec4 _720 = textureLod(gHistoryColour, _718, 0.0);
        float _721 = _720.x;
        float _724 = _720.y;
        float _727 = _720.z;
        vec3 _733 = (_716 + _714) * 0.5;
        vec3 _737 = min(vec3((_721 > 0.0) ? _721 : 0.0, (_724 > 0.0) ? _724 : 0.0, (_727 > 0.0) ? _727 : 0.0), vec3(65504.0)) - _733;
        vec3 _740 = max((_716 - _714) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_737) + vec3(1.0000000031710768509710513471353e-30));
        uvec2 _758 = _83 + uvec2(0u, 2u);
        do
        {
            if (any(greaterThanEqual(_758, _87)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_758), vec4(min(_700 + (((_733 + (_737 * min(min(_740.x, 1.0), min(_740.y, _740.z)))) - _700) * (all(lessThanEqual(abs(_718 - vec2(0.5)), vec2(0.5))) ? _543 : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _774 = mix(vec2(_137, -1.0), vec2(_139, 1.0), bvec2(_139 < _137));
        vec2 _779 = mix(vec2(_138, 0.0), _774, bvec2(_774.x < _138));
        bool _781 = _779.x < _568;
        vec2 _783 = mix(_567, _779, bvec2(_781));
        vec3 _806 = ((_592 * _457) + (_698 * _459)) + ((((_365 * _451) + (_378 * _453)) + (_391 * _454)) * _460);
        vec3 _809 = min(min(_707, _336), min(_294, _378));
        vec3 _812 = max(max(_710, _336), max(_294, _378));
        vec3 _820 = (_809 + min(_809, min(_601, min(_365, _391)))) * 0.5;
        vec3 _822 = (_812 + max(_812, max(_604, max(_365, _391)))) * 0.5;
        vec2 _824 = (-textureLod(gInVelocity, mix(vec2(_673.y, 0.0), vec2(_783.y, _781 ? 1.0 : (-1.0)), bvec2(_783.x < _674)) * parameters.gOutputSize.zw + _310, 0.0).xy) * parameters.gMotionToUv + _310;
        vec4 _826 = textureLod(gHistoryColour, _824, 0.0);
        float _827 = _826.x;
        float _830 = _826.y;
        float _833 = _826.z;
        vec3 _839 = (_822 + _820) * 0.5;
        vec3 _843 = min(vec3((_827 > 0.0) ? _827 : 0.0, (_830 > 0.0) ? _830 : 0.0, (_833 > 0.0) ? _833 : 0.0), vec3(65504.0)) - _839;
        vec3 _846 = max((_822 - _820) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_843) + vec3(1.0000000031710768509710513471353e-30));
        uvec2 _864 = _83 + uvec2(0u, 3u);
        do
        {
            if (any(greaterThanEqual(_864, _87)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_864), vec4(min(_806 + (((_839 + (_843 * min(min(_846.x, 1.0), min(_846.y, _846.z)))) - _806) * (all(lessThanEqual(abs(_824 - vec2(0.5)), vec2(0.5))) ? _543 : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        break;
    } while(false);
}

