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
    vec2 _68 = vec2(gl_GlobalInvocationID.xy) * 2.0;
    vec2 _77 = (floor(fma(_68 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _82 = textureGather(gInCoarseDepth, _77).wzxy;
    vec4 _85 = mix(vec4(65504.0), min(_82, vec4(65504.0)), greaterThan(_82, vec4(0.0)));
    vec4 _89 = textureGather(gInFiltered, _77);
    float _90 = _89.w;
    float _91 = _89.z;
    float _92 = _89.x;
    float _93 = _89.y;
    float _96 = float(abs(_90) <= 65504.0);
    float _98 = (_96 > 0.5) ? _90 : 0.0;
    float _101 = float(abs(_91) <= 65504.0);
    float _103 = (_101 > 0.5) ? _91 : 0.0;
    float _106 = float(abs(_92) <= 65504.0);
    float _108 = (_106 > 0.5) ? _92 : 0.0;
    float _111 = float(abs(_93) <= 65504.0);
    vec4 _112 = vec4(_96, _101, _106, _111);
    float _114 = (_111 > 0.5) ? _93 : 0.0;
    vec4 _122 = textureGather(gInDepth, _68 * parameters.gOutputSize.zw);
    float _123 = _122.w;
    float _127 = min(parameters.gSkyDepth, 65504.0);
    vec4 _134 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_123 > 0.0) && (_123 < _127)) ? _123 : 65504.0) - _85);
    vec4 _141 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _112) * _134.yxxx) * _134.zzyy) * _134.wwwz;
    vec4 _145 = _141 * (1.0 / max(dot(_141, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _155 = _122.z;
    vec4 _163 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_155 > 0.0) && (_155 < _127)) ? _155 : 65504.0) - _85);
    vec4 _170 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _112) * _163.yxxx) * _163.zzyy) * _163.wwwz;
    vec4 _174 = _170 * (1.0 / max(dot(_170, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _184 = _122.x;
    vec4 _192 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_184 > 0.0) && (_184 < _127)) ? _184 : 65504.0) - _85);
    vec4 _199 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _112) * _192.yxxx) * _192.zzyy) * _192.wwwz;
    vec4 _203 = _199 * (1.0 / max(dot(_199, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _213 = _122.y;
    vec4 _221 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_213 > 0.0) && (_213 < _127)) ? _213 : 65504.0) - _85);
    vec4 _228 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _112) * _221.yxxx) * _221.zzyy) * _221.wwwz;
    vec4 _232 = _228 * (1.0 / max(dot(_228, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _242 = ivec2(_68 - vec2(1.0));
    imageStore(gOutUpsampled, _242, vec4(fma(_145.w, _114, fma(_145.z, _108, fma(_145.x, _98, _145.y * _103))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _242 + ivec2(1, 0), vec4(fma(_174.w, _114, fma(_174.z, _108, fma(_174.x, _98, _174.y * _103))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _242 + ivec2(0, 1), vec4(fma(_203.w, _114, fma(_203.z, _108, fma(_203.x, _98, _203.y * _103))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _242 + ivec2(1), vec4(fma(_232.w, _114, fma(_232.z, _108, fma(_232.x, _98, _232.y * _103))), 0.0, 0.0, 0.0));
}

