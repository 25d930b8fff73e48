// The kernel language, GLSL side. A kernel is written once with these words and runs as SPIR-V, and as C++ in float and in
// double (cpu_kernel.h gives the same words their C++ meaning).
//
// Rules that keep one source valid in both languages:
//   - `real` is the scalar; write real(0.1), never 0.1 or 0.1f. Small integers mix with scalars as they are: 1 - x, 2 * x;
//     with vectors they do not: real(2) * v.
//   - `uint` is 32 bits and wraps around, its literals end in u: 1u.
//   - Parameters: plain for input, OUT(T) and INOUT(T) for the others. Array parameters are only read. No array initializers.
//   - Constants at file scope: CONST(type, NAME, value). No other globals than the resources below.
//   - Local arrays whose size is specialized: LOCAL_ARRAY(type, name, size, maximum).
//   - No swizzles but single components: vec3(v) takes xyz, vec2(v) takes xy.
//   - Uniform blocks and push constants consist of vec4 (and mat4) only; integers travel as floats below 2^24.
//   - Textures are read with SAMPLE(texture, uv) (filtered, level 0), texelFetch(texture, ivec, 0) and textureSize(texture, 0).
//   - Storage images are write-only: imageStore(image, ivec, vec4), imageSize(image).
//   - UNROLL before a `for` of few rounds, their number a specialization constant: a wish to have them written out one by one.
//   - COUNT(n); where a kernel evaluates the medium n times: counted on the CPU when asked for, nothing in GLSL.
//   - Include guards as in C. A function is declared before it is used.
//
// For a host that compiles the GLSL itself, without descriptor sets, plain_glsl.h writes the lines that go before it:
// AUREOLE_PLAIN_GLSL, AUREOLE_PUSH_BINDING (uniform-block binding that stands for push constants), AUREOLE_SPEC_<id> for every
// specialization constant and AUREOLE_IMAGE_UNIT_<slot> for every storage image (devices need not have more than 8 image units;
// slots reach to 31). For a host's own shader with descriptor sets that includes look-ups: AUREOLE_SET chooses the set,
// AUREOLE_DEFINED_CONSTANTS takes the constants from AUREOLE_SPEC_<id> so that the host's constant ids stay its own.
#ifndef AUREOLE_PRELUDE_GLSL
#define AUREOLE_PRELUDE_GLSL

#define real float
#define OUT(T) out T
#define INOUT(T) inout T
#define CONST(T, NAME, VALUE) const T NAME = VALUE;
// A local array of SIZE elements, SIZE made of specialization constants and never above the constant MAX.
#define LOCAL_ARRAY(T, name, SIZE, MAX) T name[SIZE];
#define COUNT(n)
#ifdef AUREOLE_CONTROL_FLOW_ATTRIBUTES  // who says so has enabled the extension, which only the first lines of a shader may do
#define UNROLL [[unroll]]
#else
#define UNROLL
#endif

#ifdef AUREOLE_PLAIN_GLSL
#define AUREOLE_DEFINED_CONSTANTS
#define AUREOLE_LAYOUT(slot) layout(binding = slot)
#define AUREOLE_IMAGE_LAYOUT(slot) layout(binding = AUREOLE_IMAGE_UNIT_##slot)
#define AUREOLE_BLOCK_LAYOUT(slot) layout(binding = slot, std140)
#define PUSH_CONSTANTS(Block, name) layout(binding = AUREOLE_PUSH_BINDING, std140) uniform Block##_push { Block name; };
#else
#ifndef AUREOLE_SET
#define AUREOLE_SET 0
#endif
#define AUREOLE_LAYOUT(slot) layout(set = AUREOLE_SET, binding = slot)
#define AUREOLE_IMAGE_LAYOUT(slot) AUREOLE_LAYOUT(slot)
#define AUREOLE_BLOCK_LAYOUT(slot) layout(set = AUREOLE_SET, binding = slot, std140)
#define PUSH_CONSTANTS(Block, name) layout(push_constant, std430) uniform Block##_push { Block name; };
#endif

#ifdef AUREOLE_DEFINED_CONSTANTS
#define SPEC_INT(id, NAME, VALUE) const int NAME = int(AUREOLE_SPEC_##id);
#define SPEC_BOOL(id, NAME, VALUE) const bool NAME = bool(AUREOLE_SPEC_##id);
#define SPEC_REAL(id, NAME, VALUE) const float NAME = float(AUREOLE_SPEC_##id);
#else
#define SPEC_INT(id, NAME, VALUE) layout(constant_id = id) const int NAME = VALUE;
#define SPEC_BOOL(id, NAME, VALUE) layout(constant_id = id) const bool NAME = VALUE;
#define SPEC_REAL(id, NAME, VALUE) layout(constant_id = id) const float NAME = VALUE;
#endif

#define SAMPLER_2D(slot, name) AUREOLE_LAYOUT(slot) uniform sampler2D name;
#define SAMPLER_3D(slot, name) AUREOLE_LAYOUT(slot) uniform sampler3D name;
#define SAMPLER_CUBE(slot, name) AUREOLE_LAYOUT(slot) uniform samplerCube name;
#define IMAGE_2D(slot, name) AUREOLE_IMAGE_LAYOUT(slot) uniform writeonly image2D name;
#define IMAGE_3D(slot, name) AUREOLE_IMAGE_LAYOUT(slot) uniform writeonly image3D name;
#define IMAGE_CUBE(slot, name) AUREOLE_IMAGE_LAYOUT(slot) uniform writeonly image2DArray name;
#define UNIFORMS(slot, Block, name) AUREOLE_BLOCK_LAYOUT(slot) uniform name##_uniforms { Block name; };
#define SAMPLE(tex, uv) textureLod(tex, uv, 0.0)

// A compute kernel: LOCAL_SIZE(x, y, z) and COMPUTE_MAIN(id) { ... } with `ivec3 id` the invocation.
#define LOCAL_SIZE(x, y, z) layout(local_size_x = x, local_size_y = y, local_size_z = z) in;
#define COMPUTE_MAIN(id)                                     \
    void kernel_main(ivec3 id);                              \
    void main() { kernel_main(ivec3(gl_GlobalInvocationID)); } \
    void kernel_main(ivec3 id)

// A fragment kernel: FRAGMENT_MAIN(pixel) { ... return colour; } with `ivec2 pixel` counted from the top left.
#define FRAGMENT_MAIN(pixel)                                       \
    layout(location = 0) out vec4 aureole_fragment_colour;         \
    vec4 kernel_main(ivec2 pixel);                                 \
    void main() { aureole_fragment_colour = kernel_main(ivec2(gl_FragCoord.xy)); } \
    vec4 kernel_main(ivec2 pixel)

#endif
