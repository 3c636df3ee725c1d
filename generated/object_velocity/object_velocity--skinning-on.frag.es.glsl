#version 300 es
precision highp float;
precision highp int;

in vec4 varying0;
in vec4 varying1;
layout(location = 0) out vec4 gOutVelocity;

void main()
{
    vec2 _33 = (varying0.xy * (1.0 / varying0.w)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _38 = bvec2((varying0.w > 0.0) && all(lessThanEqual(abs(_33), vec2(8.0))));
    vec2 _45 = (varying1.xy * (1.0 / varying1.w)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _50 = bvec2((varying1.w > 0.0) && all(lessThanEqual(abs(_45), vec2(8.0))));
    gOutVelocity = vec4(vec2(_38.x ? _33.x : vec2(-8.0).x, _38.y ? _33.y : vec2(-8.0).y) - vec2(_50.x ? _45.x : vec2(-8.0).x, _50.y ? _45.y : vec2(-8.0).y), 0.0, 0.0);
}

