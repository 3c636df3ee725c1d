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
        vec2 _127 = mix(vec2(_112), min(vec2(_118 * 0.0322580635547637939453125, (_117 - _118) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_112) <= 9.9999996802856924650656260769173e+37));
        float _128 = _106.y;
        float _133 = (_128 > 0.0) ? min(_128, 31.984375) : 0.0;
        float _134 = floor(_133);
        vec2 _143 = mix(vec2(_128), min(vec2(_134 * 0.0322580635547637939453125, (_133 - _134) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_128) <= 9.9999996802856924650656260769173e+37));
        float _144 = _106.z;
        float _149 = (_144 > 0.0) ? min(_144, 31.984375) : 0.0;
        float _150 = floor(_149);
        vec2 _159 = mix(vec2(_144), min(vec2(_150 * 0.0322580635547637939453125, (_149 - _150) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_144) <= 9.9999996802856924650656260769173e+37));
        float _160 = _106.w;
        float _165 = (_160 > 0.0) ? min(_160, 31.984375) : 0.0;
        float _166 = floor(_165);
        vec2 _175 = mix(vec2(_160), min(vec2(_166 * 0.0322580635547637939453125, (_165 - _166) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_160) <= 9.9999996802856924650656260769173e+37));
        vec4 _179 = textureLod(gInDepth, _80 * parameters.gOutputSize.zw, 0.0);
        float _180 = _179.x;
        float _190 = 1.0 / max(fma(_180, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        bool _201 = all(lessThanEqual(abs(_127), vec2(9.9999996802856924650656260769173e+37)));
        bool _205 = all(lessThanEqual(abs(_143), vec2(9.9999996802856924650656260769173e+37)));
        bool _209 = all(lessThanEqual(abs(_159), vec2(9.9999996802856924650656260769173e+37)));
        bool _213 = all(lessThanEqual(abs(_175), vec2(9.9999996802856924650656260769173e+37)));
        vec4 _215 = vec4(float(_201), float(_205), float(_209), float(_213));
        vec4 _218 = abs(vec4((abs(_180 - 0.5) <= 0.5) ? (((_190 > 0.0) && (_190 < min(parameters.gSkyDepth, 65504.0))) ? _190 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _100).wzxy);
        bvec4 _225 = greaterThan(_215 * vec4(lessThanEqual(abs(_218), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _226 = mix(vec4(0.0), (vec4(_87, _88, _87, _88) * vec4(_86.yy, _85.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _218), _225);
        vec4 _228 = mix(vec4(0.0), _226, greaterThan(_226, vec4(0.0)));
        float _229 = dot(_228, vec4(1.0));
        vec4 _230 = mix(vec4(1.9999999360571384930131252153835e+38), _218, _225);
        vec4 _240 = mix(vec4(0.0), _215, lessThanEqual(_230, vec4(min(min(_230.x, _230.y), min(_230.z, _230.w)))));
        vec4 _251 = mix(_240 / vec4(max(dot(_240, vec4(1.0)), 1.0)), _228 / vec4(_229), bvec4((_229 >= 1.0000000031710768509710513471353e-30) && (_229 <= 9.9999996802856924650656260769173e+37)));
        imageStore(gOutUpsampled, ivec2(gl_GlobalInvocationID.xy), vec4((((mix(vec2(0.0), _127, bvec2(_201)) * _251.x) + (mix(vec2(0.0), _143, bvec2(_205)) * _251.y)) + (mix(vec2(0.0), _159, bvec2(_209)) * _251.z)) + (mix(vec2(0.0), _175, bvec2(_213)) * _251.w), 0.0, 0.0));
        break;
    } while(false);
}

