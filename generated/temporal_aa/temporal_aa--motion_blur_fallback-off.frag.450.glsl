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
    float _108 = -parameters.gOutputSize.z;
    vec2 _111 = mix(vec2(_98, _108), vec2(_101, parameters.gOutputSize.z), bvec2(_101 < _98));
    vec2 _116 = mix(vec2(_99, 0.0), _111, bvec2(_111.x < _99));
    vec2 _121 = mix(vec2(_96, _108), vec2(_100, parameters.gOutputSize.z), bvec2(_100 < _96));
    vec2 _126 = mix(vec2(_97, 0.0), _121, bvec2(_121.x < _97));
    vec2 _131 = mix(vec2(_102, _108), vec2(_104, parameters.gOutputSize.z), bvec2(_104 < _102));
    vec2 _136 = mix(vec2(_103, 0.0), _131, bvec2(_131.x < _103));
    bool _139 = _136.x < _126.x;
    vec2 _141 = mix(_126, _136, bvec2(_139));
    vec2 _164 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_116.y, 0.0), vec2(_141.y, _139 ? parameters.gOutputSize.w : (-parameters.gOutputSize.w)), bvec2(_141.x < _116.x))), 0.0).xy * parameters.gMotionToUv));
    vec3 _178 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(-1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _183 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(0, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _188 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(1, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _193 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(-1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _198 = clamp(textureLod(gInColour, _73, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _203 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _208 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(-1, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _213 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(0, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _218 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    float _223 = max(-parameters.gJitterPx.x, 0.0);
    float _225 = 1.0 - abs(parameters.gJitterPx.x);
    float _226 = max(parameters.gJitterPx.x, 0.0);
    vec3 _252 = (((((_178 * _223) + (_183 * _225)) + (_188 * _226)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_193 * _223) + (_198 * _225)) + (_203 * _226)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_208 * _223) + (_213 * _225)) + (_218 * _226)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _253 = floatBitsToInt(_193);
    ivec3 _254 = floatBitsToInt(_203);
    ivec3 _256 = floatBitsToInt(_198);
    ivec3 _259 = floatBitsToInt(intBitsToFloat(min(min(_253, _254), _256)));
    ivec3 _260 = floatBitsToInt(_183);
    ivec3 _262 = floatBitsToInt(_213);
    ivec3 _268 = floatBitsToInt(intBitsToFloat(max(max(_253, _254), _256)));
    ivec3 _272 = floatBitsToInt(_178);
    ivec3 _273 = floatBitsToInt(_188);
    ivec3 _277 = floatBitsToInt(_208);
    ivec3 _278 = floatBitsToInt(_218);
    vec3 _298 = intBitsToFloat(min(min(_259, _260), _262)) + intBitsToFloat(min(min(_259, floatBitsToInt(intBitsToFloat(min(min(_272, _273), _260)))), floatBitsToInt(intBitsToFloat(min(min(_277, _278), _262)))));
    vec3 _299 = intBitsToFloat(max(max(_268, _260), _262)) + intBitsToFloat(max(max(_268, floatBitsToInt(intBitsToFloat(max(max(_272, _273), _260)))), floatBitsToInt(intBitsToFloat(max(max(_277, _278), _262)))));
    vec3 _300 = _299 + _298;
    vec3 _304 = (clamp(textureLod(gHistoryColour, _164, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * 4.0) - _300;
    vec3 _307 = clamp(max(_299 - _298, vec3(6.1064972523006133542367024347186e-12)) / abs(_304), vec3(0.0), vec3(1.0));
    gOutHistory = vec4((_252 + ((((_300 + (_304 * min(_307.x, min(_307.y, _307.z)))) * 0.25) - _252) * (all(lessThanEqual(floatBitsToUint(_164), uvec2(1065353216u))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65504.0, 1.0);
}

