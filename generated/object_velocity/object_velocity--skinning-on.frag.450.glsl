#version 450

layout(location = 0) in vec4 varying0;
layout(location = 1) in vec4 varying1;
layout(location = 0) out vec4 gOutVelocity;

void main()
{
    vec2 _33 = fma(varying0.xy * (1.0 / varying0.w), vec2(0.5, -0.5), vec2(0.5));
    vec2 _45 = fma(varying1.xy * (1.0 / varying1.w), vec2(0.5, -0.5), vec2(0.5));
    gOutVelocity = vec4(mix(vec2(-8.0), _33, bvec2((varying0.w > 0.0) && all(lessThanEqual(abs(_33), vec2(8.0))))) - mix(vec2(-8.0), _45, bvec2((varying1.w > 0.0) && all(lessThanEqual(abs(_45), vec2(8.0))))), 0.0, 0.0);
}

