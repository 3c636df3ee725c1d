#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform DepthDownsampleParameters
{
    vec4 gInputSize;
    vec4 gOutputSize;
    vec2 gLinearDepth;
    float gSkyDepth;
} parameters;

uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutCoarseDepth;
layout(location = 1) out vec4 gOutHalfDepth;

void main()
{
    vec2 _45 = gl_FragCoord.xy * 2.0;
    vec2 _49 = parameters.gInputSize.zw * 0.5;
    float _62 = _49.x;
    float _63 = _49.y;
    vec4 _75 = vec4(textureLod(gInDepth, _45 * parameters.gInputSize.zw + (-_49), 0.0).x, textureLod(gInDepth, _45 * parameters.gInputSize.zw + _49, 0.0).x, textureLod(gInDepth, _45 * parameters.gInputSize.zw + vec2(_62, -_63), 0.0).x, textureLod(gInDepth, _45 * parameters.gInputSize.zw + vec2(-_62, _63), 0.0).x);
    bvec4 _78 = lessThanEqual(abs(_75 - vec4(0.5)), vec4(0.5));
    vec4 _79 = vec4(_78.x ? _75.x : vec4(1.0).x, _78.y ? _75.y : vec4(1.0).y, _78.z ? _75.z : vec4(1.0).z, _78.w ? _75.w : vec4(1.0).w);
    vec4 _81 = min(_79, _79.zwxy);
    float _92 = 1.0 / max(min(_81.xxxx, _81.yyyy).x * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    float _99 = ((_92 > 0.0) && (_92 < min(parameters.gSkyDepth, 65504.0))) ? _92 : 65504.0;
    gOutCoarseDepth = vec4(_99, 0.0, 0.0, 0.0);
    gOutHalfDepth = vec4(min(_99 * 1.00048828125, 65504.0), 0.0, 0.0, 0.0);
}

