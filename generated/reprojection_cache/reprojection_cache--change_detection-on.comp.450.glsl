#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

float _80;

layout(binding = 0, std140) uniform ReprojectionCacheParameters
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

layout(binding = 16) uniform writeonly image2D gOutCache;
layout(binding = 1) uniform sampler2D gInFresh;
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _95 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _97 = _95 * parameters.gOutputSize.zw;
        vec4 _101 = textureLod(gInFresh, _97, 0.0);
        float _102 = _101.y;
        float _106 = ((_102 > 0.0) && (_102 < 65504.0)) ? _102 : 65504.0;
        float _107 = _101.x;
        vec2 _112 = mix(vec2(0.0), vec2(_107, 0.0), bvec2(abs(_107) <= 65504.0));
        vec4 _124 = parameters.gViewToPreviousClip * vec4(fma(_97, parameters.gViewRay.xy, parameters.gViewRay.zw) * _106, _106, 1.0);
        float _127 = _124.w;
        vec2 _132 = fma(_124.xy * (1.0 / _127), vec2(0.5, -0.5), vec2(0.5));
        vec2 _138 = mix(vec2(-8.0), _132, bvec2((_127 > 0.0) && all(lessThanEqual(abs(_132), vec2(8.0)))));
        float _140 = dot(_124.zw, parameters.gClipToDepth);
        vec2 _146 = _138 * parameters.gFrameToCoarse;
        vec4 _150 = textureLod(gHistoryCacheFiltered, _146, 0.0);
        float _151 = _150.x;
        vec2 _156 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_151, 0.0), bvec2(abs(_151) <= 65504.0));
        float _157 = _156.x;
        float _159 = _150.z;
        float _168 = max(fma(parameters.gMissThreshold.y, _106, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _174 = _168 - abs(((abs(_140) <= 9.9999996802856924650656260769173e+37) ? _140 : 0.0) - _150.w);
        float _177 = (_174 > 0.0) ? (_174 * (parameters.gConvergenceTime / _168)) : 0.0;
        float _193 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_157, _156.y, _159, _150.w).xy), vec2(65504.0)))) ? (((_177 > 0.0) && all(lessThanEqual(abs(fma(_138, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_177, 1.0) : 0.0) : 0.0;
        vec4 _199 = textureGather(gInFresh, fma(_95, parameters.gOutputSize.zw, -(parameters.gOutputSize.zw * 0.5)));
        vec4 _202 = mix(vec4(0.0), _199, lessThanEqual(abs(_199), vec4(65504.0)));
        vec4 _206 = textureGather(gInFresh, fma(_95, parameters.gOutputSize.zw, vec2(1.5, -0.5) * parameters.gOutputSize.zw));
        vec4 _209 = mix(vec4(0.0), _206, lessThanEqual(abs(_206), vec4(65504.0)));
        vec4 _213 = textureGather(gInFresh, fma(_95, parameters.gOutputSize.zw, vec2(-0.5, 1.5) * parameters.gOutputSize.zw));
        vec4 _216 = mix(vec4(0.0), _213, lessThanEqual(abs(_213), vec4(65504.0)));
        vec4 _220 = textureGather(gInFresh, fma(_95, parameters.gOutputSize.zw, parameters.gOutputSize.zw * 1.5));
        vec4 _223 = mix(vec4(0.0), _220, lessThanEqual(abs(_220), vec4(65504.0)));
        float _227 = dot(((_202 + _209) + _216) + _223, vec4(0.0625));
        vec4 _228 = vec4(_227);
        vec4 _229 = _202 - _228;
        vec4 _230 = _209 - _228;
        vec4 _231 = _216 - _228;
        vec4 _232 = _223 - _228;
        float _251 = (_193 > 0.0) ? (_193 * clamp(2.0 - (abs(_157 - _227) / max(fma(parameters.gChange.x, sqrt(dot(fma(_232, _232, fma(_231, _231, fma(_229, _229, _230 * _230))), vec4(0.0625))), parameters.gChange.y), 9.9999997473787516355514526367188e-05)), 0.0, 1.0)) : 0.0;
        float _263 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _265 = parameters.gSpeedPx.y - abs(length(fma(_95, parameters.gOutputSize.zw, -_146) * parameters.gOutputSize.xy));
        float _269 = ((_265 > 0.0) ? min(_265, _263) : 0.0) / _263;
        float _272 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _279 = (_159 > 0.0) ? min(_159, 255.0) : 0.0;
        float _280 = _279 * _251;
        float _283 = (_280 > 0.0) ? min(_280, 255.0) : 0.0;
        float _287 = min(min(_283 / (_283 + 1.0), _272), ((_272 * _269) * _269) * fma(-2.0, _269, 3.0));
        float _288 = _112.x;
        bool _289 = _287 > 0.0;
        float _291 = _289 ? min(_287, 1.0) : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(mix(_112, vec2((abs(_157) <= 9.9999996802856924650656260769173e+37) ? fma(_157, _291, _288 * (1.0 - _291)) : _288, _80), bvec2(_289)).x, 0.0, min(fma(_279, (_251 > 0.0) ? min(_251, 1.0) : 0.0, 1.0), 255.0), _106));
        break;
    } while(false);
}

