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
    vec2 _80 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _88 = textureLod(gInVelocity, _80, 0.0).xy * parameters.gMotionToUv;
    vec2 _90 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-_88);
    vec3 _104 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _109 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _114 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _119 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _124 = clamp(textureLod(gInColour, _80, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _129 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _134 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _139 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _144 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _149 = max(-parameters.gJitterPx.x, 0.0);
    float _151 = 1.0 - abs(parameters.gJitterPx.x);
    float _152 = max(parameters.gJitterPx.x, 0.0);
    vec3 _178 = (((((_104 * _149) + (_109 * _151)) + (_114 * _152)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_119 * _149) + (_124 * _151)) + (_129 * _152)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_134 * _149) + (_139 * _151)) + (_144 * _152)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _179 = floatBitsToInt(_119);
    ivec3 _180 = floatBitsToInt(_129);
    ivec3 _182 = floatBitsToInt(_124);
    ivec3 _185 = floatBitsToInt(intBitsToFloat(min(min(_179, _180), _182)));
    ivec3 _186 = floatBitsToInt(_109);
    ivec3 _188 = floatBitsToInt(_139);
    ivec3 _194 = floatBitsToInt(intBitsToFloat(max(max(_179, _180), _182)));
    ivec3 _198 = floatBitsToInt(_104);
    ivec3 _199 = floatBitsToInt(_114);
    ivec3 _203 = floatBitsToInt(_134);
    ivec3 _204 = floatBitsToInt(_144);
    vec3 _224 = intBitsToFloat(min(min(_185, _186), _188)) + intBitsToFloat(min(min(_185, floatBitsToInt(intBitsToFloat(min(min(_198, _199), _186)))), floatBitsToInt(intBitsToFloat(min(min(_203, _204), _188)))));
    vec3 _225 = intBitsToFloat(max(max(_194, _186), _188)) + intBitsToFloat(max(max(_194, floatBitsToInt(intBitsToFloat(max(max(_198, _199), _186)))), floatBitsToInt(intBitsToFloat(max(max(_203, _204), _188)))));
    vec3 _226 = _225 + _224;
    vec3 _228 = max(_225 - _224, vec3(6.1035156963262782170431819395162e-12));
    vec3 _230 = (clamp(textureLod(gHistoryColour, _90, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _226;
    vec3 _233 = _228 / max(abs(_230), _228);
    vec3 _256 = min((_178 + ((((_226 + (_230 * min(_233.x, min(_233.y, _233.z)))) * 0.25) - _178) * (all(lessThanEqual(abs(_90 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _272 = gl_FragCoord.xy * parameters.gOutputSize.zw + (parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _275 = _88 * 0.083333335816860198974609375;
    vec4 _277 = textureLod(gInColourFiltered, _272, 0.0);
    float _278 = _277.x;
    float _281 = _277.y;
    float _284 = _277.z;
    vec2 _290 = _275 * 1.0;
    vec4 _292 = textureLod(gInColourFiltered, _272 + _290, 0.0);
    float _293 = _292.x;
    float _296 = _292.y;
    float _299 = _292.z;
    vec4 _307 = textureLod(gInColourFiltered, _272 - _290, 0.0);
    float _308 = _307.x;
    float _311 = _307.y;
    float _314 = _307.z;
    vec2 _321 = _275 * 2.0;
    vec4 _323 = textureLod(gInColourFiltered, _272 + _321, 0.0);
    float _324 = _323.x;
    float _327 = _323.y;
    float _330 = _323.z;
    vec4 _338 = textureLod(gInColourFiltered, _272 - _321, 0.0);
    float _339 = _338.x;
    float _342 = _338.y;
    float _345 = _338.z;
    vec2 _352 = _275 * 3.0;
    vec4 _354 = textureLod(gInColourFiltered, _272 + _352, 0.0);
    float _355 = _354.x;
    float _358 = _354.y;
    float _361 = _354.z;
    vec4 _369 = textureLod(gInColourFiltered, _272 - _352, 0.0);
    float _370 = _369.x;
    float _373 = _369.y;
    float _376 = _369.z;
    vec3 _381 = (((((min(vec3((_278 > 0.0) ? _278 : 0.0, (_281 > 0.0) ? _281 : 0.0, (_284 > 0.0) ? _284 : 0.0), vec3(65504.0)) + min(vec3((_293 > 0.0) ? _293 : 0.0, (_296 > 0.0) ? _296 : 0.0, (_299 > 0.0) ? _299 : 0.0), vec3(65504.0))) + min(vec3((_308 > 0.0) ? _308 : 0.0, (_311 > 0.0) ? _311 : 0.0, (_314 > 0.0) ? _314 : 0.0), vec3(65504.0))) + min(vec3((_324 > 0.0) ? _324 : 0.0, (_327 > 0.0) ? _327 : 0.0, (_330 > 0.0) ? _330 : 0.0), vec3(65504.0))) + min(vec3((_339 > 0.0) ? _339 : 0.0, (_342 > 0.0) ? _342 : 0.0, (_345 > 0.0) ? _345 : 0.0), vec3(65504.0))) + min(vec3((_355 > 0.0) ? _355 : 0.0, (_358 > 0.0) ? _358 : 0.0, (_361 > 0.0) ? _361 : 0.0), vec3(65504.0))) + min(vec3((_370 > 0.0) ? _370 : 0.0, (_373 > 0.0) ? _373 : 0.0, (_376 > 0.0) ? _376 : 0.0), vec3(65504.0));
    vec3 _385 = mix(min(_381 * vec3(0.14285714924335479736328125), vec3(65504.0)), _256, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_88 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_256, 1.0);
    gOutColour = vec4(_385, 1.0);
}

