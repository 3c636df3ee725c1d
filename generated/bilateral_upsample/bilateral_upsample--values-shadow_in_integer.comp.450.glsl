#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutUpsampled;
layout(binding = 1) uniform sampler2D gInFiltered;
layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 3) uniform sampler2D gInDepth;

void main()
{
    do
    {
        vec2 _75 = vec2(gl_GlobalInvocationID.xy) * 2.0;
        vec2 _76 = _75 - vec2(1.0);
        if (any(greaterThanEqual(_76, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _84 = _75 + vec2(-0.5);
        vec2 _87 = fma(_84, vec2(0.5), vec2(-0.5));
        vec2 _88 = floor(_87);
        vec2 _93 = (_88 + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _96 = textureGather(gInFiltered, _93).wzxy;
        vec4 _99 = mix(vec4(1.9999999360571384930131252153835e+38), _96, lessThanEqual(abs(_96), vec4(65504.0)));
        vec4 _104 = textureGather(gInCoarseDepth, _93).wzxy;
        vec4 _110 = textureGather(gInDepth, _75 * parameters.gOutputSize.zw);
        bvec2 _111 = greaterThanEqual(_76, vec2(0.0));
        bvec2 _112 = lessThan(_75, parameters.gOutputSize.xy);
        bool _113 = _111.x;
        bool _114 = _111.y;
        if (_113 && _114)
        {
            float _118 = _110.w;
            float _128 = 1.0 / max(fma(_118, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _137 = _87 - _88;
            vec2 _138 = vec2(1.0) - _137;
            float _139 = _138.x;
            float _140 = _137.x;
            float _146 = _99.x;
            float _151 = (_146 > 0.0) ? min(_146, 31.984375) : 0.0;
            float _152 = floor(_151);
            vec2 _161 = mix(vec2(_146), min(vec2(_152 * 0.0322580635547637939453125, (_151 - _152) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_146) <= 9.9999996802856924650656260769173e+37));
            float _162 = _99.y;
            float _167 = (_162 > 0.0) ? min(_162, 31.984375) : 0.0;
            float _168 = floor(_167);
            vec2 _177 = mix(vec2(_162), min(vec2(_168 * 0.0322580635547637939453125, (_167 - _168) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_162) <= 9.9999996802856924650656260769173e+37));
            float _178 = _99.z;
            float _183 = (_178 > 0.0) ? min(_178, 31.984375) : 0.0;
            float _184 = floor(_183);
            vec2 _193 = mix(vec2(_178), min(vec2(_184 * 0.0322580635547637939453125, (_183 - _184) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_178) <= 9.9999996802856924650656260769173e+37));
            float _194 = _99.w;
            float _199 = (_194 > 0.0) ? min(_194, 31.984375) : 0.0;
            float _200 = floor(_199);
            vec2 _209 = mix(vec2(_194), min(vec2(_200 * 0.0322580635547637939453125, (_199 - _200) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_194) <= 9.9999996802856924650656260769173e+37));
            bool _212 = all(lessThanEqual(abs(_161), vec2(9.9999996802856924650656260769173e+37)));
            bool _216 = all(lessThanEqual(abs(_177), vec2(9.9999996802856924650656260769173e+37)));
            bool _220 = all(lessThanEqual(abs(_193), vec2(9.9999996802856924650656260769173e+37)));
            bool _224 = all(lessThanEqual(abs(_209), vec2(9.9999996802856924650656260769173e+37)));
            vec4 _226 = vec4(float(_212), float(_216), float(_220), float(_224));
            vec4 _229 = abs(vec4((abs(_118 - 0.5) <= 0.5) ? (((_128 > 0.0) && (_128 < min(parameters.gSkyDepth, 65504.0))) ? _128 : 65504.0) : 65504.0) - _104);
            bvec4 _236 = greaterThan(_226 * vec4(lessThanEqual(abs(_229), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _237 = mix(vec4(0.0), (vec4(_139, _140, _139, _140) * vec4(_138.yy, _137.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _229), _236);
            vec4 _239 = mix(vec4(0.0), _237, greaterThan(_237, vec4(0.0)));
            float _240 = dot(_239, vec4(1.0));
            vec4 _241 = mix(vec4(1.9999999360571384930131252153835e+38), _229, _236);
            vec4 _251 = mix(vec4(0.0), _226, lessThanEqual(_241, vec4(min(min(_241.x, _241.y), min(_241.z, _241.w)))));
            vec4 _262 = mix(_251 / vec4(max(dot(_251, vec4(1.0)), 1.0)), _239 / vec4(_240), bvec4((_240 >= 1.0000000031710768509710513471353e-30) && (_240 <= 9.9999996802856924650656260769173e+37)));
            imageStore(gOutUpsampled, ivec2(uvec2(_84)), vec4((((mix(vec2(0.0), _161, bvec2(_212)) * _262.x) + (mix(vec2(0.0), _177, bvec2(_216)) * _262.y)) + (mix(vec2(0.0), _193, bvec2(_220)) * _262.z)) + (mix(vec2(0.0), _209, bvec2(_224)) * _262.w), 0.0, 0.0));
        }
        bool _287 = _112.x;
        if (_287 && _114)
        {
            vec2 _291 = _75 + vec2(0.5, -0.5);
            float _292 = _110.z;
            float _302 = 1.0 / max(fma(_292, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _311 = fma(_291, vec2(0.5), vec2(-0.5));
            vec2 _313 = _311 - floor(_311);
            vec2 _314 = vec2(1.0) - _313;
            float _315 = _314.x;
            float _316 = _313.x;
            float _322 = _99.x;
            float _327 = (_322 > 0.0) ? min(_322, 31.984375) : 0.0;
            float _328 = floor(_327);
            vec2 _337 = mix(vec2(_322), min(vec2(_328 * 0.0322580635547637939453125, (_327 - _328) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_322) <= 9.9999996802856924650656260769173e+37));
            float _338 = _99.y;
            float _343 = (_338 > 0.0) ? min(_338, 31.984375) : 0.0;
            float _344 = floor(_343);
            vec2 _353 = mix(vec2(_338), min(vec2(_344 * 0.0322580635547637939453125, (_343 - _344) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_338) <= 9.9999996802856924650656260769173e+37));
            float _354 = _99.z;
            float _359 = (_354 > 0.0) ? min(_354, 31.984375) : 0.0;
            float _360 = floor(_359);
            vec2 _369 = mix(vec2(_354), min(vec2(_360 * 0.0322580635547637939453125, (_359 - _360) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_354) <= 9.9999996802856924650656260769173e+37));
            float _370 = _99.w;
            float _375 = (_370 > 0.0) ? min(_370, 31.984375) : 0.0;
            float _376 = floor(_375);
            vec2 _385 = mix(vec2(_370), min(vec2(_376 * 0.0322580635547637939453125, (_375 - _376) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_370) <= 9.9999996802856924650656260769173e+37));
            bool _388 = all(lessThanEqual(abs(_337), vec2(9.9999996802856924650656260769173e+37)));
            bool _392 = all(lessThanEqual(abs(_353), vec2(9.9999996802856924650656260769173e+37)));
            bool _396 = all(lessThanEqual(abs(_369), vec2(9.9999996802856924650656260769173e+37)));
            bool _400 = all(lessThanEqual(abs(_385), vec2(9.9999996802856924650656260769173e+37)));
            vec4 _402 = vec4(float(_388), float(_392), float(_396), float(_400));
            vec4 _405 = abs(vec4((abs(_292 - 0.5) <= 0.5) ? (((_302 > 0.0) && (_302 < min(parameters.gSkyDepth, 65504.0))) ? _302 : 65504.0) : 65504.0) - _104);
            bvec4 _412 = greaterThan(_402 * vec4(lessThanEqual(abs(_405), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _413 = mix(vec4(0.0), (vec4(_315, _316, _315, _316) * vec4(_314.yy, _313.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _405), _412);
            vec4 _415 = mix(vec4(0.0), _413, greaterThan(_413, vec4(0.0)));
            float _416 = dot(_415, vec4(1.0));
            vec4 _417 = mix(vec4(1.9999999360571384930131252153835e+38), _405, _412);
            vec4 _427 = mix(vec4(0.0), _402, lessThanEqual(_417, vec4(min(min(_417.x, _417.y), min(_417.z, _417.w)))));
            vec4 _438 = mix(_427 / vec4(max(dot(_427, vec4(1.0)), 1.0)), _415 / vec4(_416), bvec4((_416 >= 1.0000000031710768509710513471353e-30) && (_416 <= 9.9999996802856924650656260769173e+37)));
            imageStore(gOutUpsampled, ivec2(uvec2(_291)), vec4((((mix(vec2(0.0), _337, bvec2(_388)) * _438.x) + (mix(vec2(0.0), _353, bvec2(_392)) * _438.y)) + (mix(vec2(0.0), _369, bvec2(_396)) * _438.z)) + (mix(vec2(0.0), _385, bvec2(_400)) * _438.w), 0.0, 0.0));
        }
        bool _463 = _112.y;
        if (_113 && _463)
        {
            vec2 _467 = _75 + vec2(-0.5, 0.5);
            float _468 = _110.x;
            float _478 = 1.0 / max(fma(_468, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _487 = fma(_467, vec2(0.5), vec2(-0.5));
            vec2 _489 = _487 - floor(_487);
            vec2 _490 = vec2(1.0) - _489;
            float _491 = _490.x;
            float _492 = _489.x;
            float _498 = _99.x;
            float _503 = (_498 > 0.0) ? min(_498, 31.984375) : 0.0;
            float _504 = floor(_503);
            vec2 _513 = mix(vec2(_498), min(vec2(_504 * 0.0322580635547637939453125, (_503 - _504) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_498) <= 9.9999996802856924650656260769173e+37));
            float _514 = _99.y;
            float _519 = (_514 > 0.0) ? min(_514, 31.984375) : 0.0;
            float _520 = floor(_519);
            vec2 _529 = mix(vec2(_514), min(vec2(_520 * 0.0322580635547637939453125, (_519 - _520) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_514) <= 9.9999996802856924650656260769173e+37));
            float _530 = _99.z;
            float _535 = (_530 > 0.0) ? min(_530, 31.984375) : 0.0;
            float _536 = floor(_535);
            vec2 _545 = mix(vec2(_530), min(vec2(_536 * 0.0322580635547637939453125, (_535 - _536) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_530) <= 9.9999996802856924650656260769173e+37));
            float _546 = _99.w;
            float _551 = (_546 > 0.0) ? min(_546, 31.984375) : 0.0;
            float _552 = floor(_551);
            vec2 _561 = mix(vec2(_546), min(vec2(_552 * 0.0322580635547637939453125, (_551 - _552) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_546) <= 9.9999996802856924650656260769173e+37));
            bool _564 = all(lessThanEqual(abs(_513), vec2(9.9999996802856924650656260769173e+37)));
            bool _568 = all(lessThanEqual(abs(_529), vec2(9.9999996802856924650656260769173e+37)));
            bool _572 = all(lessThanEqual(abs(_545), vec2(9.9999996802856924650656260769173e+37)));
            bool _576 = all(lessThanEqual(abs(_561), vec2(9.9999996802856924650656260769173e+37)));
            vec4 _578 = vec4(float(_564), float(_568), float(_572), float(_576));
            vec4 _581 = abs(vec4((abs(_468 - 0.5) <= 0.5) ? (((_478 > 0.0) && (_478 < min(parameters.gSkyDepth, 65504.0))) ? _478 : 65504.0) : 65504.0) - _104);
            bvec4 _588 = greaterThan(_578 * vec4(lessThanEqual(abs(_581), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _589 = mix(vec4(0.0), (vec4(_491, _492, _491, _492) * vec4(_490.yy, _489.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _581), _588);
            vec4 _591 = mix(vec4(0.0), _589, greaterThan(_589, vec4(0.0)));
            float _592 = dot(_591, vec4(1.0));
            vec4 _593 = mix(vec4(1.9999999360571384930131252153835e+38), _581, _588);
            vec4 _603 = mix(vec4(0.0), _578, lessThanEqual(_593, vec4(min(min(_593.x, _593.y), min(_593.z, _593.w)))));
            vec4 _614 = mix(_603 / vec4(max(dot(_603, vec4(1.0)), 1.0)), _591 / vec4(_592), bvec4((_592 >= 1.0000000031710768509710513471353e-30) && (_592 <= 9.9999996802856924650656260769173e+37)));
            imageStore(gOutUpsampled, ivec2(uvec2(_467)), vec4((((mix(vec2(0.0), _513, bvec2(_564)) * _614.x) + (mix(vec2(0.0), _529, bvec2(_568)) * _614.y)) + (mix(vec2(0.0), _545, bvec2(_572)) * _614.z)) + (mix(vec2(0.0), _561, bvec2(_576)) * _614.w), 0.0, 0.0));
        }
        if (_287 && _463)
        {
            vec2 _642 = _75 + vec2(0.5);
            float _643 = _110.y;
            float _653 = 1.0 / max(fma(_643, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _662 = fma(_642, vec2(0.5), vec2(-0.5));
            vec2 _664 = _662 - floor(_662);
            vec2 _665 = vec2(1.0) - _664;
            float _666 = _665.x;
            float _667 = _664.x;
            float _673 = _99.x;
            float _678 = (_673 > 0.0) ? min(_673, 31.984375) : 0.0;
            float _679 = floor(_678);
            vec2 _688 = mix(vec2(_673), min(vec2(_679 * 0.0322580635547637939453125, (_678 - _679) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_673) <= 9.9999996802856924650656260769173e+37));
            float _689 = _99.y;
            float _694 = (_689 > 0.0) ? min(_689, 31.984375) : 0.0;
            float _695 = floor(_694);
            vec2 _704 = mix(vec2(_689), min(vec2(_695 * 0.0322580635547637939453125, (_694 - _695) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_689) <= 9.9999996802856924650656260769173e+37));
            float _705 = _99.z;
            float _710 = (_705 > 0.0) ? min(_705, 31.984375) : 0.0;
            float _711 = floor(_710);
            vec2 _720 = mix(vec2(_705), min(vec2(_711 * 0.0322580635547637939453125, (_710 - _711) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_705) <= 9.9999996802856924650656260769173e+37));
            float _721 = _99.w;
            float _726 = (_721 > 0.0) ? min(_721, 31.984375) : 0.0;
            float _727 = floor(_726);
            vec2 _736 = mix(vec2(_721), min(vec2(_727 * 0.0322580635547637939453125, (_726 - _727) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_721) <= 9.9999996802856924650656260769173e+37));
            bool _739 = all(lessThanEqual(abs(_688), vec2(9.9999996802856924650656260769173e+37)));
            bool _743 = all(lessThanEqual(abs(_704), vec2(9.9999996802856924650656260769173e+37)));
            bool _747 = all(lessThanEqual(abs(_720), vec2(9.9999996802856924650656260769173e+37)));
            bool _751 = all(lessThanEqual(abs(_736), vec2(9.9999996802856924650656260769173e+37)));
            vec4 _753 = vec4(float(_739), float(_743), float(_747), float(_751));
            vec4 _756 = abs(vec4((abs(_643 - 0.5) <= 0.5) ? (((_653 > 0.0) && (_653 < min(parameters.gSkyDepth, 65504.0))) ? _653 : 65504.0) : 65504.0) - _104);
            bvec4 _763 = greaterThan(_753 * vec4(lessThanEqual(abs(_756), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _764 = mix(vec4(0.0), (vec4(_666, _667, _666, _667) * vec4(_665.yy, _664.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _756), _763);
            vec4 _766 = mix(vec4(0.0), _764, greaterThan(_764, vec4(0.0)));
            float _767 = dot(_766, vec4(1.0));
            vec4 _768 = mix(vec4(1.9999999360571384930131252153835e+38), _756, _763);
            vec4 _778 = mix(vec4(0.0), _753, lessThanEqual(_768, vec4(min(min(_768.x, _768.y), min(_768.z, _768.w)))));
            vec4 _789 = mix(_778 / vec4(max(dot(_778, vec4(1.0)), 1.0)), _766 / vec4(_767), bvec4((_767 >= 1.0000000031710768509710513471353e-30) && (_767 <= 9.9999996802856924650656260769173e+37)));
            imageStore(gOutUpsampled, ivec2(uvec2(_642)), vec4((((mix(vec2(0.0), _688, bvec2(_739)) * _789.x) + (mix(vec2(0.0), _704, bvec2(_743)) * _789.y)) + (mix(vec2(0.0), _720, bvec2(_747)) * _789.z)) + (mix(vec2(0.0), _736, bvec2(_751)) * _789.w), 0.0, 0.0));
        }
        break;
    } while(false);
}

