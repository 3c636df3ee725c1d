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
        if (any(greaterThanEqual(_76, parameters.gOutputSize.xy)))
        {
            break;
        }
        vec2 _85 = fma(_76 + vec2(0.5), vec2(0.25), vec2(-0.5));
        vec2 _91 = (floor(_85) + vec2(1.0)) * parameters.gCoarseSize.zw;
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
        vec2 _131 = _76 + vec2(1.0);
        vec4 _135 = textureGather(gInDepth, _131 * parameters.gOutputSize.zw);
        vec2 _136 = fract(_85);
        vec2 _137 = vec2(1.0) - _136;
        float _138 = _137.x;
        float _139 = _136.x;
        float _145 = _135.w;
        float _155 = 1.0 / max(fma(_145, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        float _159 = min(parameters.gSkyDepth, 65504.0);
        vec4 _167 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_145 - 0.5) <= 0.5) ? (((_155 > 0.0) && (_155 < _159)) ? _155 : 65504.0) : 65504.0) - _128);
        vec4 _174 = ((((vec4(_138, _139, _138, _139) * vec4(_137.yy, _136.yy)) * _118) * _167.yxxx) * _167.zzyy) * _167.wwwz;
        vec4 _178 = _174 * (1.0 / max(dot(_174, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _187 = vec4(fma(_178.w, _120, fma(_178.z, _114, fma(_178.x, _104, _178.y * _109))), 0.0, 0.0, 0.0);
        vec2 _188 = _136 + vec2(0.25, 0.0);
        vec2 _189 = vec2(0.75, 1.0) - _136;
        float _190 = _189.x;
        float _191 = _188.x;
        float _197 = _135.z;
        float _203 = 1.0 / max(fma(_197, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _212 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_197 - 0.5) <= 0.5) ? (((_203 > 0.0) && (_203 < _159)) ? _203 : 65504.0) : 65504.0) - _128);
        vec4 _219 = ((((vec4(_190, _191, _190, _191) * vec4(_189.yy, _188.yy)) * _118) * _212.yxxx) * _212.zzyy) * _212.wwwz;
        vec4 _223 = _219 * (1.0 / max(dot(_219, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _232 = vec4(fma(_223.w, _120, fma(_223.z, _114, fma(_223.x, _104, _223.y * _109))), 0.0, 0.0, 0.0);
        vec2 _233 = _136 + vec2(0.0, 0.25);
        vec2 _234 = vec2(1.0, 0.75) - _136;
        float _235 = _234.x;
        float _236 = _233.x;
        float _242 = _135.x;
        float _248 = 1.0 / max(fma(_242, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _257 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_242 - 0.5) <= 0.5) ? (((_248 > 0.0) && (_248 < _159)) ? _248 : 65504.0) : 65504.0) - _128);
        vec4 _264 = ((((vec4(_235, _236, _235, _236) * vec4(_234.yy, _233.yy)) * _118) * _257.yxxx) * _257.zzyy) * _257.wwwz;
        vec4 _268 = _264 * (1.0 / max(dot(_264, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _277 = vec4(fma(_268.w, _120, fma(_268.z, _114, fma(_268.x, _104, _268.y * _109))), 0.0, 0.0, 0.0);
        vec2 _278 = _136 + vec2(0.25);
        vec2 _279 = vec2(0.75) - _136;
        float _280 = _279.x;
        float _281 = _278.x;
        float _287 = _135.y;
        float _293 = 1.0 / max(fma(_287, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _302 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_287 - 0.5) <= 0.5) ? (((_293 > 0.0) && (_293 < _159)) ? _293 : 65504.0) : 65504.0) - _128);
        vec4 _309 = ((((vec4(_280, _281, _280, _281) * vec4(_279.yy, _278.yy)) * _118) * _302.yxxx) * _302.zzyy) * _302.wwwz;
        vec4 _313 = _309 * (1.0 / max(dot(_309, vec4(1.0)), 1.0000000031710768509710513471353e-30));
        vec4 _322 = vec4(fma(_313.w, _120, fma(_313.z, _114, fma(_313.x, _104, _313.y * _109))), 0.0, 0.0, 0.0);
        bvec2 _323 = greaterThanEqual(_76, vec2(0.0));
        bvec2 _324 = lessThan(_131, parameters.gOutputSize.xy);
        ivec2 _325 = ivec2(_76);
        if (all(_323) && all(_324))
        {
            imageStore(gOutUpsampled, _325, _187);
            imageStore(gOutUpsampled, _325 + ivec2(1, 0), _232);
            imageStore(gOutUpsampled, _325 + ivec2(0, 1), _277);
            imageStore(gOutUpsampled, _325 + ivec2(1), _322);
            break;
        }
        bool _338 = _323.x;
        bool _339 = _323.y;
        if (_338 && _339)
        {
            imageStore(gOutUpsampled, _325, _187);
        }
        bool _344 = _324.x;
        if (_344 && _339)
        {
            imageStore(gOutUpsampled, _325 + ivec2(1, 0), _232);
        }
        bool _350 = _324.y;
        if (_338 && _350)
        {
            imageStore(gOutUpsampled, _325 + ivec2(0, 1), _277);
        }
        if (_344 && _350)
        {
            imageStore(gOutUpsampled, _325 + ivec2(1), _322);
        }
        break;
    } while(false);
}

