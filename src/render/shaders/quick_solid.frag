// Mast and obstacles, quickly.

in vec3 shade;
in vec3 sun;
in vec3 spot;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = vec4(encode_quickly(shade + sun * quick_sunlight(spot, 0.0, 1)), 1.0);
}
