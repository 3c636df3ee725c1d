#version 450
layout(local_size_x = 32, local_size_y = 4, local_size_z = 1) in;

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

layout(binding = 16) uniform writeonly image2D gOutHistory;
layout(binding = 2) uniform sampler2D gInDepth;
layout(binding = 3) uniform sampler2D gInVelocity;
layout(binding = 4) uniform sampler2D gHistoryColour;
layout(binding = 1) uniform sampler2D gInColour;

void main()
{
    do
    {
        uvec2 _82 = uvec2(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y * 6u);
        vec2 _84 = vec2(_82) + vec2(0.5);
        vec2 _88 = _84 * parameters.gOutputSize.zw;
        vec2 _91 = vec2(0.0, parameters.gOutputSize.w);
        uvec2 _93 = uvec2(parameters.gOutputSize.xy);
        bool _95 = any(greaterThanEqual(_82, _93));
        if (_95)
        {
            break;
        }
        vec2 _99 = fma(_84, parameters.gOutputSize.zw, _91 * (-1.0));
        vec2 _100 = parameters.gOutputSize.zw * 0.5;
        vec2 _107 = vec2(-_100.x, _100.y);
        vec4 _109 = textureGather(gInDepth, _99 + _107);
        vec4 _112 = textureGather(gInDepth, _99 + _100);
        float _113 = _109.w;
        float _114 = _109.z;
        float _115 = _112.z;
        float _116 = _109.x;
        float _117 = _109.y;
        float _118 = _112.y;
        vec2 _120 = fma(_84, parameters.gOutputSize.zw, _91 * 1.0);
        vec4 _123 = textureGather(gInDepth, _120 + _107);
        vec4 _126 = textureGather(gInDepth, _120 + _100);
        float _127 = _123.w;
        float _128 = _123.z;
        float _129 = _126.z;
        float _130 = _123.x;
        float _131 = _123.y;
        float _132 = _126.y;
        vec2 _134 = fma(_84, parameters.gOutputSize.zw, _91 * 3.0);
        vec4 _137 = textureGather(gInDepth, _134 + _107);
        vec4 _140 = textureGather(gInDepth, _134 + _100);
        float _141 = _137.w;
        float _142 = _137.z;
        float _143 = _140.z;
        float _144 = _137.x;
        float _145 = _137.y;
        float _146 = _140.y;
        vec2 _148 = fma(_84, parameters.gOutputSize.zw, _91 * 5.0);
        vec4 _151 = textureGather(gInDepth, _148 + _107);
        vec4 _154 = textureGather(gInDepth, _148 + _100);
        float _155 = _151.w;
        float _156 = _151.z;
        float _157 = _154.z;
        float _158 = _151.x;
        float _159 = _151.y;
        float _160 = _154.y;
        vec2 _165 = mix(vec2(_116, -1.0), vec2(_118, 1.0), bvec2(_118 < _116));
        vec2 _170 = mix(vec2(_117, 0.0), _165, bvec2(_165.x < _117));
        vec2 _175 = mix(vec2(_113, -1.0), vec2(_115, 1.0), bvec2(_115 < _113));
        vec2 _180 = mix(vec2(_114, 0.0), _175, bvec2(_175.x < _114));
        vec2 _185 = mix(vec2(_127, -1.0), vec2(_129, 1.0), bvec2(_129 < _127));
        vec2 _190 = mix(vec2(_128, 0.0), _185, bvec2(_185.x < _128));
        float _191 = _190.x;
        bool _193 = _191 < _180.x;
        vec2 _195 = mix(_180, _190, bvec2(_193));
        float _198 = _170.x;
        vec2 _220 = mix(vec2(_130, -1.0), vec2(_132, 1.0), bvec2(_132 < _130));
        vec2 _225 = mix(vec2(_131, 0.0), _220, bvec2(_220.x < _131));
        float _226 = _225.x;
        bool _227 = _226 < _198;
        vec2 _229 = mix(_170, _225, bvec2(_227));
        vec2 _244 = fma(_84, parameters.gOutputSize.zw, _91 * 2.0);
        vec2 _249 = mix(vec2(_141, -1.0), vec2(_143, 1.0), bvec2(_143 < _141));
        vec2 _254 = mix(vec2(_142, 0.0), _249, bvec2(_249.x < _142));
        float _255 = _254.x;
        bool _256 = _255 < _191;
        vec2 _258 = mix(_190, _254, bvec2(_256));
        vec2 _276 = mix(vec2(_144, -1.0), vec2(_146, 1.0), bvec2(_146 < _144));
        vec2 _281 = mix(vec2(_145, 0.0), _276, bvec2(_276.x < _145));
        float _282 = _281.x;
        bool _283 = _282 < _226;
        vec2 _285 = mix(_225, _281, bvec2(_283));
        vec2 _300 = fma(_84, parameters.gOutputSize.zw, _91 * 4.0);
        vec2 _305 = mix(vec2(_155, -1.0), vec2(_157, 1.0), bvec2(_157 < _155));
        vec2 _310 = mix(vec2(_156, 0.0), _305, bvec2(_305.x < _156));
        float _311 = _310.x;
        bool _312 = _311 < _255;
        vec2 _314 = mix(_254, _310, bvec2(_312));
        vec2 _332 = mix(vec2(_158, -1.0), vec2(_160, 1.0), bvec2(_160 < _158));
        vec2 _337 = mix(vec2(_159, 0.0), _332, bvec2(_332.x < _159));
        bool _339 = _337.x < _282;
        vec2 _341 = mix(_281, _337, bvec2(_339));
        vec2 _356 = fma(_84, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(_84, parameters.gOutputSize.zw, mix(vec2(_170.y, 0.0), vec2(_195.y, _193 ? 1.0 : (-1.0)), bvec2(_195.x < _198)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
        vec4 _360 = textureLod(gHistoryColour, _356, 0.0);
        float _361 = _360.x;
        float _364 = _360.y;
        float _367 = _360.z;
        vec2 _373 = fma(-textureLod(gInVelocity, fma(mix(vec2(_190.y, 0.0), vec2(_229.y, _227 ? 1.0 : (-1.0)), bvec2(_229.x < _191)), parameters.gOutputSize.zw, _120), 0.0).xy, parameters.gMotionToUv, _120);
        vec4 _375 = textureLod(gHistoryColour, _373, 0.0);
        float _376 = _375.x;
        float _379 = _375.y;
        float _382 = _375.z;
        vec2 _388 = fma(-textureLod(gInVelocity, fma(mix(vec2(_225.y, 0.0), vec2(_258.y, _256 ? 1.0 : (-1.0)), bvec2(_258.x < _226)), parameters.gOutputSize.zw, _244), 0.0).xy, parameters.gMotionToUv, _244);
        vec4 _390 = textureLod(gHistoryColour, _388, 0.0);
        float _391 = _390.x;
        float _394 = _390.y;
        float _397 = _390.z;
        vec2 _403 = fma(-textureLod(gInVelocity, fma(mix(vec2(_254.y, 0.0), vec2(_285.y, _283 ? 1.0 : (-1.0)), bvec2(_285.x < _255)), parameters.gOutputSize.zw, _134), 0.0).xy, parameters.gMotionToUv, _134);
        vec4 _405 = textureLod(gHistoryColour, _403, 0.0);
        float _406 = _405.x;
        float _409 = _405.y;
        float _412 = _405.z;
        vec2 _418 = fma(-textureLod(gInVelocity, fma(mix(vec2(_281.y, 0.0), vec2(_314.y, _312 ? 1.0 : (-1.0)), bvec2(_314.x < _282)), parameters.gOutputSize.zw, _300), 0.0).xy, parameters.gMotionToUv, _300);
        vec4 _420 = textureLod(gHistoryColour, _418, 0.0);
        float _421 = _420.x;
        float _424 = _420.y;
        float _427 = _420.z;
        vec2 _433 = fma(-textureLod(gInVelocity, fma(mix(vec2(_310.y, 0.0), vec2(_341.y, _339 ? 1.0 : (-1.0)), bvec2(_341.x < _311)), parameters.gOutputSize.zw, _148), 0.0).xy, parameters.gMotionToUv, _148);
        vec4 _435 = textureLod(gHistoryColour, _433, 0.0);
        float _436 = _435.x;
        float _439 = _435.y;
        float _442 = _435.z;
        vec2 _448 = fma(_84, parameters.gOutputSize.zw, -_91);
        vec4 _452 = textureLod(gInColour, _448, 0.0);
        float _453 = _452.x;
        float _456 = _452.y;
        float _459 = _452.z;
        vec3 _463 = min(vec3((_453 > 0.0) ? _453 : 0.0, (_456 > 0.0) ? _456 : 0.0, (_459 > 0.0) ? _459 : 0.0), vec3(65504.0));
        vec4 _465 = textureLodOffset(gInColour, _448, 0.0, ivec2(1, 0));
        float _466 = _465.x;
        float _469 = _465.y;
        float _472 = _465.z;
        vec3 _476 = min(vec3((_466 > 0.0) ? _466 : 0.0, (_469 > 0.0) ? _469 : 0.0, (_472 > 0.0) ? _472 : 0.0), vec3(65504.0));
        vec4 _478 = textureLodOffset(gInColour, _448, 0.0, ivec2(-1, 0));
        float _479 = _478.x;
        float _482 = _478.y;
        float _485 = _478.z;
        vec3 _489 = min(vec3((_479 > 0.0) ? _479 : 0.0, (_482 > 0.0) ? _482 : 0.0, (_485 > 0.0) ? _485 : 0.0), vec3(65504.0));
        vec4 _491 = textureLod(gInColour, _88, 0.0);
        float _492 = _491.x;
        float _495 = _491.y;
        float _498 = _491.z;
        vec3 _502 = min(vec3((_492 > 0.0) ? _492 : 0.0, (_495 > 0.0) ? _495 : 0.0, (_498 > 0.0) ? _498 : 0.0), vec3(65504.0));
        vec4 _504 = textureLodOffset(gInColour, _88, 0.0, ivec2(1, 0));
        float _505 = _504.x;
        float _508 = _504.y;
        float _511 = _504.z;
        vec3 _515 = min(vec3((_505 > 0.0) ? _505 : 0.0, (_508 > 0.0) ? _508 : 0.0, (_511 > 0.0) ? _511 : 0.0), vec3(65504.0));
        vec4 _517 = textureLodOffset(gInColour, _88, 0.0, ivec2(-1, 0));
        float _518 = _517.x;
        float _521 = _517.y;
        float _524 = _517.z;
        vec3 _528 = min(vec3((_518 > 0.0) ? _518 : 0.0, (_521 > 0.0) ? _521 : 0.0, (_524 > 0.0) ? _524 : 0.0), vec3(65504.0));
        vec2 _529 = fma(_84, parameters.gOutputSize.zw, _91);
        vec4 _531 = textureLod(gInColour, _529, 0.0);
        float _532 = _531.x;
        float _535 = _531.y;
        float _538 = _531.z;
        vec3 _542 = min(vec3((_532 > 0.0) ? _532 : 0.0, (_535 > 0.0) ? _535 : 0.0, (_538 > 0.0) ? _538 : 0.0), vec3(65504.0));
        vec4 _544 = textureLodOffset(gInColour, _529, 0.0, ivec2(1, 0));
        float _545 = _544.x;
        float _548 = _544.y;
        float _551 = _544.z;
        vec3 _555 = min(vec3((_545 > 0.0) ? _545 : 0.0, (_548 > 0.0) ? _548 : 0.0, (_551 > 0.0) ? _551 : 0.0), vec3(65504.0));
        vec4 _557 = textureLodOffset(gInColour, _529, 0.0, ivec2(-1, 0));
        float _558 = _557.x;
        float _561 = _557.y;
        float _564 = _557.z;
        vec3 _568 = min(vec3((_558 > 0.0) ? _558 : 0.0, (_561 > 0.0) ? _561 : 0.0, (_564 > 0.0) ? _564 : 0.0), vec3(65504.0));
        float _573 = max(-parameters.gJitterPx.x, 0.0);
        float _575 = 1.0 - abs(parameters.gJitterPx.x);
        float _576 = max(parameters.gJitterPx.x, 0.0);
        float _579 = max(-parameters.gJitterPx.y, 0.0);
        float _581 = 1.0 - abs(parameters.gJitterPx.y);
        float _582 = max(parameters.gJitterPx.y, 0.0);
        vec3 _593 = ((_528 * _573) + (_502 * _575)) + (_515 * _576);
        vec3 _600 = ((_568 * _573) + (_542 * _575)) + (_555 * _576);
        vec3 _602 = (((((_489 * _573) + (_463 * _575)) + (_476 * _576)) * _579) + (_593 * _581)) + (_600 * _582);
        vec3 _603 = min(_528, _515);
        vec3 _606 = min(min(_603, _502), min(_463, _542));
        vec3 _607 = max(_528, _515);
        vec3 _610 = max(max(_607, _502), max(_463, _542));
        vec3 _612 = min(_568, _555);
        vec3 _616 = max(_568, _555);
        vec3 _620 = (_606 + min(_606, min(min(_489, _476), _612))) * 0.5;
        vec3 _622 = (_610 + max(_610, max(max(_489, _476), _616))) * 0.5;
        vec3 _624 = (_622 + _620) * 0.5;
        vec3 _628 = min(vec3((_361 > 0.0) ? _361 : 0.0, (_364 > 0.0) ? _364 : 0.0, (_367 > 0.0) ? _367 : 0.0), vec3(65504.0)) - _624;
        vec3 _631 = max((_622 - _620) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_628) + vec3(1.0000000031710768509710513471353e-30));
        float _648 = parameters.gFeedbackMax * parameters.gHistoryValid;
        do
        {
            if (_95)
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_82), vec4(min(_602 + (((_624 + (_628 * min(min(_631.x, 1.0), min(_631.y, _631.z)))) - _602) * (all(lessThanEqual(abs(_356 - vec2(0.5)), vec2(0.5))) ? _648 : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _663 = _120 + _91;
        vec4 _665 = textureLod(gInColour, _663, 0.0);
        float _666 = _665.x;
        float _669 = _665.y;
        float _672 = _665.z;
        vec3 _676 = min(vec3((_666 > 0.0) ? _666 : 0.0, (_669 > 0.0) ? _669 : 0.0, (_672 > 0.0) ? _672 : 0.0), vec3(65504.0));
        vec4 _678 = textureLodOffset(gInColour, _663, 0.0, ivec2(1, 0));
        float _679 = _678.x;
        float _682 = _678.y;
        float _685 = _678.z;
        vec3 _689 = min(vec3((_679 > 0.0) ? _679 : 0.0, (_682 > 0.0) ? _682 : 0.0, (_685 > 0.0) ? _685 : 0.0), vec3(65504.0));
        vec4 _691 = textureLodOffset(gInColour, _663, 0.0, ivec2(-1, 0));
        float _692 = _691.x;
        float _695 = _691.y;
        float _698 = _691.z;
        vec3 _702 = min(vec3((_692 > 0.0) ? _692 : 0.0, (_695 > 0.0) ? _695 : 0.0, (_698 > 0.0) ? _698 : 0.0), vec3(65504.0));
        vec3 _710 = ((_702 * _573) + (_676 * _575)) + (_689 * _576);
        vec3 _712 = ((_593 * _579) + (_600 * _581)) + (_710 * _582);
        vec3 _715 = min(min(_612, _542), min(_502, _676));
        vec3 _718 = max(max(_616, _542), max(_502, _676));
        vec3 _719 = min(_702, _689);
        vec3 _722 = max(_702, _689);
        vec3 _726 = (_715 + min(_715, min(_603, _719))) * 0.5;
        vec3 _728 = (_718 + max(_718, max(_607, _722))) * 0.5;
        vec3 _730 = (_728 + _726) * 0.5;
        vec3 _734 = min(vec3((_376 > 0.0) ? _376 : 0.0, (_379 > 0.0) ? _379 : 0.0, (_382 > 0.0) ? _382 : 0.0), vec3(65504.0)) - _730;
        vec3 _737 = max((_728 - _726) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_734) + vec3(1.0000000031710768509710513471353e-30));
        uvec2 _755 = _82 + uvec2(0u, 1u);
        do
        {
            if (any(greaterThanEqual(_755, _93)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_755), vec4(min(_712 + (((_730 + (_734 * min(min(_737.x, 1.0), min(_737.y, _737.z)))) - _712) * (all(lessThanEqual(abs(_373 - vec2(0.5)), vec2(0.5))) ? _648 : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _767 = _244 + _91;
        vec4 _769 = textureLod(gInColour, _767, 0.0);
        float _770 = _769.x;
        float _773 = _769.y;
        float _776 = _769.z;
        vec3 _780 = min(vec3((_770 > 0.0) ? _770 : 0.0, (_773 > 0.0) ? _773 : 0.0, (_776 > 0.0) ? _776 : 0.0), vec3(65504.0));
        vec4 _782 = textureLodOffset(gInColour, _767, 0.0, ivec2(1, 0));
        float _783 = _782.x;
        float _786 = _782.y;
        float _789 = _782.z;
        vec3 _793 = min(vec3((_783 > 0.0) ? _783 : 0.0, (_786 > 0.0) ? _786 : 0.0, (_789 > 0.0) ? _789 : 0.0), vec3(65504.0));
        vec4 _795 = textureLodOffset(gInColour, _767, 0.0, ivec2(-1, 0));
        float _796 = _795.x;
        float _799 = _795.y;
        float _802 = _795.z;
        vec3 _806 = min(vec3((_796 > 0.0) ? _796 : 0.0, (_799 > 0.0) ? _799 : 0.0, (_802 > 0.0) ? _802 : 0.0), vec3(65504.0));
        vec3 _814 = ((_806 * _573) + (_780 * _575)) + (_793 * _576);
        vec3 _816 = ((_600 * _579) + (_710 * _581)) + (_814 * _582);
        vec3 _819 = min(min(_719, _676), min(_542, _780));
        vec3 _822 = max(max(_722, _676), max(_542, _780));
        vec3 _823 = min(_806, _793);
        vec3 _826 = max(_806, _793);
        vec3 _830 = (_819 + min(_819, min(_612, _823))) * 0.5;
        vec3 _832 = (_822 + max(_822, max(_616, _826))) * 0.5;
        vec3 _834 = (_832 + _830) * 0.5;
        vec3 _838 = min(vec3((_391 > 0.0) ? _391 : 0.0, (_394 > 0.0) ? _394 : 0.0, (_397 > 0.0) ? _397 : 0.0), vec3(65504.0)) - _834;
        vec3 _841 = max((_832 - _830) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_838) + vec3(1.0000000031710768509710513471353e-30));
        uvec2 _859 = _82 + uvec2(0u, 2u);
        do
        {
            if (any(greaterThanEqual(_859, _93)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_859), vec4(min(_816 + (((_834 + (_838 * min(min(_841.x, 1.0), min(_841.y, _841.z)))) - _816) * (all(lessThanEqual(abs(_388 - vec2(0.5)), vec2(0.5))) ? _648 : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _871 = _134 + _91;
        vec4 _873 = textureLod(gInColour, _871, 0.0);
        float _874 = _873.x;
        float _877 = _873.y;
        float _880 = _873.z;
        vec3 _884 = min(vec3((_874 > 0.0) ? _874 : 0.0, (_877 > 0.0) ? _877 : 0.0, (_880 > 0.0) ? _880 : 0.0), vec3(65504.0));
        vec4 _886 = textureLodOffset(gInColour, _871, 0.0, ivec2(1, 0));
        float _887 = _886.x;
        float _890 = _886.y;
        float _893 = _886.z;
        vec3 _897 = min(vec3((_887 > 0.0) ? _887 : 0.0, (_890 > 0.0) ? _890 : 0.0, (_893 > 0.0) ? _893 : 0.0), vec3(65504.0));
        vec4 _899 = textureLodOffset(gInColour, _871, 0.0, ivec2(-1, 0));
        float _900 = _899.x;
        float _903 = _899.y;
        float _906 = _899.z;
        vec3 _910 = min(vec3((_900 > 0.0) ? _900 : 0.0, (_903 > 0.0) ? _903 : 0.0, (_906 > 0.0) ? _906 : 0.0), vec3(65504.0));
        vec3 _918 = ((_910 * _573) + (_884 * _575)) + (_897 * _576);
        vec3 _920 = ((_710 * _579) + (_814 * _581)) + (_918 * _582);
        vec3 _923 = min(min(_823, _780), min(_676, _884));
        vec3 _926 = max(max(_826, _780), max(_676, _884));
        vec3 _927 = min(_910, _897);
        vec3 _930 = max(_910, _897);
        vec3 _934 = (_923 + min(_923, min(_719, _927))) * 0.5;
        vec3 _936 = (_926 + max(_926, max(_722, _930))) * 0.5;
        vec3 _938 = (_936 + _934) * 0.5;
        vec3 _942 = min(vec3((_406 > 0.0) ? _406 : 0.0, (_409 > 0.0) ? _409 : 0.0, (_412 > 0.0) ? _412 : 0.0), vec3(65504.0)) - _938;
        vec3 _945 = max((_936 - _934) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_942) + vec3(1.0000000031710768509710513471353e-30));
        uvec2 _963 = _82 + uvec2(0u, 3u);
        do
        {
            if (any(greaterThanEqual(_963, _93)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_963), vec4(min(_920 + (((_938 + (_942 * min(min(_945.x, 1.0), min(_945.y, _945.z)))) - _920) * (all(lessThanEqual(abs(_403 - vec2(0.5)), vec2(0.5))) ? _648 : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _975 = _300 + _91;
        vec4 _977 = textureLod(gInColour, _975, 0.0);
        float _978 = _977.x;
        float _981 = _977.y;
        float _984 = _977.z;
        vec3 _988 = min(vec3((_978 > 0.0) ? _978 : 0.0, (_981 > 0.0) ? _981 : 0.0, (_984 > 0.0) ? _984 : 0.0), vec3(65504.0));
        vec4 _990 = textureLodOffset(gInColour, _975, 0.0, ivec2(1, 0));
        float _991 = _990.x;
        float _994 = _990.y;
        float _997 = _990.z;
        vec3 _1001 = min(vec3((_991 > 0.0) ? _991 : 0.0, (_994 > 0.0) ? _994 : 0.0, (_997 > 0.0) ? _997 : 0.0), vec3(65504.0));
        vec4 _1003 = textureLodOffset(gInColour, _975, 0.0, ivec2(-1, 0));
        float _1004 = _1003.x;
        float _1007 = _1003.y;
        float _1010 = _1003.z;
        vec3 _1014 = min(vec3((_1004 > 0.0) ? _1004 : 0.0, (_1007 > 0.0) ? _1007 : 0.0, (_1010 > 0.0) ? _1010 : 0.0), vec3(65504.0));
        vec3 _1022 = ((_1014 * _573) + (_988 * _575)) + (_1001 * _576);
        vec3 _1024 = ((_814 * _579) + (_918 * _581)) + (_1022 * _582);
        vec3 _1027 = min(min(_927, _884), min(_780, _988));
        vec3 _1030 = max(max(_930, _884), max(_780, _988));
        vec3 _1031 = min(_1014, _1001);
        vec3 _1034 = max(_1014, _1001);
        vec3 _1038 = (_1027 + min(_1027, min(_823, _1031))) * 0.5;
        vec3 _1040 = (_1030 + max(_1030, max(_826, _1034))) * 0.5;
        vec3 _1042 = (_1040 + _1038) * 0.5;
        vec3 _1046 = min(vec3((_421 > 0.0) ? _421 : 0.0, (_424 > 0.0) ? _424 : 0.0, (_427 > 0.0) ? _427 : 0.0), vec3(65504.0)) - _1042;
        vec3 _1049 = max((_1040 - _1038) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_1046) + vec3(1.0000000031710768509710513471353e-30));
        uvec2 _1067 = _82 + uvec2(0u, 4u);
        do
        {
            if (any(greaterThanEqual(_1067, _93)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_1067), vec4(min(_1024 + (((_1042 + (_1046 * min(min(_1049.x, 1.0), min(_1049.y, _1049.z)))) - _1024) * (all(lessThanEqual(abs(_418 - vec2(0.5)), vec2(0.5))) ? _648 : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        vec2 _1079 = _148 + _91;
        vec4 _1081 = textureLod(gInColour, _1079, 0.0);
        float _1082 = _1081.x;
        float _1085 = _1081.y;
        float _1088 = _1081.z;
        vec3 _1092 = min(vec3((_1082 > 0.0) ? _1082 : 0.0, (_1085 > 0.0) ? _1085 : 0.0, (_1088 > 0.0) ? _1088 : 0.0), vec3(65504.0));
        vec4 _1094 = textureLodOffset(gInColour, _1079, 0.0, ivec2(1, 0));
        float _1095 = _1094.x;
        float _1098 = _1094.y;
        float _1101 = _1094.z;
        vec3 _1105 = min(vec3((_1095 > 0.0) ? _1095 : 0.0, (_1098 > 0.0) ? _1098 : 0.0, (_1101 > 0.0) ? _1101 : 0.0), vec3(65504.0));
        vec4 _1107 = textureLodOffset(gInColour, _1079, 0.0, ivec2(-1, 0));
        float _1108 = _1107.x;
        float _1111 = _1107.y;
        float _1114 = _1107.z;
        vec3 _1118 = min(vec3((_1108 > 0.0) ? _1108 : 0.0, (_1111 > 0.0) ? _1111 : 0.0, (_1114 > 0.0) ? _1114 : 0.0), vec3(65504.0));
        vec3 _1128 = ((_918 * _579) + (_1022 * _581)) + ((((_1118 * _573) + (_1092 * _575)) + (_1105 * _576)) * _582);
        vec3 _1131 = min(min(_1031, _988), min(_884, _1092));
        vec3 _1134 = max(max(_1034, _988), max(_884, _1092));
        vec3 _1142 = (_1131 + min(_1131, min(_927, min(_1118, _1105)))) * 0.5;
        vec3 _1144 = (_1134 + max(_1134, max(_930, max(_1118, _1105)))) * 0.5;
        vec3 _1146 = (_1144 + _1142) * 0.5;
        vec3 _1150 = min(vec3((_436 > 0.0) ? _436 : 0.0, (_439 > 0.0) ? _439 : 0.0, (_442 > 0.0) ? _442 : 0.0), vec3(65504.0)) - _1146;
        vec3 _1153 = max((_1144 - _1142) * 0.5, vec3(1.0000000116860974230803549289703e-07)) / (abs(_1150) + vec3(1.0000000031710768509710513471353e-30));
        uvec2 _1171 = _82 + uvec2(0u, 5u);
        do
        {
            if (any(greaterThanEqual(_1171, _93)))
            {
                break;
            }
            imageStore(gOutHistory, ivec2(_1171), vec4(min(_1128 + (((_1146 + (_1150 * min(min(_1153.x, 1.0), min(_1153.y, _1153.z)))) - _1128) * (all(lessThanEqual(abs(_433 - vec2(0.5)), vec2(0.5))) ? _648 : 0.0)), vec3(65504.0)), 1.0));
            break;
        } while(false);
        break;
    } while(false);
}

