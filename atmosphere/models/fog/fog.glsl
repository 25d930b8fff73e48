// Fog: air that is the same everywhere (Hoffman & Preetham 2002). Nothing is marched, no table is kept.
//
// Over a length s of air of extinction b, of which the source S is sent towards the camera at every place of it, per length,
//   dL/ds = -b L + S,  so  L(s) = L0 F + S / b (1 - F),  F = exp(-b s).
// Two sources:
//   one colour: S = b C, so L = L0 F + C (1 - F): the fog of fixed-function hardware;
//   in-scatter: S = E sum_c b_c p_c(theta), with the scattering coefficients and the extinction that the air has at the camera's
//     altitude and the sun's irradiance E there. Where nothing absorbs, b = sum_c b_c, which is the paper's equation.
// Written S s (1 - F) / (b s), which stands for any b, 0 too.
//
// Needs `atm`, `view`, triplet.glsl. A kernel may take other values for the phase functions by defining AUREOLE_FOG_PHASE(c, nu).
#ifndef AUREOLE_FOG_GLSL
#define AUREOLE_FOG_GLSL

#define AUREOLE_PROFILE_TABLE 10
#define AUREOLE_COLUMN_QUADRATURE quadrature
#define AUREOLE_COLUMN_NODES COLUMN_NODES
UNIFORMS(2, QuadratureBlock, quadrature)
SPEC_INT(30, COLUMN_NODES, 8)
SPEC_BOOL(31, ONE_COLOUR, false)
SPEC_BOOL(32, ENDLESS_SKY, false)
SPEC_REAL(33, FOG_EXTINCTION, real(0))  // of one colour, 1/km
SPEC_REAL(34, FOG_RED, real(0))         // its radiance per irradiance, 1/sr
SPEC_REAL(35, FOG_GREEN, real(0))
SPEC_REAL(36, FOG_BLUE, real(0))

#include "common/ground.glsl"
#include "common/slab.glsl"
#include "phase/phase.glsl"
#include "sky_view/camera_ray.glsl"
#include "transmittance/by_quadrature.glsl"
#include "light/sun.glsl"

#ifndef AUREOLE_FOG_PHASE
#define AUREOLE_FOG_PHASE(c, nu) phase_value(c, nu)
#endif

CONST(real, ENDLESS, real(1e9))  // km

vec3 fog_extinction(Medium air) { return ONE_COLOUR ? vec3(FOG_EXTINCTION) : air.extinction; }

vec3 fog_colour() { return vec3(FOG_RED, FOG_GREEN, FOG_BLUE); }

// S, per unit of the sun's irradiance above the air; of one colour in wavelengths, which is RGB, the same at each of them.
vec3 fog_source(Medium air, int sun, real nu) {
    if (ONE_COLOUR) return FOG_EXTINCTION * (IN_TRIPLETS ? vec3(real(1)) : fog_colour());
    vec3 scattered = vec3(real(0));
    for (int c = 0; c < PHASE_COUNT; ++c) scattered += air.scattering[c] * max(AUREOLE_FOG_PHASE(c, nu), real(0));
    return scattered * sun_share(view.space.x, view.sun_direction[sun].w, view.sun_azimuth[sun].w, view.sun_limb[sun].w);
}

vec3 fog_radiance(Medium air, vec3 source, real length_km) {
    return source * (length_km * mean_transmittance(fog_extinction(air) * length_km));
}

// In RGB, per unit of the sun's irradiance.
vec3 fog_sent(Medium air, int sun, real nu, real length_km) {
    vec3 sent = in_rgb(fog_radiance(air, fog_source(air, sun, nu), length_km));
    return ONE_COLOUR && IN_TRIPLETS ? fog_colour() * sent : sent;
}

// How far a ray of the sky goes. Seen from space the air ends where it does: a limb without end would be a wall around the planet.
real fog_length(Ray ray) {
    bool endless = ENDLESS_SKY && !ray.ground && ray.end > 0 && view.camera.w < real(0.5);
    return endless ? ENDLESS : ray.end;
}

// Sky and bare ground in RGB, per unit of the sun's irradiance. The ground's light has come through the real air, and goes back through
// the fog.
vec3 fog_sky_radiance(Medium air, Ray ray, int sun, real nu) {
    real length_km = fog_length(ray);
    vec3 radiance = fog_sent(air, sun, nu, length_km);
    if (ray.ground)
        radiance += in_rgb(ground_radiance(fog_extinction(air) * length_km, ground_beam_irradiance(sun_mu_after(ray, ray.end, real(0)))));
    return radiance;
}

#endif
