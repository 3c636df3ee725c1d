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
layout(binding = 4) uniform sampler2D gInNormal;
layout(binding = 3) uniform sampler2D gInDepth;

void main()
{
    do
    {
        vec2 _78 = vec2(gl_GlobalInvocationID.xy) * 2.0;
        vec2 _79 = _78 - vec2(1.0);
        if (any(greaterThanEqual(_79, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _91 = floor(fma(_78, vec2(0.5), vec2(-0.5)));
        vec2 _92 = max(parameters.gCoarseSize.xy, vec2(1.0));
        vec2 _93 = _92 - vec2(1.0);
        vec2 _96 = (clamp(_91, vec2(0.0), _93) + vec2(0.5)) / _92;
        vec2 _100 = (clamp(_91 + vec2(1.0), vec2(0.0), _93) + vec2(0.5)) / _92;
        vec2 _107 = _78 + vec2(-0.5);
        vec2 _110 = fma(_107, vec2(0.5), vec2(-0.5));
        vec2 _111 = floor(_110);
        vec2 _114 = (_111 + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _117 = textureGather(gInFiltered, _114).wzxy;
        vec4 _120 = mix(vec4(1.9999999360571384930131252153835e+38), _117, lessThanEqual(abs(_117), vec4(65504.0)));
        vec4 _125 = textureGather(gInCoarseDepth, _114).wzxy;
        vec3 _134 = textureLod(gInNormal, (fma(_96, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz;
        vec3 _140 = textureLod(gInNormal, (fma(vec2(_100.x, _96.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz;
        vec3 _146 = textureLod(gInNormal, (fma(vec2(_96.x, _100.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz;
        vec3 _152 = textureLod(gInNormal, (fma(_100, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz;
        vec4 _157 = textureGather(gInDepth, _78 * parameters.gOutputSize.zw);
        bvec2 _158 = greaterThanEqual(_79, vec2(0.0));
        bvec2 _159 = lessThan(_78, parameters.gOutputSize.xy);
        bool _160 = _158.x;
        bool _161 = _158.y;
        if (_160 && _161)
        {
            float _165 = _157.w;
            float _175 = 1.0 / max(fma(_165, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _184 = _110 - _111;
            vec2 _185 = vec2(1.0) - _184;
            float _186 = _185.x;
            float _187 = _184.x;
            vec3 _196 = textureLod(gInNormal, _107 * parameters.gOutputSize.zw, 0.0).xyz;
            float _199 = dot(_134, _196);
            float _203 = min(parameters.gContrast, 256.0);
            bool _206 = parameters.gContrast > 0.0;
            float _208 = dot(_140, _196);
            float _215 = dot(_146, _196);
            float _222 = dot(_152, _196);
            vec4 _232 = vec4(lessThanEqual(abs(_120), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _235 = abs(vec4((abs(_165 - 0.5) <= 0.5) ? (((_175 > 0.0) && (_175 < min(parameters.gSkyDepth, 65504.0))) ? _175 : 65504.0) : 65504.0) - _125);
            bvec4 _243 = greaterThan(_232 * vec4(lessThanEqual(abs(_235), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _244 = mix(vec4(0.0), ((vec4(_186, _187, _186, _187) * vec4(_185.yy, _184.yy)) * vec4(_206 ? ((_199 > 0.0) ? pow(min(abs(_199), 1.0), _203) : 0.0) : 1.0, _206 ? ((_208 > 0.0) ? pow(min(abs(_208), 1.0), _203) : 0.0) : 1.0, _206 ? ((_215 > 0.0) ? pow(min(abs(_215), 1.0), _203) : 0.0) : 1.0, _206 ? ((_222 > 0.0) ? pow(min(abs(_222), 1.0), _203) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _235), _243);
            vec4 _246 = mix(vec4(0.0), _244, greaterThan(_244, vec4(0.0)));
            float _247 = dot(_246, vec4(1.0));
            vec4 _248 = mix(vec4(1.9999999360571384930131252153835e+38), _235, _243);
            vec4 _258 = mix(vec4(0.0), _232, lessThanEqual(_248, vec4(min(min(_248.x, _248.y), min(_248.z, _248.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_107)), vec4(dot(mix(vec4(0.0), _120, greaterThan(_232, vec4(0.5))), mix(_258 / vec4(max(dot(_258, vec4(1.0)), 1.0)), _246 / vec4(_247), bvec4((_247 >= 1.0000000031710768509710513471353e-30) && (_247 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        bool _276 = _159.x;
        if (_276 && _161)
        {
            vec2 _280 = _78 + vec2(0.5, -0.5);
            float _281 = _157.z;
            float _291 = 1.0 / max(fma(_281, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _300 = fma(_280, vec2(0.5), vec2(-0.5));
            vec2 _302 = _300 - floor(_300);
            vec2 _303 = vec2(1.0) - _302;
            float _304 = _303.x;
            float _305 = _302.x;
            vec3 _314 = textureLod(gInNormal, _280 * parameters.gOutputSize.zw, 0.0).xyz;
            float _317 = dot(_134, _314);
            float _321 = min(parameters.gContrast, 256.0);
            bool _324 = parameters.gContrast > 0.0;
            float _326 = dot(_140, _314);
            float _333 = dot(_146, _314);
            float _340 = dot(_152, _314);
            vec4 _350 = vec4(lessThanEqual(abs(_120), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _353 = abs(vec4((abs(_281 - 0.5) <= 0.5) ? (((_291 > 0.0) && (_291 < min(parameters.gSkyDepth, 65504.0))) ? _291 : 65504.0) : 65504.0) - _125);
            bvec4 _361 = greaterThan(_350 * vec4(lessThanEqual(abs(_353), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _362 = mix(vec4(0.0), ((vec4(_304, _305, _304, _305) * vec4(_303.yy, _302.yy)) * vec4(_324 ? ((_317 > 0.0) ? pow(min(abs(_317), 1.0), _321) : 0.0) : 1.0, _324 ? ((_326 > 0.0) ? pow(min(abs(_326), 1.0), _321) : 0.0) : 1.0, _324 ? ((_333 > 0.0) ? pow(min(abs(_333), 1.0), _321) : 0.0) : 1.0, _324 ? ((_340 > 0.0) ? pow(min(abs(_340), 1.0), _321) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _353), _361);
            vec4 _364 = mix(vec4(0.0), _362, greaterThan(_362, vec4(0.0)));
            float _365 = dot(_364, vec4(1.0));
            vec4 _366 = mix(vec4(1.9999999360571384930131252153835e+38), _353, _361);
            vec4 _376 = mix(vec4(0.0), _350, lessThanEqual(_366, vec4(min(min(_366.x, _366.y), min(_366.z, _366.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_280)), vec4(dot(mix(vec4(0.0), _120, greaterThan(_350, vec4(0.5))), mix(_376 / vec4(max(dot(_376, vec4(1.0)), 1.0)), _364 / vec4(_365), bvec4((_365 >= 1.0000000031710768509710513471353e-30) && (_365 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        bool _394 = _159.y;
        if (_160 && _394)
        {
            vec2 _398 = _78 + vec2(-0.5, 0.5);
            float _399 = _157.x;
            float _409 = 1.0 / max(fma(_399, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _418 = fma(_398, vec2(0.5), vec2(-0.5));
            vec2 _420 = _418 - floor(_418);
            vec2 _421 = vec2(1.0) - _420;
            float _422 = _421.x;
            float _423 = _420.x;
            vec3 _432 = textureLod(gInNormal, _398 * parameters.gOutputSize.zw, 0.0).xyz;
            float _435 = dot(_134, _432);
            float _439 = min(parameters.gContrast, 256.0);
            bool _442 = parameters.gContrast > 0.0;
            float _444 = dot(_140, _432);
            float _451 = dot(_146, _432);
            float _458 = dot(_152, _432);
            vec4 _468 = vec4(lessThanEqual(abs(_120), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _471 = abs(vec4((abs(_399 - 0.5) <= 0.5) ? (((_409 > 0.0) && (_409 < min(parameters.gSkyDepth, 65504.0))) ? _409 : 65504.0) : 65504.0) - _125);
            bvec4 _479 = greaterThan(_468 * vec4(lessThanEqual(abs(_471), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _480 = mix(vec4(0.0), ((vec4(_422, _423, _422, _423) * vec4(_421.yy, _420.yy)) * vec4(_442 ? ((_435 > 0.0) ? pow(min(abs(_435), 1.0), _439) : 0.0) : 1.0, _442 ? ((_444 > 0.0) ? pow(min(abs(_444), 1.0), _439) : 0.0) : 1.0, _442 ? ((_451 > 0.0) ? pow(min(abs(_451), 1.0), _439) : 0.0) : 1.0, _442 ? ((_458 > 0.0) ? pow(min(abs(_458), 1.0), _439) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _471), _479);
            vec4 _482 = mix(vec4(0.0), _480, greaterThan(_480, vec4(0.0)));
            float _483 = dot(_482, vec4(1.0));
            vec4 _484 = mix(vec4(1.9999999360571384930131252153835e+38), _471, _479);
            vec4 _494 = mix(vec4(0.0), _468, lessThanEqual(_484, vec4(min(min(_484.x, _484.y), min(_484.z, _484.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_398)), vec4(dot(mix(vec4(0.0), _120, greaterThan(_468, vec4(0.5))), mix(_494 / vec4(max(dot(_494, vec4(1.0)), 1.0)), _482 / vec4(_483), bvec4((_483 >= 1.0000000031710768509710513471353e-30) && (_483 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        if (_276 && _394)
        {
            vec2 _515 = _78 + vec2(0.5);
            float _516 = _157.y;
            float _526 = 1.0 / max(fma(_516, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _535 = fma(_515, vec2(0.5), vec2(-0.5));
            vec2 _537 = _535 - floor(_535);
            vec2 _538 = vec2(1.0) - _537;
            float _539 = _538.x;
            float _540 = _537.x;
            vec3 _549 = textureLod(gInNormal, _515 * parameters.gOutputSize.zw, 0.0).xyz;
            float _552 = dot(_134, _549);
            float _556 = min(parameters.gContrast, 256.0);
            bool _559 = parameters.gContrast > 0.0;
            float _561 = dot(_140, _549);
            float _568 = dot(_146, _549);
            float _575 = dot(_152, _549);
            vec4 _585 = vec4(lessThanEqual(abs(_120), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _588 = abs(vec4((abs(_516 - 0.5) <= 0.5) ? (((_526 > 0.0) && (_526 < min(parameters.gSkyDepth, 65504.0))) ? _526 : 65504.0) : 65504.0) - _125);
            bvec4 _596 = greaterThan(_585 * vec4(lessThanEqual(abs(_588), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _597 = mix(vec4(0.0), ((vec4(_539, _540, _539, _540) * vec4(_538.yy, _537.yy)) * vec4(_559 ? ((_552 > 0.0) ? pow(min(abs(_552), 1.0), _556) : 0.0) : 1.0, _559 ? ((_561 > 0.0) ? pow(min(abs(_561), 1.0), _556) : 0.0) : 1.0, _559 ? ((_568 > 0.0) ? pow(min(abs(_568), 1.0), _556) : 0.0) : 1.0, _559 ? ((_575 > 0.0) ? pow(min(abs(_575), 1.0), _556) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _588), _596);
            vec4 _599 = mix(vec4(0.0), _597, greaterThan(_597, vec4(0.0)));
            float _600 = dot(_599, vec4(1.0));
            vec4 _601 = mix(vec4(1.9999999360571384930131252153835e+38), _588, _596);
            vec4 _611 = mix(vec4(0.0), _585, lessThanEqual(_601, vec4(min(min(_601.x, _601.y), min(_601.z, _601.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_515)), vec4(dot(mix(vec4(0.0), _120, greaterThan(_585, vec4(0.5))), mix(_611 / vec4(max(dot(_611, vec4(1.0)), 1.0)), _599 / vec4(_600), bvec4((_600 >= 1.0000000031710768509710513471353e-30) && (_600 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        break;
    } while(false);
}

