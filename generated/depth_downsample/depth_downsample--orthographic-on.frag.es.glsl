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
    vec2 _42 = gl_FragCoord.xy * 2.0;
    vec2 _46 = parameters.gInputSize.zw * 0.5;
    float _59 = _46.x;
    float _60 = _46.y;
    vec4 _72 = vec4(textureLod(gInDepth, _42 * parameters.gInputSize.zw + (-_46), 0.0).x, textureLod(gInDepth, _42 * parameters.gInputSize.zw + _46, 0.0).x, textureLod(gInDepth, _42 * parameters.gInputSize.zw + vec2(_59, -_60), 0.0).x, textureLod(gInDepth, _42 * parameters.gInputSize.zw + vec2(-_59, _60), 0.0).x);
    bvec4 _75 = lessThanEqual(abs(_72 - vec4(0.5)), vec4(0.5));
    vec4 _76 = vec4(_75.x ? _72.x : vec4(1.0).x, _75.y ? _72.y : vec4(1.0).y, _75.z ? _72.z : vec4(1.0).z, _75.w ? _72.w : vec4(1.0).w);
    vec4 _78 = min(_76, _76.zwxy);
    float _87 = min(_78.xxxx, _78.yyyy).x * parameters.gLinearDepth.x + parameters.gLinearDepth.y;
    gOutCoarseDepth = vec4(((_87 > 0.0) && (_87 < min(parameters.gSkyDepth, 65504.0))) ? _87 : 65504.0, 0.0, 0.0, 0.0);
}

