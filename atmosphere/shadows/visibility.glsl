// A look into the host's shadow map. Needs `shadow` (ShadowBlock, blocks.glsl) and the texture `shadow_map`.
#ifndef AUREOLE_SHADOWS_VISIBILITY_GLSL
#define AUREOLE_SHADOWS_VISIBILITY_GLSL

SPEC_INT(40, SHADOW_CASCADES, 1)

// 1 where the shadowed sun's beam reaches a point, 0 where the map is nearer to the sun. The point is relative to the camera, km,
// world axes: small numbers, in which floats are exact.
real sun_visibility(vec3 point) {
    vec4 place = vec4(point, real(1));
    ivec2 size = textureSize(shadow_map, 0);
    int width = size.x / SHADOW_CASCADES;
    // One look after the loop, and places compared before they are divided: with both inside, lavapipe of Mesa 22.3 crashed as it ran the
    // composite of single-lut.
    int cascade = -1;
    vec3 at = vec3(real(0));  // u, v, depth
    for (int i = SHADOW_CASCADES - 1; i >= 0; --i) {  // the finest one that has the point is the last to speak
        real w = dot(shadow.world_to_map[4 * i + 3], place);
        real u = dot(shadow.world_to_map[4 * i], place);
        real v = dot(shadow.world_to_map[4 * i + 1], place);
        real depth = dot(shadow.world_to_map[4 * i + 2], place);
        if (min(u, min(v, depth)) >= 0 && max(u, v) < w && depth <= w) {
            cascade = i;
            at = vec3(u, v, depth) / w;
        }
    }
    if (cascade < 0) return real(1);
    ivec2 texel = ivec2(cascade * width + min(int(at.x * real(width)), width - 1), min(int(at.y * real(size.y)), size.y - 1));
    real behind = shadow.depth.x * (at.z - texelFetch(shadow_map, texel, 0).x);
    return behind > shadow.depth.y ? real(0) : real(1);
}

#endif
