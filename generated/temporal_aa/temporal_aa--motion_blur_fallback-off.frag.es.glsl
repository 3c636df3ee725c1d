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
    vec2 _70 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _74 = textureLodOffset(gInDepth, _70, 0.0, ivec2(-1));
    float _75 = _74.x;
    vec4 _77 = textureLodOffset(gInDepth, _70, 0.0, ivec2(0, -1));
    float _78 = _77.x;
    vec4 _80 = textureLodOffset(gInDepth, _70, 0.0, ivec2(1, -1));
    float _81 = _80.x;
    vec4 _83 = textureLodOffset(gInDepth, _70, 0.0, ivec2(-1, 0));
    float _84 = _83.x;
    vec4 _86 = textureLod(gInDepth, _70, 0.0);
    float _87 = _86.x;
    vec4 _89 = textureLodOffset(gInDepth, _70, 0.0, ivec2(1, 0));
    float _90 = _89.x;
    vec4 _92 = textureLodOffset(gInDepth, _70, 0.0, ivec2(-1, 1));
    float _93 = _92.x;
    vec4 _95 = textureLodOffset(gInDepth, _70, 0.0, ivec2(0, 1));
    float _96 = _95.x;
    vec4 _98 = textureLodOffset(gInDepth, _70, 0.0, ivec2(1));
    float _99 = _98.x;
    vec2 _101 = vec2(_90, 1.0);
    vec2 _102 = vec2(_84, -1.0);
    bvec2 _103 = bvec2(_90 < _84);
    vec2 _104 = vec2(_103.x ? _101.x : _102.x, _103.y ? _101.y : _102.y);
    vec2 _107 = vec2(_87, 0.0);
    bvec2 _108 = bvec2(_104.x < _87);
    vec2 _109 = vec2(_108.x ? _104.x : _107.x, _108.y ? _104.y : _107.y);
    vec2 _111 = vec2(_81, 1.0);
    vec2 _112 = vec2(_75, -1.0);
    bvec2 _113 = bvec2(_81 < _75);
    vec2 _114 = vec2(_113.x ? _111.x : _112.x, _113.y ? _111.y : _112.y);
    vec2 _117 = vec2(_78, 0.0);
    bvec2 _118 = bvec2(_114.x < _78);
    vec2 _119 = vec2(_118.x ? _114.x : _117.x, _118.y ? _114.y : _117.y);
    vec2 _121 = vec2(_99, 1.0);
    vec2 _122 = vec2(_93, -1.0);
    bvec2 _123 = bvec2(_99 < _93);
    vec2 _124 = vec2(_123.x ? _121.x : _122.x, _123.y ? _121.y : _122.y);
    vec2 _127 = vec2(_96, 0.0);
    bvec2 _128 = bvec2(_124.x < _96);
    vec2 _129 = vec2(_128.x ? _124.x : _127.x, _128.y ? _124.y : _127.y);
    bool _132 = _129.x < _119.x;
    bvec2 _133 = bvec2(_132);
    vec2 _134 = vec2(_133.x ? _129.x : _119.x, _133.y ? _129.y : _119.y);
    vec2 _140 = vec2(_134.y, _132 ? 1.0 : (-1.0));
    vec2 _142 = vec2(_109.y, 0.0);
    bvec2 _143 = bvec2(_134.x < _109.x);
    vec2 _156 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-(textureLod(gInVelocity, gl_FragCoord.xy * parameters.gOutputSize.zw + (vec2(_143.x ? _140.x : _142.x, _143.y ? _140.y : _142.y) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    vec3 _170 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _175 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _180 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _185 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _190 = clamp(textureLod(gInColour, _70, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _195 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _200 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _205 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _210 = clamp(textureLodOffset(gInColour, _70, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _215 = max(-parameters.gJitterPx.x, 0.0);
    float _217 = 1.0 - abs(parameters.gJitterPx.x);
    float _218 = max(parameters.gJitterPx.x, 0.0);
    vec3 _244 = (((((_170 * _215) + (_175 * _217)) + (_180 * _218)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_185 * _215) + (_190 * _217)) + (_195 * _218)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_200 * _215) + (_205 * _217)) + (_210 * _218)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _245 = floatBitsToInt(_185);
    ivec3 _246 = floatBitsToInt(_195);
    ivec3 _248 = floatBitsToInt(_190);
    ivec3 _251 = floatBitsToInt(intBitsToFloat(min(min(_245, _246), _248)));
    ivec3 _252 = floatBitsToInt(_175);
    ivec3 _254 = floatBitsToInt(_205);
    ivec3 _260 = floatBitsToInt(intBitsToFloat(max(max(_245, _246), _248)));
    ivec3 _264 = floatBitsToInt(_170);
    ivec3 _265 = floatBitsToInt(_180);
    ivec3 _269 = floatBitsToInt(_200);
    ivec3 _270 = floatBitsToInt(_210);
    vec3 _294 = ((intBitsToFloat(max(max(_260, _252), _254)) + intBitsToFloat(max(max(_260, floatBitsToInt(intBitsToFloat(max(max(_264, _265), _252)))), floatBitsToInt(intBitsToFloat(max(max(_269, _270), _254)))))) * 0.5) * 0.5;
    vec3 _295 = ((intBitsToFloat(min(min(_251, _252), _254)) + intBitsToFloat(min(min(_251, floatBitsToInt(intBitsToFloat(min(min(_264, _265), _252)))), floatBitsToInt(intBitsToFloat(min(min(_269, _270), _254)))))) * 0.5) * 0.5;
    vec3 _296 = _294 + _295;
    vec3 _298 = max(_294 - _295, vec3(1.5258789240815695542607954848791e-12));
    vec3 _299 = clamp(textureLod(gHistoryColour, _156, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _296;
    vec3 _302 = _298 / max(abs(_299), _298);
    gOutHistory = vec4(min((_244 + (((_296 + (_299 * min(_302.x, min(_302.y, _302.z)))) - _244) * (all(lessThanEqual(abs(_156 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0)), 1.0);
}

