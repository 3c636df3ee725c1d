#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralFilterParameters
{
    vec4 gOutputSize;
    vec2 gDirection;
    vec2 gDepthAmplitude;
    float gConverged;
    float gMaxSmoothing;
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
        vec2 _74 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _79 = parameters.gDirection * parameters.gOutputSize.zw;
        vec4 _83 = textureLod(gInCache, _74 * parameters.gOutputSize.zw, 0.0);
        vec2 _87 = _79 * 3.5;
        vec4 _90 = textureLod(gInCacheFiltered, _74 * parameters.gOutputSize.zw + (-_87), 0.0);
        float _91 = _90.x;
        vec2 _96 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_91, 0.0), bvec2(abs(_91) <= 65504.0));
        float _97 = _90.w;
        float _98 = _96.x;
        vec2 _102 = _79 * 1.5;
        vec4 _105 = textureLod(gInCacheFiltered, _74 * parameters.gOutputSize.zw + (-_102), 0.0);
        float _106 = _105.x;
        vec2 _111 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_106, 0.0), bvec2(abs(_106) <= 65504.0));
        float _112 = _105.w;
        float _113 = _111.x;
        float _116 = _83.x;
        vec2 _121 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_116, 0.0), bvec2(abs(_116) <= 65504.0));
        float _122 = _83.w;
        float _123 = _121.x;
        vec4 _128 = textureLod(gInCacheFiltered, _74 * parameters.gOutputSize.zw + _102, 0.0);
        float _129 = _128.x;
        vec2 _134 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_129, 0.0), bvec2(abs(_129) <= 65504.0));
        float _135 = _128.w;
        float _136 = _134.x;
        vec4 _141 = textureLod(gInCacheFiltered, _74 * parameters.gOutputSize.zw + _87, 0.0);
        float _142 = _141.x;
        vec2 _147 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_142, 0.0), bvec2(abs(_142) <= 65504.0));
        float _148 = _141.w;
        float _149 = _147.x;
        float _160 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_122 > 0.001000000047497451305389404296875) ? min(_122, 65504.0) : 0.001000000047497451305389404296875));
        float _161 = _83.z;
        float _167 = _161 / max(parameters.gConverged, 1.0);
        float _176 = (((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0) * (1.0 - ((_167 > 0.0) ? min(_167, 1.0) : 0.0)) + 1.0;
        float _179 = (_176 > 0.0) ? min(_176, 16.0) : 0.0;
        bool _184 = (abs(_123) <= 9.9999996169031624536541560020822e+35) && (abs(_121.y) <= 9.9999996169031624536541560020822e+35);
        float _191 = abs(_97 - _122);
        float _195 = (_160 > 0.0) ? min(_160, 9.9999996169031624536541560020822e+35) : 0.0;
        float _200 = _179 * (((_191 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_195 * _191 + 1.0)) : 0.0) * 0.0544886849820613861083984375);
        bool _205 = (abs(_98) <= 9.9999996169031624536541560020822e+35) && (abs(_96.y) <= 9.9999996169031624536541560020822e+35);
        float _214 = abs(_148 - _122);
        float _220 = _179 * (((_214 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_195 * _214 + 1.0)) : 0.0) * 0.0544886849820613861083984375);
        bool _225 = (abs(_149) <= 9.9999996169031624536541560020822e+35) && (abs(_147.y) <= 9.9999996169031624536541560020822e+35);
        float _234 = abs(_112 - _122);
        float _240 = _179 * (((_234 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_195 * _234 + 1.0)) : 0.0) * 0.24420134723186492919921875);
        bool _245 = (abs(_113) <= 9.9999996169031624536541560020822e+35) && (abs(_111.y) <= 9.9999996169031624536541560020822e+35);
        float _254 = abs(_135 - _122);
        float _260 = _179 * (((_254 <= 9.9999996169031624536541560020822e+35) ? (1.0 / (_195 * _254 + 1.0)) : 0.0) * 0.24420134723186492919921875);
        bool _265 = (abs(_136) <= 9.9999996169031624536541560020822e+35) && (abs(_134.y) <= 9.9999996169031624536541560020822e+35);
        float _272 = ((((_184 ? 0.40261995792388916015625 : 0.0) + (_205 ? _200 : 0.0)) + (_225 ? _220 : 0.0)) + (_245 ? _240 : 0.0)) + (_265 ? _260 : 0.0);
        vec4 _286 = vec4(mix(vec2(0.0), ((((mix(vec2(0.0), vec3(_123, _121.y, _122).xy * 0.40261995792388916015625, bvec2(_184)) + mix(vec2(0.0), vec3(_98, _96.y, _97).xy * _200, bvec2(_205))) + mix(vec2(0.0), vec3(_149, _147.y, _148).xy * _220, bvec2(_225))) + mix(vec2(0.0), vec3(_113, _111.y, _112).xy * _240, bvec2(_245))) + mix(vec2(0.0), vec3(_136, _134.y, _135).xy * _260, bvec2(_265))) / vec2(_272), bvec2(_272 > 1.0000000031710768509710513471353e-30)).x, 0.0, (_161 > 0.0) ? min(_161, 255.0) : 0.0, min((_122 > 0.0) ? min(_122, 9.9999996169031624536541560020822e+35) : 0.0, 65504.0));
        imageStore(gOutFiltered, ivec2(gl_GlobalInvocationID.xy), _286);
        break;
    } while(false);
}

