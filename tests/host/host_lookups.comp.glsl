// Every look-up that a host's shader has (host/aureole.glsl), asked from a texture: one row a question, one row an answer.
#include "common/constants.glsl"

// The host's own shadows: stripes across x, 10 km of light, 10 km of shadow, with edges 2 km wide (host_shader.cpp has the same).
real stripes(vec3 offset_m) { return clamp(real(0.5) + 10 * (abs(fract(offset_m.x / real(20000)) - real(0.5)) - real(0.25)), real(0), real(1)); }
#define AUREOLE_SUN_VISIBILITY(offset_m) stripes(offset_m)
#include "host/aureole.glsl"

SAMPLER_2D(8, questions)  // 0: direction, distance in metres; 1: place on the target, sun, beginning of the march; 2: offset in metres,
                          // samples of the march plus their jitter
IMAGE_2D(9, answers)      // columns as below
LOCAL_SIZE(32, 1, 1)

COMPUTE_MAIN(id) {
    if (id.x >= textureSize(questions, 0).y) return;
    vec4 ray = texelFetch(questions, ivec2(0, id.x), 0);
    vec4 place = texelFetch(questions, ivec2(1, id.x), 0);
    vec3 offset = vec3(texelFetch(questions, ivec2(2, id.x), 0));
    vec3 direction = vec3(ray);
    int sun = int(place.z);
    AureoleAir air = aureole_aerial_perspective(place.x, place.y, ray.w, direction);
    real samples = texelFetch(questions, ivec2(2, id.x), 0).w;
    AureoleBeam beam = aureole_march(sun, direction, place.w, ray.w, int(samples), fract(samples));

    imageStore(answers, ivec2(0, id.x), vec4(aureole_sky(direction), real(1)));
    imageStore(answers, ivec2(1, id.x), vec4(aureole_sky_transmittance(direction), real(1)));
    imageStore(answers, ivec2(2, id.x), vec4(air.transmittance, real(1)));
    imageStore(answers, ivec2(3, id.x), vec4(air.radiance, real(1)));
    imageStore(answers, ivec2(4, id.x), vec4(aureole_sun_transmittance(sun, offset), real(1)));
    imageStore(answers, ivec2(5, id.x), vec4(aureole_sun_irradiance(sun, offset), real(1)));
    imageStore(answers, ivec2(6, id.x), vec4(aureole_sky_irradiance(direction), real(1)));
    imageStore(answers, ivec2(7, id.x), vec4(beam.transmittance, real(1)));
    imageStore(answers, ivec2(8, id.x), vec4(beam.radiance, real(1)));
    imageStore(answers, ivec2(9, id.x), vec4(beam.loss, real(1)));
}
