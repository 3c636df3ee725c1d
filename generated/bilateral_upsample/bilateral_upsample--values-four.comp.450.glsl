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
        vec2 _88 = floor(fma(_75, vec2(0.5), vec2(-0.5)));
        vec2 _89 = max(parameters.gCoarseSize.xy, vec2(1.0));
        vec2 _90 = _89 - vec2(1.0);
        vec2 _93 = (clamp(_88, vec2(0.0), _90) + vec2(0.5)) / _89;
        vec2 _97 = (clamp(_88 + vec2(1.0), vec2(0.0), _90) + vec2(0.5)) / _89;
        vec4 _113 = textureLod(gInFiltered, _93, 0.0);
        vec4 _115 = textureLod(gInFiltered, vec2(_97.x, _93.y), 0.0);
        vec4 _117 = textureLod(gInFiltered, vec2(_93.x, _97.y), 0.0);
        vec4 _119 = textureLod(gInFiltered, _97, 0.0);
        float _123 = float(all(lessThanEqual(abs(_113), vec4(65504.0))));
        vec4 _126 = mix(vec4(0.0), _113, bvec4(_123 > 0.5));
        float _130 = float(all(lessThanEqual(abs(_115), vec4(65504.0))));
        vec4 _133 = mix(vec4(0.0), _115, bvec4(_130 > 0.5));
        float _137 = float(all(lessThanEqual(abs(_117), vec4(65504.0))));
        vec4 _140 = mix(vec4(0.0), _117, bvec4(_137 > 0.5));
        float _144 = float(all(lessThanEqual(abs(_119), vec4(65504.0))));
        vec4 _145 = vec4(_123, _130, _137, _144);
        vec4 _148 = mix(vec4(0.0), _119, bvec4(_144 > 0.5));
        vec4 _153 = textureGather(gInCoarseDepth, (floor(fma(_75 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw).wzxy;
        vec4 _156 = mix(vec4(65504.0), min(_153, vec4(65504.0)), greaterThan(_153, vec4(0.0)));
        vec4 _162 = textureGather(gInDepth, _75 * parameters.gOutputSize.zw);
        float _163 = _162.w;
        float _173 = 1.0 / max(fma(_163, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _177 = min(parameters.gSkyDepth, 65504.0);
        vec4 _185 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_163 - 0.5) <= 0.5) ? (((_173 > 0.0) && (_173 < _177)) ? _173 : 65504.0) : 65504.0) - _156);
        vec4 _192 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _145) * _185.yxxx) * _185.zzyy) * _185.wwwz;
        vec4 _196 = _192 * (1.0 / max(dot(_192, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _207 = (((_126 * _196.x) + (_133 * _196.y)) + (_140 * _196.z)) + (_148 * _196.w);
        float _208 = _162.z;
        float _214 = 1.0 / max(fma(_208, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _223 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_208 - 0.5) <= 0.5) ? (((_214 > 0.0) && (_214 < _177)) ? _214 : 65504.0) : 65504.0) - _156);
        vec4 _230 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _145) * _223.yxxx) * _223.zzyy) * _223.wwwz;
        vec4 _234 = _230 * (1.0 / max(dot(_230, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _245 = (((_126 * _234.x) + (_133 * _234.y)) + (_140 * _234.z)) + (_148 * _234.w);
        float _246 = _162.x;
        float _252 = 1.0 / max(fma(_246, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _261 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_246 - 0.5) <= 0.5) ? (((_252 > 0.0) && (_252 < _177)) ? _252 : 65504.0) : 65504.0) - _156);
        vec4 _268 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _145) * _261.yxxx) * _261.zzyy) * _261.wwwz;
        vec4 _272 = _268 * (1.0 / max(dot(_268, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _283 = (((_126 * _272.x) + (_133 * _272.y)) + (_140 * _272.z)) + (_148 * _272.w);
        float _284 = _162.y;
        float _290 = 1.0 / max(fma(_284, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _299 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_284 - 0.5) <= 0.5) ? (((_290 > 0.0) && (_290 < _177)) ? _290 : 65504.0) : 65504.0) - _156);
        vec4 _306 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _145) * _299.yxxx) * _299.zzyy) * _299.wwwz;
        vec4 _310 = _306 * (1.0 / max(dot(_306, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _321 = (((_126 * _310.x) + (_133 * _310.y)) + (_140 * _310.z)) + (_148 * _310.w);
        bvec2 _322 = greaterThanEqual(_76, vec2(0.0));
        bvec2 _323 = lessThan(_75, parameters.gOutputSize.xy);
        ivec2 _324 = ivec2(_76);
        if (all(_322) && all(_323))
        {
            imageStore(gOutUpsampled, _324, _207);
            imageStore(gOutUpsampled, _324 + ivec2(1, 0), _245);
            imageStore(gOutUpsampled, _324 + ivec2(0, 1), _283);
            imageStore(gOutUpsampled, _324 + ivec2(1), _321);
            break;
        }
        bool _337 = _322.x;
        bool _338 = _322.y;
        if (_337 && _338)
        {
            imageStore(gOutUpsampled, _324, _207);
        }
        bool _343 = _323.x;
        if (_343 && _338)
        {
            imageStore(gOutUpsampled, _324 + ivec2(1, 0), _245);
        }
        bool _349 = _323.y;
        if (_337 && _349)
        {
            imageStore(gOutUpsampled, _324 + ivec2(0, 1), _283);
        }
        if (_343 && _349)
        {
            imageStore(gOutUpsampled, _324 + ivec2(1), _321);
        }
        break;
    } while(false);
}

