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
            vec2 _160 = mix(vec2(_146), min(vec2(_152 * 0.0322580635547637939453125, (_151 - _152) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_146) <= 9.9999996802856924650656260769173e+37));
            float _161 = _99.y;
            float _166 = (_161 > 0.0) ? min(_161, 31.984375) : 0.0;
            float _167 = floor(_166);
            vec2 _175 = mix(vec2(_161), min(vec2(_167 * 0.0322580635547637939453125, (_166 - _167) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_161) <= 9.9999996802856924650656260769173e+37));
            float _176 = _99.z;
            float _181 = (_176 > 0.0) ? min(_176, 31.984375) : 0.0;
            float _182 = floor(_181);
            vec2 _190 = mix(vec2(_176), min(vec2(_182 * 0.0322580635547637939453125, (_181 - _182) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_176) <= 9.9999996802856924650656260769173e+37));
            float _191 = _99.w;
            float _196 = (_191 > 0.0) ? min(_191, 31.984375) : 0.0;
            float _197 = floor(_196);
            vec2 _205 = mix(vec2(_191), min(vec2(_197 * 0.0322580635547637939453125, (_196 - _197) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_191) <= 9.9999996802856924650656260769173e+37));
            bool _208 = all(lessThanEqual(abs(_160), vec2(9.9999996802856924650656260769173e+37)));
            bool _212 = all(lessThanEqual(abs(_175), vec2(9.9999996802856924650656260769173e+37)));
            bool _216 = all(lessThanEqual(abs(_190), vec2(9.9999996802856924650656260769173e+37)));
            bool _220 = all(lessThanEqual(abs(_205), vec2(9.9999996802856924650656260769173e+37)));
            vec4 _222 = vec4(float(_208), float(_212), float(_216), float(_220));
            vec4 _225 = abs(vec4((abs(_118 - 0.5) <= 0.5) ? (((_128 > 0.0) && (_128 < min(parameters.gSkyDepth, 65504.0))) ? _128 : 65504.0) : 65504.0) - _104);
            bvec4 _232 = greaterThan(_222 * vec4(lessThanEqual(abs(_225), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _233 = mix(vec4(0.0), (vec4(_139, _140, _139, _140) * vec4(_138.yy, _137.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _225), _232);
            vec4 _235 = mix(vec4(0.0), _233, greaterThan(_233, vec4(0.0)));
            float _236 = dot(_235, vec4(1.0));
            vec4 _237 = mix(vec4(1.9999999360571384930131252153835e+38), _225, _232);
            vec4 _247 = mix(vec4(0.0), _222, lessThanEqual(_237, vec4(min(min(_237.x, _237.y), min(_237.z, _237.w)))));
            vec4 _258 = mix(_247 / vec4(max(dot(_247, vec4(1.0)), 1.0)), _235 / vec4(_236), bvec4((_236 >= 1.0000000031710768509710513471353e-30) && (_236 <= 9.9999996802856924650656260769173e+37)));
            imageStore(gOutUpsampled, ivec2(uvec2(_84)), vec4((((mix(vec2(0.0), _160, bvec2(_208)) * _258.x) + (mix(vec2(0.0), _175, bvec2(_212)) * _258.y)) + (mix(vec2(0.0), _190, bvec2(_216)) * _258.z)) + (mix(vec2(0.0), _205, bvec2(_220)) * _258.w), 0.0, 0.0));
        }
        bool _283 = _112.x;
        if (_283 && _114)
        {
            vec2 _287 = _75 + vec2(0.5, -0.5);
            float _288 = _110.z;
            float _298 = 1.0 / max(fma(_288, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _307 = fma(_287, vec2(0.5), vec2(-0.5));
            vec2 _309 = _307 - floor(_307);
            vec2 _310 = vec2(1.0) - _309;
            float _311 = _310.x;
            float _312 = _309.x;
            float _318 = _99.x;
            float _323 = (_318 > 0.0) ? min(_318, 31.984375) : 0.0;
            float _324 = floor(_323);
            vec2 _332 = mix(vec2(_318), min(vec2(_324 * 0.0322580635547637939453125, (_323 - _324) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_318) <= 9.9999996802856924650656260769173e+37));
            float _333 = _99.y;
            float _338 = (_333 > 0.0) ? min(_333, 31.984375) : 0.0;
            float _339 = floor(_338);
            vec2 _347 = mix(vec2(_333), min(vec2(_339 * 0.0322580635547637939453125, (_338 - _339) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_333) <= 9.9999996802856924650656260769173e+37));
            float _348 = _99.z;
            float _353 = (_348 > 0.0) ? min(_348, 31.984375) : 0.0;
            float _354 = floor(_353);
            vec2 _362 = mix(vec2(_348), min(vec2(_354 * 0.0322580635547637939453125, (_353 - _354) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_348) <= 9.9999996802856924650656260769173e+37));
            float _363 = _99.w;
            float _368 = (_363 > 0.0) ? min(_363, 31.984375) : 0.0;
            float _369 = floor(_368);
            vec2 _377 = mix(vec2(_363), min(vec2(_369 * 0.0322580635547637939453125, (_368 - _369) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_363) <= 9.9999996802856924650656260769173e+37));
            bool _380 = all(lessThanEqual(abs(_332), vec2(9.9999996802856924650656260769173e+37)));
            bool _384 = all(lessThanEqual(abs(_347), vec2(9.9999996802856924650656260769173e+37)));
            bool _388 = all(lessThanEqual(abs(_362), vec2(9.9999996802856924650656260769173e+37)));
            bool _392 = all(lessThanEqual(abs(_377), vec2(9.9999996802856924650656260769173e+37)));
            vec4 _394 = vec4(float(_380), float(_384), float(_388), float(_392));
            vec4 _397 = abs(vec4((abs(_288 - 0.5) <= 0.5) ? (((_298 > 0.0) && (_298 < min(parameters.gSkyDepth, 65504.0))) ? _298 : 65504.0) : 65504.0) - _104);
            bvec4 _404 = greaterThan(_394 * vec4(lessThanEqual(abs(_397), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _405 = mix(vec4(0.0), (vec4(_311, _312, _311, _312) * vec4(_310.yy, _309.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _397), _404);
            vec4 _407 = mix(vec4(0.0), _405, greaterThan(_405, vec4(0.0)));
            float _408 = dot(_407, vec4(1.0));
            vec4 _409 = mix(vec4(1.9999999360571384930131252153835e+38), _397, _404);
            vec4 _419 = mix(vec4(0.0), _394, lessThanEqual(_409, vec4(min(min(_409.x, _409.y), min(_409.z, _409.w)))));
            vec4 _430 = mix(_419 / vec4(max(dot(_419, vec4(1.0)), 1.0)), _407 / vec4(_408), bvec4((_408 >= 1.0000000031710768509710513471353e-30) && (_408 <= 9.9999996802856924650656260769173e+37)));
            imageStore(gOutUpsampled, ivec2(uvec2(_287)), vec4((((mix(vec2(0.0), _332, bvec2(_380)) * _430.x) + (mix(vec2(0.0), _347, bvec2(_384)) * _430.y)) + (mix(vec2(0.0), _362, bvec2(_388)) * _430.z)) + (mix(vec2(0.0), _377, bvec2(_392)) * _430.w), 0.0, 0.0));
        }
        bool _455 = _112.y;
        if (_113 && _455)
        {
            vec2 _459 = _75 + vec2(-0.5, 0.5);
            float _460 = _110.x;
            float _470 = 1.0 / max(fma(_460, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _479 = fma(_459, vec2(0.5), vec2(-0.5));
            vec2 _481 = _479 - floor(_479);
            vec2 _482 = vec2(1.0) - _481;
            float _483 = _482.x;
            float _484 = _481.x;
            float _490 = _99.x;
            float _495 = (_490 > 0.0) ? min(_490, 31.984375) : 0.0;
            float _496 = floor(_495);
            vec2 _504 = mix(vec2(_490), min(vec2(_496 * 0.0322580635547637939453125, (_495 - _496) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_490) <= 9.9999996802856924650656260769173e+37));
            float _505 = _99.y;
            float _510 = (_505 > 0.0) ? min(_505, 31.984375) : 0.0;
            float _511 = floor(_510);
            vec2 _519 = mix(vec2(_505), min(vec2(_511 * 0.0322580635547637939453125, (_510 - _511) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_505) <= 9.9999996802856924650656260769173e+37));
            float _520 = _99.z;
            float _525 = (_520 > 0.0) ? min(_520, 31.984375) : 0.0;
            float _526 = floor(_525);
            vec2 _534 = mix(vec2(_520), min(vec2(_526 * 0.0322580635547637939453125, (_525 - _526) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_520) <= 9.9999996802856924650656260769173e+37));
            float _535 = _99.w;
            float _540 = (_535 > 0.0) ? min(_535, 31.984375) : 0.0;
            float _541 = floor(_540);
            vec2 _549 = mix(vec2(_535), min(vec2(_541 * 0.0322580635547637939453125, (_540 - _541) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_535) <= 9.9999996802856924650656260769173e+37));
            bool _552 = all(lessThanEqual(abs(_504), vec2(9.9999996802856924650656260769173e+37)));
            bool _556 = all(lessThanEqual(abs(_519), vec2(9.9999996802856924650656260769173e+37)));
            bool _560 = all(lessThanEqual(abs(_534), vec2(9.9999996802856924650656260769173e+37)));
            bool _564 = all(lessThanEqual(abs(_549), vec2(9.9999996802856924650656260769173e+37)));
            vec4 _566 = vec4(float(_552), float(_556), float(_560), float(_564));
            vec4 _569 = abs(vec4((abs(_460 - 0.5) <= 0.5) ? (((_470 > 0.0) && (_470 < min(parameters.gSkyDepth, 65504.0))) ? _470 : 65504.0) : 65504.0) - _104);
            bvec4 _576 = greaterThan(_566 * vec4(lessThanEqual(abs(_569), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _577 = mix(vec4(0.0), (vec4(_483, _484, _483, _484) * vec4(_482.yy, _481.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _569), _576);
            vec4 _579 = mix(vec4(0.0), _577, greaterThan(_577, vec4(0.0)));
            float _580 = dot(_579, vec4(1.0));
            vec4 _581 = mix(vec4(1.9999999360571384930131252153835e+38), _569, _576);
            vec4 _591 = mix(vec4(0.0), _566, lessThanEqual(_581, vec4(min(min(_581.x, _581.y), min(_581.z, _581.w)))));
            vec4 _602 = mix(_591 / vec4(max(dot(_591, vec4(1.0)), 1.0)), _579 / vec4(_580), bvec4((_580 >= 1.0000000031710768509710513471353e-30) && (_580 <= 9.9999996802856924650656260769173e+37)));
            imageStore(gOutUpsampled, ivec2(uvec2(_459)), vec4((((mix(vec2(0.0), _504, bvec2(_552)) * _602.x) + (mix(vec2(0.0), _519, bvec2(_556)) * _602.y)) + (mix(vec2(0.0), _534, bvec2(_560)) * _602.z)) + (mix(vec2(0.0), _549, bvec2(_564)) * _602.w), 0.0, 0.0));
        }
        if (_283 && _455)
        {
            vec2 _630 = _75 + vec2(0.5);
            float _631 = _110.y;
            float _641 = 1.0 / max(fma(_631, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _650 = fma(_630, vec2(0.5), vec2(-0.5));
            vec2 _652 = _650 - floor(_650);
            vec2 _653 = vec2(1.0) - _652;
            float _654 = _653.x;
            float _655 = _652.x;
            float _661 = _99.x;
            float _666 = (_661 > 0.0) ? min(_661, 31.984375) : 0.0;
            float _667 = floor(_666);
            vec2 _675 = mix(vec2(_661), min(vec2(_667 * 0.0322580635547637939453125, (_666 - _667) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_661) <= 9.9999996802856924650656260769173e+37));
            float _676 = _99.y;
            float _681 = (_676 > 0.0) ? min(_676, 31.984375) : 0.0;
            float _682 = floor(_681);
            vec2 _690 = mix(vec2(_676), min(vec2(_682 * 0.0322580635547637939453125, (_681 - _682) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_676) <= 9.9999996802856924650656260769173e+37));
            float _691 = _99.z;
            float _696 = (_691 > 0.0) ? min(_691, 31.984375) : 0.0;
            float _697 = floor(_696);
            vec2 _705 = mix(vec2(_691), min(vec2(_697 * 0.0322580635547637939453125, (_696 - _697) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_691) <= 9.9999996802856924650656260769173e+37));
            float _706 = _99.w;
            float _711 = (_706 > 0.0) ? min(_706, 31.984375) : 0.0;
            float _712 = floor(_711);
            vec2 _720 = mix(vec2(_706), min(vec2(_712 * 0.0322580635547637939453125, (_711 - _712) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_706) <= 9.9999996802856924650656260769173e+37));
            bool _723 = all(lessThanEqual(abs(_675), vec2(9.9999996802856924650656260769173e+37)));
            bool _727 = all(lessThanEqual(abs(_690), vec2(9.9999996802856924650656260769173e+37)));
            bool _731 = all(lessThanEqual(abs(_705), vec2(9.9999996802856924650656260769173e+37)));
            bool _735 = all(lessThanEqual(abs(_720), vec2(9.9999996802856924650656260769173e+37)));
            vec4 _737 = vec4(float(_723), float(_727), float(_731), float(_735));
            vec4 _740 = abs(vec4((abs(_631 - 0.5) <= 0.5) ? (((_641 > 0.0) && (_641 < min(parameters.gSkyDepth, 65504.0))) ? _641 : 65504.0) : 65504.0) - _104);
            bvec4 _747 = greaterThan(_737 * vec4(lessThanEqual(abs(_740), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _748 = mix(vec4(0.0), (vec4(_654, _655, _654, _655) * vec4(_653.yy, _652.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _740), _747);
            vec4 _750 = mix(vec4(0.0), _748, greaterThan(_748, vec4(0.0)));
            float _751 = dot(_750, vec4(1.0));
            vec4 _752 = mix(vec4(1.9999999360571384930131252153835e+38), _740, _747);
            vec4 _762 = mix(vec4(0.0), _737, lessThanEqual(_752, vec4(min(min(_752.x, _752.y), min(_752.z, _752.w)))));
            vec4 _773 = mix(_762 / vec4(max(dot(_762, vec4(1.0)), 1.0)), _750 / vec4(_751), bvec4((_751 >= 1.0000000031710768509710513471353e-30) && (_751 <= 9.9999996802856924650656260769173e+37)));
            imageStore(gOutUpsampled, ivec2(uvec2(_630)), vec4((((mix(vec2(0.0), _675, bvec2(_723)) * _773.x) + (mix(vec2(0.0), _690, bvec2(_727)) * _773.y)) + (mix(vec2(0.0), _705, bvec2(_731)) * _773.z)) + (mix(vec2(0.0), _720, bvec2(_735)) * _773.w), 0.0, 0.0));
        }
        break;
    } while(false);
}

