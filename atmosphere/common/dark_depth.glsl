// Optical depth of a part of a ray. Needs `atm`, `transmittance_table`.
#ifndef AUREOLE_DARK_DEPTH_GLSL
#define AUREOLE_DARK_DEPTH_GLSL

#include "common/geometry.glsl"
#include "transmittance/transmittance.glsl"

// Optical depth between two points of a ray from the table: on the way up the difference of their depths to the top, on the way
// down the same of the reversed ray. For pieces that scatter nothing towards the camera it is cheaper than nodes, and as good.
vec3 dark_depth(Ray ray, real t0, real t1, bool upwards) {
    real h0 = altitude_after(ray.altitude, ray.mu, t0);
    real h1 = altitude_after(ray.altitude, ray.mu, t1);
    real mu0 = view_mu_after(ray, t0, h0);
    real mu1 = view_mu_after(ray, t1, h1);
    vec3 depth = upwards ? optical_depth_to_top(h0, mu0) - optical_depth_to_top(h1, mu1)
                         : optical_depth_to_top(h1, -mu1) - optical_depth_to_top(h0, -mu0);
    return max(depth, vec3(real(0)));
}

#endif
