#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralFilterParameters
{
    vec4 gOutputSize;
    vec2 gDirection;
    vec2 gDepthAmplitude;
    float gConverged;
    float gMaxSmoothing;
    float gMinSmoothing;
} parameters;

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutFiltered;
layout(binding = 1) uniform highp sampler2D gInCache;
layout(binding = 2) uniform highp sampler2D gInCacheFiltered;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _75 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _80 = parameters.gDirection * parameters.gOutputSize.zw;
        vec4 _84 = textureLod(gInCache, _75 * parameters.gOutputSize.zw, 0.0);
        vec2 _88 = _80 * 3.5;
        vec4 _91 = textureLod(gInCacheFiltered, _75 * parameters.gOutputSize.zw + (-_88), 0.0);
        float _92 = _91.x;
        vec2 _97 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_92, 0.0), bvec2(abs(_92) <= 65504.0));
        float _98 = _91.w;
        float _99 = _97.x;
        vec2 _103 = _80 * 1.5;
        vec4 _106 = textureLod(gInCacheFiltered, _75 * parameters.gOutputSize.zw + (-_103), 0.0);
        float _107 = _106.x;
        vec2 _112 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_107, 0.0), bvec2(abs(_107) <= 65504.0));
        float _113 = _106.w;
        float _114 = _112.x;
        float _117 = _84.x;
        vec2 _122 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_117, 0.0), bvec2(abs(_117) <= 65504.0));
        float _123 = _84.w;
        float _124 = _122.x;
        vec4 _129 = textureLod(gInCacheFiltered, _75 * parameters.gOutputSize.zw + _103, 0.0);
        float _130 = _129.x;
        vec2 _135 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_130, 0.0), bvec2(abs(_130) <= 65504.0));
        float _136 = _129.w;
        float _137 = _135.x;
        vec4 _142 = textureLod(gInCacheFiltered, _75 * parameters.gOutputSize.zw + _88, 0.0);
        float _143 = _142.x;
        vec2 _148 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_143, 0.0), bvec2(abs(_143) <= 65504.0));
        float _149 = _142.w;
        float _150 = _148.x;
        float _161 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_123 > 0.001000000047497451305389404296875) ? min(_123, 65504.0) : 0.001000000047497451305389404296875));
        float _162 = _84.z;
        float _168 = _162 / max(parameters.gConverged, 1.0);
        float _181 = (((((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0) * (1.0 - ((_168 > 0.0) ? min(_168, 1.0) : 0.0)) + 1.0) - 1.0) + parameters.gMinSmoothing;
        float _184 = (_181 > 0.0) ? min(_181, 16.0) : 0.0;
        bool _189 = (abs(_124) <= 9.9999996169031624536541560020822e+35) && (abs(_122.y) <= 9.9999996169031624536541560020822e+35);
        float _196 = abs(_98 - _123);
        float _200 = (_161 > 0.0) ? min(_161, 9.9999996169031624536541560020822e+35) : 0.0;
        float _205 = _184 * (((_196 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_200 * _196 + 1.0)) : 0.0) * 0.0544886849820613861083984375);
        bool _210 = (abs(_99) <= 9.9999996169031624536541560020822e+35) && (abs(_97.y) <= 9.9999996169031624536541560020822e+35);
        float _219 = abs(_149 - _123);
        float _225 = _184 * (((_219 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_200 * _219 + 1.0)) : 0.0) * 0.0544886849820613861083984375);
        bool _230 = (abs(_150) <= 9.9999996169031624536541560020822e+35) && (abs(_148.y) <= 9.9999996169031624536541560020822e+35);
        float _239 = abs(_113 - _123);
        float _245 = _184 * (((_239 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_200 * _239 + 1.0)) : 0.0) * 0.24420134723186492919921875);
        bool _250 = (abs(_114) <= 9.9999996169031624536541560020822e+35) && (abs(_112.y) <= 9.9999996169031624536541560020822e+35);
        float _259 = abs(_136 - _123);
        float _265 = _184 * (((_259 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_200 * _259 + 1.0)) : 0.0) * 0.24420134723186492919921875);
        bool _270 = (abs(_137) <= 9.9999996169031624536541560020822e+35) && (abs(_135.y) <= 9.9999996169031624536541560020822e+35);
        float _277 = ((((_189 ? 0.40261995792388916015625 : 0.0) + (_210 ? _205 : 0.0)) + (_230 ? _225 : 0.0)) + (_250 ? _245 : 0.0)) + (_270 ? _265 : 0.0);
        vec4 _291 = vec4(mix(vec2(0.0), ((((mix(vec2(0.0), vec3(_124, _122.y, _123).xy * 0.40261995792388916015625, bvec2(_189)) + mix(vec2(0.0), vec3(_99, _97.y, _98).xy * _205, bvec2(_210))) + mix(vec2(0.0), vec3(_150, _148.y, _149).xy * _225, bvec2(_230))) + mix(vec2(0.0), vec3(_114, _112.y, _113).xy * _245, bvec2(_250))) + mix(vec2(0.0), vec3(_137, _135.y, _136).xy * _265, bvec2(_270))) / vec2(_277), bvec2(_277 > 1.0000000031710768509710513471353e-30)).x, 0.0, (_162 > 0.0) ? min(_162, 255.0) : 0.0, min((_123 > 0.0) ? min(_123, 9.9999996169031624536541560020822e+35) : 0.0, 65504.0));
        imageStore(gOutFiltered, ivec2(gl_GlobalInvocationID.xy), _291);
        break;
    } while(false);
}

