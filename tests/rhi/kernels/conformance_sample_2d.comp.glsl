// Looks a texture up at the coordinates held by another.
SAMPLER_2D(0, coordinates)
SAMPLER_2D(1, looked_up)
IMAGE_2D(2, target)
LOCAL_SIZE(16, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 p = ivec2(id.x, id.y);
    if (p.x < textureSize(coordinates, 0).x) imageStore(target, p, SAMPLE(looked_up, vec2(texelFetch(coordinates, p, 0))));
}
