// The host's shadow map, as its own materials read it.
#ifndef HOST_SUNLIT_GLSL
#define HOST_SUNLIT_GLSL

#include "frame.glsl"

// Share of the first sun's beam at an offset; lit beyond the map. `lift`: towards which side the look-up moves, and how many texels.
float sunlit(vec3 offset, vec3 lift) {
    for (int c = 0; c < CASCADES; ++c) {
        vec3 place = (frame.camera_to_map[c] * vec4(offset + frame.texel_m[c] * lift, 1)).xyz;
        if (any(lessThan(place.xy, vec2(0.002))) || any(greaterThan(place.xy, vec2(0.998)))) continue;
        return textureLod(cascades, vec3((place.x + float(c)) / float(CASCADES), place.y, place.z), 0.0);
    }
    return 1.0;
}

// Of a surface: lifted off it, since it would shade itself, and blurred, since its triangles have corners.
float softly_sunlit(vec3 offset, vec3 n) {
    vec3 across = normalize(cross(n, frame.suns[0].xyz + vec3(1e-4, 0, 0))), along = cross(n, across);
    float sum = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) sum += sunlit(offset + 4.0 * n, 1.5 * n + 1.2 * (float(x) * across + float(y) * along));
    return sum / 9.0;
}

#endif
