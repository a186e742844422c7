// The cloth and the solids as the sun sees them.

layout(location = 0) in vec3 in_position;

void main() {
    gl_Position = vec4(2.0 * (to_shadow * vec4(in_position, 1.0)).xyz - 1.0, 1.0);
}
