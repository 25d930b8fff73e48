// The light of models with sky-view tables.
#include "light/inputs.glsl"

#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_SKY_VIEW_TABLE
#define AUREOLE_SHARP_PHASE(c, nu) smooth_phase(c, nu)
SAMPLER_2D(2, sky_view_table)
SAMPLER_2D(3, transmittance_table)

#include "common/geometry.glsl"
#include "transmittance/transmittance.glsl"
#include "sky_view/sky_view.glsl"

vec3 smooth_sky_radiance(int sun, real mu, real sine, real azimuth_cosine, real nu) {
    return in_rgb(sky_view_radiance(sky_view_coordinates(sun, mu, sine, azimuth_cosine), nu));
}

#include "light/light.glsl"
