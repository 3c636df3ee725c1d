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
    vec2 _60 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-parameters.gJitterUv);
    vec4 _68 = parameters.gReprojection * vec4((_60 - vec2(0.5)) * vec2(2.0, -2.0), textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0).x, 1.0);
    float _69 = _68.w;
    vec2 _74 = (_68.xy * (1.0 / _69)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _79 = bvec2((_69 > 0.0) && all(lessThanEqual(abs(_74), vec2(8.0))));
    gOutVelocity = vec4(_60 - vec2(_79.x ? _74.x : vec2(-8.0).x, _79.y ? _74.y : vec2(-8.0).y), 0.0, 0.0);
}

