// Cloth, quickly: what the light depends on, per corner.

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec3 in_colour;

out vec4 terms;   // of the front: toward the sun, upward; of the side seen: rim, gloss
out vec3 spot;    // in the shadow map
out vec2 uv;

void main() {
    vec3 to_eye = normalize(eye.xyz - in_position);
    float toward_sun = dot(in_normal, to_sun.xyz);
    float facing = dot(in_normal, to_eye);
    vec3 seen = facing < 0.0 ? -in_normal : in_normal;
    // A normal of nothing, of a cloth crumpled to a point, has no rim.
    float rim = dot(in_normal, in_normal) * (1.0 - min(abs(facing), 1.0));
    float gloss = pow(max(dot(seen, normalize(to_eye + to_sun.xyz)), 0.0), 28.0);
    terms = vec4(toward_sun, in_normal.y, 0.12 * rim * rim * rim, 0.06 * gloss);
    vec3 lift = (toward_sun < 0.0 ? -in_normal : in_normal) * 2.0 + to_sun.xyz * 1.5;
    spot = (to_shadow * vec4(in_position + lift * shadow.y, 1.0)).xyz;
    uv = in_colour.xy;
    gl_Position = to_clip * vec4(in_position, 1.0);
}
