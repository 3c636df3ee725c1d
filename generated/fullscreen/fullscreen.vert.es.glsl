#version 300 es

void main()
{
    gl_Position = vec4((uint(gl_VertexID) == 1u) ? 3.0 : (-1.0), (uint(gl_VertexID) == 2u) ? 3.0 : (-1.0), 0.0, 1.0);
    gl_Position.z = 2.0 * gl_Position.z - gl_Position.w;
    gl_Position.y = -gl_Position.y;
}

