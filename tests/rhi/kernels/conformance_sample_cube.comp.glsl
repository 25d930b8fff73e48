// Looks a cube up in the directions held by another texture.
SAMPLER_2D(0, coordinates)
SAMPLER_CUBE(1, looked_up)
IMAGE_2D(2, target)
LOCAL_SIZE(16, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 p = ivec2(id.x, id.y);
    if (p.x < textureSize(coordinates, 0).x) imageStore(target, p, SAMPLE(looked_up, vec3(texelFetch(coordinates, p, 0))));
}
