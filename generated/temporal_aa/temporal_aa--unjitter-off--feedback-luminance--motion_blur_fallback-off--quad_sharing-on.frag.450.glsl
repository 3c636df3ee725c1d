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

layout(location = 0) out vec4 gOutHistory;

void main()
{
    vec2 _75 = (fract(floor(gl_FragCoord.xy) * 0.5) * 4.0) - vec2(1.0);
    vec4 _82 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, (_75 * 0.5) * parameters.gOutputSize.zw));
    float _83 = _75.x;
    vec4 _87 = mix(_82.yxwz, _82, bvec4(_83 > 0.0));
    float _88 = _75.y;
    vec4 _92 = mix(_87.wzyx, _87, bvec4(_88 > 0.0));
    vec3 _93 = _92.wxx;
    vec3 _96 = _93 - (dFdxFine(_93) * _83);
    float _97 = _92.w;
    float _98 = _92.z;
    float _99 = _96.x;
    vec3 _100 = vec3(_97, _98, _99);
    vec3 _103 = _100 - (dFdyFine(_100) * _88);
    float _104 = _96.y;
    float _105 = _92.x;
    float _106 = _92.y;
    float _107 = _103.z;
    float _108 = _103.x;
    float _109 = _103.y;
    vec2 _114 = mix(vec2(_99, -1.0), vec2(_98, 1.0), bvec2(_98 < _99));
    vec2 _119 = mix(vec2(_97, 0.0), _114, bvec2(_114.x < _97));
    vec2 _124 = mix(vec2(_107, -1.0), vec2(_109, 1.0), bvec2(_109 < _107));
    vec2 _129 = mix(vec2(_108, 0.0), _124, bvec2(_124.x < _108));
    vec2 _134 = mix(vec2(_104, -1.0), vec2(_106, 1.0), bvec2(_106 < _104));
    vec2 _139 = mix(vec2(_105, 0.0), _134, bvec2(_134.x < _105));
    bool _142 = _139.x < _129.x;
    vec2 _144 = mix(_129, _139, bvec2(_142));
    vec2 _167 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, (mix(vec2(_119.y, 0.0), vec2(_144.y, _142 ? 1.0 : (-1.0)), bvec2(_144.x < _119.x)) * _75) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec2 _175 = _75 * parameters.gOutputSize.zw;
    vec3 _182 = clamp(textureLod(gInColour, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _190 = clamp(textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_175.x, 0.0)), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _198 = clamp(textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(0.0, _175.y)), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _213 = _182 - (dFdyFine(_182) * _88);
    ivec3 _220 = floatBitsToInt(_182 - (dFdxFine(_182) * _83));
    ivec3 _221 = floatBitsToInt(_190);
    ivec3 _223 = floatBitsToInt(_182);
    ivec3 _226 = floatBitsToInt(intBitsToFloat(min(min(_220, _221), _223)));
    ivec3 _227 = floatBitsToInt(_213);
    ivec3 _229 = floatBitsToInt(_198);
    ivec3 _235 = floatBitsToInt(intBitsToFloat(max(max(_220, _221), _223)));
    ivec3 _239 = floatBitsToInt(_213 - (dFdxFine(_213) * _83));
    ivec3 _240 = floatBitsToInt(_190 - (dFdyFine(_190) * _88));
    ivec3 _244 = floatBitsToInt(_198 - (dFdxFine(_198) * _83));
    ivec3 _245 = floatBitsToInt(clamp(textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _175), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    vec3 _265 = intBitsToFloat(min(min(_226, _227), _229)) + intBitsToFloat(min(min(_226, floatBitsToInt(intBitsToFloat(min(min(_239, _240), _227)))), floatBitsToInt(intBitsToFloat(min(min(_244, _245), _229)))));
    vec3 _266 = intBitsToFloat(max(max(_235, _227), _229)) + intBitsToFloat(max(max(_235, floatBitsToInt(intBitsToFloat(max(max(_239, _240), _227)))), floatBitsToInt(intBitsToFloat(max(max(_244, _245), _229)))));
    vec3 _267 = _266 + _265;
    vec3 _269 = max(_266 - _265, vec3(6.1035156963262782170431819395162e-12));
    vec3 _271 = (clamp(textureLod(gHistoryColour, _167, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _267;
    vec3 _274 = _269 / max(abs(_271), _269);
    vec3 _282 = (_267 + (_271 * min(_274.x, min(_274.y, _274.z)))) * 0.25;
    float _283 = dot(_182, vec3(13932.953125, 46871.34765625, 4731.69921875));
    float _284 = dot(_282, vec3(13932.953125, 46871.34765625, 4731.69921875));
    float _295 = max(1.0 - (abs(_283 - _284) / max(max(_283, _284), 0.20000000298023223876953125)), 0.0);
    gOutHistory = vec4(min((_182 + ((_282 - _182) * (all(lessThanEqual(abs(_167 - vec2(0.5)), vec2(0.5))) ? (mix(parameters.gFeedbackMin, parameters.gFeedbackMax, _295 * _295) * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0)), 1.0);
}

