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
            float _122 = fma(_114, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
            vec2 _131 = _83 - _84;
            vec2 _132 = vec2(1.0) - _131;
            float _133 = _132.x;
            float _134 = _131.x;
            vec4 _142 = vec4(lessThanEqual(abs(_95), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _145 = abs(vec4((abs(_114 - 0.5) <= 0.5) ? (((_122 > 0.0) && (_122 < min(parameters.gSkyDepth, 65504.0))) ? _122 : 65504.0) : 65504.0) - _100);
            bvec4 _152 = greaterThan(_142 * vec4(lessThanEqual(abs(_145), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _153 = mix(vec4(0.0), (vec4(_133, _134, _133, _134) * vec4(_132.yy, _131.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _145), _152);
            vec4 _155 = mix(vec4(0.0), _153, greaterThan(_153, vec4(0.0)));
            float _156 = dot(_155, vec4(1.0));
            vec4 _157 = mix(vec4(1.9999999360571384930131252153835e+38), _145, _152);
            vec4 _167 = mix(vec4(0.0), _142, lessThanEqual(_157, vec4(min(min(_157.x, _157.y), min(_157.z, _157.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_80)), vec4(dot(mix(vec4(0.0), _95, greaterThan(_142, vec4(0.5))), mix(_167 / vec4(max(dot(_167, vec4(1.0)), 1.0)), _155 / vec4(_156), bvec4((_156 >= 1.0000000031710768509710513471353e-30) && (_156 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        bool _185 = _108.x;
        if (_185 && _110)
        {
            vec2 _189 = _71 + vec2(0.5, -0.5);
            float _190 = _106.z;
            float _198 = fma(_190, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
            vec2 _207 = fma(_189, vec2(0.5), vec2(-0.5));
            vec2 _209 = _207 - floor(_207);
            vec2 _210 = vec2(1.0) - _209;
            float _211 = _210.x;
            float _212 = _209.x;
            vec4 _220 = vec4(lessThanEqual(abs(_95), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _223 = abs(vec4((abs(_190 - 0.5) <= 0.5) ? (((_198 > 0.0) && (_198 < min(parameters.gSkyDepth, 65504.0))) ? _198 : 65504.0) : 65504.0) - _100);
            bvec4 _230 = greaterThan(_220 * vec4(lessThanEqual(abs(_223), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _231 = mix(vec4(0.0), (vec4(_211, _212, _211, _212) * vec4(_210.yy, _209.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _223), _230);
            vec4 _233 = mix(vec4(0.0), _231, greaterThan(_231, vec4(0.0)));
            float _234 = dot(_233, vec4(1.0));
            vec4 _235 = mix(vec4(1.9999999360571384930131252153835e+38), _223, _230);
            vec4 _245 = mix(vec4(0.0), _220, lessThanEqual(_235, vec4(min(min(_235.x, _235.y), min(_235.z, _235.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_189)), vec4(dot(mix(vec4(0.0), _95, greaterThan(_220, vec4(0.5))), mix(_245 / vec4(max(dot(_245, vec4(1.0)), 1.0)), _233 / vec4(_234), bvec4((_234 >= 1.0000000031710768509710513471353e-30) && (_234 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        bool _263 = _108.y;
        if (_109 && _263)
        {
            vec2 _267 = _71 + vec2(-0.5, 0.5);
            float _268 = _106.x;
            float _276 = fma(_268, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
            vec2 _285 = fma(_267, vec2(0.5), vec2(-0.5));
            vec2 _287 = _285 - floor(_285);
            vec2 _288 = vec2(1.0) - _287;
            float _289 = _288.x;
            float _290 = _287.x;
            vec4 _298 = vec4(lessThanEqual(abs(_95), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _301 = abs(vec4((abs(_268 - 0.5) <= 0.5) ? (((_276 > 0.0) && (_276 < min(parameters.gSkyDepth, 65504.0))) ? _276 : 65504.0) : 65504.0) - _100);
            bvec4 _308 = greaterThan(_298 * vec4(lessThanEqual(abs(_301), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _309 = mix(vec4(0.0), (vec4(_289, _290, _289, _290) * vec4(_288.yy, _287.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _301), _308);
            vec4 _311 = mix(vec4(0.0), _309, greaterThan(_309, vec4(0.0)));
            float _312 = dot(_311, vec4(1.0));
            vec4 _313 = mix(vec4(1.9999999360571384930131252153835e+38), _301, _308);
            vec4 _323 = mix(vec4(0.0), _298, lessThanEqual(_313, vec4(min(min(_313.x, _313.y), min(_313.z, _313.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_267)), vec4(dot(mix(vec4(0.0), _95, greaterThan(_298, vec4(0.5))), mix(_323 / vec4(max(dot(_323, vec4(1.0)), 1.0)), _311 / vec4(_312), bvec4((_312 >= 1.0000000031710768509710513471353e-30) && (_312 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        if (_185 && _263)
        {
            vec2 _344 = _71 + vec2(0.5);
            float _345 = _106.y;
            float _353 = fma(_345, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
            vec2 _362 = fma(_344, vec2(0.5), vec2(-0.5));
            vec2 _364 = _362 - floor(_362);
            vec2 _365 = vec2(1.0) - _364;
            float _366 = _365.x;
            float _367 = _364.x;
            vec4 _375 = vec4(lessThanEqual(abs(_95), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _378 = abs(vec4((abs(_345 - 0.5) <= 0.5) ? (((_353 > 0.0) && (_353 < min(parameters.gSkyDepth, 65504.0))) ? _353 : 65504.0) : 65504.0) - _100);
            bvec4 _385 = greaterThan(_375 * vec4(lessThanEqual(abs(_378), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _386 = mix(vec4(0.0), (vec4(_366, _367, _366, _367) * vec4(_365.yy, _364.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _378), _385);
            vec4 _388 = mix(vec4(0.0), _386, greaterThan(_386, vec4(0.0)));
            float _389 = dot(_388, vec4(1.0));
            vec4 _390 = mix(vec4(1.9999999360571384930131252153835e+38), _378, _385);
            vec4 _400 = mix(vec4(0.0), _375, lessThanEqual(_390, vec4(min(min(_390.x, _390.y), min(_390.z, _390.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_344)), vec4(dot(mix(vec4(0.0), _95, greaterThan(_375, vec4(0.5))), mix(_400 / vec4(max(dot(_400, vec4(1.0)), 1.0)), _388 / vec4(_389), bvec4((_389 >= 1.0000000031710768509710513471353e-30) && (_389 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        break;
    } while(false);
}

