// Every texel tells its own place; z is the face.
IMAGE_CUBE(0, target)
LOCAL_SIZE(4, 4, 1)

COMPUTE_MAIN(id) {
    imageStore(target, id, vec4(real(id.x), real(id.y), real(id.z), real(imageSize(target).x)));
}
