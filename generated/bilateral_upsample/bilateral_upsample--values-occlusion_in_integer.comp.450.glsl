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
        vec2 _115 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_108 * 0.0322580635547637939453125, (_107 - _108) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_102) <= 65504.0));
        float _116 = _101.z;
        float _121 = (_116 > 0.0) ? min(_116, 31.984375) : 0.0;
        float _122 = floor(_121);
        vec2 _129 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_122 * 0.0322580635547637939453125, (_121 - _122) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_116) <= 65504.0));
        float _130 = _101.x;
        float _135 = (_130 > 0.0) ? min(_130, 31.984375) : 0.0;
        float _136 = floor(_135);
        vec2 _143 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_136 * 0.0322580635547637939453125, (_135 - _136) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_130) <= 65504.0));
        float _144 = _101.y;
        float _149 = (_144 > 0.0) ? min(_144, 31.984375) : 0.0;
        float _150 = floor(_149);
        vec2 _157 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_150 * 0.0322580635547637939453125, (_149 - _150) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_144) <= 65504.0));
        float _161 = float(all(lessThanEqual(abs(_115), vec2(65504.0))));
        vec2 _164 = mix(vec2(0.0), _115, bvec2(_161 > 0.5));
        float _168 = float(all(lessThanEqual(abs(_129), vec2(65504.0))));
        vec2 _171 = mix(vec2(0.0), _129, bvec2(_168 > 0.5));
        float _175 = float(all(lessThanEqual(abs(_143), vec2(65504.0))));
        vec2 _178 = mix(vec2(0.0), _143, bvec2(_175 > 0.5));
        float _182 = float(all(lessThanEqual(abs(_157), vec2(65504.0))));
        vec4 _183 = vec4(_161, _168, _175, _182);
        vec2 _186 = mix(vec2(0.0), _157, bvec2(_182 > 0.5));
        vec4 _191 = textureGather(gInCoarseDepth, _99).wzxy;
        vec4 _194 = mix(vec4(65504.0), min(_191, vec4(65504.0)), greaterThan(_191, vec4(0.0)));
        vec4 _200 = textureGather(gInDepth, _81 * parameters.gOutputSize.zw);
        float _201 = _200.w;
        float _211 = 1.0 / max(fma(_201, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _215 = min(parameters.gSkyDepth, 65504.0);
        vec4 _223 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_201 - 0.5) <= 0.5) ? (((_211 > 0.0) && (_211 < _215)) ? _211 : 65504.0) : 65504.0) - _194);
        vec4 _230 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _183) * _223.yxxx) * _223.zzyy) * _223.wwwz;
        vec4 _234 = _230 * (1.0 / max(dot(_230, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _248 = vec4((((_164 * _234.x) + (_171 * _234.y)) + (_178 * _234.z)) + (_186 * _234.w), 0.0, 0.0);
        float _249 = _200.z;
        float _255 = 1.0 / max(fma(_249, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _264 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_249 - 0.5) <= 0.5) ? (((_255 > 0.0) && (_255 < _215)) ? _255 : 65504.0) : 65504.0) - _194);
        vec4 _271 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _183) * _264.yxxx) * _264.zzyy) * _264.wwwz;
        vec4 _275 = _271 * (1.0 / max(dot(_271, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _289 = vec4((((_164 * _275.x) + (_171 * _275.y)) + (_178 * _275.z)) + (_186 * _275.w), 0.0, 0.0);
        float _290 = _200.x;
        float _296 = 1.0 / max(fma(_290, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _305 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_290 - 0.5) <= 0.5) ? (((_296 > 0.0) && (_296 < _215)) ? _296 : 65504.0) : 65504.0) - _194);
        vec4 _312 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _183) * _305.yxxx) * _305.zzyy) * _305.wwwz;
        vec4 _316 = _312 * (1.0 / max(dot(_312, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _330 = vec4((((_164 * _316.x) + (_171 * _316.y)) + (_178 * _316.z)) + (_186 * _316.w), 0.0, 0.0);
        float _331 = _200.y;
        float _337 = 1.0 / max(fma(_331, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _346 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_331 - 0.5) <= 0.5) ? (((_337 > 0.0) && (_337 < _215)) ? _337 : 65504.0) : 65504.0) - _194);
        vec4 _353 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _183) * _346.yxxx) * _346.zzyy) * _346.wwwz;
        vec4 _357 = _353 * (1.0 / max(dot(_353, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _371 = vec4((((_164 * _357.x) + (_171 * _357.y)) + (_178 * _357.z)) + (_186 * _357.w), 0.0, 0.0);
        bvec2 _372 = greaterThanEqual(_82, vec2(0.0));
        bvec2 _373 = lessThan(_81, parameters.gOutputSize.xy);
        ivec2 _374 = ivec2(_82);
        if (all(_372) && all(_373))
        {
            imageStore(gOutUpsampled, _374, _248);
            imageStore(gOutUpsampled, _374 + ivec2(1, 0), _289);
            imageStore(gOutUpsampled, _374 + ivec2(0, 1), _330);
            imageStore(gOutUpsampled, _374 + ivec2(1), _371);
            break;
        }
        bool _387 = _372.x;
        bool _388 = _372.y;
        if (_387 && _388)
        {
            imageStore(gOutUpsampled, _374, _248);
        }
        bool _393 = _373.x;
        if (_393 && _388)
        {
            imageStore(gOutUpsampled, _374 + ivec2(1, 0), _289);
        }
        bool _399 = _373.y;
        if (_387 && _399)
        {
            imageStore(gOutUpsampled, _374 + ivec2(0, 1), _330);
        }
        if (_393 && _399)
        {
            imageStore(gOutUpsampled, _374 + ivec2(1), _371);
        }
        break;
    } while(false);
}

