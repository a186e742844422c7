// Light, sky and tone. Colours are linear until encode() makes sRGB of them.

const vec3 sun_light = vec3(1.62, 1.50, 1.30);
const vec3 sky_light = vec3(0.34, 0.41, 0.51);
const vec3 ground_light = vec3(0.25, 0.23, 0.20);

// Light of the surroundings on a surface that faces along `normal`.
vec3 ambient(vec3 normal) {
    return mix(ground_light, sky_light, 0.5 + 0.5 * normal.y);
}

vec3 sky(vec3 direction) {
    vec3 horizon = vec3(0.72, 0.80, 0.87);
    vec3 zenith = vec3(0.10, 0.27, 0.58);
    float height = direction.y > 0.0 ? 1.0 - exp(-3.4 * direction.y) : 0.0;
    vec3 colour = mix(horizon, zenith, height);
    // Warmth toward the sun, along the horizon most of all.
    float toward = max(dot(normalize(direction.xz + 1e-5), normalize(to_sun.xz)), 0.0);
    colour += vec3(0.14, 0.08, 0.0) * toward * toward * exp(-5.0 * abs(direction.y));
    // Below the horizon, seen only where there is no ground: a soft studio floor.
    float depth = smoothstep(0.0, 0.8, -direction.y);
    return mix(colour, vec3(0.34, 0.33, 0.32), depth);
}

// sRGB from light: linear up to a shoulder, above it bent toward white by its strongest channel so
// that hues keep.
vec3 encode(vec3 light) {
    const float shoulder = 0.66;
    float peak = max(light.r, max(light.g, light.b));
    if (peak > shoulder) {
        float room = 1.0 - shoulder;
        float bent = 1.0 - room * room / (peak - shoulder + room);
        vec3 kept = light * (bent / peak);
        light = mix(kept, vec3(bent), 0.18 * (1.0 - 1.0 / (1.0 + 0.6 * (peak - bent))));
    }
    vec3 low = 12.92 * light;
    vec3 high = 1.055 * pow(max(light, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThan(light, vec3(0.0031308)));
}
