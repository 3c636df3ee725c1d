#version 450

layout(binding = 0, std140) uniform CameraVelocityParameters
{
    mat4 gReprojection;
    vec4 gViewRay;
    vec4 gOutputSize;
    vec2 gJitterUv;
} parameters;

layout(binding = 1) uniform sampler2D gInDepth;

layout(location = 0) out vec4 gOutVelocity;

void main()
{
    vec2 _60 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -parameters.gJitterUv);
    vec4 _68 = parameters.gReprojection * vec4((_60 - vec2(0.5)) * vec2(2.0, -2.0), textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0).x, 1.0);
    float _69 = _68.w;
    vec2 _74 = fma(_68.xy * (1.0 / _69), vec2(0.5, -0.5), vec2(0.5));
    gOutVelocity = vec4(_60 - mix(vec2(-8.0), _74, bvec2((_69 > 0.0) && all(lessThanEqual(abs(_74), vec2(8.0))))), 0.0, 0.0);
}

