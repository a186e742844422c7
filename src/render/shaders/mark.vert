// Points of a size in pixels, and thin lines.

layout(location = 0) in vec3 in_position;
layout(location = 2) in vec4 in_colour;

uniform mat4 to_clip;
uniform vec2 lift;     // as in line.vert
uniform vec4 pixels;   // size of the picture; diameter

out vec4 colour;

void main() {
    vec4 clip = to_clip * vec4(in_position, 1.0);
    clip.z += lift.y * (clip.w / max(clip.w - lift.x, 0.5 * abs(clip.w)) - 1.0);
    gl_Position = clip;
    gl_PointSize = pixels.z + 1.0;
    colour = in_colour;
}
