// A line with edges that fade over a pixel.

in vec4 colour;
noperspective in float across;

layout(location = 0) out vec4 pixel;

void main() {
    float inside = pixels.z + pixels.w - abs(across);
    float opacity = colour.a * clamp(inside / max(2.0 * pixels.w, 1e-3), 0.0, 1.0);
    if (opacity < 0.02) discard;
    pixel = vec4(colour.rgb, opacity);
}
