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
    vec2 _62 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -parameters.gJitterUv);
    vec4 _69 = parameters.gReprojection * vec4(fma(_62, vec2(2.0, -2.0), vec2(-1.0, 1.0)), textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0).x, 1.0);
    float _70 = _69.w;
    vec2 _75 = fma(_69.xy * (1.0 / _70), vec2(0.5, -0.5), vec2(0.5));
    gOutVelocity = vec4(_62 - mix(vec2(-8.0), _75, bvec2((_70 > 0.0) && all(lessThanEqual(abs(_75), vec2(8.0))))), 0.0, 0.0);
}

