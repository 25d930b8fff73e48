// The film: means of the paths of all frames so far, for each direction of the camera's own projection. Layers of rgba32_float stacked
// in y: 0: mean of the paths (a: their number); 1: sum of their squared distances from it; 2: what is known without paths.
#ifndef AUREOLE_FILM_GLSL
#define AUREOLE_FILM_GLSL

#include "models/reference/reference.glsl"

SAMPLER_2D(2, film)

ivec2 film_size() {
    ivec2 size = textureSize(film, 0);
    return ivec2(size.x, size.y / 3);
}
vec4 film_texel(ivec2 texel, int layer) {
    ivec2 size = film_size();
    ivec2 inside = ivec2(clamp(texel.x, 0, size.x - 1), clamp(texel.y, 0, size.y - 1));
    return texelFetch(film, ivec2(inside.x, inside.y + layer * size.y), 0);
}
Estimate film_estimate(ivec2 texel) {
    Estimate estimate;
    estimate.mean = vec3(film_texel(texel, 0));
    estimate.count = film_texel(texel, 0).w;
    estimate.spread = vec3(film_texel(texel, 1));
    return estimate;
}

#endif
