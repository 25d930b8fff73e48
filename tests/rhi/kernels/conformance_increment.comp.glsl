// target = source + push.amount: a chain of these shows missing synchronization. Writes past the edges must vanish.
struct Amount {
    vec4 amount;
};
SAMPLER_2D(0, source)
IMAGE_2D(1, target)
PUSH_CONSTANTS(Amount, push)
LOCAL_SIZE(8, 8, 1)

COMPUTE_MAIN(id) {
    ivec2 p = ivec2(id.x, id.y);
    ivec2 size = textureSize(source, 0);
    ivec2 inside = ivec2(min(p.x, size.x - 1), min(p.y, size.y - 1));
    COUNT(1);
    imageStore(target, p, texelFetch(source, inside, 0) + push.amount);
}
