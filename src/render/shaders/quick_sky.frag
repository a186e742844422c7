// The sky, quickly.

in vec3 colour;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = vec4(dithered(colour), 1.0);
}
