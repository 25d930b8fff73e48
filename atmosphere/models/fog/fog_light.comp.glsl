// The light of fog.
#include "light/inputs.glsl"

#define AUREOLE_FOG_PHASE(c, nu) smooth_phase(c, nu)
#include "models/fog/fog.glsl"

vec3 smooth_sky_radiance(int sun, real mu, real sine, real azimuth_cosine, real nu) {
    return fog_sky_radiance(sample_medium(view.camera.x), camera_ray_towards(mu, sine, azimuth_cosine, sun), sun, nu);
}

#include "light/light.glsl"
