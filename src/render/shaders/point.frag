// A disc with a darker rim, so that it stands out from any ground.

in vec4 colour;

layout(location = 0) out vec4 pixel;

void main() {
    float radius = 0.5 * pixels.z;
    float from_middle = length(gl_PointCoord - 0.5) * (pixels.z + 1.0);
    float opacity = colour.a * clamp(radius + 0.5 - from_middle, 0.0, 1.0);
    if (opacity < 0.02) discard;
    float rim = pixels.z < 5.0 ? 0.0 : clamp(from_middle - 0.74 * radius + 0.5, 0.0, 1.0);
    pixel = vec4(colour.rgb * (1.0 - 0.75 * rim), opacity);
}
