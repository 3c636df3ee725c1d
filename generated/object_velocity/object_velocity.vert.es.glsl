#version 300 es

layout(std140) uniform ObjectVelocityParameters
{
    mat4 gObjectToClip;
    mat4 gPrevObjectToClip;
    vec2 gJitterNdc;
} parameters;

layout(location = 0) in vec3 input_position;
out vec4 varying0;
out vec4 varying1;

void main()
{
    vec4 _31 = vec4(input_position, 1.0);
    vec4 _34 = parameters.gObjectToClip * _31;
    vec2 _43 = _34.xy + (parameters.gJitterNdc * _34.w);
    vec4 _45 = _34;
    _45.x = _43.x;
    _45.y = _43.y;
    gl_Position = _45;
    varying0 = _34;
    varying1 = parameters.gPrevObjectToClip * _31;
    gl_Position.z = 2.0 * gl_Position.z - gl_Position.w;
    gl_Position.y = -gl_Position.y;
}

