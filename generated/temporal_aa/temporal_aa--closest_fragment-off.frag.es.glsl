#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform TemporalAaParameters
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

uniform highp sampler2D gInVelocity;
uniform highp sampler2D gHistoryColour;
uniform highp sampler2D gInColour;
uniform highp sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _77 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _85 = textureLod(gInVelocity, _77, 0.0).xy * parameters.gMotionToUv;
    vec2 _87 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-_85);
    vec3 _101 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _106 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _111 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _116 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _121 = clamp(textureLod(gInColour, _77, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _126 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _131 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _136 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _141 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _146 = max(-parameters.gJitterPx.x, 0.0);
    float _148 = 1.0 - abs(parameters.gJitterPx.x);
    float _149 = max(parameters.gJitterPx.x, 0.0);
    vec3 _175 = (((((_101 * _146) + (_106 * _148)) + (_111 * _149)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_116 * _146) + (_121 * _148)) + (_126 * _149)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_131 * _146) + (_136 * _148)) + (_141 * _149)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _176 = floatBitsToInt(_116);
    ivec3 _177 = floatBitsToInt(_126);
    ivec3 _179 = floatBitsToInt(_121);
    ivec3 _182 = floatBitsToInt(intBitsToFloat(min(min(_176, _177), _179)));
    ivec3 _183 = floatBitsToInt(_106);
    ivec3 _185 = floatBitsToInt(_136);
    ivec3 _191 = floatBitsToInt(intBitsToFloat(max(max(_176, _177), _179)));
    ivec3 _195 = floatBitsToInt(_101);
    ivec3 _196 = floatBitsToInt(_111);
    ivec3 _200 = floatBitsToInt(_131);
    ivec3 _201 = floatBitsToInt(_141);
    vec3 _225 = ((intBitsToFloat(max(max(_191, _183), _185)) + intBitsToFloat(max(max(_191, floatBitsToInt(intBitsToFloat(max(max(_195, _196), _183)))), floatBitsToInt(intBitsToFloat(max(max(_200, _201), _185)))))) * 0.5) * 0.5;
    vec3 _226 = ((intBitsToFloat(min(min(_182, _183), _185)) + intBitsToFloat(min(min(_182, floatBitsToInt(intBitsToFloat(min(min(_195, _196), _183)))), floatBitsToInt(intBitsToFloat(min(min(_200, _201), _185)))))) * 0.5) * 0.5;
    vec3 _227 = _225 + _226;
    vec3 _229 = max(_225 - _226, vec3(1.5258789240815695542607954848791e-12));
    vec3 _230 = clamp(textureLod(gHistoryColour, _87, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _227;
    vec3 _233 = _229 / max(abs(_230), _229);
    vec3 _255 = min((_175 + (((_227 + (_230 * min(_233.x, min(_233.y, _233.z)))) - _175) * (all(lessThanEqual(abs(_87 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _270 = gl_FragCoord.xy * parameters.gOutputSize.zw + (parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _273 = _85 * 0.083333335816860198974609375;
    vec4 _275 = textureLod(gInColourFiltered, _270, 0.0);
    float _276 = _275.x;
    float _279 = _275.y;
    float _282 = _275.z;
    vec2 _288 = _273 * 1.0;
    vec4 _290 = textureLod(gInColourFiltered, _270 + _288, 0.0);
    float _291 = _290.x;
    float _294 = _290.y;
    float _297 = _290.z;
    vec4 _305 = textureLod(gInColourFiltered, _270 - _288, 0.0);
    float _306 = _305.x;
    float _309 = _305.y;
    float _312 = _305.z;
    vec2 _319 = _273 * 2.0;
    vec4 _321 = textureLod(gInColourFiltered, _270 + _319, 0.0);
    float _322 = _321.x;
    float _325 = _321.y;
    float _328 = _321.z;
    vec4 _336 = textureLod(gInColourFiltered, _270 - _319, 0.0);
    float _337 = _336.x;
    float _340 = _336.y;
    float _343 = _336.z;
    vec2 _350 = _273 * 3.0;
    vec4 _352 = textureLod(gInColourFiltered, _270 + _350, 0.0);
    float _353 = _352.x;
    float _356 = _352.y;
    float _359 = _352.z;
    vec4 _367 = textureLod(gInColourFiltered, _270 - _350, 0.0);
    float _368 = _367.x;
    float _371 = _367.y;
    float _374 = _367.z;
    vec3 _379 = (((((min(vec3((_276 > 0.0) ? _276 : 0.0, (_279 > 0.0) ? _279 : 0.0, (_282 > 0.0) ? _282 : 0.0), vec3(65504.0)) + min(vec3((_291 > 0.0) ? _291 : 0.0, (_294 > 0.0) ? _294 : 0.0, (_297 > 0.0) ? _297 : 0.0), vec3(65504.0))) + min(vec3((_306 > 0.0) ? _306 : 0.0, (_309 > 0.0) ? _309 : 0.0, (_312 > 0.0) ? _312 : 0.0), vec3(65504.0))) + min(vec3((_322 > 0.0) ? _322 : 0.0, (_325 > 0.0) ? _325 : 0.0, (_328 > 0.0) ? _328 : 0.0), vec3(65504.0))) + min(vec3((_337 > 0.0) ? _337 : 0.0, (_340 > 0.0) ? _340 : 0.0, (_343 > 0.0) ? _343 : 0.0), vec3(65504.0))) + min(vec3((_353 > 0.0) ? _353 : 0.0, (_356 > 0.0) ? _356 : 0.0, (_359 > 0.0) ? _359 : 0.0), vec3(65504.0))) + min(vec3((_368 > 0.0) ? _368 : 0.0, (_371 > 0.0) ? _371 : 0.0, (_374 > 0.0) ? _374 : 0.0), vec3(65504.0));
    vec3 _383 = mix(min(_379 * vec3(0.14285714924335479736328125), vec3(65504.0)), _255, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_85 * parameters.gOutputSize.xy)) / (parameters.gBlurToPx - parameters.gBlurFromPx), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_255, 1.0);
    gOutColour = vec4(_383, 1.0);
}

