#version 450

layout(binding = 0, std140) uniform TemporalAaParameters
{
    vec4 gOutputSize;
    vec2 gJitterPx;
    vec2 gMotionToUv;
    float gHistoryValid;
    float gFeedbackMin;
    float gFeedbackMax;
    float gBlurFromPx;
    float gBlurToPx;
    mat4 gReprojection;
} parameters;

layout(binding = 2) uniform sampler2D gInDepth;
layout(binding = 3) uniform sampler2D gInVelocity;
layout(binding = 4) uniform sampler2D gHistoryColour;
layout(binding = 1) uniform sampler2D gInColour;
layout(binding = 5) uniform sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _77 = parameters.gOutputSize.zw * 0.5;
    vec4 _81 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_77));
    float _83 = _77.x;
    float _84 = _77.y;
    vec4 _88 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_83, -_84)));
    vec4 _93 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_83, _84)));
    vec4 _96 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _77));
    float _97 = _81.w;
    float _98 = _81.z;
    float _99 = _81.x;
    float _100 = _81.y;
    float _101 = _88.z;
    float _102 = _88.y;
    float _103 = _93.x;
    float _104 = _93.y;
    float _105 = _96.y;
    float _109 = -parameters.gOutputSize.z;
    vec2 _112 = mix(vec2(_99, _109), vec2(_102, parameters.gOutputSize.z), bvec2(_102 < _99));
    vec2 _117 = mix(vec2(_100, 0.0), _112, bvec2(_112.x < _100));
    vec2 _122 = mix(vec2(_97, _109), vec2(_101, parameters.gOutputSize.z), bvec2(_101 < _97));
    vec2 _127 = mix(vec2(_98, 0.0), _122, bvec2(_122.x < _98));
    vec2 _132 = mix(vec2(_103, _109), vec2(_105, parameters.gOutputSize.z), bvec2(_105 < _103));
    vec2 _137 = mix(vec2(_104, 0.0), _132, bvec2(_132.x < _104));
    bool _140 = _137.x < _127.x;
    vec2 _142 = mix(_127, _137, bvec2(_140));
    vec2 _163 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_117.y, 0.0), vec2(_142.y, _140 ? parameters.gOutputSize.w : (-parameters.gOutputSize.w)), bvec2(_142.x < _117.x))), 0.0).xy * parameters.gMotionToUv;
    vec2 _165 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_163);
    float _175 = length(_163 * parameters.gOutputSize.xy);
    vec2 _179 = parameters.gOutputSize.zw * mix(0.66600000858306884765625, 0.5, clamp(_175 * 0.100000001490116119384765625, 0.0, 1.0));
    vec3 _186 = clamp(textureLod(gInColour, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _195 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_179), 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    float _196 = _179.x;
    float _197 = _179.y;
    vec3 _205 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_196, -_197)), 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _213 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_196, _197)), 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _219 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _179), 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _223 = min(_186, min(min(_195, _205), min(_213, _219)));
    vec3 _227 = max(_186, max(max(_195, _205), max(_213, _219)));
    vec2 _231 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec3 _236 = clamp(textureLod(gInColourFiltered, _231, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _237 = _227 + _223;
    vec3 _241 = (clamp(textureLod(gHistoryColour, _165, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * 2.0) - _237;
    vec3 _244 = clamp(max(_227 - _223, vec3(3.0532486261503066771183512173593e-12)) / abs(_241), vec3(0.0), vec3(1.0));
    vec3 _265 = (_236 + ((((_237 + (_241 * min(_244.x, min(_244.y, _244.z)))) * 0.5) - _236) * (all(lessThanEqual(floatBitsToUint(_165), uvec2(1065353216u))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65504.0;
    vec2 _277 = _163 * 0.083333335816860198974609375;
    vec4 _279 = textureLod(gInColourFiltered, _231, 0.0);
    float _280 = _279.x;
    float _283 = _279.y;
    float _286 = _279.z;
    vec2 _292 = _277 * 1.0;
    vec4 _294 = textureLod(gInColourFiltered, _231 + _292, 0.0);
    float _295 = _294.x;
    float _298 = _294.y;
    float _301 = _294.z;
    vec4 _309 = textureLod(gInColourFiltered, _231 - _292, 0.0);
    float _310 = _309.x;
    float _313 = _309.y;
    float _316 = _309.z;
    vec2 _323 = _277 * 2.0;
    vec4 _325 = textureLod(gInColourFiltered, _231 + _323, 0.0);
    float _326 = _325.x;
    float _329 = _325.y;
    float _332 = _325.z;
    vec4 _340 = textureLod(gInColourFiltered, _231 - _323, 0.0);
    float _341 = _340.x;
    float _344 = _340.y;
    float _347 = _340.z;
    vec2 _354 = _277 * 3.0;
    vec4 _356 = textureLod(gInColourFiltered, _231 + _354, 0.0);
    float _357 = _356.x;
    float _360 = _356.y;
    float _363 = _356.z;
    vec4 _371 = textureLod(gInColourFiltered, _231 - _354, 0.0);
    float _372 = _371.x;
    float _375 = _371.y;
    float _378 = _371.z;
    vec3 _383 = (((((min(vec3((_280 > 0.0) ? _280 : 0.0, (_283 > 0.0) ? _283 : 0.0, (_286 > 0.0) ? _286 : 0.0), vec3(65504.0)) + min(vec3((_295 > 0.0) ? _295 : 0.0, (_298 > 0.0) ? _298 : 0.0, (_301 > 0.0) ? _301 : 0.0), vec3(65504.0))) + min(vec3((_310 > 0.0) ? _310 : 0.0, (_313 > 0.0) ? _313 : 0.0, (_316 > 0.0) ? _316 : 0.0), vec3(65504.0))) + min(vec3((_326 > 0.0) ? _326 : 0.0, (_329 > 0.0) ? _329 : 0.0, (_332 > 0.0) ? _332 : 0.0), vec3(65504.0))) + min(vec3((_341 > 0.0) ? _341 : 0.0, (_344 > 0.0) ? _344 : 0.0, (_347 > 0.0) ? _347 : 0.0), vec3(65504.0))) + min(vec3((_357 > 0.0) ? _357 : 0.0, (_360 > 0.0) ? _360 : 0.0, (_363 > 0.0) ? _363 : 0.0), vec3(65504.0))) + min(vec3((_372 > 0.0) ? _372 : 0.0, (_375 > 0.0) ? _375 : 0.0, (_378 > 0.0) ? _378 : 0.0), vec3(65504.0));
    vec3 _387 = mix(min(_383 * vec3(0.14285714924335479736328125), vec3(65504.0)), _265, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - _175) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_265, 1.0);
    gOutColour = vec4(_387, 1.0);
}

