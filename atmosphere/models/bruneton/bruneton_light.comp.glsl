// The light of the model bruneton.
#include "light/inputs.glsl"

#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_SCATTERING_TABLE
#define AUREOLE_IRRADIANCE_TABLE
#define AUREOLE_SHARP_PHASE(c, nu) smooth_phase(c, nu)
SAMPLER_3D(2, scattering_table)
SAMPLER_2D(3, transmittance_table)
SAMPLER_2D(4, irradiance_table)

#include "common/view_ray.glsl"
#include "models/bruneton/bruneton_rays.glsl"

vec3 smooth_sky_radiance(int sun, real mu, real sine, real, real nu) {
    ViewDirection v;
    v.mu = mu;
    v.sine = sine;
    v.horizontal = vec3(real(0));
    real entry = distance_to_air(v);
    return entry < 0 ? vec3(real(0)) : max(ray_radiance(camera_air_ray(v, entry, sun, nu)), vec3(real(0)));
}

#include "light/light.glsl"
