// Mast, finial and rings: lacquered bodies that mirror a little of the sky.

in vec3 position;
in vec3 normal;
in vec3 colour;

layout(location = 0) out vec4 pixel;

void main() {
    vec3 n = normalize(normal);
    vec3 to_eye = normalize(eye.xyz - position);
    float toward_sun = max(dot(n, to_sun.xyz), 0.0);
    float lit = sunlight(position + (n * 2.5 + to_sun.xyz * 2.0) * shadow.y, shadow.z, 3);
    vec3 light = colour * (sun_light * toward_sun * lit + ambient(n));

    float mirror = 0.05 + 0.5 * pow(1.0 - max(dot(n, to_eye), 0.0), 4.0);
    float gloss = pow(max(dot(n, normalize(to_eye + to_sun.xyz)), 0.0), 90.0);
    light += 0.5 * mirror * sky(reflect(-to_eye, n)) + sun_light * (0.8 * gloss * lit);
    pixel = vec4(tone(light), 1.0);
}
