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
    vec2 _104 = vec2(_92, parameters.gOutputSize.z);
    float _105 = -parameters.gOutputSize.z;
    vec2 _106 = vec2(_86, _105);
    bvec2 _107 = bvec2(_92 < _86);
    vec2 _108 = vec2(_107.x ? _104.x : _106.x, _107.y ? _104.y : _106.y);
    vec2 _111 = vec2(_89, 0.0);
    bvec2 _112 = bvec2(_108.x < _89);
    vec2 _113 = vec2(_112.x ? _108.x : _111.x, _112.y ? _108.y : _111.y);
    vec2 _115 = vec2(_83, parameters.gOutputSize.z);
    vec2 _116 = vec2(_77, _105);
    bvec2 _117 = bvec2(_83 < _77);
    vec2 _118 = vec2(_117.x ? _115.x : _116.x, _117.y ? _115.y : _116.y);
    vec2 _121 = vec2(_80, 0.0);
    bvec2 _122 = bvec2(_118.x < _80);
    vec2 _123 = vec2(_122.x ? _118.x : _121.x, _122.y ? _118.y : _121.y);
    vec2 _125 = vec2(_101, parameters.gOutputSize.z);
    vec2 _126 = vec2(_95, _105);
    bvec2 _127 = bvec2(_101 < _95);
    vec2 _128 = vec2(_127.x ? _125.x : _126.x, _127.y ? _125.y : _126.y);
    vec2 _131 = vec2(_98, 0.0);
    bvec2 _132 = bvec2(_128.x < _98);
    vec2 _133 = vec2(_132.x ? _128.x : _131.x, _132.y ? _128.y : _131.y);
    bool _136 = _133.x < _123.x;
    bvec2 _137 = bvec2(_136);
    vec2 _138 = vec2(_137.x ? _133.x : _123.x, _137.y ? _133.y : _123.y);
    vec2 _146 = vec2(_138.y, _136 ? parameters.gOutputSize.w : (-parameters.gOutputSize.w));
    vec2 _148 = vec2(_113.y, 0.0);
    bvec2 _149 = bvec2(_138.x < _113.x);
    vec2 _161 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-(textureLod(gInVelocity, gl_FragCoord.xy * parameters.gOutputSize.zw + vec2(_149.x ? _146.x : _148.x, _149.y ? _146.y : _148.y), 0.0).xy * parameters.gMotionToUv));
    vec3 _175 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(-1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _180 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(0, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _185 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(1, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _190 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(-1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _195 = clamp(textureLod(gInColour, _72, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _200 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _205 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(-1, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _210 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(0, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _215 = clamp(textureLodOffset(gInColour, _72, 0.0, ivec2(1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
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
    vec3 _301 = (clamp(textureLod(gHistoryColour, _161, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * 4.0) - _297;
    vec3 _304 = clamp(max(_296 - _295, vec3(6.1064972523006133542367024347186e-12)) / abs(_301), vec3(0.0), vec3(1.0));
    gOutHistory = vec4((_249 + ((((_297 + (_301 * min(_304.x, min(_304.y, _304.z)))) * 0.25) - _249) * (all(lessThanEqual(floatBitsToUint(_161), uvec2(1065353216u))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65504.0, 1.0);
}

