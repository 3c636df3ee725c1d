#version 450
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

layout(binding = 16) uniform writeonly image2D gOutFiltered;
layout(binding = 1) uniform sampler2D gInCache;

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
        float _84 = _83.x;
        vec2 _89 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_84, 0.0), bvec2(abs(_84) <= 65504.0));
        float _90 = _83.w;
        float _91 = _89.x;
        vec2 _95 = _79 * 1.0;
        vec4 _98 = textureLod(gInCache, fma(_74, parameters.gOutputSize.zw, -_95), 0.0);
        float _99 = _98.x;
        vec2 _104 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_99, 0.0), bvec2(abs(_99) <= 65504.0));
        float _105 = _98.w;
        float _106 = _104.x;
        vec4 _111 = textureLod(gInCache, fma(_74, parameters.gOutputSize.zw, _95), 0.0);
        float _112 = _111.x;
        vec2 _117 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_112, 0.0), bvec2(abs(_112) <= 65504.0));
        float _118 = _111.w;
        float _119 = _117.x;
        vec2 _123 = _79 * 2.0;
        vec4 _126 = textureLod(gInCache, fma(_74, parameters.gOutputSize.zw, -_123), 0.0);
        float _127 = _126.x;
        vec2 _132 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_127, 0.0), bvec2(abs(_127) <= 65504.0));
        float _133 = _126.w;
        float _134 = _132.x;
        vec4 _139 = textureLod(gInCache, fma(_74, parameters.gOutputSize.zw, _123), 0.0);
        float _140 = _139.x;
        vec2 _145 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_140, 0.0), bvec2(abs(_140) <= 65504.0));
        float _146 = _139.w;
        float _147 = _145.x;
        vec2 _151 = _79 * 3.0;
        vec4 _154 = textureLod(gInCache, fma(_74, parameters.gOutputSize.zw, -_151), 0.0);
        float _155 = _154.x;
        vec2 _160 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_155, 0.0), bvec2(abs(_155) <= 65504.0));
        float _161 = _154.w;
        float _162 = _160.x;
        vec4 _167 = textureLod(gInCache, fma(_74, parameters.gOutputSize.zw, _151), 0.0);
        float _168 = _167.x;
        vec2 _173 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_168, 0.0), bvec2(abs(_168) <= 65504.0));
        float _174 = _167.w;
        float _175 = _173.x;
        vec2 _179 = _79 * 4.0;
        vec4 _182 = textureLod(gInCache, fma(_74, parameters.gOutputSize.zw, -_179), 0.0);
        float _183 = _182.x;
        vec2 _188 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_183, 0.0), bvec2(abs(_183) <= 65504.0));
        float _189 = _182.w;
        float _190 = _188.x;
        vec4 _195 = textureLod(gInCache, fma(_74, parameters.gOutputSize.zw, _179), 0.0);
        float _196 = _195.x;
        vec2 _201 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_196, 0.0), bvec2(abs(_196) <= 65504.0));
        float _202 = _195.w;
        float _203 = _201.x;
        float _214 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_90 > 0.001000000047497451305389404296875) ? min(_90, 65504.0) : 0.001000000047497451305389404296875));
        float _215 = _83.z;
        float _221 = _215 / max(parameters.gConverged, 1.0);
        float _234 = (fma(((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0, 1.0 - ((_221 > 0.0) ? min(_221, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
        float _237 = (_234 > 0.0) ? min(_234, 16.0) : 0.0;
        bool _242 = (abs(_91) <= 9.9999996169031624536541560020822e+35) && (abs(_89.y) <= 9.9999996169031624536541560020822e+35);
        float _248 = _237 * 0.122100673615932464599609375;
        float _250 = abs(_105 - _90);
        float _254 = (_214 > 0.0) ? min(_214, 9.9999996169031624536541560020822e+35) : 0.0;
        float _258 = _248 * ((_250 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_254, _250, 1.0)) : 0.0);
        bool _263 = (abs(_106) <= 9.9999996169031624536541560020822e+35) && (abs(_104.y) <= 9.9999996169031624536541560020822e+35);
        float _272 = abs(_118 - _90);
        float _277 = _248 * ((_272 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_254, _272, 1.0)) : 0.0);
        bool _282 = (abs(_119) <= 9.9999996169031624536541560020822e+35) && (abs(_117.y) <= 9.9999996169031624536541560020822e+35);
        float _291 = abs(_133 - _90);
        float _296 = _248 * ((_291 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_254, _291, 1.0)) : 0.0);
        bool _301 = (abs(_134) <= 9.9999996169031624536541560020822e+35) && (abs(_132.y) <= 9.9999996169031624536541560020822e+35);
        float _310 = abs(_146 - _90);
        float _315 = _248 * ((_310 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_254, _310, 1.0)) : 0.0);
        bool _320 = (abs(_147) <= 9.9999996169031624536541560020822e+35) && (abs(_145.y) <= 9.9999996169031624536541560020822e+35);
        float _328 = _237 * 0.02724434249103069305419921875;
        float _330 = abs(_161 - _90);
        float _335 = _328 * ((_330 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_254, _330, 1.0)) : 0.0);
        bool _340 = (abs(_162) <= 9.9999996169031624536541560020822e+35) && (abs(_160.y) <= 9.9999996169031624536541560020822e+35);
        float _349 = abs(_174 - _90);
        float _354 = _328 * ((_349 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_254, _349, 1.0)) : 0.0);
        bool _359 = (abs(_175) <= 9.9999996169031624536541560020822e+35) && (abs(_173.y) <= 9.9999996169031624536541560020822e+35);
        vec2 _364 = (((((mix(vec2(0.0), vec3(_91, _89.y, _90).xy * 0.40261995792388916015625, bvec2(_242)) + mix(vec2(0.0), vec3(_106, _104.y, _105).xy * _258, bvec2(_263))) + mix(vec2(0.0), vec3(_119, _117.y, _118).xy * _277, bvec2(_282))) + mix(vec2(0.0), vec3(_134, _132.y, _133).xy * _296, bvec2(_301))) + mix(vec2(0.0), vec3(_147, _145.y, _146).xy * _315, bvec2(_320))) + mix(vec2(0.0), vec3(_162, _160.y, _161).xy * _335, bvec2(_340))) + mix(vec2(0.0), vec3(_175, _173.y, _174).xy * _354, bvec2(_359));
        float _368 = abs(_189 - _90);
        float _373 = _328 * ((_368 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_254, _368, 1.0)) : 0.0);
        bool _378 = (abs(_190) <= 9.9999996169031624536541560020822e+35) && (abs(_188.y) <= 9.9999996169031624536541560020822e+35);
        float _387 = abs(_202 - _90);
        float _392 = _328 * ((_387 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_254, _387, 1.0)) : 0.0);
        bool _397 = (abs(_203) <= 9.9999996169031624536541560020822e+35) && (abs(_201.y) <= 9.9999996169031624536541560020822e+35);
        float _404 = ((((((((_242 ? 0.40261995792388916015625 : 0.0) + (_263 ? _258 : 0.0)) + (_282 ? _277 : 0.0)) + (_301 ? _296 : 0.0)) + (_320 ? _315 : 0.0)) + (_340 ? _335 : 0.0)) + (_359 ? _354 : 0.0)) + (_378 ? _373 : 0.0)) + (_397 ? _392 : 0.0);
        imageStore(gOutFiltered, ivec2(gl_GlobalInvocationID.xy), vec4(mix(vec2(0.0), ((_364 + mix(vec2(0.0), vec3(_190, _188.y, _189).xy * _373, bvec2(_378))) + mix(vec2(0.0), vec3(_203, _201.y, _202).xy * _392, bvec2(_397))) / vec2(_404), bvec2(_404 > 1.0000000031710768509710513471353e-30)).x, 0.0, (_215 > 0.0) ? min(_215, 255.0) : 0.0, min((_90 > 0.0) ? min(_90, 9.9999996169031624536541560020822e+35) : 0.0, 65504.0)));
        break;
    } while(false);
}

