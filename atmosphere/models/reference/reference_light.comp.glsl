// The light of the path tracer.
#include "light/inputs.glsl"

#define AUREOLE_PROFILE_TABLE 10
#define AUREOLE_FIRST_PHASE(c, nu) smooth_phase(c, nu)
#define AUREOLE_FIRST_ORDER_BY_NODES
UNIFORMS(11, QuadratureBlock, quadrature)
SPEC_INT(34, LIGHT_PATHS, 8)

#include "models/reference/reference.glsl"

// A number of a direction's cosine, for its random numbers: the same wherever rounding is the only difference, but for bad luck.
uint cosine_number(real cosine) { return uint(int((cosine + 1) * real(4096) + real(0.5))); }

vec3 smooth_sky_radiance(int sun, real mu, real sine, real azimuth_cosine, real) {
    vec3 up = vec3(view.up);
    vec3 towards = vec3(view.sun_azimuth[sun]);
    real across = sqrt(max((1 - azimuth_cosine) * (1 + azimuth_cosine), real(0)));
    vec3 direction = mu * up + sine * (azimuth_cosine * towards + across * cross(up, towards));
    CameraWalk start = camera_walk(direction, view_direction(direction));
    if (!start.met) return vec3(real(0));
    Leg leg = leg_to_end(start.walk, FIRST_ORDER_SAMPLED, sun);
    Estimate estimate = no_estimate();
    add_paths(estimate, start.walk, leg, sun, cosine_number(mu), cosine_number(azimuth_cosine), 0, LIGHT_PATHS);
    return exact_part(start.walk, leg, sun) + estimate.mean;
}

#include "light/light.glsl"
