// The floor: takes the shadow and fades into the horizon.

in vec3 position;

layout(location = 0) out vec4 pixel;

void main() {
    vec3 offset = position - ground.xyz;
    float distance_in_sizes = length(offset.xz) / ground.w;
    float haze = 1.0 - exp(-0.006 * distance_in_sizes * distance_in_sizes);
    vec3 horizon = sky(normalize(vec3(position.x - eye.x, 0.0, position.z - eye.z)));

    float lit = sunlight(position, shadow.w, 6);
    float open = open_sky(position);
    vec3 albedo = vec3(0.335, 0.33, 0.315);
    vec3 light = albedo * (sun_light * to_sun.y * lit + sky_light * (0.9 * open));
    pixel = vec4(tone(mix(light, horizon, haze)), 1.0);
}
