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
        vec2 _80 = vec2(gl_GlobalInvocationID.xy) * 2.0;
        vec2 _81 = _80 - vec2(1.0);
        if (any(greaterThanEqual(_81, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _96 = (floor(fma(_80 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _100 = textureGather(gInFiltered, _96);
        float _101 = _100.w;
        float _106 = (_101 > 0.0) ? min(_101, 31.984375) : 0.0;
        float _107 = floor(_106);
        vec2 _114 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_107 * 0.0322580635547637939453125, min((_106 - _107) * 1.01587307453155517578125, 1.0)), bvec2(abs(_101) <= 65504.0));
        float _115 = _100.z;
        float _120 = (_115 > 0.0) ? min(_115, 31.984375) : 0.0;
        float _121 = floor(_120);
        vec2 _128 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_121 * 0.0322580635547637939453125, min((_120 - _121) * 1.01587307453155517578125, 1.0)), bvec2(abs(_115) <= 65504.0));
        float _129 = _100.x;
        float _134 = (_129 > 0.0) ? min(_129, 31.984375) : 0.0;
        float _135 = floor(_134);
        vec2 _142 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_135 * 0.0322580635547637939453125, min((_134 - _135) * 1.01587307453155517578125, 1.0)), bvec2(abs(_129) <= 65504.0));
        float _143 = _100.y;
        float _148 = (_143 > 0.0) ? min(_143, 31.984375) : 0.0;
        float _149 = floor(_148);
        vec2 _156 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_149 * 0.0322580635547637939453125, min((_148 - _149) * 1.01587307453155517578125, 1.0)), bvec2(abs(_143) <= 65504.0));
        float _160 = float(abs(_114.x) <= 65504.0);
        vec2 _163 = mix(vec2(0.0), _114, bvec2(_160 > 0.5));
        float _167 = float(abs(_128.x) <= 65504.0);
        vec2 _170 = mix(vec2(0.0), _128, bvec2(_167 > 0.5));
        float _174 = float(abs(_142.x) <= 65504.0);
        vec2 _177 = mix(vec2(0.0), _142, bvec2(_174 > 0.5));
        float _181 = float(abs(_156.x) <= 65504.0);
        vec4 _182 = vec4(_160, _167, _174, _181);
        vec2 _185 = mix(vec2(0.0), _156, bvec2(_181 > 0.5));
        vec4 _190 = textureGather(gInCoarseDepth, _96).wzxy;
        vec4 _193 = mix(vec4(65504.0), min(_190, vec4(65504.0)), greaterThan(_190, vec4(0.0)));
        vec4 _199 = textureGather(gInDepth, _80 * parameters.gOutputSize.zw);
        float _200 = _199.w;
        float _210 = 1.0 / max(fma(_200, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _214 = min(parameters.gSkyDepth, 65504.0);
        vec4 _222 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_200 - 0.5) <= 0.5) ? (((_210 > 0.0) && (_210 < _214)) ? _210 : 65504.0) : 65504.0) - _193);
        vec4 _229 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _182) * _222.yxxx) * _222.zzyy) * _222.wwwz;
        vec4 _233 = _229 * (1.0 / max(dot(_229, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _247 = vec4((((_163 * _233.x) + (_170 * _233.y)) + (_177 * _233.z)) + (_185 * _233.w), 0.0, 0.0);
        float _248 = _199.z;
        float _254 = 1.0 / max(fma(_248, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _263 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_248 - 0.5) <= 0.5) ? (((_254 > 0.0) && (_254 < _214)) ? _254 : 65504.0) : 65504.0) - _193);
        vec4 _270 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _182) * _263.yxxx) * _263.zzyy) * _263.wwwz;
        vec4 _274 = _270 * (1.0 / max(dot(_270, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _288 = vec4((((_163 * _274.x) + (_170 * _274.y)) + (_177 * _274.z)) + (_185 * _274.w), 0.0, 0.0);
        float _289 = _199.x;
        float _295 = 1.0 / max(fma(_289, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _304 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_289 - 0.5) <= 0.5) ? (((_295 > 0.0) && (_295 < _214)) ? _295 : 65504.0) : 65504.0) - _193);
        vec4 _311 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _182) * _304.yxxx) * _304.zzyy) * _304.wwwz;
        vec4 _315 = _311 * (1.0 / max(dot(_311, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _329 = vec4((((_163 * _315.x) + (_170 * _315.y)) + (_177 * _315.z)) + (_185 * _315.w), 0.0, 0.0);
        float _330 = _199.y;
        float _336 = 1.0 / max(fma(_330, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _345 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_330 - 0.5) <= 0.5) ? (((_336 > 0.0) && (_336 < _214)) ? _336 : 65504.0) : 65504.0) - _193);
        vec4 _352 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _182) * _345.yxxx) * _345.zzyy) * _345.wwwz;
        vec4 _356 = _352 * (1.0 / max(dot(_352, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _370 = vec4((((_163 * _356.x) + (_170 * _356.y)) + (_177 * _356.z)) + (_185 * _356.w), 0.0, 0.0);
        bvec2 _371 = greaterThanEqual(_81, vec2(0.0));
        bvec2 _372 = lessThan(_80, parameters.gOutputSize.xy);
        ivec2 _373 = ivec2(_81);
        if (all(_371) && all(_372))
        {
            imageStore(gOutUpsampled, _373, _247);
            imageStore(gOutUpsampled, _373 + ivec2(1, 0), _288);
            imageStore(gOutUpsampled, _373 + ivec2(0, 1), _329);
            imageStore(gOutUpsampled, _373 + ivec2(1), _370);
            break;
        }
        bool _386 = _371.x;
        bool _387 = _371.y;
        if (_386 && _387)
        {
            imageStore(gOutUpsampled, _373, _247);
        }
        bool _392 = _372.x;
        if (_392 && _387)
        {
            imageStore(gOutUpsampled, _373 + ivec2(1, 0), _288);
        }
        bool _398 = _372.y;
        if (_386 && _398)
        {
            imageStore(gOutUpsampled, _373 + ivec2(0, 1), _329);
        }
        if (_392 && _398)
        {
            imageStore(gOutUpsampled, _373 + ivec2(1), _370);
        }
        break;
    } while(false);
}

