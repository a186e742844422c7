// What the shaders of lines and points share.

uniform mat4 to_clip;
uniform vec2 lift;     // how far marks are drawn toward the eye [m]; of depth, see lifted()
uniform vec4 pixels;   // size of the picture; of a line half its width and half the faded edge, of a
                       // point its diameter

// Nearer in depth alone: where it stands in the picture stays. Depth is a + b / w for a point that is
// w before the eye.
vec4 lifted(vec3 place) {
    vec4 clip = to_clip * vec4(place, 1.0);
    clip.z += lift.y * (clip.w / max(clip.w - lift.x, 0.5 * abs(clip.w)) - 1.0);
    return clip;
}
