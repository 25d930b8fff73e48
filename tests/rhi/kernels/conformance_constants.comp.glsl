// Writes down everything that is not a texture: specialization, push constants, uniforms; one row for each.
struct Uniforms {
    vec4 first;
    mat4 matrix;
    vec4 last;
};
struct Push {
    vec4 a;
    vec4 b;
};
UNIFORMS(0, Uniforms, block)
IMAGE_2D(1, target)
PUSH_CONSTANTS(Push, push)
SPEC_INT(0, SPECIAL_INT, 7)
SPEC_BOOL(1, SPECIAL_BOOL, true)
SPEC_REAL(2, SPECIAL_REAL, 0.5)
LOCAL_SIZE(1, 1, 1)

COMPUTE_MAIN(id) {
    real flag = real(0);
    if (SPECIAL_BOOL) flag = real(1);
    imageStore(target, ivec2(0, 0), vec4(real(SPECIAL_INT), flag, SPECIAL_REAL, real(id.x)));
    imageStore(target, ivec2(1, 0), push.a);
    imageStore(target, ivec2(2, 0), push.b);
    imageStore(target, ivec2(3, 0), block.first);
    imageStore(target, ivec2(4, 0), block.matrix * vec4(real(1), real(10), real(100), real(1000)));
    imageStore(target, ivec2(5, 0), block.last);
}
