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
    vec2 _73 = gl_FragCoord.xy * parameters.gOutputSize.zw;
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
    vec2 _161 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_114.y, 0.0), vec2(_139.y, _137 ? 1.0 : (-1.0)), bvec2(_139.x < _114.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec3 _175 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _180 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _185 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _190 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _195 = clamp(textureLod(gInColour, _73, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _200 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _205 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _210 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _215 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _220 = max(-parameters.gJitterPx.x, 0.0);
    float _222 = 1.0 - abs(parameters.gJitterPx.x);
    float _223 = max(parameters.gJitterPx.x, 0.0);
    vec3 _249 = (((((_175 * _220) + (_180 * _222)) + (_185 * _223)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_190 * _220) + (_195 * _222)) + (_200 * _223)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_205 * _220) + (_210 * _222)) + (_215 * _223)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _250 = floatBitsToInt(_190);
    ivec3 _251 = floatBitsToInt(_200);
    ivec3 _253 = floatBitsToInt(_195);
    ivec3 _256 = floatBitsToInt(intBitsToFloat(min(min(_250, _251), _253)));
    ivec3 _257 = floatBitsToInt(_180);
    ivec3 _259 = floatBitsToInt(_210);
    ivec3 _265 = floatBitsToInt(intBitsToFloat(max(max(_250, _251), _253)));
    ivec3 _269 = floatBitsToInt(_175);
    ivec3 _270 = floatBitsToInt(_185);
    ivec3 _274 = floatBitsToInt(_205);
    ivec3 _275 = floatBitsToInt(_215);
    vec3 _295 = intBitsToFloat(min(min(_256, _257), _259)) + intBitsToFloat(min(min(_256, floatBitsToInt(intBitsToFloat(min(min(_269, _270), _257)))), floatBitsToInt(intBitsToFloat(min(min(_274, _275), _259)))));
    vec3 _296 = intBitsToFloat(max(max(_265, _257), _259)) + intBitsToFloat(max(max(_265, floatBitsToInt(intBitsToFloat(max(max(_269, _270), _257)))), floatBitsToInt(intBitsToFloat(max(max(_274, _275), _259)))));
    vec3 _297 = _296 + _295;
    vec3 _299 = max(_296 - _295, vec3(6.1035156963262782170431819395162e-12));
    vec3 _301 = (clamp(textureLod(gHistoryColour, _161, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _297;
    vec3 _304 = _299 / max(abs(_301), _299);
    gOutHistory = vec4(min((_249 + ((((_297 + (_301 * min(_304.x, min(_304.y, _304.z)))) * 0.25) - _249) * (all(lessThanEqual(abs(_161 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0)), 1.0);
}

