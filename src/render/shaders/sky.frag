// The sky, where nothing else is.

in vec3 direction;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = vec4(tone(sky(normalize(direction))), 1.0);
}
