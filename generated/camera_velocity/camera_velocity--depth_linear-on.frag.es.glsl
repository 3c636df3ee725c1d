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
    vec4 _53 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _54 = _53.x;
    vec2 _58 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-parameters.gJitterUv);
    vec4 _70 = parameters.gReprojection * vec4((_58 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _54, _54, 1.0);
    float _71 = _70.w;
    vec2 _76 = (_70.xy * (1.0 / _71)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _81 = bvec2((_71 > 0.0) && all(lessThanEqual(abs(_76), vec2(8.0))));
    gOutVelocity = vec4(_58 - vec2(_81.x ? _76.x : vec2(-8.0).x, _81.y ? _76.y : vec2(-8.0).y), 0.0, 0.0);
}

