#version 300 es
precision highp float;
precision highp int;

in vec4 varying0;
in vec4 varying1;
layout(location = 0) out vec2 gOutVelocity;

void main()
{
    bool _29 = varying0.w > 0.0;
    vec2 _34 = (varying0.xy / vec2(_29 ? varying0.w : 1.0)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _39 = bvec2(_29 && all(lessThanEqual(abs(_34), vec2(8.0))));
    bool _42 = varying1.w > 0.0;
    vec2 _47 = (varying1.xy / vec2(_42 ? varying1.w : 1.0)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _52 = bvec2(_42 && all(lessThanEqual(abs(_47), vec2(8.0))));
    gOutVelocity = vec2(_39.x ? _34.x : vec2(-8.0).x, _39.y ? _34.y : vec2(-8.0).y) - vec2(_52.x ? _47.x : vec2(-8.0).x, _52.y ? _47.y : vec2(-8.0).y);
}

