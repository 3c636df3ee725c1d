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
layout(binding = 5) uniform sampler2D gInCoarseNormal;
layout(binding = 4) uniform sampler2D gInNormal;
layout(binding = 3) uniform sampler2D gInDepth;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _83 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _85 = _83 * parameters.gOutputSize.zw;
        vec2 _89 = fma(_83, vec2(0.5), vec2(-0.5));
        vec2 _90 = floor(_89);
        vec2 _91 = _89 - _90;
        vec2 _92 = vec2(1.0) - _91;
        vec2 _93 = max(parameters.gCoarseSize.xy, vec2(1.0));
        vec2 _94 = _93 - vec2(1.0);
        vec2 _97 = (clamp(_90, vec2(0.0), _94) + vec2(0.5)) / _93;
        vec2 _98 = _90 + vec2(1.0);
        vec2 _101 = (clamp(_98, vec2(0.0), _94) + vec2(0.5)) / _93;
        float _108 = _92.x;
        float _109 = _91.x;
        vec2 _118 = _98 * parameters.gCoarseSize.zw;
        vec4 _121 = textureGather(gInFiltered, _118).wzxy;
        vec4 _124 = mix(vec4(1.9999999360571384930131252153835e+38), _121, lessThanEqual(abs(_121), vec4(65504.0)));
        vec3 _148 = textureLod(gInNormal, _85, 0.0).xyz;
        float _152 = min(dot(textureLod(gInCoarseNormal, _97, 0.0).xyz, _148), 1.0);
        float _155 = min(parameters.gContrast, 256.0);
        bool _158 = parameters.gContrast > 0.0;
        float _161 = min(dot(textureLod(gInCoarseNormal, vec2(_101.x, _97.y), 0.0).xyz, _148), 1.0);
        float _168 = min(dot(textureLod(gInCoarseNormal, vec2(_97.x, _101.y), 0.0).xyz, _148), 1.0);
        float _175 = min(dot(textureLod(gInCoarseNormal, _101, 0.0).xyz, _148), 1.0);
        vec4 _185 = textureLod(gInDepth, _85, 0.0);
        float _186 = _185.x;
        float _196 = 1.0 / max(fma(_186, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _207 = vec4(lessThanEqual(abs(_124), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _210 = abs(vec4((abs(_186 - 0.5) <= 0.5) ? (((_196 > 0.0) && (_196 < min(parameters.gSkyDepth, 65504.0))) ? _196 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _118).wzxy);
        bvec4 _218 = greaterThan(_207 * vec4(lessThanEqual(abs(_210), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _219 = mix(vec4(0.0), ((vec4(_108, _109, _108, _109) * vec4(_92.yy, _91.yy)) * vec4(_158 ? ((_152 > 0.0) ? pow(abs(_152), _155) : 0.0) : 1.0, _158 ? ((_161 > 0.0) ? pow(abs(_161), _155) : 0.0) : 1.0, _158 ? ((_168 > 0.0) ? pow(abs(_168), _155) : 0.0) : 1.0, _158 ? ((_175 > 0.0) ? pow(abs(_175), _155) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _210), _218);
        vec4 _221 = mix(vec4(0.0), _219, greaterThan(_219, vec4(0.0)));
        float _222 = dot(_221, vec4(1.0));
        vec4 _223 = mix(vec4(1.9999999360571384930131252153835e+38), _210, _218);
        vec4 _233 = mix(vec4(0.0), _207, lessThanEqual(_223, vec4(min(min(_223.x, _223.y), min(_223.z, _223.w)))));
        imageStore(gOutUpsampled, ivec2(gl_GlobalInvocationID.xy), vec4(dot(mix(vec4(0.0), _124, greaterThan(_207, vec4(0.5))), mix(_233 / vec4(max(dot(_233, vec4(1.0)), 1.0)), _221 / vec4(_222), bvec4((_222 >= 1.0000000031710768509710513471353e-30) && (_222 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

