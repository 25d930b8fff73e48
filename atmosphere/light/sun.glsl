// A sun's light at a point, inside the air or above it. Needs `atm` and the transmittance table.
#ifndef AUREOLE_SUN_GLSL
#define AUREOLE_SUN_GLSL

#include "common/constants.glsl"
#include "common/geometry.glsl"
#include "transmittance/transmittance.glsl"

// Share of a disk above a straight horizon, x radii above its centre. atan, not asin, which is coarse on some devices.
real visible_share(real x) {
    real c = clamp(x, real(-1), real(1));
    real s = sqrt(1 - c * c);
    return real(0.5) + (c * s + atan(c, s)) / PI;
}

// Share of a sun's irradiance that reaches a surface facing it: what the horizon leaves of its disk, through the air. mu_s and
// sine: of the sun's zenith angle at the point; chord2: squared chord of its angular radius (ViewBlock::sun_limb). Continuous in all
// of them, across the top of the air too: from above it, a low sun shines through the limb. The horizon counts as straight: right
// wherever the planet looks much larger than the sun.
vec3 sun_share(real altitude, real mu_s, real sine, real chord2) {
    // Sine and cosine of the sun's angle above the horizon, whose dip has the cosine R / r and the sine tangent / r. Sines are
    // compared, which is exact where it matters; a sun more than a right angle away from the horizon is all above or all below it.
    real radius = bottom_radius();
    real r = radius + altitude;
    real tangent = horizon_distance(altitude);
    real above = (mu_s * radius + sine * tangent) / r;
    real disk = sqrt(chord2 * (1 - chord2 / 4));
    real share = visible_share(sine * radius < mu_s * tangent ? sign(above) : above / max(disk, real(1e-6)));
    if (altitude <= shell_thickness()) return share * transmittance_to_top(altitude, mu_s);

    real lowest = r * sine - radius;  // altitude of the lowest point of the line to the sun
    if (mu_s >= 0 || lowest >= shell_thickness()) return vec3(share);
    return share * transmittance_to_top(shell_thickness(), -half_chord(lowest) / (radius + shell_thickness()));
}

#endif
