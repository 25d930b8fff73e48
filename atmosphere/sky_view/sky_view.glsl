// Sky-view table: everything the camera sees of the air and the bare ground, in all directions, per unit of solar irradiance.
// Layers stacked in y, for each sun:
//   layer 0:     radiance (1/sr) with the phase functions of molecules applied, multiple scattering, and the ground's reflection;
//   layer 1 + i: single scattering by the i-th sharp phase function (aerosols) without its value. The look-up multiplies by
//                p(nu) at the pixel's own nu, so the sun's aureole is as sharp as the phase function, at any table size.
// and one more for all suns: the optical depth of the air in that direction, for the sun's disk and stars behind it.
// Axes. x: cosine of the azimuth from the sun's, from 1 to -1: half a turn is enough by symmetry; what layers hold is close to a
// low polynomial in that cosine, so it is the cheapest axis to compute and, measured, the one that needs the fewest texels.
// y: angle from the horizon, 0 at the horizon's own row on each side, dense there; a look-up never mixes the two sides, so the
// horizon is exact at any altitude. Above the atmosphere, the upper half spans from the horizon to the top's limb.
#ifndef AUREOLE_SKY_VIEW_GLSL
#define AUREOLE_SKY_VIEW_GLSL

#include "common/horizon.glsl"
#include "common/specialization.glsl"
#include "phase/phase.glsl"
#include "phase/sharp_phases.glsl"

int sky_view_layers() { return sharp_layer(MAX_PHASES); }  // of a sun
int sky_view_all_layers() { return SUN_COUNT * sky_view_layers() + 1; }

// Position in [0, 1] on a side: the square root of the chord between the direction and the horizon below or above it,
// 2 sin(angle / 2), over the greatest that occurs (common/horizon.glsl).
// Upper side: from the horizon to the zenith, or from space to the limb of the top; lower side: to the nadir.
real sky_view_half_sine(real position, bool below) {  // sin(angle / 2)
    real greatest = 1 / (below ? view.horizon.w : view.horizon.z);
    return min(real(0.5) * greatest * position * position, real(1));
}

// x position of an azimuth with cosine c, and the cosine at a position. Tables of models with another axis than the cosine have
// Hillaire's: sin(azimuth / 2).
SPEC_BOOL(7, HALF_ANGLE_AZIMUTH, false)
real sky_view_azimuth_position(real azimuth_cosine) {
    real x = clamp(real(0.5) - real(0.5) * azimuth_cosine, real(0), real(1));
    return HALF_ANGLE_AZIMUTH ? sqrt(x) : x;
}
real sky_view_azimuth_cosine(real position) { return 1 - 2 * (HALF_ANGLE_AZIMUTH ? position * position : position); }

// Keeps a row of a layer, 0 to rows - 1, a little off both ends. Coordinates of a stacked texture are rounded: at an end they would
// let in a trace of the next layer, and a trace of the horizon's optical depth times the peak of a phase function is a bright dot.
real clamp_within_layer(real row, int rows) {
    real margin = real(1) / real(256);
    return clamp(row, margin, real(rows - 1) - margin);
}

#ifdef AUREOLE_SKY_VIEW_TABLE
// Texture coordinates of layer 0 of a sun for a direction: cosine and sine of its zenith angle, cosine of its azimuth from the
// sun's. z: what radiances are to be multiplied by: the inverse of the table's exposure; 0 where a camera in space looks past the air.
vec3 sky_view_coordinates(int sun, real mu, real sine, real azimuth_cosine) {
    bool below = sine_above_horizon(mu, sine) < 0;
    real part = chord_to_horizon(mu, sine) * (below ? view.horizon.w : view.horizon.z);
    ivec2 size = textureSize(sky_view_table, 0);
    int rows = size.y / sky_view_all_layers();
    int half_rows = rows / 2;
    real row = real(0.5) + clamp_within_layer(sqrt(min(part, real(1))) * real(half_rows - 1), half_rows) +
               real(sun * sky_view_layers() * rows + (below ? 0 : half_rows));
    bool past = view.camera.w > real(0.5) && !below && part > 1;
    return vec3(unit_to_texture(sky_view_azimuth_position(azimuth_cosine), size.x), row / real(size.y), past ? real(0) : view.table_exposure_inverse[sun]);
}
vec3 sky_view_layer(vec3 coordinates, int layer) {
    real offset = real(layer) / real(sky_view_all_layers());
    return vec3(SAMPLE(sky_view_table, vec2(coordinates.x, coordinates.y + offset)));
}

// Share of light from beyond the air that comes through it, for coordinates of the last sun. Below the horizon: what the air before
// the ground would let through.
vec3 sky_view_transmittance(vec3 coordinates) {
    return coordinates.z > 0 ? exp(-sky_view_layer(coordinates, sky_view_layers())) : vec3(real(1));
}

// Radiance per unit of the irradiance of the coordinates' sun, 1/sr; nu is the cosine between the direction and that sun. A kernel
// may take other values for the sharp phase functions by defining AUREOLE_SHARP_PHASE(c, nu).
#ifndef AUREOLE_SHARP_PHASE
#define AUREOLE_SHARP_PHASE(c, nu) phase_value(c, nu)
#endif
vec3 sky_view_radiance(vec3 coordinates, real nu) {
    vec3 radiance = sky_view_layer(coordinates, 0);
    for (int c = 0; c < PHASE_COUNT; ++c)
        if (phase_is_sharp(c)) radiance += sky_view_layer(coordinates, sharp_layer(c)) * AUREOLE_SHARP_PHASE(c, nu);
    return radiance * coordinates.z;
}
#endif

#endif
