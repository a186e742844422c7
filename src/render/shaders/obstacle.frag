// Obstacles: matt bodies, and plates that are seen from both sides.

in vec3 position;
in vec3 normal;
in vec3 colour;

layout(location = 0) out vec4 pixel;

void main() {
    vec3 to_eye = normalize(eye.xyz - position);
    vec3 n = normalize(normal);
    n = dot(n, to_eye) < 0.0 ? -n : n;
    float toward_sun = max(dot(n, to_sun.xyz), 0.0);
    float lit = sunlight(position + (n * 2.5 + to_sun.xyz * 2.0) * shadow.y, shadow.z, 3);
    float gloss = pow(max(dot(n, normalize(to_eye + to_sun.xyz)), 0.0), 24.0);
    vec3 light = colour * (sun_light * (toward_sun * lit) + ambient(n));
    pixel = vec4(tone(light + sun_light * (0.05 * gloss * lit)), 1.0);
}
