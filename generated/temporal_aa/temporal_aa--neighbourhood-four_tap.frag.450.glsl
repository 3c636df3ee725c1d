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
    vec2 _76 = parameters.gOutputSize.zw * 0.5;
    vec4 _80 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_76));
    float _82 = _76.x;
    float _83 = _76.y;
    vec4 _87 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_82, -_83)));
    vec4 _92 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_82, _83)));
    vec4 _95 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76));
    float _96 = _80.w;
    float _97 = _80.z;
    float _98 = _80.x;
    float _99 = _80.y;
    float _100 = _87.z;
    float _101 = _87.y;
    float _102 = _92.x;
    float _103 = _92.y;
    float _104 = _95.y;
    vec2 _109 = mix(vec2(_98, -1.0), vec2(_101, 1.0), bvec2(_101 < _98));
    vec2 _114 = mix(vec2(_99, 0.0), _109, bvec2(_109.x < _99));
    vec2 _119 = mix(vec2(_96, -1.0), vec2(_100, 1.0), bvec2(_100 < _96));
    vec2 _124 = mix(vec2(_97, 0.0), _119, bvec2(_119.x < _97));
    vec2 _129 = mix(vec2(_102, -1.0), vec2(_104, 1.0), bvec2(_104 < _102));
    vec2 _134 = mix(vec2(_103, 0.0), _129, bvec2(_129.x < _103));
    bool _137 = _134.x < _124.x;
    vec2 _139 = mix(_124, _134, bvec2(_137));
    vec2 _159 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_114.y, 0.0), vec2(_139.y, _137 ? 1.0 : (-1.0)), bvec2(_139.x < _114.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _161 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_159);
    float _171 = length(_159 * parameters.gOutputSize.xy);
    vec2 _175 = parameters.gOutputSize.zw * mix(0.66600000858306884765625, 0.5, clamp(_171 * 0.100000001490116119384765625, 0.0, 1.0));
    vec3 _182 = clamp(textureLod(gInColour, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _191 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_175), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _192 = _175.x;
    float _193 = _175.y;
    vec3 _201 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_192, -_193)), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _209 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_192, _193)), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _215 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _175), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _219 = min(_182, min(min(_191, _201), min(_209, _215)));
    vec3 _223 = max(_182, max(max(_191, _201), max(_209, _215)));
    vec2 _227 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec3 _232 = clamp(textureLod(gInColourFiltered, _227, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _233 = _223 + _219;
    vec3 _235 = max(_223 - _219, vec3(3.0517578481631391085215909697581e-12));
    vec3 _237 = (clamp(textureLod(gHistoryColour, _161, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 2.0) - _233;
    vec3 _240 = _235 / max(abs(_237), _235);
    vec3 _263 = min((_232 + ((((_233 + (_237 * min(_240.x, min(_240.y, _240.z)))) * 0.5) - _232) * (all(lessThanEqual(abs(_161 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _275 = _159 * 0.083333335816860198974609375;
    vec4 _277 = textureLod(gInColourFiltered, _227, 0.0);
    float _278 = _277.x;
    float _281 = _277.y;
    float _284 = _277.z;
    vec2 _290 = _275 * 1.0;
    vec4 _292 = textureLod(gInColourFiltered, _227 + _290, 0.0);
    float _293 = _292.x;
    float _296 = _292.y;
    float _299 = _292.z;
    vec4 _307 = textureLod(gInColourFiltered, _227 - _290, 0.0);
    float _308 = _307.x;
    float _311 = _307.y;
    float _314 = _307.z;
    vec2 _321 = _275 * 2.0;
    vec4 _323 = textureLod(gInColourFiltered, _227 + _321, 0.0);
    float _324 = _323.x;
    float _327 = _323.y;
    float _330 = _323.z;
    vec4 _338 = textureLod(gInColourFiltered, _227 - _321, 0.0);
    float _339 = _338.x;
    float _342 = _338.y;
    float _345 = _338.z;
    vec2 _352 = _275 * 3.0;
    vec4 _354 = textureLod(gInColourFiltered, _227 + _352, 0.0);
    float _355 = _354.x;
    float _358 = _354.y;
    float _361 = _354.z;
    vec4 _369 = textureLod(gInColourFiltered, _227 - _352, 0.0);
    float _370 = _369.x;
    float _373 = _369.y;
    float _376 = _369.z;
    vec3 _381 = (((((min(vec3((_278 > 0.0) ? _278 : 0.0, (_281 > 0.0) ? _281 : 0.0, (_284 > 0.0) ? _284 : 0.0), vec3(65504.0)) + min(vec3((_293 > 0.0) ? _293 : 0.0, (_296 > 0.0) ? _296 : 0.0, (_299 > 0.0) ? _299 : 0.0), vec3(65504.0))) + min(vec3((_308 > 0.0) ? _308 : 0.0, (_311 > 0.0) ? _311 : 0.0, (_314 > 0.0) ? _314 : 0.0), vec3(65504.0))) + min(vec3((_324 > 0.0) ? _324 : 0.0, (_327 > 0.0) ? _327 : 0.0, (_330 > 0.0) ? _330 : 0.0), vec3(65504.0))) + min(vec3((_339 > 0.0) ? _339 : 0.0, (_342 > 0.0) ? _342 : 0.0, (_345 > 0.0) ? _345 : 0.0), vec3(65504.0))) + min(vec3((_355 > 0.0) ? _355 : 0.0, (_358 > 0.0) ? _358 : 0.0, (_361 > 0.0) ? _361 : 0.0), vec3(65504.0))) + min(vec3((_370 > 0.0) ? _370 : 0.0, (_373 > 0.0) ? _373 : 0.0, (_376 > 0.0) ? _376 : 0.0), vec3(65504.0));
    vec3 _385 = mix(min(_381 * vec3(0.14285714924335479736328125), vec3(65504.0)), _263, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - _171) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_263, 1.0);
    gOutColour = vec4(_385, 1.0);
}

