// What the air of a ray scatters of a sun's direct beam towards the camera, slab by slab: of this the march of the shadows pass and
// that of a host's shader (host/aureole.glsl) are made. Needs `atm` and the functions of transmittance/transmittance.glsl.
#ifndef AUREOLE_SHADOWS_BEAM_GLSL
#define AUREOLE_SHADOWS_BEAM_GLSL

#include "common/slab.glsl"
#include "common/geometry.glsl"
#include "medium/medium.glsl"

// A slab of air as constant as it is at t, behind air of optical depth `depth`; as the froxels of aerial perspective have them.
struct BeamSlab {
    Medium air;
    vec3 depth;  // of the slab
    vec3 beam;   // times air.scattering of a phase function and its value: radiance per unit of the sun's irradiance, where it is lit
};
BeamSlab beam_slab(Ray ray, vec3 depth, real t, real step_km) {
    BeamSlab slab;
    real h = altitude_after(ray.altitude, ray.mu, t);
    slab.air = sample_medium(h);
    slab.depth = slab.air.extinction * step_km;
    slab.beam = exp(-depth) * mean_transmittance(slab.depth) * transmittance_to_sun(h, sun_mu_after(ray, t, h)) * step_km;
    return slab;
}

#endif
