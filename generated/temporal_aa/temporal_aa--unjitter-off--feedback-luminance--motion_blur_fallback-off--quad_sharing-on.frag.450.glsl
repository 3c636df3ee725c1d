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
    vec2 _117 = mix(vec2(_102, -1.0), vec2(_101, 1.0), bvec2(_101 < _102));
    vec2 _122 = mix(vec2(_100, 0.0), _117, bvec2(_117.x < _100));
    vec2 _127 = mix(vec2(_110, -1.0), vec2(_112, 1.0), bvec2(_112 < _110));
    vec2 _132 = mix(vec2(_111, 0.0), _127, bvec2(_127.x < _111));
    vec2 _137 = mix(vec2(_107, -1.0), vec2(_109, 1.0), bvec2(_109 < _107));
    vec2 _142 = mix(vec2(_108, 0.0), _137, bvec2(_137.x < _108));
    bool _145 = _142.x < _132.x;
    vec2 _147 = mix(_132, _142, bvec2(_145));
    vec2 _170 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -(textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, (mix(vec2(_122.y, 0.0), vec2(_147.y, _145 ? 1.0 : (-1.0)), bvec2(_147.x < _122.x)) * _78) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv));
    ivec2 _180 = ivec2(parameters.gOutputSize.xy) - ivec2(1);
    ivec2 _182 = ivec2((gl_FragCoord.xy * parameters.gOutputSize.zw) * parameters.gOutputSize.xy);
    ivec2 _183 = min(_182, _180);
    ivec2 _186 = clamp(_182 + ivec2(_78), ivec2(0), _180);
    int _187 = _183.x;
    vec3 _195 = clamp(texelFetch(gInColour, ivec3(_187, _183.y, 0).xy, 0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    int _196 = _186.x;
    vec3 _202 = clamp(texelFetch(gInColour, ivec3(_196, _183.y, 0).xy, 0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _209 = clamp(texelFetch(gInColour, ivec3(_187, _186.y, 0).xy, 0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _224 = _195 - (dFdyFine(_195) * _91);
    ivec3 _231 = floatBitsToInt(_195 - (dFdxFine(_195) * _86));
    ivec3 _232 = floatBitsToInt(_202);
    ivec3 _234 = floatBitsToInt(_195);
    ivec3 _237 = floatBitsToInt(intBitsToFloat(min(min(_231, _232), _234)));
    ivec3 _238 = floatBitsToInt(_224);
    ivec3 _240 = floatBitsToInt(_209);
    ivec3 _246 = floatBitsToInt(intBitsToFloat(max(max(_231, _232), _234)));
    ivec3 _250 = floatBitsToInt(_224 - (dFdxFine(_224) * _86));
    ivec3 _251 = floatBitsToInt(_202 - (dFdyFine(_202) * _91));
    ivec3 _255 = floatBitsToInt(_209 - (dFdxFine(_209) * _86));
    ivec3 _256 = floatBitsToInt(clamp(texelFetch(gInColour, ivec3(_196, _186.y, 0).xy, 0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    vec3 _276 = intBitsToFloat(min(min(_237, _238), _240)) + intBitsToFloat(min(min(_237, floatBitsToInt(intBitsToFloat(min(min(_250, _251), _238)))), floatBitsToInt(intBitsToFloat(min(min(_255, _256), _240)))));
    vec3 _277 = intBitsToFloat(max(max(_246, _238), _240)) + intBitsToFloat(max(max(_246, floatBitsToInt(intBitsToFloat(max(max(_250, _251), _238)))), floatBitsToInt(intBitsToFloat(max(max(_255, _256), _240)))));
    vec3 _278 = _277 + _276;
    vec3 _280 = max(_277 - _276, vec3(6.1035156963262782170431819395162e-12));
    vec3 _282 = (clamp(textureLod(gHistoryColour, _170, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _278;
    vec3 _285 = _280 / max(abs(_282), _280);
    vec3 _293 = (_278 + (_282 * min(_285.x, min(_285.y, _285.z)))) * 0.25;
    float _294 = dot(_195, vec3(13932.953125, 46871.34765625, 4731.69921875));
    float _295 = dot(_293, vec3(13932.953125, 46871.34765625, 4731.69921875));
    float _306 = max(1.0 - (abs(_294 - _295) / max(max(_294, _295), 0.20000000298023223876953125)), 0.0);
    gOutHistory = vec4(min((_195 + ((_293 - _195) * (all(lessThanEqual(abs(_170 - vec2(0.5)), vec2(0.5))) ? (mix(parameters.gFeedbackMin, parameters.gFeedbackMax, _306 * _306) * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0)), 1.0);
}

