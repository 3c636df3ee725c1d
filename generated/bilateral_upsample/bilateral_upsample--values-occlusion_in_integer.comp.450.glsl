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
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _80 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _83 = fma(_80, vec2(0.5), vec2(-0.5));
        vec2 _84 = floor(_83);
        vec2 _85 = _83 - _84;
        vec2 _86 = vec2(1.0) - _85;
        float _87 = _86.x;
        float _88 = _85.x;
        vec2 _100 = (_84 + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _103 = textureGather(gInFiltered, _100).wzxy;
        vec4 _106 = mix(vec4(1.9999999360571384930131252153835e+38), _103, lessThanEqual(abs(_103), vec4(65504.0)));
        float _112 = _106.x;
        float _117 = (_112 > 0.0) ? min(_112, 31.984375) : 0.0;
        float _118 = floor(_117);
        vec2 _126 = mix(vec2(_112), min(vec2(_118 * 0.0322580635547637939453125, (_117 - _118) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_112) <= 9.9999996802856924650656260769173e+37));
        float _127 = _106.y;
        float _132 = (_127 > 0.0) ? min(_127, 31.984375) : 0.0;
        float _133 = floor(_132);
        vec2 _141 = mix(vec2(_127), min(vec2(_133 * 0.0322580635547637939453125, (_132 - _133) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_127) <= 9.9999996802856924650656260769173e+37));
        float _142 = _106.z;
        float _147 = (_142 > 0.0) ? min(_142, 31.984375) : 0.0;
        float _148 = floor(_147);
        vec2 _156 = mix(vec2(_142), min(vec2(_148 * 0.0322580635547637939453125, (_147 - _148) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_142) <= 9.9999996802856924650656260769173e+37));
        float _157 = _106.w;
        float _162 = (_157 > 0.0) ? min(_157, 31.984375) : 0.0;
        float _163 = floor(_162);
        vec2 _171 = mix(vec2(_157), min(vec2(_163 * 0.0322580635547637939453125, (_162 - _163) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_157) <= 9.9999996802856924650656260769173e+37));
        vec4 _175 = textureLod(gInDepth, _80 * parameters.gOutputSize.zw, 0.0);
        float _176 = _175.x;
        float _186 = 1.0 / max(fma(_176, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        bool _197 = all(lessThanEqual(abs(_126), vec2(9.9999996802856924650656260769173e+37)));
        bool _201 = all(lessThanEqual(abs(_141), vec2(9.9999996802856924650656260769173e+37)));
        bool _205 = all(lessThanEqual(abs(_156), vec2(9.9999996802856924650656260769173e+37)));
        bool _209 = all(lessThanEqual(abs(_171), vec2(9.9999996802856924650656260769173e+37)));
        vec4 _211 = vec4(float(_197), float(_201), float(_205), float(_209));
        vec4 _214 = abs(vec4((abs(_176 - 0.5) <= 0.5) ? (((_186 > 0.0) && (_186 < min(parameters.gSkyDepth, 65504.0))) ? _186 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _100).wzxy);
        bvec4 _221 = greaterThan(_211 * vec4(lessThanEqual(abs(_214), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _222 = mix(vec4(0.0), (vec4(_87, _88, _87, _88) * vec4(_86.yy, _85.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _214), _221);
        vec4 _224 = mix(vec4(0.0), _222, greaterThan(_222, vec4(0.0)));
        float _225 = dot(_224, vec4(1.0));
        vec4 _226 = mix(vec4(1.9999999360571384930131252153835e+38), _214, _221);
        vec4 _236 = mix(vec4(0.0), _211, lessThanEqual(_226, vec4(min(min(_226.x, _226.y), min(_226.z, _226.w)))));
        vec4 _247 = mix(_236 / vec4(max(dot(_236, vec4(1.0)), 1.0)), _224 / vec4(_225), bvec4((_225 >= 1.0000000031710768509710513471353e-30) && (_225 <= 9.9999996802856924650656260769173e+37)));
        imageStore(gOutUpsampled, ivec2(gl_GlobalInvocationID.xy), vec4((((mix(vec2(0.0), _126, bvec2(_197)) * _247.x) + (mix(vec2(0.0), _141, bvec2(_201)) * _247.y)) + (mix(vec2(0.0), _156, bvec2(_205)) * _247.z)) + (mix(vec2(0.0), _171, bvec2(_209)) * _247.w), 0.0, 0.0));
        break;
    } while(false);
}

