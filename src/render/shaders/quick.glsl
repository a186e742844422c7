// What the quick fragment shaders share: cheap encoding and few shadow taps. The quick shaders are
// for drivers that draw on the processor: they do per corner what hardly bends between corners.

// As encode(), from one square root a channel; within 6 of 255.
vec3 encode_quickly(vec3 light) {
    const float shoulder = 0.66, room = 1.0 - shoulder;
    float peak = max(light.r, max(light.g, light.b));
    float bent = peak > shoulder ? 1.0 - room * room / (peak - shoulder + room) : peak;
    light *= bent / max(peak, 1e-4);
    light += (bent - light) * min(0.1 * (peak - bent), 0.15);
    return 1.0498 * sqrt(light) - 0.0285 * light;
}

uniform sampler2DShadow shadow_map;

// How much of the sun reaches a place of the shadow map: the mean of n taps, each of which is a
// blend of four texels. A loop, because drivers that draw on the processor run both sides of a
// branch, but leave a loop when no pixel needs it.
float quick_sunlight(vec3 spot, float spacing, int n) {
    bool inside = all(greaterThan(spot, vec3(0.0))) && all(lessThan(spot, vec3(1.0)));
    int taps = inside ? n : 0;
    float lit = inside ? 0.0 : 1.0;
    float reach = n > 1 ? 0.5 * spacing * shadow.x : 0.0;
    for (int i = 0; i < taps; ++i) {
        vec2 corner = vec2(i & 1, i >> 1) * 2.0 - 1.0;
        lit += textureLod(shadow_map, spot + vec3(corner * reach, 0.0), 0.0) / float(n);
    }
    return lit;
}
