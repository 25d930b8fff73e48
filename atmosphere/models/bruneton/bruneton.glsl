// Tables of Bruneton & Neyret 2008 in the parameterization of Bruneton 2017: scattered light over (altitude, mu, mu_s, nu), the four
// numbers on which a ray's radiance depends in a spherically symmetric atmosphere. Packed into a 3D texture: nu x mu_s along x, mu
// along y, altitude along z. Needs `atm`.
//
// Layers stacked along z:
//   layer 0:     (light scattered once by molecules + light scattered more than once / p_R(nu)), so that the look-up multiplies by
//                Rayleigh's phase function p_R at the pixel's own nu: what varies fastest with nu needs no nodes. rgb;
//   layer 1 + i: light scattered once by the i-th sharp phase function (aerosols), without its value.
// In combined textures there is layer 0 alone, and its fourth component is the red of layer 1; green and blue follow from the
// assumption that both kinds of scattered light have the same ratios of channels but for their coefficients (Bruneton 2008,
// section 4).
// Everything per unit of solar irradiance and times TABLE_SCALE, which keeps twilight out of half floats' coarse end.
#ifndef AUREOLE_BRUNETON_GLSL
#define AUREOLE_BRUNETON_GLSL

#include "common/geometry.glsl"
#include "phase/phase.glsl"
#include "common/storage.glsl"
#include "phase/sharp_phases.glsl"
#include "transmittance/transmittance.glsl"

SPEC_INT(30, NU_NODES, 8)
SPEC_BOOL(31, COMBINED, false)
CONST(real, TABLE_SCALE, real(1024))

int scattering_layers_apart() { return sharp_layer(MAX_PHASES); }
int scattering_layers() { return COMBINED ? 1 : scattering_layers_apart(); }

// ---- Axes. Each maps its ends to the centres of the first and last texel. ----
//
// Altitude: altitude_position (geometry.glsl): rho / rho_top with rho = sqrt(r^2 - R^2).
//
// mu: the ray's length between its least and greatest value at that altitude, apart for rays that end on the ground (from h
// straight down to rho at the horizon) and on the top (transmittance.glsl): the field is discontinuous at the horizon, so
// the two halves of the axis must not mix. Rows 0 to n/2 - 1: ground, from the horizon to the nadir; then from the zenith to the
// horizon.
real ground_position(real altitude, real length) {
    real length_range = max(horizon_distance(altitude) - altitude, real(1e-20));
    return clamp((length - altitude) / length_range, real(0), real(1));
}
real mu_position(real altitude, real mu, bool ground) {
    return ground ? ground_position(altitude, distance_to_ground(altitude, mu)) : transmittance_position(altitude, mu).x;
}
// The same of a ray whose length is known: exact near the horizon, where the ground's distance by the cosine is not.
real ray_position(Ray ray) {
    return ray.ground ? ground_position(ray.altitude, ray.end) : transmittance_position(ray.altitude, ray.mu).x;
}
real row_at(real position, bool ground, int rows) {
    real last = real(rows / 2 - 1);
    return ground ? last * (1 - position) : last + 1 + last * position;
}
real mu_row(real altitude, real mu, bool ground, int rows) { return row_at(mu_position(altitude, mu, ground), ground, rows); }

// mu_s: by the length d of the ray from the ground to the top in that direction, so that nodes are dense at the horizon:
// a = (d - d_min) / (d_max - d_min), d_max that of the horizon; u = (1 - a / A) / (1 + a), where A = a of the lowest sun kept
// (atm.sun_mapping.x); below that one nothing changes any more.
real sun_axis(real mu_s) {
    real a = (distance_to_top(real(0), mu_s) - shell_thickness()) / (atm.radii.w - shell_thickness());
    return max(1 - a / atm.sun_mapping.x, real(0)) / (1 + max(a, real(0)));
}
// The inverse: a = (1 - u) A / (1 + u A), and mu_s from d: T^2 = R^2 + 2 R d mu_s + d^2. Exact at the zenith, as in multi_scatter.glsl.
real sun_axis_mu(real u) {
    if (u >= 1) return real(1);
    real a = (1 - u) * atm.sun_mapping.x / (1 + u * atm.sun_mapping.x);
    real d = shell_thickness() + a * (atm.radii.w - shell_thickness());
    return clamp((atm.radii.w * atm.radii.w - d * d) / (2 * bottom_radius() * d), real(-1), real(1));
}

// nu: even, from -1 to 1. Two look-ups are mixed by hand, as x holds mu_s too.

// The ray of a row of the axis of mu: where it ends, and no sun yet.
Ray row_ray(real altitude, int row, int rows) {
    int last = rows / 2 - 1;
    Ray ray;
    ray.altitude = altitude;
    ray.mu_s = real(0);
    ray.nu = real(0);
    ray.ground = row <= last;
    real r = bottom_radius() + ray.altitude;
    if (ray.ground) {
        real p = 1 - real(row) / real(last);
        real rho = horizon_distance(ray.altitude);
        real d = ray.altitude + p * (rho - ray.altitude);
        ray.end = d;
        // On the ground every ray down has length 0; there stands what the rows tend to: the horizon, but for the last, the nadir.
        real on_ground = p > 0 ? real(0) : real(-1);
        ray.mu = d > 0 ? clamp(-(rho * rho + d * d) / (2 * r * d), real(-1), real(0)) : on_ground;
    } else {
        real p = real(row - last - 1) / real(last);
        ray.mu = transmittance_mu(ray.altitude, p);
        ray.end = distance_to_top(ray.altitude, ray.mu);
    }
    return ray;
}

// The ray of a texel of a layer: altitude, directions (a nu that mu and mu_s do not allow is replaced by the nearest that they do)
// and where it ends.
Ray table_ray(ivec3 texel, ivec3 size) {
    int sun_nodes = size.x / NU_NODES;
    Ray ray = row_ray(altitude_at(texel_to_unit(texel.z, size.z)), texel.y, size.y);
    ray.mu_s = sun_axis_mu(texel_to_unit(texel.x % sun_nodes, sun_nodes));
    real middle = ray.mu * ray.mu_s;
    real sines = sqrt(max((1 - ray.mu) * (1 + ray.mu) * (1 - ray.mu_s) * (1 + ray.mu_s), real(0)));
    ray.nu = clamp(2 * texel_to_unit(texel.x / sun_nodes, NU_NODES) - 1, max(middle - sines, real(-1)), min(middle + sines, real(1)));
    return ray;
}

// Where a look-up goes.
struct TablePlace {
    vec3 at;    // texture coordinates in layer 0, at the node of nu below
    real step;  // in x to the node above
    real share; // of the node above
};
// `row`: of the axis of mu, between two of them too.
TablePlace table_place_in_row(Ray ray, real row, ivec3 size, int layers) {
    int sun_nodes = size.x / NU_NODES;
    int heights = size.z / layers;
    real nu = clamp(real(0.5) * (ray.nu + 1), real(0), real(1)) * real(NU_NODES - 1);
    real node = min(floor(nu), real(NU_NODES - 2));
    TablePlace place;
    place.step = 1 / real(NU_NODES);
    place.share = nu - node;
    place.at = vec3((node + unit_to_texture(sun_axis(ray.mu_s), sun_nodes)) * place.step,
                    (real(0.5) + row) / real(size.y),
                    (real(0.5) + altitude_position(ray.altitude) * real(heights - 1)) / real(size.z));
    return place;
}
TablePlace table_place(Ray ray, ivec3 size, int layers) {
    return table_place_in_row(ray, mu_row(ray.altitude, ray.mu, ray.ground, size.y), size, layers);
}

// ---- Look-ups ----

#ifdef AUREOLE_SCATTERING_TABLE
// Of a ray with its length.
TablePlace scattering_place(Ray ray) {
    ivec3 size = textureSize(scattering_table, 0);
    return table_place_in_row(ray, row_at(ray_position(ray), ray.ground, size.y), size, scattering_layers());
}

vec4 scattering_layer(TablePlace place, int layer) {
    vec3 at = place.at + vec3(real(0), real(0), real(layer) / real(scattering_layers()));
    return mix(SAMPLE(scattering_table, at), SAMPLE(scattering_table, at + vec3(place.step, real(0), real(0))), place.share);
}

// Light scattered once by sharp phase function c, without its value. `first`: what layer 0 has there.
vec3 sharp_light(TablePlace place, vec4 first, int c) {
    if (!COMBINED) return vec3(scattering_layer(place, sharp_layer(c)));
    return first.w / max(first.x, real(1e-9)) * vec3(first.x, first.y * atm.sun_mapping.z, first.z * atm.sun_mapping.w);
}

#ifndef AUREOLE_SHARP_PHASE
#define AUREOLE_SHARP_PHASE(c, nu) phase_value(c, nu)
#endif

// Radiance that the air of a ray scatters towards its start, 1/sr.
vec3 air_radiance(TablePlace place, real nu) {
    vec4 first = scattering_layer(place, 0);
    vec3 radiance = rayleigh_phase(nu) * vec3(first);
    for (int c = 0; c < PHASE_COUNT; ++c)
        if (phase_is_sharp(c)) radiance += AUREOLE_SHARP_PHASE(c, nu) * sharp_light(place, first, c);
    return radiance / TABLE_SCALE;
}

// The same of the part of a ray before a point behind this transmittance, whose own ray on from there is looked up at `on`.
vec3 air_radiance_before(TablePlace place, TablePlace on, vec3 transmittance, real nu) {
    vec4 here = scattering_layer(place, 0);
    vec4 there = scattering_layer(on, 0);
    vec3 none = vec3(real(0));
    vec3 radiance = rayleigh_phase(nu) * max(vec3(here) - transmittance * vec3(there), none);
    for (int c = 0; c < PHASE_COUNT; ++c)
        if (phase_is_sharp(c))
            radiance += AUREOLE_SHARP_PHASE(c, nu) * max(sharp_light(place, here, c) - transmittance * sharp_light(on, there, c), none);
    return radiance / TABLE_SCALE;
}
#endif

#ifdef AUREOLE_IRRADIANCE_TABLE
// Irradiance that the sky gives a level surface, per unit of the sun's; axes: mu_s along x, altitude along y.
vec3 diffuse_irradiance(real altitude, real mu_s) {
    ivec2 size = textureSize(irradiance_table, 0);
    return vec3(SAMPLE(irradiance_table,
                       vec2(unit_to_texture(sun_axis(mu_s), size.x), unit_to_texture(altitude_position(altitude), size.y))));
}

// All light on the ground.
vec3 ground_irradiance(real mu_s) { return ground_beam_irradiance(mu_s) + diffuse_irradiance(real(0), mu_s); }
#endif

#endif
