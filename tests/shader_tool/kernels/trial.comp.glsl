// Uses every word that the shader tool reads: textures, images, uniforms, push constants, specialization, includes.
#include "common.glsl"
#include "common.glsl"

#define SLOT_TARGET 4  // slots may be named

SAMPLER_2D(0, source)
SAMPLER_3D(2, volume)
SAMPLER_CUBE(3, sky)
UNIFORMS(1, Params, params)
IMAGE_2D(SLOT_TARGET, target)
PUSH_CONSTANTS(Params, push)
SPEC_INT(0, STEPS, 4)
SPEC_BOOL(9, LIT, true)  // these three change nothing
SPEC_REAL(7, SHARE, real(-0.375))
SPEC_INT(1, BELOW, -3)

#ifdef AUREOLE_NEVER_DEFINED
SAMPLER_2D(0, absent)
#endif

LOCAL_SIZE(8, 4, 1)

// target = STEPS * (source * exp(-scale.x) + push.scale), with scale.x taken apart and put together again.
COMPUTE_MAIN(id) {
    ivec2 size = imageSize(target);
    if (id.x >= size.x || id.y >= size.y) { return; }
    vec2 uv = (vec2(ivec2(id)) + real(0.5)) / vec2(size);
    real lo;
    real hi;
    split(params.scale.x, lo, hi);
    vec4 unlit = SAMPLE(volume, vec3(uv, real(0.5))) + SAMPLE(sky, vec3(real(0), real(0), real(1)));
    vec4 sum = vec4(real(0));
    for (int i = 0; i < STEPS; ++i) { sum += SAMPLE(source, uv) * exp(-(lo + hi)) + push.scale + real(0) * unlit; }
    if (!LIT) sum += vec4(SHARE * real(BELOW));
    imageStore(target, ivec2(id), sum);
}
