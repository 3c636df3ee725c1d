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

layout(location = 0) out vec4 gOutHistory;

void main()
{
    vec2 _74 = (fract(floor(gl_FragCoord.xy) * 0.5) * 4.0) - vec2(1.0);
    vec4 _81 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, (_74 * 0.5) * parameters.gOutputSize.zw));
    float _82 = _74.x;
    vec4 _86 = mix(_81.yxwz, _81, bvec4(_82 > 0.0));
    float _87 = _74.y;
    vec4 _91 = mix(_86.wzyx, _86, bvec4(_87 > 0.0));
    vec3 _92 = _91.wxx;
    vec3 _95 = _92 - (dFdxFine(_92) * _82);
    float _96 = _91.w;
    float _97 = _91.z;
    float _98 = _95.x;
    vec3 _99 = vec3(_96, _97, _98);
    vec3 _102 = _99 - (dFdyFine(_99) * _87);
    float _103 = _91.x;
    float _104 = _91.y;
    float _105 = _95.y;
    float _106 = _102.x;
    float _107 = _102.y;
    float _108 = _102.z;
    vec2 _113 = mix(vec2(_98, -1.0), vec2(_97, 1.0), bvec2(_97 < _98));
    vec2 _118 = mix(vec2(_96, 0.0), _113, bvec2(_113.x < _96));
    vec2 _123 = mix(vec2(_108, -1.0), vec2(_107, 1.0), bvec2(_107 < _108));
    vec2 _128 = mix(vec2(_106, 0.0), _123, bvec2(_123.x < _106));
    vec2 _133 = mix(vec2(_105, -1.0), vec2(_104, 1.0), bvec2(_104 < _105));
    vec2 _138 = mix(vec2(_103, 0.0), _133, bvec2(_133.x < _103));
    bool _141 = _138.x < _128.x;
    vec2 _143 = mix(_128, _138, bvec2(_141));
    vec2 _166 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, (mix(vec2(_118.y, 0.0), vec2(_143.y, _141 ? 1.0 : (-1.0)), bvec2(_143.x < _118.x)) * _74) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec2 _174 = _74 * parameters.gOutputSize.zw;
    vec3 _181 = clamp(textureLod(gInColour, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _189 = clamp(textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_174.x, 0.0)), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _197 = clamp(textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(0.0, _174.y)), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _212 = _181 - (dFdyFine(_181) * _87);
    ivec3 _219 = floatBitsToInt(_181 - (dFdxFine(_181) * _82));
    ivec3 _220 = floatBitsToInt(_189);
    ivec3 _222 = floatBitsToInt(_181);
    ivec3 _225 = floatBitsToInt(intBitsToFloat(min(min(_219, _220), _222)));
    ivec3 _226 = floatBitsToInt(_212);
    ivec3 _228 = floatBitsToInt(_197);
    ivec3 _234 = floatBitsToInt(intBitsToFloat(max(max(_219, _220), _222)));
    ivec3 _238 = floatBitsToInt(_212 - (dFdxFine(_212) * _82));
    ivec3 _239 = floatBitsToInt(_189 - (dFdyFine(_189) * _87));
    ivec3 _243 = floatBitsToInt(_197 - (dFdxFine(_197) * _82));
    ivec3 _244 = floatBitsToInt(clamp(textureLod(gInColour, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _174), 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    vec3 _268 = ((intBitsToFloat(max(max(_234, _226), _228)) + intBitsToFloat(max(max(_234, floatBitsToInt(intBitsToFloat(max(max(_238, _239), _226)))), floatBitsToInt(intBitsToFloat(max(max(_243, _244), _228)))))) * 0.5) * 0.5;
    vec3 _269 = ((intBitsToFloat(min(min(_225, _226), _228)) + intBitsToFloat(min(min(_225, floatBitsToInt(intBitsToFloat(min(min(_238, _239), _226)))), floatBitsToInt(intBitsToFloat(min(min(_243, _244), _228)))))) * 0.5) * 0.5;
    vec3 _270 = _268 + _269;
    vec3 _272 = max(_268 - _269, vec3(1.5258789240815695542607954848791e-12));
    vec3 _273 = clamp(textureLod(gHistoryColour, _166, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _270;
    vec3 _276 = _272 / max(abs(_273), _272);
    vec3 _283 = _270 + (_273 * min(_276.x, min(_276.y, _276.z)));
    float _284 = dot(_181, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
    float _286 = dot(_283, vec3(0.2125999927520751953125, 0.715200006961822509765625, 0.072200000286102294921875));
    float _299 = max(1.0 - (abs(fma(_284, 65536.0, _286 * (-65536.0))) / max(max(_284 * 65536.0, _286 * 65536.0), 0.20000000298023223876953125)), 0.0);
    gOutHistory = vec4(min((_181 + ((_283 - _181) * (all(lessThanEqual(abs(_166 - vec2(0.5)), vec2(0.5))) ? (mix(parameters.gFeedbackMin, parameters.gFeedbackMax, _299 * _299) * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0)), 1.0);
}

