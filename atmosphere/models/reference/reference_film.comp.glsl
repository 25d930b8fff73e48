// Adds a frame's paths to the film.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PHASE_TABLE 7
#define AUREOLE_PROFILE_TABLE 10
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, ViewBlock, view)
UNIFORMS(11, QuadratureBlock, quadrature)
IMAGE_2D(3, film_out)

struct FilmFrame {
    vec4 paths;  // x: number before this frame (0: the film starts anew), y: number of this frame
};
PUSH_CONSTANTS(FilmFrame, film_frame)

#include "common/triplet.glsl"
#include "models/reference/film.glsl"

LOCAL_SIZE(8, 8, 1)

COMPUTE_MAIN(id) {
    // Not the film's own size: a new film reads another texture, as nothing has been written to its own.
    ivec2 size = ivec2(imageSize(film_out).x, imageSize(film_out).y / 3);
    ivec2 texel = ivec2(id.x, id.y);
    if (id.x >= size.x || id.y >= size.y) return;
    ViewRay ray = view_ray((real(id.x) + real(0.5)) / real(size.x), (real(id.y) + real(0.5)) / real(size.y));
    CameraWalk start = camera_walk(ray.direction, view_direction(ray.direction));
    int before = int(film_frame.paths.x);

    Estimate estimate = no_estimate();
    vec3 exact = vec3(real(0));
    if (before > 0) {
        estimate = film_estimate(texel);
        exact = vec3(film_texel(texel, 2));
    }
    if (ray.valid && start.met) {
        Leg leg = leg_to_end(start.walk, FIRST_ORDER_SAMPLED, ALL_SUNS);
        if (before == 0) exact = exact_part(start.walk, leg, ALL_SUNS);
        add_paths(estimate, start.walk, leg, ALL_SUNS, uint(id.x), uint(id.y), before, int(film_frame.paths.y));
    }
    imageStore(film_out, texel, vec4(estimate.mean, estimate.count));
    imageStore(film_out, ivec2(id.x, id.y + size.y), vec4(estimate.spread, real(0)));
    imageStore(film_out, ivec2(id.x, id.y + 2 * size.y), vec4(exact, real(0)));
}
