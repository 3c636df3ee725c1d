#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform CameraVelocityParameters
{
    mat4 gReprojection;
    vec4 gViewRay;
    vec4 gOutputSize;
    vec2 gJitterUv;
} parameters;

uniform highp sampler2D gInDepth;

layout(location = 0) out vec4 gOutVelocity;

void main()
{
    vec2 _59 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-parameters.gJitterUv);
    vec4 _74 = ((parameters.gReprojection * vec4((_59 * parameters.gViewRay.xy + parameters.gViewRay.zw) * 1.0, 1.0, 0.0)) * textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0).x) + (parameters.gReprojection * vec4(0.0, 0.0, 0.0, 1.0));
    float _75 = _74.w;
    vec2 _80 = (_74.xy * (1.0 / _75)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _85 = bvec2((_75 > 0.0) && all(lessThanEqual(abs(_80), vec2(8.0))));
    gOutVelocity = vec4(_59 - vec2(_85.x ? _80.x : vec2(-8.0).x, _85.y ? _80.y : vec2(-8.0).y), 0.0, 0.0);
}

