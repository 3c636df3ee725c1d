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
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _63 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec4 _72 = textureGather(gInDepth, (_63 * 2.0) * parameters.gInputSize.zw);
        vec4 _76 = mix(vec4(1.0), _72, lessThanEqual(abs(_72 - vec4(0.5)), vec4(0.5)));
        vec2 _77 = floor(_63);
        vec4 _84 = _76.zwxy;
        vec4 _85 = max(_76, _84);
        vec4 _90 = min(_76, _84);
        float _102 = 1.0 / max(((fract(0.5 * (_77.x + _77.y)) > 0.25) ? max(_85.xxxx, _85.yyyy).x : min(_90.xxxx, _90.yyyy).x) * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
        imageStore(gOutCoarseDepth, ivec2(gl_GlobalInvocationID.xy), vec4(((_102 > 0.0) && (_102 < min(parameters.gSkyDepth, 65504.0))) ? _102 : 65504.0, 0.0, 0.0, 0.0));
        break;
    } while(false);
}

