// Squares on the ground around the mast's foot and below balls, where less of the sky is seen.

out vec3 position;
out vec2 from_middle;   // in half sides

void main() {
    int piece = gl_VertexID / 6, i = gl_VertexID - 6 * piece;
    vec2 corner = vec2(i == 1 || i == 2 || i == 4 ? 1.0 : -1.0, i == 2 || i == 4 || i == 5 ? 1.0 : -1.0);
    vec4 body = piece == 0 ? mast : balls[max(piece - 1, 0)];
    float half_side = piece == 0 ? 25.0 * body.w : 6.0 * body.w;
    if (piece > int(counts.x)) half_side = 0.0;
    from_middle = corner;
    position = vec3(body.x + half_side * corner.x, ground.y, body.z + half_side * corner.y);
    gl_Position = to_clip * vec4(position, 1.0);
}
