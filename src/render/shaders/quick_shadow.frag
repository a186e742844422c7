// The ground under the shadow map, quickly.

in vec3 in_sun;
in vec3 in_shade;
in vec3 spot;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = vec4(mix(in_shade, in_sun, quick_sunlight(spot, shadow.w, 4)), 1.0);
}
