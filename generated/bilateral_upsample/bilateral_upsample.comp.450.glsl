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
        vec2 _71 = vec2(gl_GlobalInvocationID.xy) * 2.0;
        vec2 _72 = _71 - vec2(1.0);
        if (any(greaterThanEqual(_72, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _80 = _71 + vec2(-0.5);
        vec2 _83 = fma(_80, vec2(0.5), vec2(-0.5));
        vec2 _84 = floor(_83);
        vec2 _89 = (_84 + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _92 = textureGather(gInFiltered, _89).wzxy;
        vec4 _95 = mix(vec4(1.9999999360571384930131252153835e+38), _92, lessThanEqual(abs(_92), vec4(65504.0)));
        vec4 _100 = textureGather(gInCoarseDepth, _89).wzxy;
        vec4 _106 = textureGather(gInDepth, _71 * parameters.gOutputSize.zw);
        bvec2 _107 = greaterThanEqual(_72, vec2(0.0));
        bvec2 _108 = lessThan(_71, parameters.gOutputSize.xy);
        bool _109 = _107.x;
        bool _110 = _107.y;
        if (_109 && _110)
        {
            float _114 = _106.w;
            float _124 = 1.0 / max(fma(_114, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _133 = _83 - _84;
            vec2 _134 = vec2(1.0) - _133;
            float _135 = _134.x;
            float _136 = _133.x;
            vec4 _144 = vec4(lessThanEqual(abs(_95), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _147 = abs(vec4((abs(_114 - 0.5) <= 0.5) ? (((_124 > 0.0) && (_124 < min(parameters.gSkyDepth, 65504.0))) ? _124 : 65504.0) : 65504.0) - _100);
            bvec4 _154 = greaterThan(_144 * vec4(lessThanEqual(abs(_147), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _155 = mix(vec4(0.0), (vec4(_135, _136, _135, _136) * vec4(_134.yy, _133.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _147), _154);
            vec4 _157 = mix(vec4(0.0), _155, greaterThan(_155, vec4(0.0)));
            float _158 = dot(_157, vec4(1.0));
            vec4 _159 = mix(vec4(1.9999999360571384930131252153835e+38), _147, _154);
            vec4 _169 = mix(vec4(0.0), _144, lessThanEqual(_159, vec4(min(min(_159.x, _159.y), min(_159.z, _159.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_80)), vec4(dot(mix(vec4(0.0), _95, greaterThan(_144, vec4(0.5))), mix(_169 / vec4(max(dot(_169, vec4(1.0)), 1.0)), _157 / vec4(_158), bvec4((_158 >= 1.0000000031710768509710513471353e-30) && (_158 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        bool _187 = _108.x;
        if (_187 && _110)
        {
            vec2 _191 = _71 + vec2(0.5, -0.5);
            float _192 = _106.z;
            float _202 = 1.0 / max(fma(_192, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _211 = fma(_191, vec2(0.5), vec2(-0.5));
            vec2 _213 = _211 - floor(_211);
            vec2 _214 = vec2(1.0) - _213;
            float _215 = _214.x;
            float _216 = _213.x;
            vec4 _224 = vec4(lessThanEqual(abs(_95), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _227 = abs(vec4((abs(_192 - 0.5) <= 0.5) ? (((_202 > 0.0) && (_202 < min(parameters.gSkyDepth, 65504.0))) ? _202 : 65504.0) : 65504.0) - _100);
            bvec4 _234 = greaterThan(_224 * vec4(lessThanEqual(abs(_227), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _235 = mix(vec4(0.0), (vec4(_215, _216, _215, _216) * vec4(_214.yy, _213.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _227), _234);
            vec4 _237 = mix(vec4(0.0), _235, greaterThan(_235, vec4(0.0)));
            float _238 = dot(_237, vec4(1.0));
            vec4 _239 = mix(vec4(1.9999999360571384930131252153835e+38), _227, _234);
            vec4 _249 = mix(vec4(0.0), _224, lessThanEqual(_239, vec4(min(min(_239.x, _239.y), min(_239.z, _239.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_191)), vec4(dot(mix(vec4(0.0), _95, greaterThan(_224, vec4(0.5))), mix(_249 / vec4(max(dot(_249, vec4(1.0)), 1.0)), _237 / vec4(_238), bvec4((_238 >= 1.0000000031710768509710513471353e-30) && (_238 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        bool _267 = _108.y;
        if (_109 && _267)
        {
            vec2 _271 = _71 + vec2(-0.5, 0.5);
            float _272 = _106.x;
            float _282 = 1.0 / max(fma(_272, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _291 = fma(_271, vec2(0.5), vec2(-0.5));
            vec2 _293 = _291 - floor(_291);
            vec2 _294 = vec2(1.0) - _293;
            float _295 = _294.x;
            float _296 = _293.x;
            vec4 _304 = vec4(lessThanEqual(abs(_95), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _307 = abs(vec4((abs(_272 - 0.5) <= 0.5) ? (((_282 > 0.0) && (_282 < min(parameters.gSkyDepth, 65504.0))) ? _282 : 65504.0) : 65504.0) - _100);
            bvec4 _314 = greaterThan(_304 * vec4(lessThanEqual(abs(_307), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _315 = mix(vec4(0.0), (vec4(_295, _296, _295, _296) * vec4(_294.yy, _293.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _307), _314);
            vec4 _317 = mix(vec4(0.0), _315, greaterThan(_315, vec4(0.0)));
            float _318 = dot(_317, vec4(1.0));
            vec4 _319 = mix(vec4(1.9999999360571384930131252153835e+38), _307, _314);
            vec4 _329 = mix(vec4(0.0), _304, lessThanEqual(_319, vec4(min(min(_319.x, _319.y), min(_319.z, _319.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_271)), vec4(dot(mix(vec4(0.0), _95, greaterThan(_304, vec4(0.5))), mix(_329 / vec4(max(dot(_329, vec4(1.0)), 1.0)), _317 / vec4(_318), bvec4((_318 >= 1.0000000031710768509710513471353e-30) && (_318 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        if (_187 && _267)
        {
            vec2 _350 = _71 + vec2(0.5);
            float _351 = _106.y;
            float _361 = 1.0 / max(fma(_351, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _370 = fma(_350, vec2(0.5), vec2(-0.5));
            vec2 _372 = _370 - floor(_370);
            vec2 _373 = vec2(1.0) - _372;
            float _374 = _373.x;
            float _375 = _372.x;
            vec4 _383 = vec4(lessThanEqual(abs(_95), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _386 = abs(vec4((abs(_351 - 0.5) <= 0.5) ? (((_361 > 0.0) && (_361 < min(parameters.gSkyDepth, 65504.0))) ? _361 : 65504.0) : 65504.0) - _100);
            bvec4 _393 = greaterThan(_383 * vec4(lessThanEqual(abs(_386), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _394 = mix(vec4(0.0), (vec4(_374, _375, _374, _375) * vec4(_373.yy, _372.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _386), _393);
            vec4 _396 = mix(vec4(0.0), _394, greaterThan(_394, vec4(0.0)));
            float _397 = dot(_396, vec4(1.0));
            vec4 _398 = mix(vec4(1.9999999360571384930131252153835e+38), _386, _393);
            vec4 _408 = mix(vec4(0.0), _383, lessThanEqual(_398, vec4(min(min(_398.x, _398.y), min(_398.z, _398.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_350)), vec4(dot(mix(vec4(0.0), _95, greaterThan(_383, vec4(0.5))), mix(_408 / vec4(max(dot(_408, vec4(1.0)), 1.0)), _396 / vec4(_397), bvec4((_397 >= 1.0000000031710768509710513471353e-30) && (_397 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        break;
    } while(false);
}

