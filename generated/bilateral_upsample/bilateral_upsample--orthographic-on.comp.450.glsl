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
        vec2 _76 = _75 - vec2(1.0);
        if (any(greaterThanEqual(_76, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _91 = (floor(fma(_75 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _95 = textureGather(gInFiltered, _91);
        float _96 = _95.w;
        float _97 = _95.z;
        float _98 = _95.x;
        float _99 = _95.y;
        float _102 = float(abs(_96) <= 65504.0);
        float _104 = (_102 > 0.5) ? _96 : 0.0;
        float _107 = float(abs(_97) <= 65504.0);
        float _109 = (_107 > 0.5) ? _97 : 0.0;
        float _112 = float(abs(_98) <= 65504.0);
        float _114 = (_112 > 0.5) ? _98 : 0.0;
        float _117 = float(abs(_99) <= 65504.0);
        vec4 _118 = vec4(_102, _107, _112, _117);
        float _120 = (_117 > 0.5) ? _99 : 0.0;
        vec4 _125 = textureGather(gInCoarseDepth, _91).wzxy;
        vec4 _128 = mix(vec4(65504.0), min(_125, vec4(65504.0)), greaterThan(_125, vec4(0.0)));
        vec4 _134 = textureGather(gInDepth, _75 * parameters.gOutputSize.zw);
        float _135 = _134.w;
        float _143 = fma(_135, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
        float _147 = min(parameters.gSkyDepth, 65504.0);
        vec4 _155 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_135 - 0.5) <= 0.5) ? (((_143 > 0.0) && (_143 < _147)) ? _143 : 65504.0) : 65504.0) - _128);
        vec4 _162 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _118) * _155.yxxx) * _155.zzyy) * _155.wwwz;
        vec4 _166 = _162 * (1.0 / max(dot(_162, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _175 = vec4(fma(_166.w, _120, fma(_166.z, _114, fma(_166.x, _104, _166.y * _109))), 0.0, 0.0, 0.0);
        float _176 = _134.z;
        float _180 = fma(_176, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
        vec4 _189 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_176 - 0.5) <= 0.5) ? (((_180 > 0.0) && (_180 < _147)) ? _180 : 65504.0) : 65504.0) - _128);
        vec4 _196 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _118) * _189.yxxx) * _189.zzyy) * _189.wwwz;
        vec4 _200 = _196 * (1.0 / max(dot(_196, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _209 = vec4(fma(_200.w, _120, fma(_200.z, _114, fma(_200.x, _104, _200.y * _109))), 0.0, 0.0, 0.0);
        float _210 = _134.x;
        float _214 = fma(_210, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
        vec4 _223 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_210 - 0.5) <= 0.5) ? (((_214 > 0.0) && (_214 < _147)) ? _214 : 65504.0) : 65504.0) - _128);
        vec4 _230 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _118) * _223.yxxx) * _223.zzyy) * _223.wwwz;
        vec4 _234 = _230 * (1.0 / max(dot(_230, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _243 = vec4(fma(_234.w, _120, fma(_234.z, _114, fma(_234.x, _104, _234.y * _109))), 0.0, 0.0, 0.0);
        float _244 = _134.y;
        float _248 = fma(_244, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
        vec4 _257 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_244 - 0.5) <= 0.5) ? (((_248 > 0.0) && (_248 < _147)) ? _248 : 65504.0) : 65504.0) - _128);
        vec4 _264 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _118) * _257.yxxx) * _257.zzyy) * _257.wwwz;
        vec4 _268 = _264 * (1.0 / max(dot(_264, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _277 = vec4(fma(_268.w, _120, fma(_268.z, _114, fma(_268.x, _104, _268.y * _109))), 0.0, 0.0, 0.0);
        bvec2 _278 = greaterThanEqual(_76, vec2(0.0));
        bvec2 _279 = lessThan(_75, parameters.gOutputSize.xy);
        ivec2 _280 = ivec2(_76);
        if (all(_278) && all(_279))
        {
            imageStore(gOutUpsampled, _280, _175);
            imageStore(gOutUpsampled, _280 + ivec2(1, 0), _209);
            imageStore(gOutUpsampled, _280 + ivec2(0, 1), _243);
            imageStore(gOutUpsampled, _280 + ivec2(1), _277);
            break;
        }
        bool _293 = _278.x;
        bool _294 = _278.y;
        if (_293 && _294)
        {
            imageStore(gOutUpsampled, _280, _175);
        }
        bool _299 = _279.x;
        if (_299 && _294)
        {
            imageStore(gOutUpsampled, _280 + ivec2(1, 0), _209);
        }
        bool _305 = _279.y;
        if (_293 && _305)
        {
            imageStore(gOutUpsampled, _280 + ivec2(0, 1), _243);
        }
        if (_299 && _305)
        {
            imageStore(gOutUpsampled, _280 + ivec2(1), _277);
        }
        break;
    } while(false);
}

