// Pixel number and push constants, plus what a texture holds there.
struct Paint {
    vec4 scale;
    vec4 offset;
};
SAMPLER_2D(0, canvas)
PUSH_CONSTANTS(Paint, push)

FRAGMENT_MAIN(pixel) {
    vec4 place = vec4(real(pixel.x), real(pixel.y), real(0), real(1));
    return place * push.scale + push.offset + texelFetch(canvas, pixel, 0);
}
