#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform DepthDownsampleParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutCoarseDepth;
layout(binding = 1) uniform sampler2D gInDepth;

void main()
{
    vec4 _57 = textureLod(gInDepth, (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * parameters.gInputSize.zw, 0.0).xxxx;
    vec4 _61 = mix(vec4(1.0), _57, lessThanEqual(abs(_57 - vec4(0.5)), vec4(0.5)));
    vec4 _63 = min(_61, _61.zwxy);
    float _74 = 1.0 / max(fma(min(_63.xxxx, _63.yyyy).x, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_74 > 0.0) && (_74 < min(parameters.gSkyDepth, 65504.0))) ? _74 : 65504.0, 0.0, 0.0, 0.0));
}

