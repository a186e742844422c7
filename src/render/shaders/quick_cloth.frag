// Cloth, quickly: as cloth.frag with one shadow tap.

uniform sampler2D cloth_texture;

in vec4 terms;
in vec3 spot;
in vec2 uv;

layout(location = 0) out vec4 pixel;

void main() {
    vec3 albedo = texture(cloth_texture, uv).rgb;
    float side = gl_FrontFacing ? 1.0 : -1.0;
    float toward_sun = terms.x * side, upward = terms.y * side;
    float lit = quick_sunlight(spot, 0.0, 1);
    float direct = max((toward_sun + 0.12) / 1.12, 0.0);
    float through = max(-toward_sun, 0.0);
    vec3 around = 0.65 * (sky_light + ground_light) + 0.35 * upward * (sky_light - ground_light);
    vec3 sun = sun_light * lit;
    vec3 light = albedo * (sun * direct + around);
    light += albedo * (0.3 + 0.7 * albedo) * sun * (1.1 * through);
    light += (sky_light * terms.z + sun * terms.w) * (0.5 + 0.5 * albedo);
    pixel = vec4(encode_quickly(light), 1.0);
}
