#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform DepthDownsampleParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

layout(binding = 16, r32f) uniform writeonly highp image2D gOutCoarseDepth;
layout(binding = 1) uniform highp sampler2D gInDepth;

void main()
{
    vec2 _54 = (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * 4.0;
    vec4 _63 = textureGather(gInDepth, (_54 - vec2(1.0)) * parameters.gInputSize.zw);
    vec4 _71 = textureGather(gInDepth, (_54 + vec2(1.0, -1.0)) * parameters.gInputSize.zw);
    vec4 _79 = textureGather(gInDepth, (_54 + vec2(-1.0, 1.0)) * parameters.gInputSize.zw);
    vec4 _87 = textureGather(gInDepth, (_54 + vec2(1.0)) * parameters.gInputSize.zw);
    vec4 _94 = min(min(mix(vec4(1.0), _63, lessThanEqual(abs(_63 - vec4(0.5)), vec4(0.5))), mix(vec4(1.0), _71, lessThanEqual(abs(_71 - vec4(0.5)), vec4(0.5)))), min(mix(vec4(1.0), _79, lessThanEqual(abs(_79 - vec4(0.5)), vec4(0.5))), mix(vec4(1.0), _87, lessThanEqual(abs(_87 - vec4(0.5)), vec4(0.5)))));
    vec4 _96 = min(_94, _94.zwxy);
    float _107 = 1.0 / max(min(_96.xxxx, _96.yyyy).x * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_107 > 0.0) && (_107 < min(parameters.gSkyDepth, 65504.0))) ? _107 : 65504.0, 0.0, 0.0, 0.0));
}

