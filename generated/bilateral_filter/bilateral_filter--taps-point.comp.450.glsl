#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralFilterParameters
{
    vec4 gOutputSize;
    vec2 gDirection;
    vec2 gDepthAmplitude;
    float gConverged;
    float gMaxSmoothing;
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
        vec2 _73 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _78 = parameters.gDirection * parameters.gOutputSize.zw;
        vec4 _82 = textureLod(gInCache, _73 * parameters.gOutputSize.zw, 0.0);
        float _83 = _82.x;
        vec2 _88 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_83, 0.0), bvec2(abs(_83) <= 65504.0));
        float _89 = _82.w;
        float _90 = _88.x;
        vec2 _94 = _78 * 1.0;
        vec4 _97 = textureLod(gInCache, fma(_73, parameters.gOutputSize.zw, -_94), 0.0);
        float _98 = _97.x;
        vec2 _103 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_98, 0.0), bvec2(abs(_98) <= 65504.0));
        float _104 = _97.w;
        float _105 = _103.x;
        vec4 _110 = textureLod(gInCache, fma(_73, parameters.gOutputSize.zw, _94), 0.0);
        float _111 = _110.x;
        vec2 _116 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_111, 0.0), bvec2(abs(_111) <= 65504.0));
        float _117 = _110.w;
        float _118 = _116.x;
        vec2 _122 = _78 * 2.0;
        vec4 _125 = textureLod(gInCache, fma(_73, parameters.gOutputSize.zw, -_122), 0.0);
        float _126 = _125.x;
        vec2 _131 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_126, 0.0), bvec2(abs(_126) <= 65504.0));
        float _132 = _125.w;
        float _133 = _131.x;
        vec4 _138 = textureLod(gInCache, fma(_73, parameters.gOutputSize.zw, _122), 0.0);
        float _139 = _138.x;
        vec2 _144 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_139, 0.0), bvec2(abs(_139) <= 65504.0));
        float _145 = _138.w;
        float _146 = _144.x;
        vec2 _150 = _78 * 3.0;
        vec4 _153 = textureLod(gInCache, fma(_73, parameters.gOutputSize.zw, -_150), 0.0);
        float _154 = _153.x;
        vec2 _159 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_154, 0.0), bvec2(abs(_154) <= 65504.0));
        float _160 = _153.w;
        float _161 = _159.x;
        vec4 _166 = textureLod(gInCache, fma(_73, parameters.gOutputSize.zw, _150), 0.0);
        float _167 = _166.x;
        vec2 _172 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_167, 0.0), bvec2(abs(_167) <= 65504.0));
        float _173 = _166.w;
        float _174 = _172.x;
        vec2 _178 = _78 * 4.0;
        vec4 _181 = textureLod(gInCache, fma(_73, parameters.gOutputSize.zw, -_178), 0.0);
        float _182 = _181.x;
        vec2 _187 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_182, 0.0), bvec2(abs(_182) <= 65504.0));
        float _188 = _181.w;
        float _189 = _187.x;
        vec4 _194 = textureLod(gInCache, fma(_73, parameters.gOutputSize.zw, _178), 0.0);
        float _195 = _194.x;
        vec2 _200 = mix(vec2(1.9999999233806324907308312004164e+36), vec2(_195, 0.0), bvec2(abs(_195) <= 65504.0));
        float _201 = _194.w;
        float _202 = _200.x;
        float _213 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_89 > 0.001000000047497451305389404296875) ? min(_89, 65504.0) : 0.001000000047497451305389404296875));
        float _214 = _82.z;
        float _220 = _214 / max(parameters.gConverged, 1.0);
        float _229 = fma(((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0, 1.0 - ((_220 > 0.0) ? min(_220, 1.0) : 0.0), 1.0);
        float _232 = (_229 > 0.0) ? min(_229, 16.0) : 0.0;
        bool _237 = (abs(_90) <= 9.9999996169031624536541560020822e+35) && (abs(_88.y) <= 9.9999996169031624536541560020822e+35);
        float _243 = _232 * 0.122100673615932464599609375;
        float _245 = abs(_104 - _89);
        float _249 = (_213 > 0.0) ? min(_213, 9.9999996169031624536541560020822e+35) : 0.0;
        float _253 = _243 * ((_245 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_249, _245, 1.0)) : 0.0);
        bool _258 = (abs(_105) <= 9.9999996169031624536541560020822e+35) && (abs(_103.y) <= 9.9999996169031624536541560020822e+35);
        float _267 = abs(_117 - _89);
        float _272 = _243 * ((_267 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_249, _267, 1.0)) : 0.0);
        bool _277 = (abs(_118) <= 9.9999996169031624536541560020822e+35) && (abs(_116.y) <= 9.9999996169031624536541560020822e+35);
        float _286 = abs(_132 - _89);
        float _291 = _243 * ((_286 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_249, _286, 1.0)) : 0.0);
        bool _296 = (abs(_133) <= 9.9999996169031624536541560020822e+35) && (abs(_131.y) <= 9.9999996169031624536541560020822e+35);
        float _305 = abs(_145 - _89);
        float _310 = _243 * ((_305 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_249, _305, 1.0)) : 0.0);
        bool _315 = (abs(_146) <= 9.9999996169031624536541560020822e+35) && (abs(_144.y) <= 9.9999996169031624536541560020822e+35);
        float _323 = _232 * 0.02724434249103069305419921875;
        float _325 = abs(_160 - _89);
        float _330 = _323 * ((_325 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_249, _325, 1.0)) : 0.0);
        bool _335 = (abs(_161) <= 9.9999996169031624536541560020822e+35) && (abs(_159.y) <= 9.9999996169031624536541560020822e+35);
        float _344 = abs(_173 - _89);
        float _349 = _323 * ((_344 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_249, _344, 1.0)) : 0.0);
        bool _354 = (abs(_174) <= 9.9999996169031624536541560020822e+35) && (abs(_172.y) <= 9.9999996169031624536541560020822e+35);
        vec2 _359 = (((((mix(vec2(0.0), vec3(_90, _88.y, _89).xy * 0.40261995792388916015625, bvec2(_237)) + mix(vec2(0.0), vec3(_105, _103.y, _104).xy * _253, bvec2(_258))) + mix(vec2(0.0), vec3(_118, _116.y, _117).xy * _272, bvec2(_277))) + mix(vec2(0.0), vec3(_133, _131.y, _132).xy * _291, bvec2(_296))) + mix(vec2(0.0), vec3(_146, _144.y, _145).xy * _310, bvec2(_315))) + mix(vec2(0.0), vec3(_161, _159.y, _160).xy * _330, bvec2(_335))) + mix(vec2(0.0), vec3(_174, _172.y, _173).xy * _349, bvec2(_354));
        float _363 = abs(_188 - _89);
        float _368 = _323 * ((_363 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_249, _363, 1.0)) : 0.0);
        bool _373 = (abs(_189) <= 9.9999996169031624536541560020822e+35) && (abs(_187.y) <= 9.9999996169031624536541560020822e+35);
        float _382 = abs(_201 - _89);
        float _387 = _323 * ((_382 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_249, _382, 1.0)) : 0.0);
        bool _392 = (abs(_202) <= 9.9999996169031624536541560020822e+35) && (abs(_200.y) <= 9.9999996169031624536541560020822e+35);
        float _399 = ((((((((_237 ? 0.40261995792388916015625 : 0.0) + (_258 ? _253 : 0.0)) + (_277 ? _272 : 0.0)) + (_296 ? _291 : 0.0)) + (_315 ? _310 : 0.0)) + (_335 ? _330 : 0.0)) + (_354 ? _349 : 0.0)) + (_373 ? _368 : 0.0)) + (_392 ? _387 : 0.0);
        imageStore(gOutFiltered, ivec2(gl_GlobalInvocationID.xy), vec4(mix(vec2(0.0), ((_359 + mix(vec2(0.0), vec3(_189, _187.y, _188).xy * _368, bvec2(_373))) + mix(vec2(0.0), vec3(_202, _200.y, _201).xy * _387, bvec2(_392))) / vec2(_399), bvec2(_399 > 1.0000000031710768509710513471353e-30)).x, 0.0, (_214 > 0.0) ? min(_214, 255.0) : 0.0, min((_89 > 0.0) ? min(_89, 9.9999996169031624536541560020822e+35) : 0.0, 65504.0)));
        break;
    } while(false);
}

