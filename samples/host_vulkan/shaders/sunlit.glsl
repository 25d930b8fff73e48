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

#endif
