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
    vec2 _92 = vec2((gl_WorkGroupID.xy * uvec2(32u, 8u)) + uvec2((gl_LocalInvocationIndex & 15u) + ((gl_LocalInvocationIndex >> 1u) & 16u), ((gl_LocalInvocationIndex >> 4u) & 1u) + (2u * (gl_LocalInvocationIndex >> 6u)))) * 2.0;
    vec2 _101 = (floor(fma(_92 + vec2(-0.5), vec2(0.5), vec2(-0.5))) + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _106 = textureGather(gInCoarseDepth, _101).wzxy;
    vec4 _109 = mix(vec4(65504.0), min(_106, vec4(65504.0)), greaterThan(_106, vec4(0.0)));
    vec4 _113 = textureGather(gInFiltered, _101);
    float _114 = _113.w;
    float _115 = _113.z;
    float _116 = _113.x;
    float _117 = _113.y;
    float _120 = float(abs(_114) <= 65504.0);
    float _122 = (_120 > 0.5) ? _114 : 0.0;
    float _125 = float(abs(_115) <= 65504.0);
    float _127 = (_125 > 0.5) ? _115 : 0.0;
    float _130 = float(abs(_116) <= 65504.0);
    float _132 = (_130 > 0.5) ? _116 : 0.0;
    float _135 = float(abs(_117) <= 65504.0);
    vec4 _136 = vec4(_120, _125, _130, _135);
    float _138 = (_135 > 0.5) ? _117 : 0.0;
    vec4 _146 = textureGather(gInDepth, _92 * parameters.gOutputSize.zw);
    float _147 = _146.w;
    float _151 = min(parameters.gSkyDepth, 65504.0);
    vec4 _158 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_147 > 0.0) && (_147 < _151)) ? _147 : 65504.0) - _109);
    vec4 _165 = (((vec4(0.5625, 0.1875, 0.1875, 0.0625) * _136) * _158.yxxx) * _158.zzyy) * _158.wwwz;
    vec4 _169 = _165 * (1.0 / max(dot(_165, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _179 = _146.z;
    vec4 _187 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_179 > 0.0) && (_179 < _151)) ? _179 : 65504.0) - _109);
    vec4 _194 = (((vec4(0.1875, 0.5625, 0.0625, 0.1875) * _136) * _187.yxxx) * _187.zzyy) * _187.wwwz;
    vec4 _198 = _194 * (1.0 / max(dot(_194, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _208 = _146.x;
    vec4 _216 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_208 > 0.0) && (_208 < _151)) ? _208 : 65504.0) - _109);
    vec4 _223 = (((vec4(0.1875, 0.0625, 0.5625, 0.1875) * _136) * _216.yxxx) * _216.zzyy) * _216.wwwz;
    vec4 _227 = _223 * (1.0 / max(dot(_223, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    float _237 = _146.y;
    vec4 _245 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4(((_237 > 0.0) && (_237 < _151)) ? _237 : 65504.0) - _109);
    vec4 _252 = (((vec4(0.0625, 0.1875, 0.1875, 0.5625) * _136) * _245.yxxx) * _245.zzyy) * _245.wwwz;
    vec4 _256 = _252 * (1.0 / max(dot(_252, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    ivec2 _266 = ivec2(_92 - vec2(1.0));
    imageStore(gOutUpsampled, _266, vec4(fma(_169.w, _138, fma(_169.z, _132, fma(_169.x, _122, _169.y * _127))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _266 + ivec2(1, 0), vec4(fma(_198.w, _138, fma(_198.z, _132, fma(_198.x, _122, _198.y * _127))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _266 + ivec2(0, 1), vec4(fma(_227.w, _138, fma(_227.z, _132, fma(_227.x, _122, _227.y * _127))), 0.0, 0.0, 0.0));
    imageStore(gOutUpsampled, _266 + ivec2(1), vec4(fma(_256.w, _138, fma(_256.z, _132, fma(_256.x, _122, _256.y * _127))), 0.0, 0.0, 0.0));
}

