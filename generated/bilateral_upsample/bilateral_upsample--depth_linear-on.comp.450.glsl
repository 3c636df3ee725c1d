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
        vec2 _69 = vec2(gl_GlobalInvocationID.xy) * 2.0;
        vec2 _70 = _69 - vec2(1.0);
        if (any(greaterThanEqual(_70, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _78 = _69 + vec2(-0.5);
        vec2 _81 = fma(_78, vec2(0.5), vec2(-0.5));
        vec2 _82 = floor(_81);
        vec2 _87 = (_82 + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _90 = textureGather(gInFiltered, _87).wzxy;
        vec4 _93 = mix(vec4(1.9999999360571384930131252153835e+38), _90, lessThanEqual(abs(_90), vec4(65504.0)));
        vec4 _98 = textureGather(gInCoarseDepth, _87).wzxy;
        vec4 _104 = textureGather(gInDepth, _69 * parameters.gOutputSize.zw);
        bvec2 _105 = greaterThanEqual(_70, vec2(0.0));
        bvec2 _106 = lessThan(_69, parameters.gOutputSize.xy);
        bool _107 = _105.x;
        bool _108 = _105.y;
        if (_107 && _108)
        {
            float _112 = _104.w;
            vec2 _120 = _81 - _82;
            vec2 _121 = vec2(1.0) - _120;
            float _122 = _121.x;
            float _123 = _120.x;
            vec4 _131 = vec4(lessThanEqual(abs(_93), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _134 = abs(vec4(((_112 > 0.0) && (_112 < min(parameters.gSkyDepth, 65504.0))) ? _112 : 65504.0) - _98);
            bvec4 _141 = greaterThan(_131 * vec4(lessThanEqual(abs(_134), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _142 = mix(vec4(0.0), (vec4(_122, _123, _122, _123) * vec4(_121.yy, _120.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _134), _141);
            vec4 _144 = mix(vec4(0.0), _142, greaterThan(_142, vec4(0.0)));
            float _145 = dot(_144, vec4(1.0));
            vec4 _146 = mix(vec4(1.9999999360571384930131252153835e+38), _134, _141);
            vec4 _156 = mix(vec4(0.0), _131, lessThanEqual(_146, vec4(min(min(_146.x, _146.y), min(_146.z, _146.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_78)), vec4(dot(mix(vec4(0.0), _93, greaterThan(_131, vec4(0.5))), mix(_156 / vec4(max(dot(_156, vec4(1.0)), 1.0)), _144 / vec4(_145), bvec4((_145 >= 1.0000000031710768509710513471353e-30) && (_145 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        bool _174 = _106.x;
        if (_174 && _108)
        {
            vec2 _178 = _69 + vec2(0.5, -0.5);
            float _179 = _104.z;
            vec2 _187 = fma(_178, vec2(0.5), vec2(-0.5));
            vec2 _189 = _187 - floor(_187);
            vec2 _190 = vec2(1.0) - _189;
            float _191 = _190.x;
            float _192 = _189.x;
            vec4 _200 = vec4(lessThanEqual(abs(_93), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _203 = abs(vec4(((_179 > 0.0) && (_179 < min(parameters.gSkyDepth, 65504.0))) ? _179 : 65504.0) - _98);
            bvec4 _210 = greaterThan(_200 * vec4(lessThanEqual(abs(_203), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _211 = mix(vec4(0.0), (vec4(_191, _192, _191, _192) * vec4(_190.yy, _189.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _203), _210);
            vec4 _213 = mix(vec4(0.0), _211, greaterThan(_211, vec4(0.0)));
            float _214 = dot(_213, vec4(1.0));
            vec4 _215 = mix(vec4(1.9999999360571384930131252153835e+38), _203, _210);
            vec4 _225 = mix(vec4(0.0), _200, lessThanEqual(_215, vec4(min(min(_215.x, _215.y), min(_215.z, _215.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_178)), vec4(dot(mix(vec4(0.0), _93, greaterThan(_200, vec4(0.5))), mix(_225 / vec4(max(dot(_225, vec4(1.0)), 1.0)), _213 / vec4(_214), bvec4((_214 >= 1.0000000031710768509710513471353e-30) && (_214 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        bool _243 = _106.y;
        if (_107 && _243)
        {
            vec2 _247 = _69 + vec2(-0.5, 0.5);
            float _248 = _104.x;
            vec2 _256 = fma(_247, vec2(0.5), vec2(-0.5));
            vec2 _258 = _256 - floor(_256);
            vec2 _259 = vec2(1.0) - _258;
            float _260 = _259.x;
            float _261 = _258.x;
            vec4 _269 = vec4(lessThanEqual(abs(_93), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _272 = abs(vec4(((_248 > 0.0) && (_248 < min(parameters.gSkyDepth, 65504.0))) ? _248 : 65504.0) - _98);
            bvec4 _279 = greaterThan(_269 * vec4(lessThanEqual(abs(_272), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _280 = mix(vec4(0.0), (vec4(_260, _261, _260, _261) * vec4(_259.yy, _258.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _272), _279);
            vec4 _282 = mix(vec4(0.0), _280, greaterThan(_280, vec4(0.0)));
            float _283 = dot(_282, vec4(1.0));
            vec4 _284 = mix(vec4(1.9999999360571384930131252153835e+38), _272, _279);
            vec4 _294 = mix(vec4(0.0), _269, lessThanEqual(_284, vec4(min(min(_284.x, _284.y), min(_284.z, _284.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_247)), vec4(dot(mix(vec4(0.0), _93, greaterThan(_269, vec4(0.5))), mix(_294 / vec4(max(dot(_294, vec4(1.0)), 1.0)), _282 / vec4(_283), bvec4((_283 >= 1.0000000031710768509710513471353e-30) && (_283 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        if (_174 && _243)
        {
            vec2 _315 = _69 + vec2(0.5);
            float _316 = _104.y;
            vec2 _324 = fma(_315, vec2(0.5), vec2(-0.5));
            vec2 _326 = _324 - floor(_324);
            vec2 _327 = vec2(1.0) - _326;
            float _328 = _327.x;
            float _329 = _326.x;
            vec4 _337 = vec4(lessThanEqual(abs(_93), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _340 = abs(vec4(((_316 > 0.0) && (_316 < min(parameters.gSkyDepth, 65504.0))) ? _316 : 65504.0) - _98);
            bvec4 _347 = greaterThan(_337 * vec4(lessThanEqual(abs(_340), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _348 = mix(vec4(0.0), (vec4(_328, _329, _328, _329) * vec4(_327.yy, _326.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _340), _347);
            vec4 _350 = mix(vec4(0.0), _348, greaterThan(_348, vec4(0.0)));
            float _351 = dot(_350, vec4(1.0));
            vec4 _352 = mix(vec4(1.9999999360571384930131252153835e+38), _340, _347);
            vec4 _362 = mix(vec4(0.0), _337, lessThanEqual(_352, vec4(min(min(_352.x, _352.y), min(_352.z, _352.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_315)), vec4(dot(mix(vec4(0.0), _93, greaterThan(_337, vec4(0.5))), mix(_362 / vec4(max(dot(_362, vec4(1.0)), 1.0)), _350 / vec4(_351), bvec4((_351 >= 1.0000000031710768509710513471353e-30) && (_351 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        break;
    } while(false);
}

