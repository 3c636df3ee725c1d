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
        if (any(greaterThanEqual(_75, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _83 = _75 + vec2(0.5);
        vec2 _86 = fma(_83, vec2(0.25), vec2(-0.5));
        vec2 _87 = floor(_86);
        vec2 _92 = (_87 + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _95 = textureGather(gInFiltered, _92).wzxy;
        vec4 _98 = mix(vec4(1.9999999360571384930131252153835e+38), _95, lessThanEqual(abs(_95), vec4(65504.0)));
        vec4 _103 = textureGather(gInCoarseDepth, _92).wzxy;
        vec2 _106 = _75 + vec2(1.0);
        vec4 _110 = textureGather(gInDepth, _106 * parameters.gOutputSize.zw);
        bvec2 _111 = greaterThanEqual(_75, vec2(0.0));
        bvec2 _112 = lessThan(_106, parameters.gOutputSize.xy);
        bool _113 = _111.x;
        bool _114 = _111.y;
        if (_113 && _114)
        {
            float _118 = _110.w;
            float _128 = 1.0 / max(fma(_118, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _137 = _86 - _87;
            vec2 _138 = vec2(1.0) - _137;
            float _139 = _138.x;
            float _140 = _137.x;
            vec4 _148 = vec4(lessThanEqual(abs(_98), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _151 = abs(vec4((abs(_118 - 0.5) <= 0.5) ? (((_128 > 0.0) && (_128 < min(parameters.gSkyDepth, 65504.0))) ? _128 : 65504.0) : 65504.0) - _103);
            bvec4 _158 = greaterThan(_148 * vec4(lessThanEqual(abs(_151), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _159 = mix(vec4(0.0), (vec4(_139, _140, _139, _140) * vec4(_138.yy, _137.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _151), _158);
            vec4 _161 = mix(vec4(0.0), _159, greaterThan(_159, vec4(0.0)));
            float _162 = dot(_161, vec4(1.0));
            vec4 _163 = mix(vec4(1.9999999360571384930131252153835e+38), _151, _158);
            vec4 _173 = mix(vec4(0.0), _148, lessThanEqual(_163, vec4(min(min(_163.x, _163.y), min(_163.z, _163.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_83)), vec4(dot(mix(vec4(0.0), _98, greaterThan(_148, vec4(0.5))), mix(_173 / vec4(max(dot(_173, vec4(1.0)), 1.0)), _161 / vec4(_162), bvec4((_162 >= 1.0000000031710768509710513471353e-30) && (_162 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        bool _191 = _112.x;
        if (_191 && _114)
        {
            vec2 _195 = _75 + vec2(1.5, 0.5);
            float _196 = _110.z;
            float _206 = 1.0 / max(fma(_196, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _215 = fma(_195, vec2(0.25), vec2(-0.5));
            vec2 _217 = _215 - floor(_215);
            vec2 _218 = vec2(1.0) - _217;
            float _219 = _218.x;
            float _220 = _217.x;
            vec4 _228 = vec4(lessThanEqual(abs(_98), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _231 = abs(vec4((abs(_196 - 0.5) <= 0.5) ? (((_206 > 0.0) && (_206 < min(parameters.gSkyDepth, 65504.0))) ? _206 : 65504.0) : 65504.0) - _103);
            bvec4 _238 = greaterThan(_228 * vec4(lessThanEqual(abs(_231), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _239 = mix(vec4(0.0), (vec4(_219, _220, _219, _220) * vec4(_218.yy, _217.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _231), _238);
            vec4 _241 = mix(vec4(0.0), _239, greaterThan(_239, vec4(0.0)));
            float _242 = dot(_241, vec4(1.0));
            vec4 _243 = mix(vec4(1.9999999360571384930131252153835e+38), _231, _238);
            vec4 _253 = mix(vec4(0.0), _228, lessThanEqual(_243, vec4(min(min(_243.x, _243.y), min(_243.z, _243.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_195)), vec4(dot(mix(vec4(0.0), _98, greaterThan(_228, vec4(0.5))), mix(_253 / vec4(max(dot(_253, vec4(1.0)), 1.0)), _241 / vec4(_242), bvec4((_242 >= 1.0000000031710768509710513471353e-30) && (_242 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        bool _271 = _112.y;
        if (_113 && _271)
        {
            vec2 _275 = _75 + vec2(0.5, 1.5);
            float _276 = _110.x;
            float _286 = 1.0 / max(fma(_276, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _295 = fma(_275, vec2(0.25), vec2(-0.5));
            vec2 _297 = _295 - floor(_295);
            vec2 _298 = vec2(1.0) - _297;
            float _299 = _298.x;
            float _300 = _297.x;
            vec4 _308 = vec4(lessThanEqual(abs(_98), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _311 = abs(vec4((abs(_276 - 0.5) <= 0.5) ? (((_286 > 0.0) && (_286 < min(parameters.gSkyDepth, 65504.0))) ? _286 : 65504.0) : 65504.0) - _103);
            bvec4 _318 = greaterThan(_308 * vec4(lessThanEqual(abs(_311), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _319 = mix(vec4(0.0), (vec4(_299, _300, _299, _300) * vec4(_298.yy, _297.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _311), _318);
            vec4 _321 = mix(vec4(0.0), _319, greaterThan(_319, vec4(0.0)));
            float _322 = dot(_321, vec4(1.0));
            vec4 _323 = mix(vec4(1.9999999360571384930131252153835e+38), _311, _318);
            vec4 _333 = mix(vec4(0.0), _308, lessThanEqual(_323, vec4(min(min(_323.x, _323.y), min(_323.z, _323.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_275)), vec4(dot(mix(vec4(0.0), _98, greaterThan(_308, vec4(0.5))), mix(_333 / vec4(max(dot(_333, vec4(1.0)), 1.0)), _321 / vec4(_322), bvec4((_322 >= 1.0000000031710768509710513471353e-30) && (_322 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        if (_191 && _271)
        {
            vec2 _354 = _75 + vec2(1.5);
            float _355 = _110.y;
            float _365 = 1.0 / max(fma(_355, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
            vec2 _374 = fma(_354, vec2(0.25), vec2(-0.5));
            vec2 _376 = _374 - floor(_374);
            vec2 _377 = vec2(1.0) - _376;
            float _378 = _377.x;
            float _379 = _376.x;
            vec4 _387 = vec4(lessThanEqual(abs(_98), vec4(9.9999996802856924650656260769173e+37)));
            vec4 _390 = abs(vec4((abs(_355 - 0.5) <= 0.5) ? (((_365 > 0.0) && (_365 < min(parameters.gSkyDepth, 65504.0))) ? _365 : 65504.0) : 65504.0) - _103);
            bvec4 _397 = greaterThan(_387 * vec4(lessThanEqual(abs(_390), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
            vec4 _398 = mix(vec4(0.0), (vec4(_378, _379, _378, _379) * vec4(_377.yy, _376.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _390), _397);
            vec4 _400 = mix(vec4(0.0), _398, greaterThan(_398, vec4(0.0)));
            float _401 = dot(_400, vec4(1.0));
            vec4 _402 = mix(vec4(1.9999999360571384930131252153835e+38), _390, _397);
            vec4 _412 = mix(vec4(0.0), _387, lessThanEqual(_402, vec4(min(min(_402.x, _402.y), min(_402.z, _402.w)))));
            imageStore(gOutUpsampled, ivec2(uvec2(_354)), vec4(dot(mix(vec4(0.0), _98, greaterThan(_387, vec4(0.5))), mix(_412 / vec4(max(dot(_412, vec4(1.0)), 1.0)), _400 / vec4(_401), bvec4((_401 >= 1.0000000031710768509710513471353e-30) && (_401 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        }
        break;
    } while(false);
}

