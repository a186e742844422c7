// How much of the sky a place on the ground sees past the mast's foot and the balls.

float open_sky(vec3 place) {
    float open = 1.0;
    if (mast.w > 0.0) {
        float gap = max(distance(place.xz, mast.xz) / mast.w - 1.0, 0.0);
        open = 1.0 - 0.55 / (1.0 + 0.35 * gap * gap);
    }
    int count = int(counts.x);
    for (int i = 0; i < count; ++i) {
        vec3 way = balls[i].xyz - place;
        float far = inversesqrt(max(dot(way, way), 1e-12));
        float covered = max(way.y * far, 0.0) * min(balls[i].w * balls[i].w * far * far, 1.0);
        open *= 1.0 - 0.85 * covered;
    }
    return open;
}
