#version 450

layout(location = 0) in vec4 varying0;
layout(location = 1) in vec4 varying1;
layout(location = 0) out vec2 gOutVelocity;

void main()
{
    bool _29 = varying0.w > 0.0;
    vec2 _34 = fma(varying0.xy / vec2(_29 ? varying0.w : 1.0), vec2(0.5, -0.5), vec2(0.5));
    bool _42 = varying1.w > 0.0;
    vec2 _47 = fma(varying1.xy / vec2(_42 ? varying1.w : 1.0), vec2(0.5, -0.5), vec2(0.5));
    gOutVelocity = mix(vec2(-8.0), _34, bvec2(_29 && all(lessThanEqual(abs(_34), vec2(8.0))))) - mix(vec2(-8.0), _47, bvec2(_42 && all(lessThanEqual(abs(_47), vec2(8.0)))));
}

