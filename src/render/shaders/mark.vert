// Points of a size in pixels, and thin lines.

layout(location = 0) in vec3 in_position;
layout(location = 2) in vec4 in_colour;

out vec4 colour;

void main() {
    gl_Position = lifted(in_position);
    gl_PointSize = pixels.z + 1.0;
    colour = in_colour;
}
