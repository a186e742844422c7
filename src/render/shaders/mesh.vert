// Cloth and solids: places are in the world already.

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec3 in_colour;

out vec3 position;
out vec3 normal;
out vec3 colour;   // of a solid; of a cloth u and v

void main() {
    position = in_position;
    normal = in_normal;
    colour = in_colour;
    gl_Position = to_clip * vec4(in_position, 1.0);
}
