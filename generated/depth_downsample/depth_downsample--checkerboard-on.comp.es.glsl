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
    vec2 _50 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec4 _59 = textureGather(gInDepth, (_50 * 2.0) * parameters.gInputSize.zw);
    vec4 _63 = mix(vec4(1.0), _59, lessThanEqual(abs(_59 - vec4(0.5)), vec4(0.5)));
    vec2 _64 = floor(_50);
    vec4 _71 = _63.zwxy;
    vec4 _72 = max(_63, _71);
    vec4 _77 = min(_63, _71);
    float _89 = 1.0 / max(((fract(0.5 * (_64.x + _64.y)) > 0.25) ? max(_72.xxxx, _72.yyyy).x : min(_77.xxxx, _77.yyyy).x) * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_89 > 0.0) && (_89 < min(parameters.gSkyDepth, 65504.0))) ? _89 : 65504.0, 0.0, 0.0, 0.0));
}

