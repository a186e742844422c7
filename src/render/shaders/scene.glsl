// The scene's values, for every shader. Lengths are in metres.

layout(std140) uniform Scene {
    mat4 to_clip;
    mat4 to_shadow;   // world -> shadow map: x, y, depth in [0, 1]
    vec4 eye;         // place; w: 1 where there is a ground
    vec4 to_sun;      // unit vector
    vec4 ground;      // the point below the cloth's middle; w: size of the cloth
    vec4 shadow;      // texel in the map, texel [m], tap step on cloth and on ground [texels]
    vec4 mast;        // foot; w: radius, 0 where there is none
    vec4 balls[8];    // spheres near the ground: centre; w: radius
    vec4 counts;      // x: of balls
};
