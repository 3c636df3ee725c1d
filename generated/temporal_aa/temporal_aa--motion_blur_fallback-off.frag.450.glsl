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
    vec2 _72 = gl_FragCoord.xy * parameters.gOutputSize.zw;
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
    vec2 _160 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_113.y, 0.0), vec2(_138.y, _136 ? 1.0 : (-1.0)), bvec2(_138.x < _113.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec3 _174 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _179 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _184 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _189 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _194 = clamp(textureLod(gInColour, _72, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _199 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _204 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _209 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _214 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _219 = max(-parameters.gJitterPx.x, 0.0);
    float _221 = 1.0 - abs(parameters.gJitterPx.x);
    float _222 = max(parameters.gJitterPx.x, 0.0);
    vec3 _248 = (((((_174 * _219) + (_179 * _221)) + (_184 * _222)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_189 * _219) + (_194 * _221)) + (_199 * _222)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_204 * _219) + (_209 * _221)) + (_214 * _222)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _249 = floatBitsToInt(_189);
    ivec3 _250 = floatBitsToInt(_199);
    ivec3 _252 = floatBitsToInt(_194);
    ivec3 _255 = floatBitsToInt(intBitsToFloat(min(min(_249, _250), _252)));
    ivec3 _256 = floatBitsToInt(_179);
    ivec3 _258 = floatBitsToInt(_209);
    ivec3 _264 = floatBitsToInt(intBitsToFloat(max(max(_249, _250), _252)));
    ivec3 _268 = floatBitsToInt(_174);
    ivec3 _269 = floatBitsToInt(_184);
    ivec3 _273 = floatBitsToInt(_204);
    ivec3 _274 = floatBitsToInt(_214);
    vec3 _294 = intBitsToFloat(min(min(_255, _256), _258)) + intBitsToFloat(min(min(_255, floatBitsToInt(intBitsToFloat(min(min(_268, _269), _256)))), floatBitsToInt(intBitsToFloat(min(min(_273, _274), _258)))));
    vec3 _295 = intBitsToFloat(max(max(_264, _256), _258)) + intBitsToFloat(max(max(_264, floatBitsToInt(intBitsToFloat(max(max(_268, _269), _256)))), floatBitsToInt(intBitsToFloat(max(max(_273, _274), _258)))));
    vec3 _296 = _295 + _294;
    vec3 _298 = max(_295 - _294, vec3(6.1035156963262782170431819395162e-12));
    vec3 _300 = (clamp(textureLod(gHistoryColour, _160, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _296;
    vec3 _303 = _298 / max(abs(_300), _298);
    gOutHistory = vec4(min((_248 + ((((_296 + (_300 * min(_303.x, min(_303.y, _303.z)))) * 0.25) - _248) * (all(lessThanEqual(abs(_160 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0)), 1.0);
}

