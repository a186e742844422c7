// A level square below the cloth, far wider than the haze lets one see.

out vec3 position;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    position = ground.xyz + vec3(corner.x, 0.0, corner.y) * (60.0 * ground.w);
    gl_Position = to_clip * vec4(position, 1.0);
}
