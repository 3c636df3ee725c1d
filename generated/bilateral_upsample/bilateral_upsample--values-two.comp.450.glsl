#version 450
layout(local_size_x = 32, local_size_y = 8, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutUpsampled;
layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 1) uniform sampler2D gInFiltered;
layout(binding = 3) uniform sampler2D gInDepth;

void main()
{
    vec2 _73 = vec2(gl_GlobalInvocationID.xy) * 2.0;
    vec2 _82 = (floor(fma(_73 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _87 = textureGather(gInCoarseDepth, _82).wzxy;
    vec4 _90 = mix(vec4(65504.0), min(_87, vec4(65504.0)), greaterThan(_87, vec4(0.0)));
    vec4 _94 = textureGather(gInFiltered, _82);
    vec4 _96 = textureGather(gInFiltered, _82, 1);
    vec2 _100 = vec4(_94.w, _96.w, 0.0, 0.0).xy;
    vec2 _104 = vec4(_94.z, _96.z, 0.0, 0.0).xy;
    vec2 _108 = vec4(_94.x, _96.x, 0.0, 0.0).xy;
    vec2 _112 = vec4(_94.y, _96.y, 0.0, 0.0).xy;
    float _116 = float(all(lessThanEqual(abs(_100), vec2(65504.0))));
    vec2 _119 = mix(vec2(0.0), _100, bvec2(_116 > 0.5));
    float _123 = float(all(lessThanEqual(abs(_104), vec2(65504.0))));
    vec2 _126 = mix(vec2(0.0), _104, bvec2(_123 > 0.5));
    float _130 = float(all(lessThanEqual(abs(_108), vec2(65504.0))));
    vec2 _133 = mix(vec2(0.0), _108, bvec2(_130 > 0.5));
    float _137 = float(all(lessThanEqual(abs(_112), vec2(65504.0))));
    vec4 _138 = vec4(_116, _123, _130, _137);
    vec2 _141 = mix(vec2(0.0), _112, bvec2(_137 > 0.5));
    vec4 _149 = textureGather(gInDepth, _73 * parameters.gOutputSize.zw);
    float _150 = _149.w;
    float _160 = 1.0 / max(fma(_150, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _164 = min(parameters.gSkyDepth, 65504.0);
    vec4 _172 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_150 - 0.5) <= 0.5) ? (((_160 > 0.0) && (_160 < _164)) ? _160 : 65504.0) : 65504.0) - _90);
    vec4 _179 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _138) * _172.yxxx) * _172.zzyy) * _172.wwwz;
    vec4 _183 = _179 * (1.0 / max(dot(_179, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _198 = _149.z;
    float _204 = 1.0 / max(fma(_198, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _213 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_198 - 0.5) <= 0.5) ? (((_204 > 0.0) && (_204 < _164)) ? _204 : 65504.0) : 65504.0) - _90);
    vec4 _220 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _138) * _213.yxxx) * _213.zzyy) * _213.wwwz;
    vec4 _224 = _220 * (1.0 / max(dot(_220, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _239 = _149.x;
    float _245 = 1.0 / max(fma(_239, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _254 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_239 - 0.5) <= 0.5) ? (((_245 > 0.0) && (_245 < _164)) ? _245 : 65504.0) : 65504.0) - _90);
    vec4 _261 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _138) * _254.yxxx) * _254.zzyy) * _254.wwwz;
    vec4 _265 = _261 * (1.0 / max(dot(_261, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _280 = _149.y;
    float _286 = 1.0 / max(fma(_280, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _295 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_280 - 0.5) <= 0.5) ? (((_286 > 0.0) && (_286 < _164)) ? _286 : 65504.0) : 65504.0) - _90);
    vec4 _302 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _138) * _295.yxxx) * _295.zzyy) * _295.wwwz;
    vec4 _306 = _302 * (1.0 / max(dot(_302, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _321 = ivec2(_73 - vec2(1.0));
    imageStore(gOutUpsampled, _321, vec4((((_119 * _183.x) + (_126 * _183.y)) + (_133 * _183.z)) + (_141 * _183.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _321 + ivec2(1, 0), vec4((((_119 * _224.x) + (_126 * _224.y)) + (_133 * _224.z)) + (_141 * _224.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _321 + ivec2(0, 1), vec4((((_119 * _265.x) + (_126 * _265.y)) + (_133 * _265.z)) + (_141 * _265.w), 0.0, 0.0));
    imageStore(gOutUpsampled, _321 + ivec2(1), vec4((((_119 * _306.x) + (_126 * _306.y)) + (_133 * _306.z)) + (_141 * _306.w), 0.0, 0.0));
}

