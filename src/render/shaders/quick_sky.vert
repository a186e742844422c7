// The sky, quickly: a lattice over the picture with the sky's colour per corner.

const int columns = 24, rows = 32;   // as in scene_programs.h

out vec3 colour;   // encoded

void main() {
    int piece = gl_VertexID / 6, corner = gl_VertexID - 6 * piece;
    int right = corner == 1 || corner == 2 || corner == 4 ? 1 : 0;
    int upper = corner == 2 || corner == 4 || corner == 5 ? 1 : 0;
    vec2 place = vec2(piece % columns + right, piece / columns + upper);
    place = 2.0 * place / vec2(columns, rows) - 1.0;
    vec4 far = inverse(to_clip) * vec4(place, 1.0, 1.0);
    colour = encode(sky(normalize(far.xyz / far.w - eye.xyz)));
    gl_Position = vec4(place, 1.0, 1.0);
}
