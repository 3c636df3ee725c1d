#version 300 es
precision highp float;
precision highp int;

in vec4 varying0;
in vec4 varying1;
layout(location = 0) out vec2 gOutVelocity;

void main()
{
    bool _29 = varying0.w > 0.0;
    vec2 _35 = clamp((varying0.xy / vec2(_29 ? varying0.w : 1.0)) * vec2(0.5, -0.5) + vec2(0.5), vec2(-8.0), vec2(8.0));
    bvec2 _36 = bvec2(_29);
    bool _39 = varying1.w > 0.0;
    vec2 _45 = clamp((varying1.xy / vec2(_39 ? varying1.w : 1.0)) * vec2(0.5, -0.5) + vec2(0.5), vec2(-8.0), vec2(8.0));
    bvec2 _46 = bvec2(_39);
    gOutVelocity = vec2(_36.x ? _35.x : vec2(-8.0).x, _36.y ? _35.y : vec2(-8.0).y) - vec2(_46.x ? _45.x : vec2(-8.0).x, _46.y ? _45.y : vec2(-8.0).y);
}

