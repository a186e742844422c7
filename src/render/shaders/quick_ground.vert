// The ground, quickly, with its colours in the sun and in the shade per corner. No buffers: six
// corners for each piece. Either a disc of rings around the cloth, wider ones farther out, or the
// part that the shadow map covers.

uniform bool under_map;

const int pieces = 40, rings = 18;   // as in scene_programs.h
const int cells = 12;                // a side of the part under the map; as there

out vec3 in_sun;      // encoded
out vec3 in_shade;    // encoded
out vec3 spot;

vec3 of_disc(int piece, ivec2 corner) {
    float share = float(piece / pieces + corner.x) / float(rings);
    float angle = 6.2831853 * float(piece % pieces + corner.y) / float(pieces);
    float radius = ground.w * (4.0 * share + 64.0 * pow(share, 6.0));
    return ground.xyz + radius * vec3(cos(angle), 0.0, sin(angle));
}

vec3 below_map(int piece, ivec2 corner) {
    vec2 place = vec2(piece % cells + corner.x, piece / cells + corner.y) / float(cells);
    vec3 on_ray = (inverse(to_shadow) * vec4(place, 0.5, 1.0)).xyz;
    return on_ray + to_sun.xyz * ((ground.y - on_ray.y) / to_sun.y);
}

void main() {
    int piece = gl_VertexID / 6, i = gl_VertexID - 6 * piece;
    ivec2 corner = ivec2(i == 1 || i == 2 || i == 4 ? 1 : 0, i == 2 || i == 4 || i == 5 ? 1 : 0);
    vec3 position = under_map ? below_map(piece, corner) : of_disc(piece, corner);

    float in_sizes = distance(position.xz, ground.xz) / ground.w;
    float haze = 1.0 - exp(-0.006 * in_sizes * in_sizes);
    vec3 horizon = sky(normalize(vec3(position.x - eye.x, 0.0, position.z - eye.z)));
    vec3 albedo = vec3(0.335, 0.33, 0.315);
    vec3 shade = albedo * sky_light * 0.9;
    in_sun = encode(mix(shade + albedo * sun_light * to_sun.y, horizon, haze));
    in_shade = encode(mix(shade, horizon, haze));
    spot = (to_shadow * vec4(position, 1.0)).xyz;
    gl_Position = to_clip * vec4(position, 1.0);
}
