#version 310 es
layout(local_size_x = 32, local_size_y = 8, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutUpsampled;
layout(binding = 2) uniform highp sampler2D gInCoarseDepth;
layout(binding = 1) uniform highp sampler2D gInFiltered;
layout(binding = 3) uniform highp sampler2D gInDepth;

void main()
{
    vec2 _95 = vec2((gl_WorkGroupID.xy * uvec2(32u, 8u)) + uvec2((gl_LocalInvocationIndex & 15u) + ((gl_LocalInvocationIndex >> 1u) & 16u), ((gl_LocalInvocationIndex >> 4u) & 1u) + (2u * (gl_LocalInvocationIndex >> 6u)))) * 2.0;
    vec2 _101 = floor(_95 * vec2(0.5) + vec2(-0.5));
    vec2 _102 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _103 = _102 - vec2(1.0);
    vec2 _106 = (clamp(_101, vec2(0.0), _103) + vec2(0.5)) / _102;
    vec2 _110 = (clamp(_101 + vec2(1.0), vec2(0.0), _103) + vec2(0.5)) / _102;
    vec4 _127 = textureGather(gInCoarseDepth, (floor((_95 + vec2(-0.5)) * vec2(0.5) + vec2(-0.5)) + vec2(1.0)) * parameters.gCoarseSize.zw).wzxy;
    vec4 _130 = mix(vec4(65504.0), min(_127, vec4(65504.0)), greaterThan(_127, vec4(0.0)));
    vec4 _134 = textureLod(gInFiltered, _106, 0.0);
    vec4 _136 = textureLod(gInFiltered, vec2(_110.x, _106.y), 0.0);
    vec4 _138 = textureLod(gInFiltered, vec2(_106.x, _110.y), 0.0);
    vec4 _140 = textureLod(gInFiltered, _110, 0.0);
    float _144 = float(all(lessThanEqual(abs(_134), vec4(65504.0))));
    vec4 _147 = mix(vec4(0.0), _134, bvec4(_144 > 0.5));
    float _151 = float(all(lessThanEqual(abs(_136), vec4(65504.0))));
    vec4 _154 = mix(vec4(0.0), _136, bvec4(_151 > 0.5));
    float _158 = float(all(lessThanEqual(abs(_138), vec4(65504.0))));
    vec4 _161 = mix(vec4(0.0), _138, bvec4(_158 > 0.5));
    float _165 = float(all(lessThanEqual(abs(_140), vec4(65504.0))));
    vec4 _166 = vec4(_144, _151, _158, _165);
    vec4 _169 = mix(vec4(0.0), _140, bvec4(_165 > 0.5));
    vec4 _177 = textureGather(gInDepth, _95 * parameters.gOutputSize.zw);
    float _178 = _177.w;
    float _188 = 1.0 / max(_178 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    float _192 = min(parameters.gSkyDepth, 65504.0);
    vec4 _200 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_178 - 0.5) <= 0.5) ? (((_188 > 0.0) && (_188 < _192)) ? _188 : 65504.0) : 65504.0) - _130);
    vec4 _207 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _166) * _200.yxxx) * _200.zzyy) * _200.wwwz;
    vec4 _211 = _207 * (1.0 / max(dot(_207, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _223 = _177.z;
    float _229 = 1.0 / max(_223 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _238 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_223 - 0.5) <= 0.5) ? (((_229 > 0.0) && (_229 < _192)) ? _229 : 65504.0) : 65504.0) - _130);
    vec4 _245 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _166) * _238.yxxx) * _238.zzyy) * _238.wwwz;
    vec4 _249 = _245 * (1.0 / max(dot(_245, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _261 = _177.x;
    float _267 = 1.0 / max(_261 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _276 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_261 - 0.5) <= 0.5) ? (((_267 > 0.0) && (_267 < _192)) ? _267 : 65504.0) : 65504.0) - _130);
    vec4 _283 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _166) * _276.yxxx) * _276.zzyy) * _276.wwwz;
    vec4 _287 = _283 * (1.0 / max(dot(_283, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _299 = _177.y;
    float _305 = 1.0 / max(_299 * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    vec4 _314 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_299 - 0.5) <= 0.5) ? (((_305 > 0.0) && (_305 < _192)) ? _305 : 65504.0) : 65504.0) - _130);
    vec4 _321 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _166) * _314.yxxx) * _314.zzyy) * _314.wwwz;
    vec4 _325 = _321 * (1.0 / max(dot(_321, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _337 = ivec2(_95 - vec2(1.0));
    imageStore(gOutUpsampled, _337, (((_147 * _211.x) + (_154 * _211.y)) + (_161 * _211.z)) + (_169 * _211.w));
    imageStore(gOutUpsampled, _337 + ivec2(1, 0), (((_147 * _249.x) + (_154 * _249.y)) + (_161 * _249.z)) + (_169 * _249.w));
    imageStore(gOutUpsampled, _337 + ivec2(0, 1), (((_147 * _287.x) + (_154 * _287.y)) + (_161 * _287.z)) + (_169 * _287.w));
    imageStore(gOutUpsampled, _337 + ivec2(1), (((_147 * _325.x) + (_154 * _325.y)) + (_161 * _325.z)) + (_169 * _325.w));
}

