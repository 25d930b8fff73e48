// Stores the texels of one texture into another, as they are.
SAMPLER_2D(0, source)
IMAGE_2D(1, target)
LOCAL_SIZE(8, 4, 1)

COMPUTE_MAIN(id) {
    ivec2 p = ivec2(id.x, id.y);
    ivec2 size = textureSize(source, 0);
    if (p.x < size.x && p.y < size.y) imageStore(target, p, texelFetch(source, p, 0));
}
