// What fragment shaders share beyond light.glsl and dither.glsl: tone and shadow.

vec3 tone(vec3 light) {
    return dithered(encode(light));
}

// How much of the sun reaches a point: the mean of n x n taps of the shadow map, `spacing` texels
// apart; each tap is itself a blend of four.
uniform sampler2DShadow shadow_map;

float sunlight(vec3 place, float spacing, int n) {
    vec3 spot = (to_shadow * vec4(place, 1.0)).xyz;
    bool inside = all(greaterThan(spot, vec3(0.0))) && all(lessThan(spot, vec3(1.0)));
    float first = -0.5 * float(n - 1) * spacing * shadow.x;

    // Most points are all in light or all in shade: four corners and the middle tell. Loops, not
    // branches, because drivers that draw on the processor run both sides of a branch.
    int hints = inside ? 5 : 0;
    float hint = inside ? 0.0 : 5.0;
    for (int i = 0; i < hints; ++i) {
        vec2 corner = i == 4 ? vec2(0.0) : vec2(i & 1, i >> 1) * 2.0 - 1.0;
        hint += textureLod(shadow_map, spot + vec3(corner * first, 0.0), 0.0);
    }
    bool edge = hint > 0.0 && hint < 5.0;
    int taps = edge ? n * n : 0;
    float lit = edge ? 0.0 : 0.2 * hint;
    float share = 1.0 / float(n * n);
    for (int i = 0; i < taps; ++i) {
        vec2 tap = vec2(i % n, i / n) * (spacing * shadow.x) + first;
        lit += share * textureLod(shadow_map, spot + vec3(tap, 0.0), 0.0);
    }
    return lit;
}
