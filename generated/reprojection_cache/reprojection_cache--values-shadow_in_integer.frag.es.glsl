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
uniform highp sampler2D gHistoryCache;
uniform highp sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _91 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _95 = textureLod(gInFresh, _91, 0.0);
    float _96 = _95.y;
    float _97 = _95.x;
    float _102 = (_97 > 0.0) ? min(_97, 31.984375) : 0.0;
    float _103 = floor(_102);
    vec2 _109 = vec2(_103 * 0.0322580635547637939453125, min((_102 - _103) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _110 = bvec2(abs(_97) <= 65504.0);
    vec2 _111 = vec2(_110.x ? _109.x : vec2(1.9999999360571384930131252153835e+38).x, _110.y ? _109.y : vec2(1.9999999360571384930131252153835e+38).y);
    bvec2 _113 = lessThanEqual(abs(_111), vec2(65504.0));
    vec2 _114 = vec2(_113.x ? _111.x : vec2(0.0).x, _113.y ? _111.y : vec2(0.0).y);
    float _118 = ((_96 > 0.0) && (_96 < 65504.0)) ? _96 : 65504.0;
    vec4 _130 = parameters.gViewToPreviousClip * vec4((_91 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _118, _118, 1.0);
    float _133 = _130.w;
    vec2 _138 = (_130.xy * (1.0 / _133)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _143 = bvec2((_133 > 0.0) && all(lessThanEqual(abs(_138), vec2(8.0))));
    vec2 _144 = vec2(_143.x ? _138.x : vec2(-8.0).x, _143.y ? _138.y : vec2(-8.0).y);
    float _146 = dot(_130.zw, parameters.gClipToDepth);
    vec2 _152 = _144 * parameters.gFrameToCoarse;
    float _158 = max(parameters.gMissThreshold.y * _118 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec2 _160 = _152 * parameters.gOutputSize.xy + vec2(-0.5);
    vec2 _161 = floor(_160);
    vec2 _162 = _160 - _161;
    vec2 _163 = vec2(1.0) - _162;
    float _164 = _163.x;
    float _165 = _162.x;
    vec2 _172 = (_161 + vec2(0.5)) * parameters.gOutputSize.zw;
    vec4 _176 = textureLod(gHistoryCache, _172, 0.0);
    float _177 = _176.x;
    vec2 _182 = (_161 + vec2(1.5, 0.5)) * parameters.gOutputSize.zw;
    vec4 _184 = textureLod(gHistoryCache, _182, 0.0);
    float _185 = _184.x;
    vec2 _190 = (_161 + vec2(0.5, 1.5)) * parameters.gOutputSize.zw;
    vec4 _192 = textureLod(gHistoryCache, _190, 0.0);
    float _193 = _192.x;
    vec2 _198 = (_161 + vec2(1.5)) * parameters.gOutputSize.zw;
    vec4 _200 = textureLod(gHistoryCache, _198, 0.0);
    float _201 = _200.x;
    vec4 _214 = vec4(_158) - abs(vec4((abs(_146) <= 9.9999996802856924650656260769173e+37) ? _146 : 0.0) - vec4(textureLod(gHistoryCache, _172, 0.0).y, textureLod(gHistoryCache, _182, 0.0).y, textureLod(gHistoryCache, _190, 0.0).y, textureLod(gHistoryCache, _198, 0.0).y));
    vec4 _215 = _214 * (parameters.gConvergenceTime / _158);
    bvec4 _216 = greaterThan(_214, vec4(0.0));
    vec4 _217 = vec4(_216.x ? _215.x : vec4(0.0).x, _216.y ? _215.y : vec4(0.0).y, _216.z ? _215.z : vec4(0.0).z, _216.w ? _215.w : vec4(0.0).w);
    vec4 _218 = min(_217, vec4(1.0));
    bvec4 _219 = greaterThan(_217, vec4(0.0));
    bvec4 _224 = bvec4(all(lessThanEqual(abs(_144 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5))));
    bvec4 _225 = bvec4(_219.x && _224.x, _219.y && _224.y, _219.z && _224.z, _219.w && _224.w);
    vec4 _226 = vec4(_225.x ? _218.x : vec4(0.0).x, _225.y ? _218.y : vec4(0.0).y, _225.z ? _218.z : vec4(0.0).z, _225.w ? _218.w : vec4(0.0).w);
    bvec4 _228 = lessThanEqual(abs(vec4(_177, _185, _193, _201)), vec4(65504.0));
    vec4 _229 = vec4(_228.x ? _226.x : vec4(0.0).x, _228.y ? _226.y : vec4(0.0).y, _228.z ? _226.z : vec4(0.0).z, _228.w ? _226.w : vec4(0.0).w);
    vec4 _230 = (vec4(_164, _165, _164, _165) * vec4(_163.yy, _162.yy)) * _229;
    vec4 _234 = _230 * (1.0 / max(dot(_230, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec4 _248 = vec4((_177 > 0.0) ? min(_177, 31.984375) : 0.0, (_185 > 0.0) ? min(_185, 31.984375) : 0.0, (_193 > 0.0) ? min(_193, 31.984375) : 0.0, (_201 > 0.0) ? min(_201, 31.984375) : 0.0);
    vec4 _249 = floor(_248);
    float _255 = dot(_234, min(_248 - _249, vec4(0.984375))) * 1.01587307453155517578125;
    vec2 _257 = vec2(dot(_234, _249) * 0.0322580635547637939453125, _255).yx;
    vec4 _261 = textureLod(gHistoryCacheStateFiltered, _152, 0.0);
    float _262 = _261.x;
    float _265 = (_262 > 0.0) ? min(_262, 255.0) : 0.0;
    float _272 = ((parameters.gHistoryValid > 0.5) && (abs(_255) <= 65504.0)) ? dot(_234, _229) : 0.0;
    float _284 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _286 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_152)) * parameters.gOutputSize.xy));
    float _290 = ((_286 > 0.0) ? min(_286, _284) : 0.0) / _284;
    float _293 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _298 = _265 * _272;
    float _301 = (_298 > 0.0) ? min(_298, 255.0) : 0.0;
    float _305 = min(min(_301 / (_301 + 1.0), _293), ((_293 * _290) * _290) * ((-2.0) * _290 + 3.0));
    bvec2 _309 = bvec2(all(lessThanEqual(abs(_114), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _310 = vec2(_309.x ? _114.x : vec2(0.0).x, _309.y ? _114.y : vec2(0.0).y);
    vec2 _317 = _310 + ((_257 - _310) * clamp(_305, 0.0, 1.0));
    bvec2 _318 = bvec2(all(lessThanEqual(abs(_257), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _319 = vec2(_318.x ? _317.x : _310.x, _318.y ? _317.y : _310.y);
    bvec2 _321 = bvec2(_305 > 0.0);
    vec2 _322 = vec2(_321.x ? _319.x : _114.x, _321.y ? _319.y : _114.y);
    float _331 = _322.x;
    float _332 = _322.y;
    gOutCache = vec4(((_331 > 0.0) ? min(_331, 1.0) : 0.0) * 0.984375 + floor(((_332 > 0.0) ? min(_332, 1.0) : 0.0) * 31.0 + 0.5), _118, 0.0, 0.0);
    gOutCacheState = vec4(min(((_265 > 0.0) ? min(_265, 255.0) : 0.0) * ((_272 > 0.0) ? min(_272, 1.0) : 0.0) + 1.0, 255.0), 0.0, 0.0, 0.0);
}

