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

void main()
{
    vec2 _47 = gl_FragCoord.xy * 4.0;
    vec2 _48 = _47 - vec2(1.0);
    vec2 _52 = parameters.gInputSize.zw * 0.5;
    vec2 _56 = -_52;
    float _65 = _52.x;
    float _66 = _52.y;
    vec2 _68 = vec2(_65, -_66);
    vec2 _74 = vec2(-_65, _66);
    vec4 _78 = vec4(textureLod(gInDepth, _48 * parameters.gInputSize.zw + _56, 0.0).x, textureLod(gInDepth, _48 * parameters.gInputSize.zw + _52, 0.0).x, textureLod(gInDepth, _48 * parameters.gInputSize.zw + _68, 0.0).x, textureLod(gInDepth, _48 * parameters.gInputSize.zw + _74, 0.0).x);
    bvec4 _81 = lessThanEqual(abs(_78 - vec4(0.5)), vec4(0.5));
    vec2 _83 = _47 + vec2(1.0, -1.0);
    vec4 _100 = vec4(textureLod(gInDepth, _83 * parameters.gInputSize.zw + _56, 0.0).x, textureLod(gInDepth, _83 * parameters.gInputSize.zw + _52, 0.0).x, textureLod(gInDepth, _83 * parameters.gInputSize.zw + _68, 0.0).x, textureLod(gInDepth, _83 * parameters.gInputSize.zw + _74, 0.0).x);
    bvec4 _103 = lessThanEqual(abs(_100 - vec4(0.5)), vec4(0.5));
    vec2 _105 = _47 + vec2(-1.0, 1.0);
    vec4 _122 = vec4(textureLod(gInDepth, _105 * parameters.gInputSize.zw + _56, 0.0).x, textureLod(gInDepth, _105 * parameters.gInputSize.zw + _52, 0.0).x, textureLod(gInDepth, _105 * parameters.gInputSize.zw + _68, 0.0).x, textureLod(gInDepth, _105 * parameters.gInputSize.zw + _74, 0.0).x);
    bvec4 _125 = lessThanEqual(abs(_122 - vec4(0.5)), vec4(0.5));
    vec2 _127 = _47 + vec2(1.0);
    vec4 _144 = vec4(textureLod(gInDepth, _127 * parameters.gInputSize.zw + _56, 0.0).x, textureLod(gInDepth, _127 * parameters.gInputSize.zw + _52, 0.0).x, textureLod(gInDepth, _127 * parameters.gInputSize.zw + _68, 0.0).x, textureLod(gInDepth, _127 * parameters.gInputSize.zw + _74, 0.0).x);
    bvec4 _147 = lessThanEqual(abs(_144 - vec4(0.5)), vec4(0.5));
    vec4 _151 = min(min(vec4(_81.x ? _78.x : vec4(1.0).x, _81.y ? _78.y : vec4(1.0).y, _81.z ? _78.z : vec4(1.0).z, _81.w ? _78.w : vec4(1.0).w), vec4(_103.x ? _100.x : vec4(1.0).x, _103.y ? _100.y : vec4(1.0).y, _103.z ? _100.z : vec4(1.0).z, _103.w ? _100.w : vec4(1.0).w)), min(vec4(_125.x ? _122.x : vec4(1.0).x, _125.y ? _122.y : vec4(1.0).y, _125.z ? _122.z : vec4(1.0).z, _125.w ? _122.w : vec4(1.0).w), vec4(_147.x ? _144.x : vec4(1.0).x, _147.y ? _144.y : vec4(1.0).y, _147.z ? _144.z : vec4(1.0).z, _147.w ? _144.w : vec4(1.0).w)));
    vec4 _153 = min(_151, _151.zwxy);
    float _164 = 1.0 / max(min(_153.xxxx, _153.yyyy).x * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    gOutCoarseDepth = vec4(((_164 > 0.0) && (_164 < min(parameters.gSkyDepth, 65504.0))) ? _164 : 65504.0, 0.0, 0.0, 0.0);
}

