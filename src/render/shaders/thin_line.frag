// A line as the driver draws it, of one pixel.

in vec4 colour;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = colour;
}
