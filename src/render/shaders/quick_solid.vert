// Mast and obstacles, quickly: all light but the shadow, per corner.

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec3 in_colour;

uniform bool matt;   // obstacles, which are seen from both sides; else lacquer

out vec3 shade;   // light that reaches it in the shadow
out vec3 sun;     // what the sun adds
out vec3 spot;

void main() {
    vec3 to_eye = normalize(eye.xyz - in_position);
    vec3 n = matt && dot(in_normal, to_eye) < 0.0 ? -in_normal : in_normal;
    float lacquer = matt ? 0.0 : 1.0;
    float mirror = 0.05 + 0.5 * pow(1.0 - max(dot(n, to_eye), 0.0), 4.0);
    float gloss = pow(max(dot(n, normalize(to_eye + to_sun.xyz)), 0.0), matt ? 24.0 : 90.0);
    shade = in_colour * ambient(n) + 0.5 * lacquer * mirror * sky(reflect(-to_eye, n));
    sun = sun_light * (in_colour * max(dot(n, to_sun.xyz), 0.0) +
                       (matt ? 0.05 : 0.8) * gloss);
    vec3 lift = n * 2.5 + to_sun.xyz * 2.0;
    spot = (to_shadow * vec4(in_position + lift * shadow.y, 1.0)).xyz;
    gl_Position = to_clip * vec4(in_position, 1.0);
}
