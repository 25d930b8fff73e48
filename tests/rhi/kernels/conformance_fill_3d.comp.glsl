// Every texel tells its own place.
IMAGE_3D(0, target)
LOCAL_SIZE(4, 2, 2)

COMPUTE_MAIN(id) {
    ivec3 size = imageSize(target);
    imageStore(target, id, vec4(real(id.x), real(id.y), real(id.z), real(size.x + 10 * size.y + 100 * size.z)));
}
