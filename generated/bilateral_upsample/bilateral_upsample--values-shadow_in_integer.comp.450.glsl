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
        vec2 _115 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_107 * 0.0322580635547637939453125, min((_106 - _107) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_101) <= 65504.0));
        float _116 = _100.z;
        float _121 = (_116 > 0.0) ? min(_116, 31.984375) : 0.0;
        float _122 = floor(_121);
        vec2 _130 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_122 * 0.0322580635547637939453125, min((_121 - _122) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_116) <= 65504.0));
        float _131 = _100.x;
        float _136 = (_131 > 0.0) ? min(_131, 31.984375) : 0.0;
        float _137 = floor(_136);
        vec2 _145 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_137 * 0.0322580635547637939453125, min((_136 - _137) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_131) <= 65504.0));
        float _146 = _100.y;
        float _151 = (_146 > 0.0) ? min(_146, 31.984375) : 0.0;
        float _152 = floor(_151);
        vec2 _160 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_152 * 0.0322580635547637939453125, min((_151 - _152) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_146) <= 65504.0));
        float _164 = float(abs(_115.x) <= 65504.0);
        vec2 _167 = mix(vec2(0.0), _115, bvec2(_164 > 0.5));
        float _171 = float(abs(_130.x) <= 65504.0);
        vec2 _174 = mix(vec2(0.0), _130, bvec2(_171 > 0.5));
        float _178 = float(abs(_145.x) <= 65504.0);
        vec2 _181 = mix(vec2(0.0), _145, bvec2(_178 > 0.5));
        float _185 = float(abs(_160.x) <= 65504.0);
        vec4 _186 = vec4(_164, _171, _178, _185);
        vec2 _189 = mix(vec2(0.0), _160, bvec2(_185 > 0.5));
        vec4 _194 = textureGather(gInCoarseDepth, _96).wzxy;
        vec4 _197 = mix(vec4(65504.0), min(_194, vec4(65504.0)), greaterThan(_194, vec4(0.0)));
        vec4 _203 = textureGather(gInDepth, _80 * parameters.gOutputSize.zw);
        float _204 = _203.w;
        float _214 = 1.0 / max(fma(_204, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _218 = min(parameters.gSkyDepth, 65504.0);
        vec4 _226 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_204 - 0.5) <= 0.5) ? (((_214 > 0.0) && (_214 < _218)) ? _214 : 65504.0) : 65504.0) - _197);
        vec4 _233 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _186) * _226.yxxx) * _226.zzyy) * _226.wwwz;
        vec4 _237 = _233 * (1.0 / max(dot(_233, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _251 = vec4((((_167 * _237.x) + (_174 * _237.y)) + (_181 * _237.z)) + (_189 * _237.w), 0.0, 0.0);
        float _252 = _203.z;
        float _258 = 1.0 / max(fma(_252, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _267 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_252 - 0.5) <= 0.5) ? (((_258 > 0.0) && (_258 < _218)) ? _258 : 65504.0) : 65504.0) - _197);
        vec4 _274 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _186) * _267.yxxx) * _267.zzyy) * _267.wwwz;
        vec4 _278 = _274 * (1.0 / max(dot(_274, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _292 = vec4((((_167 * _278.x) + (_174 * _278.y)) + (_181 * _278.z)) + (_189 * _278.w), 0.0, 0.0);
        float _293 = _203.x;
        float _299 = 1.0 / max(fma(_293, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _308 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_293 - 0.5) <= 0.5) ? (((_299 > 0.0) && (_299 < _218)) ? _299 : 65504.0) : 65504.0) - _197);
        vec4 _315 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _186) * _308.yxxx) * _308.zzyy) * _308.wwwz;
        vec4 _319 = _315 * (1.0 / max(dot(_315, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _333 = vec4((((_167 * _319.x) + (_174 * _319.y)) + (_181 * _319.z)) + (_189 * _319.w), 0.0, 0.0);
        float _334 = _203.y;
        float _340 = 1.0 / max(fma(_334, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _349 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_334 - 0.5) <= 0.5) ? (((_340 > 0.0) && (_340 < _218)) ? _340 : 65504.0) : 65504.0) - _197);
        vec4 _356 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _186) * _349.yxxx) * _349.zzyy) * _349.wwwz;
        vec4 _360 = _356 * (1.0 / max(dot(_356, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _374 = vec4((((_167 * _360.x) + (_174 * _360.y)) + (_181 * _360.z)) + (_189 * _360.w), 0.0, 0.0);
        bvec2 _375 = greaterThanEqual(_81, vec2(0.0));
        bvec2 _376 = lessThan(_80, parameters.gOutputSize.xy);
        ivec2 _377 = ivec2(_81);
        if (all(_375) && all(_376))
        {
            imageStore(gOutUpsampled, _377, _251);
            imageStore(gOutUpsampled, _377 + ivec2(1, 0), _292);
            imageStore(gOutUpsampled, _377 + ivec2(0, 1), _333);
            imageStore(gOutUpsampled, _377 + ivec2(1), _374);
            break;
        }
        bool _390 = _375.x;
        bool _391 = _375.y;
        if (_390 && _391)
        {
            imageStore(gOutUpsampled, _377, _251);
        }
        bool _396 = _376.x;
        if (_396 && _391)
        {
            imageStore(gOutUpsampled, _377 + ivec2(1, 0), _292);
        }
        bool _402 = _376.y;
        if (_390 && _402)
        {
            imageStore(gOutUpsampled, _377 + ivec2(0, 1), _333);
        }
        if (_396 && _402)
        {
            imageStore(gOutUpsampled, _377 + ivec2(1), _374);
        }
        break;
    } while(false);
}

