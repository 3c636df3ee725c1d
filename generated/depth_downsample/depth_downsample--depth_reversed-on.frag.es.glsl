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
    vec2 _43 = gl_FragCoord.xy * 2.0;
    vec2 _47 = parameters.gInputSize.zw * 0.5;
    float _60 = _47.x;
    float _61 = _47.y;
    vec4 _73 = vec4(textureLod(gInDepth, _43 * parameters.gInputSize.zw + (-_47), 0.0).x, textureLod(gInDepth, _43 * parameters.gInputSize.zw + _47, 0.0).x, textureLod(gInDepth, _43 * parameters.gInputSize.zw + vec2(_60, -_61), 0.0).x, textureLod(gInDepth, _43 * parameters.gInputSize.zw + vec2(-_60, _61), 0.0).x);
    bvec4 _76 = lessThanEqual(abs(_73 - vec4(0.5)), vec4(0.5));
    vec4 _77 = vec4(_76.x ? _73.x : vec4(0.0).x, _76.y ? _73.y : vec4(0.0).y, _76.z ? _73.z : vec4(0.0).z, _76.w ? _73.w : vec4(0.0).w);
    vec4 _79 = max(_77, _77.zwxy);
    float _90 = 1.0 / max(max(_79.xxxx, _79.yyyy).x * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    gOutCoarseDepth = vec4(((_90 > 0.0) && (_90 < min(parameters.gSkyDepth, 65504.0))) ? _90 : 65504.0, 0.0, 0.0, 0.0);
}

