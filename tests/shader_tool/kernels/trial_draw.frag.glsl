// A fragment kernel: colour = source texel + (pixel.x / 2, pixel.x / 2, 0, 1).
#include "common.glsl"

SAMPLER_2D(0, source)

FRAGMENT_MAIN(pixel) {
    real lo;
    real hi;
    split(real(pixel.x), lo, hi);
    return texelFetch(source, pixel, 0) + vec4(lo, hi, real(0), real(1));
}
