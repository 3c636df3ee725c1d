#version 450

struct Joint
{
    mat4 toWorld;
};

layout(binding = 2, std430) readonly buffer gInJoints
{
    Joint _data[];
} gInJoints_1;

layout(binding = 3, std430) readonly buffer gInPrevJoints
{
    Joint _data[];
} gInPrevJoints_1;

layout(binding = 0, std140) uniform ObjectVelocityParameters
{
    mat4 gObjectToClip;
    mat4 gPrevObjectToClip;
    vec2 gJitterNdc;
} parameters;

layout(location = 0) in vec3 input_position;
layout(location = 1) in uvec4 input_joints;
layout(location = 2) in vec4 input_weights;
layout(location = 0) out vec4 varying0;
layout(location = 1) out vec4 varying1;

void main()
{
    vec4 _45 = vec4(input_position, 1.0);
    vec4 _94 = parameters.gObjectToClip * (((((gInJoints_1._data[input_joints.x].toWorld * _45) * input_weights.x) + ((gInJoints_1._data[input_joints.y].toWorld * _45) * input_weights.y)) + ((gInJoints_1._data[input_joints.z].toWorld * _45) * input_weights.z)) + ((gInJoints_1._data[input_joints.w].toWorld * _45) * input_weights.w));
    vec2 _103 = _94.xy + (parameters.gJitterNdc * _94.w);
    vec4 _105 = _94;
    _105.x = _103.x;
    _105.y = _103.y;
    gl_Position = _105;
    varying0 = _94;
    varying1 = parameters.gPrevObjectToClip * (((((gInPrevJoints_1._data[input_joints.x].toWorld * _45) * input_weights.x) + ((gInPrevJoints_1._data[input_joints.y].toWorld * _45) * input_weights.y)) + ((gInPrevJoints_1._data[input_joints.z].toWorld * _45) * input_weights.z)) + ((gInPrevJoints_1._data[input_joints.w].toWorld * _45) * input_weights.w));
    gl_Position.z = 2.0 * gl_Position.z - gl_Position.w;
    gl_Position.y = -gl_Position.y;
}

