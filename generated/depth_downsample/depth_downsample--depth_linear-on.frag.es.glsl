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
    vec2 _39 = gl_FragCoord.xy * 2.0;
    vec2 _43 = parameters.gInputSize.zw * 0.5;
    float _56 = _43.x;
    float _57 = _43.y;
    vec4 _69 = vec4(textureLod(gInDepth, _39 * parameters.gInputSize.zw + (-_43), 0.0).x, textureLod(gInDepth, _39 * parameters.gInputSize.zw + _43, 0.0).x, textureLod(gInDepth, _39 * parameters.gInputSize.zw + vec2(_56, -_57), 0.0).x, textureLod(gInDepth, _39 * parameters.gInputSize.zw + vec2(-_56, _57), 0.0).x);
    bvec4 _70 = greaterThan(_69, vec4(0.0));
    vec4 _71 = vec4(_70.x ? _69.x : vec4(65504.0).x, _70.y ? _69.y : vec4(65504.0).y, _70.z ? _69.z : vec4(65504.0).z, _70.w ? _69.w : vec4(65504.0).w);
    bvec4 _72 = lessThan(_71, vec4(65504.0));
    vec4 _73 = vec4(_72.x ? _71.x : vec4(65504.0).x, _72.y ? _71.y : vec4(65504.0).y, _72.z ? _71.z : vec4(65504.0).z, _72.w ? _71.w : vec4(65504.0).w);
    vec4 _75 = min(_73, _73.zwxy);
    vec4 _78 = min(_75.xxxx, _75.yyyy);
    float _79 = _78.x;
    gOutCoarseDepth = vec4(((_79 > 0.0) && (_79 < min(parameters.gSkyDepth, 65504.0))) ? _79 : 65504.0, 0.0, 0.0, 0.0);
}

