// From scene-linear radiance to what a display takes, each step on request.
#ifndef AUREOLE_DISPLAY_GLSL
#define AUREOLE_DISPLAY_GLSL

// ACES reference rendering and output transforms for Rec.709, as fitted by Stephen Hill (2015): a matrix into the transform's
// space, a rational curve, a matrix back.
// Beyond 1e6 the curve is flat, and its squares would leave the range of float.
vec3 aces_fitted(vec3 color) {
    color = min(color, vec3(real(1e6)));
    vec3 v = vec3(dot(color, vec3(real(0.59719), real(0.35458), real(0.04823))),
                  dot(color, vec3(real(0.07600), real(0.90834), real(0.01566))),
                  dot(color, vec3(real(0.02840), real(0.13383), real(0.83777))));
    v = (v * (v + vec3(real(0.0245786))) - vec3(real(0.000090537))) /
        (v * (real(0.983729) * v + vec3(real(0.4329510))) + vec3(real(0.238081)));
    v = vec3(dot(v, vec3(real(1.60475), real(-0.53108), real(-0.07367))),
             dot(v, vec3(real(-0.10208), real(1.10813), real(-0.00605))),
             dot(v, vec3(real(-0.00327), real(-0.07276), real(1.07602))));
    return clamp(v, vec3(real(0)), vec3(real(1)));
}

// IEC 61966-2-1.
vec3 encode_srgb(vec3 color) {
    vec3 c = clamp(color, vec3(real(0)), vec3(real(1)));
    vec3 low = real(12.92) * c;
    vec3 high = real(1.055) * pow(max(c, vec3(real(1e-5))), vec3(real(1) / real(2.4))) - vec3(real(0.055));
    return mix(high, low, lessThan(c, vec3(real(0.0031308))));
}

// Noise of triangular distribution in (-1, 1): gradient noise of Jimenez 2014, evenly distributed, bent into a triangle. Moves
// with the frame so that the eye averages it.
real triangular_noise(ivec2 pixel, real frame) {
    real x = real(pixel.x) + real(5.588238) * frame;
    real y = real(pixel.y) + real(5.588238) * frame;
    real u = 2 * fract(real(52.9829189) * fract(real(0.06711056) * x + real(0.00583715) * y)) - 1;
    return sign(u) * (1 - sqrt(max(1 - abs(u), real(0))));
}

// `tone_map`: 0 none, 1 ACES as fitted by Hill. The noise is of one step of 8 bits.
vec3 display(vec3 color, int tone_map, bool srgb, bool dither, ivec2 pixel, real frame) {
    if (tone_map == 1) color = aces_fitted(color);
    if (srgb) color = encode_srgb(color);
    if (dither) color += vec3(triangular_noise(pixel, frame) / real(255));
    return color;
}

#endif
