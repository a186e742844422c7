// A trace of noise hides the steps of 8 bits in the sky.

vec3 dithered(vec3 encoded) {
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return encoded + (noise - 0.5) / 255.0;
}
