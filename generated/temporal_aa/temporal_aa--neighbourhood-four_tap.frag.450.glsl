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
    vec2 _74 = parameters.gOutputSize.zw * 0.5;
    vec4 _78 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_74));
    float _80 = _74.x;
    float _81 = _74.y;
    vec4 _85 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_80, -_81)));
    vec4 _90 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_80, _81)));
    vec4 _93 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _74));
    float _94 = _78.w;
    float _95 = _78.z;
    float _96 = _78.x;
    float _97 = _78.y;
    float _98 = _85.z;
    float _99 = _85.y;
    float _100 = _90.x;
    float _101 = _90.y;
    float _102 = _93.y;
    vec2 _107 = mix(vec2(_96, -1.0), vec2(_99, 1.0), bvec2(_99 < _96));
    vec2 _112 = mix(vec2(_97, 0.0), _107, bvec2(_107.x < _97));
    vec2 _117 = mix(vec2(_94, -1.0), vec2(_98, 1.0), bvec2(_98 < _94));
    vec2 _122 = mix(vec2(_95, 0.0), _117, bvec2(_117.x < _95));
    vec2 _127 = mix(vec2(_100, -1.0), vec2(_102, 1.0), bvec2(_102 < _100));
    vec2 _132 = mix(vec2(_101, 0.0), _127, bvec2(_127.x < _101));
    bool _135 = _132.x < _122.x;
    vec2 _137 = mix(_122, _132, bvec2(_135));
    vec2 _157 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_112.y, 0.0), vec2(_137.y, _135 ? 1.0 : (-1.0)), bvec2(_137.x < _112.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _159 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_157);
    float _169 = length(_157 * parameters.gOutputSize.xy);
    vec2 _173 = parameters.gOutputSize.zw * mix(0.66600000858306884765625, 0.5, clamp(_169 * 0.100000001490116119384765625, 0.0, 1.0));
    vec3 _180 = clamp(textureLod(gInColour, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _189 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_173), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _190 = _173.x;
    float _191 = _173.y;
    vec3 _199 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_190, -_191)), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _207 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_190, _191)), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _213 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _173), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec2 _225 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec3 _230 = clamp(textureLod(gInColourFiltered, _225, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _231 = max(_180, max(max(_189, _199), max(_207, _213))) * 0.5;
    vec3 _232 = min(_180, min(min(_189, _199), min(_207, _213))) * 0.5;
    vec3 _233 = _231 + _232;
    vec3 _235 = max(_231 - _232, vec3(1.5258789240815695542607954848791e-12));
    vec3 _236 = clamp(textureLod(gHistoryColour, _159, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _233;
    vec3 _239 = _235 / max(abs(_236), _235);
    vec3 _261 = min((_230 + (((_233 + (_236 * min(_239.x, min(_239.y, _239.z)))) - _230) * (all(lessThanEqual(abs(_159 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _272 = _157 * 0.083333335816860198974609375;
    vec4 _274 = textureLod(gInColourFiltered, _225, 0.0);
    float _275 = _274.x;
    float _278 = _274.y;
    float _281 = _274.z;
    vec2 _287 = _272 * 1.0;
    vec4 _289 = textureLod(gInColourFiltered, _225 + _287, 0.0);
    float _290 = _289.x;
    float _293 = _289.y;
    float _296 = _289.z;
    vec4 _304 = textureLod(gInColourFiltered, _225 - _287, 0.0);
    float _305 = _304.x;
    float _308 = _304.y;
    float _311 = _304.z;
    vec2 _318 = _272 * 2.0;
    vec4 _320 = textureLod(gInColourFiltered, _225 + _318, 0.0);
    float _321 = _320.x;
    float _324 = _320.y;
    float _327 = _320.z;
    vec4 _335 = textureLod(gInColourFiltered, _225 - _318, 0.0);
    float _336 = _335.x;
    float _339 = _335.y;
    float _342 = _335.z;
    vec2 _349 = _272 * 3.0;
    vec4 _351 = textureLod(gInColourFiltered, _225 + _349, 0.0);
    float _352 = _351.x;
    float _355 = _351.y;
    float _358 = _351.z;
    vec4 _366 = textureLod(gInColourFiltered, _225 - _349, 0.0);
    float _367 = _366.x;
    float _370 = _366.y;
    float _373 = _366.z;
    vec3 _378 = (((((min(vec3((_275 > 0.0) ? _275 : 0.0, (_278 > 0.0) ? _278 : 0.0, (_281 > 0.0) ? _281 : 0.0), vec3(65504.0)) + min(vec3((_290 > 0.0) ? _290 : 0.0, (_293 > 0.0) ? _293 : 0.0, (_296 > 0.0) ? _296 : 0.0), vec3(65504.0))) + min(vec3((_305 > 0.0) ? _305 : 0.0, (_308 > 0.0) ? _308 : 0.0, (_311 > 0.0) ? _311 : 0.0), vec3(65504.0))) + min(vec3((_321 > 0.0) ? _321 : 0.0, (_324 > 0.0) ? _324 : 0.0, (_327 > 0.0) ? _327 : 0.0), vec3(65504.0))) + min(vec3((_336 > 0.0) ? _336 : 0.0, (_339 > 0.0) ? _339 : 0.0, (_342 > 0.0) ? _342 : 0.0), vec3(65504.0))) + min(vec3((_352 > 0.0) ? _352 : 0.0, (_355 > 0.0) ? _355 : 0.0, (_358 > 0.0) ? _358 : 0.0), vec3(65504.0))) + min(vec3((_367 > 0.0) ? _367 : 0.0, (_370 > 0.0) ? _370 : 0.0, (_373 > 0.0) ? _373 : 0.0), vec3(65504.0));
    vec3 _382 = mix(min(_378 * vec3(0.14285714924335479736328125), vec3(65504.0)), _261, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - _169) / (parameters.gBlurToPx - parameters.gBlurFromPx), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_261, 1.0);
    gOutColour = vec4(_382, 1.0);
}

