// Cloth: thin, lit on both sides, with light shining through from behind.

uniform sampler2D cloth_texture;

in vec3 position;
in vec3 normal;
in vec3 colour;

layout(location = 0) out vec4 pixel;

// The normal of the side that is seen.
vec3 seen_normal(vec3 to_eye) {
    vec3 smooth_normal = normal;
    if (dot(normal, normal) < 1e-8) smooth_normal = cross(dFdx(position), dFdy(position));
    vec3 n = normalize(smooth_normal);
    if (dot(normal, normal) < 1e-8 ? dot(n, to_eye) < 0.0 : !gl_FrontFacing) n = -n;
    // Blended between vertices it may lean past the outline of a fold; it is turned back into view.
    float facing = dot(n, to_eye);
    return facing < 0.03 ? normalize(n + (0.03 - facing) * to_eye) : n;
}

void main() {
    vec3 to_eye = normalize(eye.xyz - position);
    vec3 n = seen_normal(to_eye);
    vec3 albedo = texture(cloth_texture, colour.xy).rgb;
    float toward_sun = dot(n, to_sun.xyz);

    // The test point is lifted off the cloth on the sun's side, so that a fold shadows others only.
    vec3 lift = (toward_sun < 0.0 ? -n : n) * 2.0 + to_sun.xyz * 1.5;
    float lit = sunlight(position + lift * shadow.y, shadow.z, 3);

    float direct = max((toward_sun + 0.12) / 1.12, 0.0);
    float through = max(-toward_sun, 0.0);
    vec3 light = albedo * (sun_light * direct * lit + ambient(n) + 0.3 * ambient(-n));
    // What shines through has passed the dye: deeper in colour.
    light += albedo * (0.3 + 0.7 * albedo) * sun_light * (1.1 * through * lit);

    float rim = 1.0 - max(dot(n, to_eye), 0.0);
    float gloss = pow(max(dot(n, normalize(to_eye + to_sun.xyz)), 0.0), 28.0);
    light += sky_light * (0.12 * rim * rim * rim) * mix(vec3(1.0), albedo, 0.5);
    light += sun_light * (0.06 * gloss * lit) * mix(vec3(1.0), albedo, 0.5);
    pixel = vec4(tone(light), 1.0);
}
