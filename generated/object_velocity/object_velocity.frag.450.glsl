#version 450

layout(location = 0) in vec4 varying0;
layout(location = 1) in vec4 varying1;
layout(location = 0) out vec2 gOutVelocity;

void main()
{
    bool _29 = varying0.w > 0.0;
    bool _39 = varying1.w > 0.0;
    gOutVelocity = mix(vec2(-8.0), clamp(fma(varying0.xy / vec2(_29 ? varying0.w : 1.0), vec2(0.5, -0.5), vec2(0.5)), vec2(-8.0), vec2(8.0)), bvec2(_29)) - mix(vec2(-8.0), clamp(fma(varying1.xy / vec2(_39 ? varying1.w : 1.0), vec2(0.5, -0.5), vec2(0.5)), vec2(-8.0), vec2(8.0)), bvec2(_39));
}

