// What is multiplied with the ground near bodies.

in vec3 position;
in vec2 from_middle;

layout(location = 0) out vec4 pixel;

void main() {
    float fade = 1.0 - smoothstep(0.5, 1.0, length(from_middle));
    // The root of the open share, since colours are encoded; half, since the sun stays.
    pixel = vec4(vec3(1.0 - 0.5 * fade * (1.0 - open_sky(position))), 1.0);
}
