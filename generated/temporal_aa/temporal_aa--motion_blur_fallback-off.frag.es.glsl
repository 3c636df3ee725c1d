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
    mat4 gReprojection;
} parameters;

uniform highp sampler2D gInDepth;
uniform highp sampler2D gInVelocity;
uniform highp sampler2D gHistoryColour;
uniform highp sampler2D gInColour;

layout(location = 0) out vec4 gOutHistory;

void main()
{
    vec2 _73 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _77 = textureLodOffset(gInDepth, _73, 0.0, ivec2(-1));
    float _78 = _77.x;
    vec4 _80 = textureLodOffset(gInDepth, _73, 0.0, ivec2(0, -1));
    float _81 = _80.x;
    vec4 _83 = textureLodOffset(gInDepth, _73, 0.0, ivec2(1, -1));
    float _84 = _83.x;
    vec4 _86 = textureLodOffset(gInDepth, _73, 0.0, ivec2(-1, 0));
    float _87 = _86.x;
    vec4 _89 = textureLod(gInDepth, _73, 0.0);
    float _90 = _89.x;
    vec4 _92 = textureLodOffset(gInDepth, _73, 0.0, ivec2(1, 0));
    float _93 = _92.x;
    vec4 _95 = textureLodOffset(gInDepth, _73, 0.0, ivec2(-1, 1));
    float _96 = _95.x;
    vec4 _98 = textureLodOffset(gInDepth, _73, 0.0, ivec2(0, 1));
    float _99 = _98.x;
    vec4 _101 = textureLodOffset(gInDepth, _73, 0.0, ivec2(1));
    float _102 = _101.x;
    vec2 _104 = vec2(_93, 1.0);
    vec2 _105 = vec2(_87, -1.0);
    bvec2 _106 = bvec2(_93 < _87);
    vec2 _107 = vec2(_106.x ? _104.x : _105.x, _106.y ? _104.y : _105.y);
    vec2 _110 = vec2(_90, 0.0);
    bvec2 _111 = bvec2(_107.x < _90);
    vec2 _112 = vec2(_111.x ? _107.x : _110.x, _111.y ? _107.y : _110.y);
    vec2 _114 = vec2(_84, 1.0);
    vec2 _115 = vec2(_78, -1.0);
    bvec2 _116 = bvec2(_84 < _78);
    vec2 _117 = vec2(_116.x ? _114.x : _115.x, _116.y ? _114.y : _115.y);
    vec2 _120 = vec2(_81, 0.0);
    bvec2 _121 = bvec2(_117.x < _81);
    vec2 _122 = vec2(_121.x ? _117.x : _120.x, _121.y ? _117.y : _120.y);
    vec2 _124 = vec2(_102, 1.0);
    vec2 _125 = vec2(_96, -1.0);
    bvec2 _126 = bvec2(_102 < _96);
    vec2 _127 = vec2(_126.x ? _124.x : _125.x, _126.y ? _124.y : _125.y);
    vec2 _130 = vec2(_99, 0.0);
    bvec2 _131 = bvec2(_127.x < _99);
    vec2 _132 = vec2(_131.x ? _127.x : _130.x, _131.y ? _127.y : _130.y);
    bool _135 = _132.x < _122.x;
    bvec2 _136 = bvec2(_135);
    vec2 _137 = vec2(_136.x ? _132.x : _122.x, _136.y ? _132.y : _122.y);
    vec2 _143 = vec2(_137.y, _135 ? 1.0 : (-1.0));
    vec2 _145 = vec2(_112.y, 0.0);
    bvec2 _146 = bvec2(_137.x < _112.x);
    vec2 _159 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-(textureLod(gInVelocity, gl_FragCoord.xy * parameters.gOutputSize.zw + (vec2(_146.x ? _143.x : _145.x, _146.y ? _143.y : _145.y) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec3 _173 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _178 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _183 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _188 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _193 = clamp(textureLod(gInColour, _73, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _198 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _203 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _208 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _213 = clamp(textureLodOffset(gInColour, _73, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _218 = max(-parameters.gJitterPx.x, 0.0);
    float _220 = 1.0 - abs(parameters.gJitterPx.x);
    float _221 = max(parameters.gJitterPx.x, 0.0);
    vec3 _247 = (((((_173 * _218) + (_178 * _220)) + (_183 * _221)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_188 * _218) + (_193 * _220)) + (_198 * _221)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_203 * _218) + (_208 * _220)) + (_213 * _221)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _248 = floatBitsToInt(_188);
    ivec3 _249 = floatBitsToInt(_198);
    ivec3 _251 = floatBitsToInt(_193);
    ivec3 _254 = floatBitsToInt(intBitsToFloat(min(min(_248, _249), _251)));
    ivec3 _255 = floatBitsToInt(_178);
    ivec3 _257 = floatBitsToInt(_208);
    ivec3 _263 = floatBitsToInt(intBitsToFloat(max(max(_248, _249), _251)));
    ivec3 _267 = floatBitsToInt(_173);
    ivec3 _268 = floatBitsToInt(_183);
    ivec3 _272 = floatBitsToInt(_203);
    ivec3 _273 = floatBitsToInt(_213);
    vec3 _293 = intBitsToFloat(min(min(_254, _255), _257)) + intBitsToFloat(min(min(_254, floatBitsToInt(intBitsToFloat(min(min(_267, _268), _255)))), floatBitsToInt(intBitsToFloat(min(min(_272, _273), _257)))));
    vec3 _294 = intBitsToFloat(max(max(_263, _255), _257)) + intBitsToFloat(max(max(_263, floatBitsToInt(intBitsToFloat(max(max(_267, _268), _255)))), floatBitsToInt(intBitsToFloat(max(max(_272, _273), _257)))));
    vec3 _295 = _294 + _293;
    vec3 _297 = max(_294 - _293, vec3(6.1035156963262782170431819395162e-12));
    vec3 _299 = (clamp(textureLod(gHistoryColour, _159, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _295;
    vec3 _302 = _297 / max(abs(_299), _297);
    gOutHistory = vec4(min((_247 + ((((_295 + (_299 * min(_302.x, min(_302.y, _302.z)))) * 0.25) - _247) * (all(lessThanEqual(abs(_159 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0)), 1.0);
}

