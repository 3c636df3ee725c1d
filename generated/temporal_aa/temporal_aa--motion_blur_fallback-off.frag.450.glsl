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
    vec2 _70 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _73 = parameters.gOutputSize.zw * 0.5;
    vec4 _77 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_73));
    float _79 = _73.x;
    float _80 = _73.y;
    vec4 _84 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_79, -_80)));
    vec4 _89 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_79, _80)));
    vec4 _92 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _73));
    float _93 = _77.w;
    float _94 = _77.z;
    float _95 = _77.x;
    float _96 = _77.y;
    float _97 = _84.z;
    float _98 = _84.y;
    float _99 = _89.x;
    float _100 = _89.y;
    float _101 = _92.y;
    vec2 _106 = mix(vec2(_95, -1.0), vec2(_98, 1.0), bvec2(_98 < _95));
    vec2 _111 = mix(vec2(_96, 0.0), _106, bvec2(_106.x < _96));
    vec2 _116 = mix(vec2(_93, -1.0), vec2(_97, 1.0), bvec2(_97 < _93));
    vec2 _121 = mix(vec2(_94, 0.0), _116, bvec2(_116.x < _94));
    vec2 _126 = mix(vec2(_99, -1.0), vec2(_101, 1.0), bvec2(_101 < _99));
    vec2 _131 = mix(vec2(_100, 0.0), _126, bvec2(_126.x < _100));
    bool _134 = _131.x < _121.x;
    vec2 _136 = mix(_121, _131, bvec2(_134));
    vec2 _158 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_111.y, 0.0), vec2(_136.y, _134 ? 1.0 : (-1.0)), bvec2(_136.x < _111.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec3 _172 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _177 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _182 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _187 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _192 = clamp(textureLod(gInColour, _70, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _197 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _202 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _207 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _212 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _217 = max(-parameters.gJitterPx.x, 0.0);
    float _219 = 1.0 - abs(parameters.gJitterPx.x);
    float _220 = max(parameters.gJitterPx.x, 0.0);
    vec3 _246 = (((((_172 * _217) + (_177 * _219)) + (_182 * _220)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_187 * _217) + (_192 * _219)) + (_197 * _220)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_202 * _217) + (_207 * _219)) + (_212 * _220)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _247 = floatBitsToInt(_187);
    ivec3 _248 = floatBitsToInt(_197);
    ivec3 _250 = floatBitsToInt(_192);
    ivec3 _253 = floatBitsToInt(intBitsToFloat(min(min(_247, _248), _250)));
    ivec3 _254 = floatBitsToInt(_177);
    ivec3 _256 = floatBitsToInt(_207);
    ivec3 _262 = floatBitsToInt(intBitsToFloat(max(max(_247, _248), _250)));
    ivec3 _266 = floatBitsToInt(_172);
    ivec3 _267 = floatBitsToInt(_182);
    ivec3 _271 = floatBitsToInt(_202);
    ivec3 _272 = floatBitsToInt(_212);
    vec3 _296 = ((intBitsToFloat(max(max(_262, _254), _256)) + intBitsToFloat(max(max(_262, floatBitsToInt(intBitsToFloat(max(max(_266, _267), _254)))), floatBitsToInt(intBitsToFloat(max(max(_271, _272), _256)))))) * 0.5) * 0.5;
    vec3 _297 = ((intBitsToFloat(min(min(_253, _254), _256)) + intBitsToFloat(min(min(_253, floatBitsToInt(intBitsToFloat(min(min(_266, _267), _254)))), floatBitsToInt(intBitsToFloat(min(min(_271, _272), _256)))))) * 0.5) * 0.5;
    vec3 _298 = _296 + _297;
    vec3 _300 = max(_296 - _297, vec3(1.5258789240815695542607954848791e-12));
    vec3 _301 = clamp(textureLod(gHistoryColour, _158, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _298;
    vec3 _304 = _300 / max(abs(_301), _300);
    gOutHistory = vec4(min((_246 + (((_298 + (_301 * min(_304.x, min(_304.y, _304.z)))) - _246) * (all(lessThanEqual(abs(_158 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0)), 1.0);
}

