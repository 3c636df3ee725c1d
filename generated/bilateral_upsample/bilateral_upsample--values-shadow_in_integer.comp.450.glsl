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
        vec2 _81 = vec2(gl_GlobalInvocationID.xy) * 2.0;
        vec2 _82 = _81 - vec2(1.0);
        if (any(greaterThanEqual(_82, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _99 = (floor(fma(_81 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _101 = textureGather(gInFiltered, _99);
        float _102 = _101.w;
        float _107 = (_102 > 0.0) ? min(_102, 31.984375) : 0.0;
        float _108 = floor(_107);
        vec2 _116 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_108 * 0.0322580635547637939453125, (_107 - _108) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_102) <= 65504.0));
        float _117 = _101.z;
        float _122 = (_117 > 0.0) ? min(_117, 31.984375) : 0.0;
        float _123 = floor(_122);
        vec2 _131 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_123 * 0.0322580635547637939453125, (_122 - _123) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_117) <= 65504.0));
        float _132 = _101.x;
        float _137 = (_132 > 0.0) ? min(_132, 31.984375) : 0.0;
        float _138 = floor(_137);
        vec2 _146 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_138 * 0.0322580635547637939453125, (_137 - _138) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_132) <= 65504.0));
        float _147 = _101.y;
        float _152 = (_147 > 0.0) ? min(_147, 31.984375) : 0.0;
        float _153 = floor(_152);
        vec2 _161 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_153 * 0.0322580635547637939453125, (_152 - _153) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_147) <= 65504.0));
        float _165 = float(all(lessThanEqual(abs(_116), vec2(65504.0))));
        vec2 _168 = mix(vec2(0.0), _116, bvec2(_165 > 0.5));
        float _172 = float(all(lessThanEqual(abs(_131), vec2(65504.0))));
        vec2 _175 = mix(vec2(0.0), _131, bvec2(_172 > 0.5));
        float _179 = float(all(lessThanEqual(abs(_146), vec2(65504.0))));
        vec2 _182 = mix(vec2(0.0), _146, bvec2(_179 > 0.5));
        float _186 = float(all(lessThanEqual(abs(_161), vec2(65504.0))));
        vec4 _187 = vec4(_165, _172, _179, _186);
        vec2 _190 = mix(vec2(0.0), _161, bvec2(_186 > 0.5));
        vec4 _195 = textureGather(gInCoarseDepth, _99).wzxy;
        vec4 _198 = mix(vec4(65504.0), min(_195, vec4(65504.0)), greaterThan(_195, vec4(0.0)));
        vec4 _204 = textureGather(gInDepth, _81 * parameters.gOutputSize.zw);
        float _205 = _204.w;
        float _215 = 1.0 / max(fma(_205, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _219 = min(parameters.gSkyDepth, 65504.0);
        vec4 _227 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_205 - 0.5) <= 0.5) ? (((_215 > 0.0) && (_215 < _219)) ? _215 : 65504.0) : 65504.0) - _198);
        vec4 _234 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _187) * _227.yxxx) * _227.zzyy) * _227.wwwz;
        vec4 _238 = _234 * (1.0 / max(dot(_234, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _252 = vec4((((_168 * _238.x) + (_175 * _238.y)) + (_182 * _238.z)) + (_190 * _238.w), 0.0, 0.0);
        float _253 = _204.z;
        float _259 = 1.0 / max(fma(_253, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _268 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_253 - 0.5) <= 0.5) ? (((_259 > 0.0) && (_259 < _219)) ? _259 : 65504.0) : 65504.0) - _198);
        vec4 _275 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _187) * _268.yxxx) * _268.zzyy) * _268.wwwz;
        vec4 _279 = _275 * (1.0 / max(dot(_275, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _293 = vec4((((_168 * _279.x) + (_175 * _279.y)) + (_182 * _279.z)) + (_190 * _279.w), 0.0, 0.0);
        float _294 = _204.x;
        float _300 = 1.0 / max(fma(_294, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _309 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_294 - 0.5) <= 0.5) ? (((_300 > 0.0) && (_300 < _219)) ? _300 : 65504.0) : 65504.0) - _198);
        vec4 _316 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _187) * _309.yxxx) * _309.zzyy) * _309.wwwz;
        vec4 _320 = _316 * (1.0 / max(dot(_316, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _334 = vec4((((_168 * _320.x) + (_175 * _320.y)) + (_182 * _320.z)) + (_190 * _320.w), 0.0, 0.0);
        float _335 = _204.y;
        float _341 = 1.0 / max(fma(_335, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _350 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_335 - 0.5) <= 0.5) ? (((_341 > 0.0) && (_341 < _219)) ? _341 : 65504.0) : 65504.0) - _198);
        vec4 _357 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _187) * _350.yxxx) * _350.zzyy) * _350.wwwz;
        vec4 _361 = _357 * (1.0 / max(dot(_357, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _375 = vec4((((_168 * _361.x) + (_175 * _361.y)) + (_182 * _361.z)) + (_190 * _361.w), 0.0, 0.0);
        bvec2 _376 = greaterThanEqual(_82, vec2(0.0));
        bvec2 _377 = lessThan(_81, parameters.gOutputSize.xy);
        ivec2 _378 = ivec2(_82);
        if (all(_376) && all(_377))
        {
            imageStore(gOutUpsampled, _378, _252);
            imageStore(gOutUpsampled, _378 + ivec2(1, 0), _293);
            imageStore(gOutUpsampled, _378 + ivec2(0, 1), _334);
            imageStore(gOutUpsampled, _378 + ivec2(1), _375);
            break;
        }
        bool _391 = _376.x;
        bool _392 = _376.y;
        if (_391 && _392)
        {
            imageStore(gOutUpsampled, _378, _252);
        }
        bool _397 = _377.x;
        if (_397 && _392)
        {
            imageStore(gOutUpsampled, _378 + ivec2(1, 0), _293);
        }
        bool _403 = _377.y;
        if (_391 && _403)
        {
            imageStore(gOutUpsampled, _378 + ivec2(0, 1), _334);
        }
        if (_397 && _403)
        {
            imageStore(gOutUpsampled, _378 + ivec2(1), _375);
        }
        break;
    } while(false);
}

