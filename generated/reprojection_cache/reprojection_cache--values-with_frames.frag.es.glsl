#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform ReprojectionCacheParameters
{
    mat4 gViewToPreviousClip;
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gFrameToCoarse;
    vec2 gMotionToUv;
    vec2 gClipToDepth;
    vec2 gMissThreshold;
    vec2 gSpeedPx;
    vec2 gChange;
    float gConvergenceTime;
    float gMaxWeight;
    float gHistoryValid;
} parameters;

uniform highp sampler2D gInFresh;
uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gHistoryCache;
uniform highp sampler2D gHistoryCoarseDepth;

layout(location = 0) out vec4 gOutCache;

void main()
{
    vec2 _93 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _101 = textureLod(gInCoarseDepth, _93, 0.0);
    float _102 = _101.x;
    vec2 _103 = textureLod(gInFresh, _93, 0.0).xy;
    bvec2 _105 = lessThanEqual(abs(_103), vec2(65504.0));
    vec2 _106 = vec2(_105.x ? _103.x : vec2(0.0).x, _105.y ? _103.y : vec2(0.0).y);
    float _110 = ((_102 > 0.0) && (_102 < 65504.0)) ? _102 : 65504.0;
    vec4 _122 = parameters.gViewToPreviousClip * vec4((_93 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _110, _110, 1.0);
    float _125 = _122.w;
    vec2 _130 = (_122.xy * (1.0 / _125)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _135 = bvec2((_125 > 0.0) && all(lessThanEqual(abs(_130), vec2(8.0))));
    vec2 _136 = vec2(_135.x ? _130.x : vec2(-8.0).x, _135.y ? _130.y : vec2(-8.0).y);
    float _138 = dot(_122.zw, parameters.gClipToDepth);
    vec2 _144 = _136 * parameters.gFrameToCoarse;
    float _150 = max(parameters.gMissThreshold.y * _110 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec2 _152 = _144 * parameters.gOutputSize.xy + vec2(-0.5);
    vec2 _153 = floor(_152);
    vec2 _154 = _152 - _153;
    vec2 _155 = vec2(1.0) - _154;
    float _156 = _155.x;
    float _157 = _154.x;
    vec2 _164 = (_153 + vec2(0.5)) * parameters.gOutputSize.zw;
    vec2 _176 = (_153 + vec2(1.5, 0.5)) * parameters.gOutputSize.zw;
    vec2 _184 = (_153 + vec2(0.5, 1.5)) * parameters.gOutputSize.zw;
    vec2 _192 = (_153 + vec2(1.5)) * parameters.gOutputSize.zw;
    vec4 _196 = vec4(textureLod(gHistoryCache, _164, 0.0).x, textureLod(gHistoryCache, _176, 0.0).x, textureLod(gHistoryCache, _184, 0.0).x, textureLod(gHistoryCache, _192, 0.0).x);
    vec4 _208 = vec4(_150) - abs(vec4((abs(_138) <= 9.9999996802856924650656260769173e+37) ? _138 : 0.0) - vec4(textureLod(gHistoryCoarseDepth, _164, 0.0).x, textureLod(gHistoryCoarseDepth, _176, 0.0).x, textureLod(gHistoryCoarseDepth, _184, 0.0).x, textureLod(gHistoryCoarseDepth, _192, 0.0).x));
    vec4 _209 = _208 * (parameters.gConvergenceTime / _150);
    bvec4 _210 = greaterThan(_208, vec4(0.0));
    vec4 _211 = vec4(_210.x ? _209.x : vec4(0.0).x, _210.y ? _209.y : vec4(0.0).y, _210.z ? _209.z : vec4(0.0).z, _210.w ? _209.w : vec4(0.0).w);
    vec4 _212 = min(_211, vec4(1.0));
    bvec4 _213 = greaterThan(_211, vec4(0.0));
    bvec4 _218 = bvec4(all(lessThanEqual(abs(_136 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5))));
    bvec4 _219 = bvec4(_213.x && _218.x, _213.y && _218.y, _213.z && _218.z, _213.w && _218.w);
    bvec4 _221 = greaterThanEqual(_196, vec4(0.0));
    bvec4 _222 = lessThan(_196, vec4(16777216.0));
    vec4 _224 = vec4(bvec4(_221.x && _222.x, _221.y && _222.y, _221.z && _222.z, _221.w && _222.w));
    bvec4 _225 = greaterThan(_224, vec4(0.5));
    vec4 _226 = vec4(_225.x ? _196.x : vec4(0.0).x, _225.y ? _196.y : vec4(0.0).y, _225.z ? _196.z : vec4(0.0).z, _225.w ? _196.w : vec4(0.0).w);
    vec4 _228 = floor(_226 * 9.5367431640625e-07);
    vec4 _230 = _226 - (_228 * 1048576.0);
    vec4 _232 = floor(_230 * 0.0009765625);
    vec4 _238 = vec4(_219.x ? _212.x : vec4(0.0).x, _219.y ? _212.y : vec4(0.0).y, _219.z ? _212.z : vec4(0.0).z, _219.w ? _212.w : vec4(0.0).w) * _224;
    vec4 _239 = (vec4(_156, _157, _156, _157) * vec4(_155.yy, _154.yy)) * _238;
    vec4 _243 = _239 * (1.0 / max(dot(_239, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _247 = vec2(dot(_243, _232 * 0.000977517105638980865478515625), dot(_243, min((_230 - (_232 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0))));
    float _248 = dot(_243, _228);
    vec2 _252 = abs(_247);
    float _256 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_252, vec2(65504.0)))) ? dot(_243, _238) : 0.0;
    float _268 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _270 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_144)) * parameters.gOutputSize.xy));
    float _274 = ((_270 > 0.0) ? min(_270, _268) : 0.0) / _268;
    float _277 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _282 = _248 * _256;
    float _285 = (_282 > 0.0) ? min(_282, 255.0) : 0.0;
    float _289 = min(min(_285 / (_285 + 1.0), _277), ((_277 * _274) * _274) * ((-2.0) * _274 + 3.0));
    bvec2 _293 = bvec2(all(lessThanEqual(abs(_106), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _294 = vec2(_293.x ? _106.x : vec2(0.0).x, _293.y ? _106.y : vec2(0.0).y);
    vec2 _300 = _294 + ((_247 - _294) * clamp(_289, 0.0, 1.0));
    bvec2 _301 = bvec2(all(lessThanEqual(_252, vec2(9.9999996802856924650656260769173e+37))));
    vec2 _302 = vec2(_301.x ? _300.x : _294.x, _301.y ? _300.y : _294.y);
    bvec2 _304 = bvec2(_289 > 0.0);
    vec2 _305 = vec2(_304.x ? _302.x : _106.x, _304.y ? _302.y : _106.y);
    float _313 = min(((_248 > 0.0) ? min(_248, 255.0) : 0.0) * ((_256 > 0.0) ? min(_256, 1.0) : 0.0) + 1.0, 255.0);
    float _314 = _305.x;
    float _318 = _305.y;
    vec2 _325 = floor((vec2((_314 > 0.0) ? min(_314, 1.0) : 0.0, (_318 > 0.0) ? min(_318, 1.0) : 0.0) * 1023.0) + vec2(0.5));
    gOutCache = vec4((floor(((_313 > 0.0) ? min(_313, 15.0) : 0.0) + 0.5) * 1024.0 + _325.x) * 1024.0 + _325.y, 0.0, 0.0, 0.0);
}

