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

uniform highp sampler2D gInDepth;
uniform highp sampler2D gInVelocity;
uniform highp sampler2D gHistoryColour;
uniform highp sampler2D gInColour;

layout(location = 0) out vec4 gOutHistory;

void main()
{
    vec2 _72 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _76 = textureLodOffset(gInDepth, _72, 0.0, ivec2(-1));
    float _77 = _76.x;
    vec4 _79 = textureLodOffset(gInDepth, _72, 0.0, ivec2(0, -1));
    float _80 = _79.x;
    vec4 _82 = textureLodOffset(gInDepth, _72, 0.0, ivec2(1, -1));
    float _83 = _82.x;
    vec4 _85 = textureLodOffset(gInDepth, _72, 0.0, ivec2(-1, 0));
    float _86 = _85.x;
    vec4 _88 = textureLod(gInDepth, _72, 0.0);
    float _89 = _88.x;
    vec4 _91 = textureLodOffset(gInDepth, _72, 0.0, ivec2(1, 0));
    float _92 = _91.x;
    vec4 _94 = textureLodOffset(gInDepth, _72, 0.0, ivec2(-1, 1));
    float _95 = _94.x;
    vec4 _97 = textureLodOffset(gInDepth, _72, 0.0, ivec2(0, 1));
    float _98 = _97.x;
    vec4 _100 = textureLodOffset(gInDepth, _72, 0.0, ivec2(1));
    float _101 = _100.x;
    vec2 _103 = vec2(_92, 1.0);
    vec2 _104 = vec2(_86, -1.0);
    bvec2 _105 = bvec2(_92 < _86);
    vec2 _106 = vec2(_105.x ? _103.x : _104.x, _105.y ? _103.y : _104.y);
    vec2 _109 = vec2(_89, 0.0);
    bvec2 _110 = bvec2(_106.x < _89);
    vec2 _111 = vec2(_110.x ? _106.x : _109.x, _110.y ? _106.y : _109.y);
    vec2 _113 = vec2(_83, 1.0);
    vec2 _114 = vec2(_77, -1.0);
    bvec2 _115 = bvec2(_83 < _77);
    vec2 _116 = vec2(_115.x ? _113.x : _114.x, _115.y ? _113.y : _114.y);
    vec2 _119 = vec2(_80, 0.0);
    bvec2 _120 = bvec2(_116.x < _80);
    vec2 _121 = vec2(_120.x ? _116.x : _119.x, _120.y ? _116.y : _119.y);
    vec2 _123 = vec2(_101, 1.0);
    vec2 _124 = vec2(_95, -1.0);
    bvec2 _125 = bvec2(_101 < _95);
    vec2 _126 = vec2(_125.x ? _123.x : _124.x, _125.y ? _123.y : _124.y);
    vec2 _129 = vec2(_98, 0.0);
    bvec2 _130 = bvec2(_126.x < _98);
    vec2 _131 = vec2(_130.x ? _126.x : _129.x, _130.y ? _126.y : _129.y);
    bool _134 = _131.x < _121.x;
    bvec2 _135 = bvec2(_134);
    vec2 _136 = vec2(_135.x ? _131.x : _121.x, _135.y ? _131.y : _121.y);
    vec2 _142 = vec2(_136.y, _134 ? 1.0 : (-1.0));
    vec2 _144 = vec2(_111.y, 0.0);
    bvec2 _145 = bvec2(_136.x < _111.x);
    vec2 _158 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-(textureLod(gInVelocity, gl_FragCoord.xy * parameters.gOutputSize.zw + (vec2(_145.x ? _142.x : _144.x, _145.y ? _142.y : _144.y) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec3 _172 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _177 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _182 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _187 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _192 = clamp(textureLod(gInColour, _72, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _197 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _202 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _207 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _212 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
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
    vec3 _292 = intBitsToFloat(min(min(_253, _254), _256)) + intBitsToFloat(min(min(_253, floatBitsToInt(intBitsToFloat(min(min(_266, _267), _254)))), floatBitsToInt(intBitsToFloat(min(min(_271, _272), _256)))));
    vec3 _293 = intBitsToFloat(max(max(_262, _254), _256)) + intBitsToFloat(max(max(_262, floatBitsToInt(intBitsToFloat(max(max(_266, _267), _254)))), floatBitsToInt(intBitsToFloat(max(max(_271, _272), _256)))));
    vec3 _294 = _293 + _292;
    vec3 _296 = max(_293 - _292, vec3(6.1035156963262782170431819395162e-12));
    vec3 _298 = (clamp(textureLod(gHistoryColour, _158, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _294;
    vec3 _301 = _296 / max(abs(_298), _296);
    gOutHistory = vec4(min((_246 + ((((_294 + (_298 * min(_301.x, min(_301.y, _301.z)))) * 0.25) - _246) * (all(lessThanEqual(abs(_158 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0)), 1.0);
}

