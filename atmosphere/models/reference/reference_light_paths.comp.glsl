// Traces the directions of the light's integral (light/directions.glsl), an invocation a part of the paths of one. They have a pass of
// their own, as all of them together are too much work for one invocation: see light_paths.glsl.
#include "light/inputs.glsl"

#define AUREOLE_PROFILE_TABLE 10
#define AUREOLE_FIRST_PHASE(c, nu) smooth_phase(c, nu)
#define AUREOLE_FIRST_ORDER_BY_NODES
UNIFORMS(11, QuadratureBlock, quadrature)

#include "light/directions.glsl"
#include "models/reference/light_paths.glsl"
#include "models/reference/reference.glsl"

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(light_out);
    int sun = id.y / LIGHT_PARTS;
    if (id.x >= size.x || id.y >= size.y || sun >= SUN_COUNT) return;
    int part = id.y - sun * LIGHT_PARTS;
    vec3 direction = light_direction(sun, light_ring(id.x / LIGHT_AZIMUTHS), id.x % LIGHT_AZIMUTHS).direction;
    CameraWalk start = camera_walk(direction, view_direction(direction));
    vec3 radiance = vec3(real(0));
    if (start.met) {
        Leg leg = leg_to_end(start.walk, FIRST_ORDER_SAMPLED, sun);
        int first = LIGHT_PATHS * part / LIGHT_PARTS;
        int count = LIGHT_PATHS * (part + 1) / LIGHT_PARTS - first;
        if (part == 0) radiance = exact_part(start.walk, leg, sun);
        Estimate estimate = no_estimate();
        add_paths(estimate, start.walk, leg, sun, uint(id.x), uint(sun), first, count);
        radiance += real(count) / real(max(LIGHT_PATHS, 1)) * estimate.mean;
    }
    imageStore(light_out, ivec2(id.x, id.y), vec4(radiance, real(1)));
}
