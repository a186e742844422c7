// The ground outside of the shadow map, quickly.

in vec3 in_sun;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = vec4(in_sun, 1.0);
}
