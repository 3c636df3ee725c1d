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
        float _145 = 1.0 / max(fma(_135, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _149 = min(parameters.gSkyDepth, 65504.0);
        vec4 _157 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_135 - 0.5) <= 0.5) ? (((_145 > 0.0) && (_145 < _149)) ? _145 : 65504.0) : 65504.0) - _128);
        vec4 _164 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _118) * _157.yxxx) * _157.zzyy) * _157.wwwz;
        vec4 _168 = _164 * (1.0 / max(dot(_164, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _177 = vec4(fma(_168.w, _120, fma(_168.z, _114, fma(_168.x, _104, _168.y * _109))), 0.0, 0.0, 0.0);
        float _178 = _134.z;
        float _184 = 1.0 / max(fma(_178, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _193 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_178 - 0.5) <= 0.5) ? (((_184 > 0.0) && (_184 < _149)) ? _184 : 65504.0) : 65504.0) - _128);
        vec4 _200 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _118) * _193.yxxx) * _193.zzyy) * _193.wwwz;
        vec4 _204 = _200 * (1.0 / max(dot(_200, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _213 = vec4(fma(_204.w, _120, fma(_204.z, _114, fma(_204.x, _104, _204.y * _109))), 0.0, 0.0, 0.0);
        float _214 = _134.x;
        float _220 = 1.0 / max(fma(_214, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _229 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_214 - 0.5) <= 0.5) ? (((_220 > 0.0) && (_220 < _149)) ? _220 : 65504.0) : 65504.0) - _128);
        vec4 _236 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _118) * _229.yxxx) * _229.zzyy) * _229.wwwz;
        vec4 _240 = _236 * (1.0 / max(dot(_236, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _249 = vec4(fma(_240.w, _120, fma(_240.z, _114, fma(_240.x, _104, _240.y * _109))), 0.0, 0.0, 0.0);
        float _250 = _134.y;
        float _256 = 1.0 / max(fma(_250, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _265 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_250 - 0.5) <= 0.5) ? (((_256 > 0.0) && (_256 < _149)) ? _256 : 65504.0) : 65504.0) - _128);
        vec4 _272 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _118) * _265.yxxx) * _265.zzyy) * _265.wwwz;
        vec4 _276 = _272 * (1.0 / max(dot(_272, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _285 = vec4(fma(_276.w, _120, fma(_276.z, _114, fma(_276.x, _104, _276.y * _109))), 0.0, 0.0, 0.0);
        bvec2 _286 = greaterThanEqual(_76, vec2(0.0));
        bvec2 _287 = lessThan(_75, parameters.gOutputSize.xy);
        ivec2 _288 = ivec2(_76);
        if (all(_286) && all(_287))
        {
            imageStore(gOutUpsampled, _288, _177);
            imageStore(gOutUpsampled, _288 + ivec2(1, 0), _213);
            imageStore(gOutUpsampled, _288 + ivec2(0, 1), _249);
            imageStore(gOutUpsampled, _288 + ivec2(1), _285);
            break;
        }
        bool _301 = _286.x;
        bool _302 = _286.y;
        if (_301 && _302)
        {
            imageStore(gOutUpsampled, _288, _177);
        }
        bool _307 = _287.x;
        if (_307 && _302)
        {
            imageStore(gOutUpsampled, _288 + ivec2(1, 0), _213);
        }
        bool _313 = _287.y;
        if (_301 && _313)
        {
            imageStore(gOutUpsampled, _288 + ivec2(0, 1), _249);
        }
        if (_307 && _313)
        {
            imageStore(gOutUpsampled, _288 + ivec2(1), _285);
        }
        break;
    } while(false);
}

