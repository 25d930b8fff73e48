// Optical depth of a part of a ray on which altitude is monotone. Needs `atm`, and `transmittance_table` or what column.glsl needs.
#ifndef AUREOLE_DARK_DEPTH_GLSL
#define AUREOLE_DARK_DEPTH_GLSL

#include "common/geometry.glsl"
#include "transmittance/transmittance.glsl"

#ifdef AUREOLE_TRANSMITTANCE_TABLE
// From the table: on the way up the difference of the ends' depths to the top, on the way down the same of the reversed ray. For
// pieces that scatter nothing towards the camera it is cheaper than nodes, and as good.
vec3 dark_depth(Ray ray, real t0, real t1, bool upwards) {
    real h0 = altitude_after(ray.altitude, ray.mu, t0);
    real h1 = altitude_after(ray.altitude, ray.mu, t1);
    real mu0 = view_mu_after(ray, t0, h0);
    real mu1 = view_mu_after(ray, t1, h1);
    vec3 depth = optical_depth_to_top(upwards ? h0 : h1, upwards ? mu0 : -mu1) -
                 optical_depth_to_top(upwards ? h1 : h0, upwards ? mu1 : -mu0);
    return max(depth, vec3(real(0)));
}
#else
vec3 dark_depth(Ray ray, real t0, real t1, bool upwards) { return column(ray.altitude, ray.mu, t0, t1, upwards); }
#endif

#endif
