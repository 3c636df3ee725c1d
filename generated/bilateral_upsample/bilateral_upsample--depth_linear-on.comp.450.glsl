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
        vec2 _73 = vec2(gl_GlobalInvocationID.xy) * 2.0;
        vec2 _74 = _73 - vec2(1.0);
        if (any(greaterThanEqual(_74, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _89 = (floor(fma(_73 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _93 = textureGather(gInFiltered, _89);
        float _94 = _93.w;
        float _95 = _93.z;
        float _96 = _93.x;
        float _97 = _93.y;
        float _100 = float(abs(_94) <= 65504.0);
        float _102 = (_100 > 0.5) ? _94 : 0.0;
        float _105 = float(abs(_95) <= 65504.0);
        float _107 = (_105 > 0.5) ? _95 : 0.0;
        float _110 = float(abs(_96) <= 65504.0);
        float _112 = (_110 > 0.5) ? _96 : 0.0;
        float _115 = float(abs(_97) <= 65504.0);
        vec4 _116 = vec4(_100, _105, _110, _115);
        float _118 = (_115 > 0.5) ? _97 : 0.0;
        vec4 _123 = textureGather(gInCoarseDepth, _89).wzxy;
        vec4 _126 = mix(vec4(65504.0), min(_123, vec4(65504.0)), greaterThan(_123, vec4(0.0)));
        vec4 _132 = textureGather(gInDepth, _73 * parameters.gOutputSize.zw);
        float _133 = _132.w;
        float _137 = min(parameters.gSkyDepth, 65504.0);
        vec4 _144 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_133 > 0.0) && (_133 < _137)) ? _133 : 65504.0) - _126);
        vec4 _151 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _116) * _144.yxxx) * _144.zzyy) * _144.wwwz;
        vec4 _155 = _151 * (1.0 / max(dot(_151, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _164 = vec4(fma(_155.w, _118, fma(_155.z, _112, fma(_155.x, _102, _155.y * _107))), 0.0, 0.0, 0.0);
        float _165 = _132.z;
        vec4 _173 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_165 > 0.0) && (_165 < _137)) ? _165 : 65504.0) - _126);
        vec4 _180 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _116) * _173.yxxx) * _173.zzyy) * _173.wwwz;
        vec4 _184 = _180 * (1.0 / max(dot(_180, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _193 = vec4(fma(_184.w, _118, fma(_184.z, _112, fma(_184.x, _102, _184.y * _107))), 0.0, 0.0, 0.0);
        float _194 = _132.x;
        vec4 _202 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_194 > 0.0) && (_194 < _137)) ? _194 : 65504.0) - _126);
        vec4 _209 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _116) * _202.yxxx) * _202.zzyy) * _202.wwwz;
        vec4 _213 = _209 * (1.0 / max(dot(_209, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _222 = vec4(fma(_213.w, _118, fma(_213.z, _112, fma(_213.x, _102, _213.y * _107))), 0.0, 0.0, 0.0);
        float _223 = _132.y;
        vec4 _231 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_223 > 0.0) && (_223 < _137)) ? _223 : 65504.0) - _126);
        vec4 _238 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _116) * _231.yxxx) * _231.zzyy) * _231.wwwz;
        vec4 _242 = _238 * (1.0 / max(dot(_238, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _251 = vec4(fma(_242.w, _118, fma(_242.z, _112, fma(_242.x, _102, _242.y * _107))), 0.0, 0.0, 0.0);
        bvec2 _252 = greaterThanEqual(_74, vec2(0.0));
        bvec2 _253 = lessThan(_73, parameters.gOutputSize.xy);
        ivec2 _254 = ivec2(_74);
        if (all(_252) && all(_253))
        {
            imageStore(gOutUpsampled, _254, _164);
            imageStore(gOutUpsampled, _254 + ivec2(1, 0), _193);
            imageStore(gOutUpsampled, _254 + ivec2(0, 1), _222);
            imageStore(gOutUpsampled, _254 + ivec2(1), _251);
            break;
        }
        bool _267 = _252.x;
        bool _268 = _252.y;
        if (_267 && _268)
        {
            imageStore(gOutUpsampled, _254, _164);
        }
        bool _273 = _253.x;
        if (_273 && _268)
        {
            imageStore(gOutUpsampled, _254 + ivec2(1, 0), _193);
        }
        bool _279 = _253.y;
        if (_267 && _279)
        {
            imageStore(gOutUpsampled, _254 + ivec2(0, 1), _222);
        }
        if (_273 && _279)
        {
            imageStore(gOutUpsampled, _254 + ivec2(1), _251);
        }
        break;
    } while(false);
}

