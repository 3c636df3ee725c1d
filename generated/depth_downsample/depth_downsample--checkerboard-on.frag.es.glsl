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
    vec2 _44 = gl_FragCoord.xy * 2.0;
    vec2 _48 = parameters.gInputSize.zw * 0.5;
    float _61 = _48.x;
    float _62 = _48.y;
    vec4 _74 = vec4(textureLod(gInDepth, _44 * parameters.gInputSize.zw + (-_48), 0.0).x, textureLod(gInDepth, _44 * parameters.gInputSize.zw + _48, 0.0).x, textureLod(gInDepth, _44 * parameters.gInputSize.zw + vec2(_61, -_62), 0.0).x, textureLod(gInDepth, _44 * parameters.gInputSize.zw + vec2(-_61, _62), 0.0).x);
    bvec4 _77 = lessThanEqual(abs(_74 - vec4(0.5)), vec4(0.5));
    vec4 _78 = vec4(_77.x ? _74.x : vec4(1.0).x, _77.y ? _74.y : vec4(1.0).y, _77.z ? _74.z : vec4(1.0).z, _77.w ? _74.w : vec4(1.0).w);
    vec2 _79 = floor(gl_FragCoord.xy);
    vec4 _86 = _78.zwxy;
    vec4 _87 = max(_78, _86);
    vec4 _92 = min(_78, _86);
    float _104 = 1.0 / max(((fract(0.5 * (_79.x + _79.y)) > 0.25) ? max(_87.xxxx, _87.yyyy).x : min(_92.xxxx, _92.yyyy).x) * parameters.gLinearDepth.x + parameters.gLinearDepth.y, 1.0000000031710768509710513471353e-30);
    gOutCoarseDepth = vec4(((_104 > 0.0) && (_104 < min(parameters.gSkyDepth, 65504.0))) ? _104 : 65504.0, 0.0, 0.0, 0.0);
}

