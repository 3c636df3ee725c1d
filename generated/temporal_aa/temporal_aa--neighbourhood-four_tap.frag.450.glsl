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
    vec2 _75 = parameters.gOutputSize.zw * 0.5;
    vec4 _79 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_75));
    float _81 = _75.x;
    float _82 = _75.y;
    vec4 _86 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_81, -_82)));
    vec4 _91 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_81, _82)));
    vec4 _94 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _75));
    float _95 = _79.w;
    float _96 = _79.z;
    float _97 = _79.x;
    float _98 = _79.y;
    float _99 = _86.z;
    float _100 = _86.y;
    float _101 = _91.x;
    float _102 = _91.y;
    float _103 = _94.y;
    vec2 _108 = mix(vec2(_97, -1.0), vec2(_100, 1.0), bvec2(_100 < _97));
    vec2 _113 = mix(vec2(_98, 0.0), _108, bvec2(_108.x < _98));
    vec2 _118 = mix(vec2(_95, -1.0), vec2(_99, 1.0), bvec2(_99 < _95));
    vec2 _123 = mix(vec2(_96, 0.0), _118, bvec2(_118.x < _96));
    vec2 _128 = mix(vec2(_101, -1.0), vec2(_103, 1.0), bvec2(_103 < _101));
    vec2 _133 = mix(vec2(_102, 0.0), _128, bvec2(_128.x < _102));
    bool _136 = _133.x < _123.x;
    vec2 _138 = mix(_123, _133, bvec2(_136));
    vec2 _158 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_113.y, 0.0), vec2(_138.y, _136 ? 1.0 : (-1.0)), bvec2(_138.x < _113.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _160 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_158);
    float _170 = length(_158 * parameters.gOutputSize.xy);
    vec2 _174 = parameters.gOutputSize.zw * mix(0.66600000858306884765625, 0.5, clamp(_170 * 0.100000001490116119384765625, 0.0, 1.0));
    vec3 _181 = clamp(textureLod(gInColour, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _190 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_174), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _191 = _174.x;
    float _192 = _174.y;
    vec3 _200 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_191, -_192)), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _208 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_191, _192)), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _214 = clamp(textureLod(gInColourFiltered, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _174), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec2 _226 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec3 _231 = clamp(textureLod(gInColourFiltered, _226, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _232 = max(_181, max(max(_190, _200), max(_208, _214))) * 0.5;
    vec3 _233 = min(_181, min(min(_190, _200), min(_208, _214))) * 0.5;
    vec3 _234 = _232 + _233;
    vec3 _236 = max(_232 - _233, vec3(1.5258789240815695542607954848791e-12));
    vec3 _237 = clamp(textureLod(gHistoryColour, _160, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _234;
    vec3 _240 = _236 / max(abs(_237), _236);
    vec3 _262 = min((_231 + (((_234 + (_237 * min(_240.x, min(_240.y, _240.z)))) - _231) * (all(lessThanEqual(abs(_160 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _274 = _158 * 0.083333335816860198974609375;
    vec4 _276 = textureLod(gInColourFiltered, _226, 0.0);
    float _277 = _276.x;
    float _280 = _276.y;
    float _283 = _276.z;
    vec2 _289 = _274 * 1.0;
    vec4 _291 = textureLod(gInColourFiltered, _226 + _289, 0.0);
    float _292 = _291.x;
    float _295 = _291.y;
    float _298 = _291.z;
    vec4 _306 = textureLod(gInColourFiltered, _226 - _289, 0.0);
    float _307 = _306.x;
    float _310 = _306.y;
    float _313 = _306.z;
    vec2 _320 = _274 * 2.0;
    vec4 _322 = textureLod(gInColourFiltered, _226 + _320, 0.0);
    float _323 = _322.x;
    float _326 = _322.y;
    float _329 = _322.z;
    vec4 _337 = textureLod(gInColourFiltered, _226 - _320, 0.0);
    float _338 = _337.x;
    float _341 = _337.y;
    float _344 = _337.z;
    vec2 _351 = _274 * 3.0;
    vec4 _353 = textureLod(gInColourFiltered, _226 + _351, 0.0);
    float _354 = _353.x;
    float _357 = _353.y;
    float _360 = _353.z;
    vec4 _368 = textureLod(gInColourFiltered, _226 - _351, 0.0);
    float _369 = _368.x;
    float _372 = _368.y;
    float _375 = _368.z;
    vec3 _380 = (((((min(vec3((_277 > 0.0) ? _277 : 0.0, (_280 > 0.0) ? _280 : 0.0, (_283 > 0.0) ? _283 : 0.0), vec3(65504.0)) + min(vec3((_292 > 0.0) ? _292 : 0.0, (_295 > 0.0) ? _295 : 0.0, (_298 > 0.0) ? _298 : 0.0), vec3(65504.0))) + min(vec3((_307 > 0.0) ? _307 : 0.0, (_310 > 0.0) ? _310 : 0.0, (_313 > 0.0) ? _313 : 0.0), vec3(65504.0))) + min(vec3((_323 > 0.0) ? _323 : 0.0, (_326 > 0.0) ? _326 : 0.0, (_329 > 0.0) ? _329 : 0.0), vec3(65504.0))) + min(vec3((_338 > 0.0) ? _338 : 0.0, (_341 > 0.0) ? _341 : 0.0, (_344 > 0.0) ? _344 : 0.0), vec3(65504.0))) + min(vec3((_354 > 0.0) ? _354 : 0.0, (_357 > 0.0) ? _357 : 0.0, (_360 > 0.0) ? _360 : 0.0), vec3(65504.0))) + min(vec3((_369 > 0.0) ? _369 : 0.0, (_372 > 0.0) ? _372 : 0.0, (_375 > 0.0) ? _375 : 0.0), vec3(65504.0));
    vec3 _384 = mix(min(_380 * vec3(0.14285714924335479736328125), vec3(65504.0)), _262, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - _170) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_262, 1.0);
    gOutColour = vec4(_384, 1.0);
}

