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
    vec2 _78 = (fract(floor(gl_FragCoord.xy) * 0.5) * 4.0) - vec2(1.0);
    vec4 _85 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, (_78 * 0.5) * parameters.gOutputSize.zw));
    float _86 = _78.x;
    vec4 _90 = mix(_85.yxwz, _85, bvec4(_86 > 0.0));
    float _91 = _78.y;
    vec4 _95 = mix(_90.wzyx, _90, bvec4(_91 > 0.0));
    vec3 _96 = _95.wxx;
    vec3 _99 = _96 - (dFdxFine(_96) * _86);
    float _100 = _95.w;
    float _101 = _95.z;
    float _102 = _99.x;
    vec3 _103 = vec3(_100, _101, _102);
    vec3 _106 = _103 - (dFdyFine(_103) * _91);
    float _107 = _99.y;
    float _108 = _95.x;
    float _109 = _95.y;
    float _110 = _106.z;
    float _111 = _106.x;
    float _112 = _106.y;
    vec2 _113 = _78 * parameters.gOutputSize.zw;
    float _114 = _113.x;
    float _117 = -_114;
    vec2 _120 = mix(vec2(_102, _117), vec2(_101, _114), bvec2(_101 < _102));
    vec2 _125 = mix(vec2(_100, 0.0), _120, bvec2(_120.x < _100));
    vec2 _130 = mix(vec2(_110, _117), vec2(_112, _114), bvec2(_112 < _110));
    vec2 _135 = mix(vec2(_111, 0.0), _130, bvec2(_130.x < _111));
    vec2 _140 = mix(vec2(_107, _117), vec2(_109, _114), bvec2(_109 < _107));
    vec2 _145 = mix(vec2(_108, 0.0), _140, bvec2(_140.x < _108));
    bool _148 = _145.x < _135.x;
    vec2 _150 = mix(_135, _145, bvec2(_148));
    float _151 = _113.y;
    vec2 _173 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_125.y, 0.0), vec2(_150.y, _148 ? _151 : (-_151)), bvec2(_150.x < _125.x))), 0.0).xy * parameters.gMotionToUv));
    ivec2 _183 = ivec2(parameters.gOutputSize.xy) - ivec2(1);
    ivec2 _185 = ivec2((gl_FragCoord.xy * parameters.gOutputSize.zw) * parameters.gOutputSize.xy);
    ivec2 _186 = min(_185, _183);
    ivec2 _189 = clamp(_185 + ivec2(_78), ivec2(0), _183);
    int _190 = _186.x;
    vec3 _198 = clamp(texelFetch(gInColour, ivec3(_190, _186.y, 0).xy, 0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    int _199 = _189.x;
    vec3 _205 = clamp(texelFetch(gInColour, ivec3(_199, _186.y, 0).xy, 0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _212 = clamp(texelFetch(gInColour, ivec3(_190, _189.y, 0).xy, 0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _227 = _198 - (dFdyFine(_198) * _91);
    ivec3 _234 = floatBitsToInt(_198 - (dFdxFine(_198) * _86));
    ivec3 _235 = floatBitsToInt(_205);
    ivec3 _237 = floatBitsToInt(_198);
    ivec3 _240 = floatBitsToInt(intBitsToFloat(min(min(_234, _235), _237)));
    ivec3 _241 = floatBitsToInt(_227);
    ivec3 _243 = floatBitsToInt(_212);
    ivec3 _249 = floatBitsToInt(intBitsToFloat(max(max(_234, _235), _237)));
    ivec3 _253 = floatBitsToInt(_227 - (dFdxFine(_227) * _86));
    ivec3 _254 = floatBitsToInt(_205 - (dFdyFine(_205) * _91));
    ivec3 _258 = floatBitsToInt(_212 - (dFdxFine(_212) * _86));
    ivec3 _259 = floatBitsToInt(clamp(texelFetch(gInColour, ivec3(_199, _189.y, 0).xy, 0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)));
    vec3 _279 = intBitsToFloat(min(min(_240, _241), _243)) + intBitsToFloat(min(min(_240, floatBitsToInt(intBitsToFloat(min(min(_253, _254), _241)))), floatBitsToInt(intBitsToFloat(min(min(_258, _259), _243)))));
    vec3 _280 = intBitsToFloat(max(max(_249, _241), _243)) + intBitsToFloat(max(max(_249, floatBitsToInt(intBitsToFloat(max(max(_253, _254), _241)))), floatBitsToInt(intBitsToFloat(max(max(_258, _259), _243)))));
    vec3 _281 = _280 + _279;
    vec3 _285 = (clamp(textureLod(gHistoryColour, _173, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * 4.0) - _281;
    vec3 _288 = clamp(max(_280 - _279, vec3(6.1064972523006133542367024347186e-12)) / abs(_285), vec3(0.0), vec3(1.0));
    vec3 _296 = (_281 + (_285 * min(_288.x, min(_288.y, _288.z)))) * 0.25;
    float _297 = dot(_198, vec3(13926.150390625, 46848.4609375, 4729.388671875));
    float _298 = dot(_296, vec3(13926.150390625, 46848.4609375, 4729.388671875));
    float _309 = clamp(1.0 - (abs(_297 - _298) / max(max(_297, _298), 0.20000000298023223876953125)), 0.0, 1.0);
    gOutHistory = vec4((_198 + ((_296 - _198) * (all(lessThanEqual(floatBitsToUint(_173), uvec2(1065353216u))) ? (mix(parameters.gFeedbackMin, parameters.gFeedbackMax, _309 * _309) * parameters.gHistoryValid) : 0.0))) * 65504.0, 1.0);
}

