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
        vec2 _89 = floor(fma(_76, vec2(0.5), vec2(-0.5)));
        vec2 _90 = max(parameters.gCoarseSize.xy, vec2(1.0));
        vec2 _91 = _90 - vec2(1.0);
        vec2 _94 = (clamp(_89, vec2(0.0), _91) + vec2(0.5)) / _90;
        vec2 _98 = (clamp(_89 + vec2(1.0), vec2(0.0), _91) + vec2(0.5)) / _90;
        vec2 _110 = textureLod(gInFiltered, _94, 0.0).xy;
        vec2 _113 = textureLod(gInFiltered, vec2(_98.x, _94.y), 0.0).xy;
        vec2 _116 = textureLod(gInFiltered, vec2(_94.x, _98.y), 0.0).xy;
        vec2 _119 = textureLod(gInFiltered, _98, 0.0).xy;
        float _123 = float(all(lessThanEqual(abs(_110), vec2(65504.0))));
        vec2 _126 = mix(vec2(0.0), _110, bvec2(_123 > 0.5));
        float _130 = float(all(lessThanEqual(abs(_113), vec2(65504.0))));
        vec2 _133 = mix(vec2(0.0), _113, bvec2(_130 > 0.5));
        float _137 = float(all(lessThanEqual(abs(_116), vec2(65504.0))));
        vec2 _140 = mix(vec2(0.0), _116, bvec2(_137 > 0.5));
        float _144 = float(all(lessThanEqual(abs(_119), vec2(65504.0))));
        vec4 _145 = vec4(_123, _130, _137, _144);
        vec2 _148 = mix(vec2(0.0), _119, bvec2(_144 > 0.5));
        vec4 _158 = textureGather(gInCoarseDepth, (floor(fma(_76 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw).wzxy;
        vec4 _161 = mix(vec4(65504.0), min(_158, vec4(65504.0)), greaterThan(_158, vec4(0.0)));
        vec4 _167 = textureGather(gInDepth, _76 * parameters.gOutputSize.zw);
        float _168 = _167.w;
        float _178 = 1.0 / max(fma(_168, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _182 = min(parameters.gSkyDepth, 65504.0);
        vec4 _190 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_168 - 0.5) <= 0.5) ? (((_178 > 0.0) && (_178 < _182)) ? _178 : 65504.0) : 65504.0) - _161);
        vec4 _197 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _145) * _190.yxxx) * _190.zzyy) * _190.wwwz;
        vec4 _201 = _197 * (1.0 / max(dot(_197, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _215 = vec4((((_126 * _201.x) + (_133 * _201.y)) + (_140 * _201.z)) + (_148 * _201.w), 0.0, 0.0);
        float _216 = _167.z;
        float _222 = 1.0 / max(fma(_216, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _231 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_216 - 0.5) <= 0.5) ? (((_222 > 0.0) && (_222 < _182)) ? _222 : 65504.0) : 65504.0) - _161);
        vec4 _238 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _145) * _231.yxxx) * _231.zzyy) * _231.wwwz;
        vec4 _242 = _238 * (1.0 / max(dot(_238, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _256 = vec4((((_126 * _242.x) + (_133 * _242.y)) + (_140 * _242.z)) + (_148 * _242.w), 0.0, 0.0);
        float _257 = _167.x;
        float _263 = 1.0 / max(fma(_257, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _272 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_257 - 0.5) <= 0.5) ? (((_263 > 0.0) && (_263 < _182)) ? _263 : 65504.0) : 65504.0) - _161);
        vec4 _279 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _145) * _272.yxxx) * _272.zzyy) * _272.wwwz;
        vec4 _283 = _279 * (1.0 / max(dot(_279, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _297 = vec4((((_126 * _283.x) + (_133 * _283.y)) + (_140 * _283.z)) + (_148 * _283.w), 0.0, 0.0);
        float _298 = _167.y;
        float _304 = 1.0 / max(fma(_298, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _313 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_298 - 0.5) <= 0.5) ? (((_304 > 0.0) && (_304 < _182)) ? _304 : 65504.0) : 65504.0) - _161);
        vec4 _320 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _145) * _313.yxxx) * _313.zzyy) * _313.wwwz;
        vec4 _324 = _320 * (1.0 / max(dot(_320, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _338 = vec4((((_126 * _324.x) + (_133 * _324.y)) + (_140 * _324.z)) + (_148 * _324.w), 0.0, 0.0);
        bvec2 _339 = greaterThanEqual(_77, vec2(0.0));
        bvec2 _340 = lessThan(_76, parameters.gOutputSize.xy);
        ivec2 _341 = ivec2(_77);
        if (all(_339) && all(_340))
        {
            imageStore(gOutUpsampled, _341, _215);
            imageStore(gOutUpsampled, _341 + ivec2(1, 0), _256);
            imageStore(gOutUpsampled, _341 + ivec2(0, 1), _297);
            imageStore(gOutUpsampled, _341 + ivec2(1), _338);
            break;
        }
        bool _354 = _339.x;
        bool _355 = _339.y;
        if (_354 && _355)
        {
            imageStore(gOutUpsampled, _341, _215);
        }
        bool _360 = _340.x;
        if (_360 && _355)
        {
            imageStore(gOutUpsampled, _341 + ivec2(1, 0), _256);
        }
        bool _366 = _340.y;
        if (_354 && _366)
        {
            imageStore(gOutUpsampled, _341 + ivec2(0, 1), _297);
        }
        if (_360 && _366)
        {
            imageStore(gOutUpsampled, _341 + ivec2(1), _338);
        }
        break;
    } while(false);
}

