// A line between two vertices as a quad that keeps its width in pixels. The vertices come as a
// buffer texture, since each corner of the quad needs both ends.

uniform usamplerBuffer ends;   // position as the bits of three floats; sRGB and opacity, 8 bits each
uniform mat4 to_clip;
uniform vec2 lift;             // how far lines are drawn toward the eye [m]; of depth, see lifted()
uniform vec4 pixels;           // size of the picture; half the width of a line; half the faded edge

out vec4 colour;
noperspective out float across;   // from the middle [pixels]

// Nearer in depth alone: where it stands in the picture stays. Depth is a + b / w for a point that is
// w before the eye.
vec4 lifted(vec3 place) {
    vec4 clip = to_clip * vec4(place, 1.0);
    clip.z += lift.y * (clip.w / max(clip.w - lift.x, 0.5 * abs(clip.w)) - 1.0);
    return clip;
}

void main() {
    int line = gl_VertexID / 6, corner = gl_VertexID - 6 * line;
    bool second = corner == 1 || corner == 2 || corner == 4;
    float side = corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0;
    uvec4 first_end = texelFetch(ends, 2 * line), second_end = texelFetch(ends, 2 * line + 1);
    vec4 a = lifted(uintBitsToFloat(first_end.xyz)), b = lifted(uintBitsToFloat(second_end.xyz));

    // What lies behind the eye is cut off, so that the direction in the picture is right.
    const float nearest = 1e-5;
    vec4 here = second ? b : a;
    if (a.w < nearest && b.w >= nearest) a = mix(a, b, (nearest - a.w) / (b.w - a.w));
    else if (b.w < nearest && a.w >= nearest) b = mix(b, a, (nearest - b.w) / (a.w - b.w));
    here = second ? b : a;
    vec2 along = (b.xy / b.w - a.xy / a.w) * pixels.xy;
    float length_in_picture = length(along);
    along = length_in_picture > 1e-6 ? along / length_in_picture : vec2(1.0, 0.0);
    across = side * (pixels.z + pixels.w);
    vec2 offset = vec2(-along.y, along.x) * across + (second ? along : -along) * pixels.w;
    here.xy += 2.0 * offset / pixels.xy * here.w;
    gl_Position = here;

    uint bits = second ? second_end.w : first_end.w;
    colour = vec4(bits & 255u, (bits >> 8) & 255u, (bits >> 16) & 255u, bits >> 24) / 255.0;
}
