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
    vec2 _71 = vec2(gl_GlobalInvocationID.xy) * 2.0;
    vec2 _73 = fma(_71 + vec2(0.5), vec2(0.25), vec2(-0.5));
    vec2 _79 = (floor(_73) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _84 = textureGather(gInCoarseDepth, _79).wzxy;
    vec4 _87 = mix(vec4(65504.0), min(_84, vec4(65504.0)), greaterThan(_84, vec4(0.0)));
    vec4 _91 = textureGather(gInFiltered, _79);
    float _92 = _91.w;
    float _93 = _91.z;
    float _94 = _91.x;
    float _95 = _91.y;
    float _98 = float(abs(_92) <= 65504.0);
    float _100 = (_98 > 0.5) ? _92 : 0.0;
    float _103 = float(abs(_93) <= 65504.0);
    float _105 = (_103 > 0.5) ? _93 : 0.0;
    float _108 = float(abs(_94) <= 65504.0);
    float _110 = (_108 > 0.5) ? _94 : 0.0;
    float _113 = float(abs(_95) <= 65504.0);
    vec4 _114 = vec4(_98, _103, _108, _113);
    float _116 = (_113 > 0.5) ? _95 : 0.0;
    vec4 _125 = textureGather(gInDepth, (_71 + vec2(1.0)) * parameters.gOutputSize.zw);
    vec2 _126 = fract(_73);
    vec2 _127 = vec2(1.0) - _126;
    float _128 = _127.x;
    float _129 = _126.x;
    float _135 = _125.w;
    float _145 = 1.0 / max(fma(_135, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _149 = min(parameters.gSkyDepth, 65504.0);
    vec4 _157 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_135 - 0.5) <= 0.5) ? (((_145 > 0.0) && (_145 < _149)) ? _145 : 65504.0) : 65504.0) - _87);
    vec4 _164 = ((((vec4(_128, _129, _128, _129) * vec4(_127.yy, _126.yy)) * _114) * _157.yxxx) * _157.zzyy) * _157.wwwz;
    vec4 _168 = _164 * (1.0 / max(dot(_164, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _178 = _126 + vec2(0.25, 0.0);
    vec2 _179 = vec2(0.75, 1.0) - _126;
    float _180 = _179.x;
    float _181 = _178.x;
    float _187 = _125.z;
    float _193 = 1.0 / max(fma(_187, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _202 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_187 - 0.5) <= 0.5) ? (((_193 > 0.0) && (_193 < _149)) ? _193 : 65504.0) : 65504.0) - _87);
    vec4 _209 = ((((vec4(_180, _181, _180, _181) * vec4(_179.yy, _178.yy)) * _114) * _202.yxxx) * _202.zzyy) * _202.wwwz;
    vec4 _213 = _209 * (1.0 / max(dot(_209, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _223 = _126 + vec2(0.0, 0.25);
    vec2 _224 = vec2(1.0, 0.75) - _126;
    float _225 = _224.x;
    float _226 = _223.x;
    float _232 = _125.x;
    float _238 = 1.0 / max(fma(_232, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _247 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_232 - 0.5) <= 0.5) ? (((_238 > 0.0) && (_238 < _149)) ? _238 : 65504.0) : 65504.0) - _87);
    vec4 _254 = ((((vec4(_225, _226, _225, _226) * vec4(_224.yy, _223.yy)) * _114) * _247.yxxx) * _247.zzyy) * _247.wwwz;
    vec4 _258 = _254 * (1.0 / max(dot(_254, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    vec2 _268 = _126 + vec2(0.25);
    vec2 _269 = vec2(0.75) - _126;
    float _270 = _269.x;
    float _271 = _268.x;
    float _277 = _125.y;
    float _283 = 1.0 / max(fma(_277, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _292 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_277 - 0.5) <= 0.5) ? (((_283 > 0.0) && (_283 < _149)) ? _283 : 65504.0) : 65504.0) - _87);
    vec4 _299 = ((((vec4(_270, _271, _270, _271) * vec4(_269.yy, _268.yy)) * _114) * _292.yxxx) * _292.zzyy) * _292.wwwz;
    vec4 _303 = _299 * (1.0 / max(dot(_299, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _313 = ivec2(_71);
    imageStore(gOutUpsampled, _313, vec4(fma(_168.w, _116, fma(_168.z, _110, fma(_168.x, _100, _168.y * _105))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _313 + ivec2(1, 0), vec4(fma(_213.w, _116, fma(_213.z, _110, fma(_213.x, _100, _213.y * _105))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _313 + ivec2(0, 1), vec4(fma(_258.w, _116, fma(_258.z, _110, fma(_258.x, _100, _258.y * _105))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _313 + ivec2(1), vec4(fma(_303.w, _116, fma(_303.z, _110, fma(_303.x, _100, _303.y * _105))), 0.0, 0.0, 0.0));
}

