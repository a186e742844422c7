// A line between two vertices as a quad that keeps its width in pixels. The vertices come as a
// buffer texture, since each corner of the quad needs both ends.

uniform usamplerBuffer ends;   // position as the bits of three floats; sRGB and opacity, 8 bits each

out vec4 colour;
noperspective out float across;   // from the middle [pixels]

void main() {
    int line = gl_VertexID / 6, corner = gl_VertexID - 6 * line;
    bool second = corner == 1 || corner == 2 || corner == 4;
    float side = corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0;
    uvec4 first_end = texelFetch(ends, 2 * line), second_end = texelFetch(ends, 2 * line + 1);
    vec4 a = lifted(uintBitsToFloat(first_end.xyz)), b = lifted(uintBitsToFloat(second_end.xyz));

    // What lies behind the eye is cut off, so that the direction in the picture is right.
    const float nearest = 1e-5;
    if (a.w < nearest && b.w >= nearest) a = mix(a, b, (nearest - a.w) / (b.w - a.w));
    else if (b.w < nearest && a.w >= nearest) b = mix(b, a, (nearest - b.w) / (a.w - b.w));
    vec4 here = second ? b : a;
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
