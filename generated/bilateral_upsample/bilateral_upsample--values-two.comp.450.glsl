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
        vec2 _76 = vec2(gl_GlobalInvocationID.xy) * 2.0;
        vec2 _77 = _76 - vec2(1.0);
        if (any(greaterThanEqual(_77, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _92 = (floor(fma(_76 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _96 = textureGather(gInFiltered, _92);
        vec4 _98 = textureGather(gInFiltered, _92, 1);
        vec2 _102 = vec4(_96.w, _98.w, 0.0, 0.0).xy;
        vec2 _106 = vec4(_96.z, _98.z, 0.0, 0.0).xy;
        vec2 _110 = vec4(_96.x, _98.x, 0.0, 0.0).xy;
        vec2 _114 = vec4(_96.y, _98.y, 0.0, 0.0).xy;
        float _118 = float(all(lessThanEqual(abs(_102), vec2(65504.0))));
        vec2 _121 = mix(vec2(0.0), _102, bvec2(_118 > 0.5));
        float _125 = float(all(lessThanEqual(abs(_106), vec2(65504.0))));
        vec2 _128 = mix(vec2(0.0), _106, bvec2(_125 > 0.5));
        float _132 = float(all(lessThanEqual(abs(_110), vec2(65504.0))));
        vec2 _135 = mix(vec2(0.0), _110, bvec2(_132 > 0.5));
        float _139 = float(all(lessThanEqual(abs(_114), vec2(65504.0))));
        vec4 _140 = vec4(_118, _125, _132, _139);
        vec2 _143 = mix(vec2(0.0), _114, bvec2(_139 > 0.5));
        vec4 _148 = textureGather(gInCoarseDepth, _92).wzxy;
        vec4 _151 = mix(vec4(65504.0), min(_148, vec4(65504.0)), greaterThan(_148, vec4(0.0)));
        vec4 _157 = textureGather(gInDepth, _76 * parameters.gOutputSize.zw);
        float _158 = _157.w;
        float _168 = 1.0 / max(fma(_158, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _172 = min(parameters.gSkyDepth, 65504.0);
        vec4 _180 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_158 - 0.5) <= 0.5) ? (((_168 > 0.0) && (_168 < _172)) ? _168 : 65504.0) : 65504.0) - _151);
        vec4 _187 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _140) * _180.yxxx) * _180.zzyy) * _180.wwwz;
        vec4 _191 = _187 * (1.0 / max(dot(_187, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _205 = vec4((((_121 * _191.x) + (_128 * _191.y)) + (_135 * _191.z)) + (_143 * _191.w), 0.0, 0.0);
        float _206 = _157.z;
        float _212 = 1.0 / max(fma(_206, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _221 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_206 - 0.5) <= 0.5) ? (((_212 > 0.0) && (_212 < _172)) ? _212 : 65504.0) : 65504.0) - _151);
        vec4 _228 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _140) * _221.yxxx) * _221.zzyy) * _221.wwwz;
        vec4 _232 = _228 * (1.0 / max(dot(_228, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _246 = vec4((((_121 * _232.x) + (_128 * _232.y)) + (_135 * _232.z)) + (_143 * _232.w), 0.0, 0.0);
        float _247 = _157.x;
        float _253 = 1.0 / max(fma(_247, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _262 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_247 - 0.5) <= 0.5) ? (((_253 > 0.0) && (_253 < _172)) ? _253 : 65504.0) : 65504.0) - _151);
        vec4 _269 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _140) * _262.yxxx) * _262.zzyy) * _262.wwwz;
        vec4 _273 = _269 * (1.0 / max(dot(_269, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _287 = vec4((((_121 * _273.x) + (_128 * _273.y)) + (_135 * _273.z)) + (_143 * _273.w), 0.0, 0.0);
        float _288 = _157.y;
        float _294 = 1.0 / max(fma(_288, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _303 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_288 - 0.5) <= 0.5) ? (((_294 > 0.0) && (_294 < _172)) ? _294 : 65504.0) : 65504.0) - _151);
        vec4 _310 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _140) * _303.yxxx) * _303.zzyy) * _303.wwwz;
        vec4 _314 = _310 * (1.0 / max(dot(_310, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _328 = vec4((((_121 * _314.x) + (_128 * _314.y)) + (_135 * _314.z)) + (_143 * _314.w), 0.0, 0.0);
        bvec2 _329 = greaterThanEqual(_77, vec2(0.0));
        bvec2 _330 = lessThan(_76, parameters.gOutputSize.xy);
        ivec2 _331 = ivec2(_77);
        if (all(_329) && all(_330))
        {
            imageStore(gOutUpsampled, _331, _205);
            imageStore(gOutUpsampled, _331 + ivec2(1, 0), _246);
            imageStore(gOutUpsampled, _331 + ivec2(0, 1), _287);
            imageStore(gOutUpsampled, _331 + ivec2(1), _328);
            break;
        }
        bool _344 = _329.x;
        bool _345 = _329.y;
        if (_344 && _345)
        {
            imageStore(gOutUpsampled, _331, _205);
        }
        bool _350 = _330.x;
        if (_350 && _345)
        {
            imageStore(gOutUpsampled, _331 + ivec2(1, 0), _246);
        }
        bool _356 = _330.y;
        if (_344 && _356)
        {
            imageStore(gOutUpsampled, _331 + ivec2(0, 1), _287);
        }
        if (_350 && _356)
        {
            imageStore(gOutUpsampled, _331 + ivec2(1), _328);
        }
        break;
    } while(false);
}

