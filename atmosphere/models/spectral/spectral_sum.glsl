// What a table holds in three wavelengths after another, added up to linear Rec.709 per unit of the sun's own colour.
//
// Radiance: sum over triplets k of M_k L_k / E, with M_k the triplet's matrix, which has the sun's spectrum in it, and E = sum of
// M_k (1, 1, 1): so that times a sun of colour E it is the luminance of each primary. Linear; colours out of gamut keep their negative
// parts, since neighbours and layers are yet to be mixed.
//
// Optical depth: -log of the sun's light that comes through, sum of M_k exp(-tau_k) / E. Not below that of the clearest wavelength nor
// above that of the darkest, which bounds what negative weights and colours out of gamut do.
//
// The including kernel declares the tables of the triplets before, in slots 2 to 15, and AUREOLE_TEXEL, the type of a place in them;
// those from TRIPLETS on are not read.
#ifndef AUREOLE_SPECTRAL_SUM_GLSL
#define AUREOLE_SPECTRAL_SUM_GLSL

#include "common/to_rec709.glsl"

CONST(int, MAX_TRIPLETS, 14)

// M_k / E: column c of triplet k is to_rgb[3 k + c].
struct SpectralBlock {
    vec4 to_rgb[42];
};
// A part of a table: the layers of one kind.
struct SpectralRows {
    vec4 range;  // x: the first row, y: the first row that is no more part of it
};
UNIFORMS(0, SpectralBlock, spectral)
PUSH_CONSTANTS(SpectralRows, rows)
SPEC_INT(8, TRIPLETS, 1)
SPEC_BOOL(51, OPTICAL_DEPTH, false)

vec3 to_rgb(int triplet, vec3 v) {
    return to_rec709(v, spectral.to_rgb[3 * triplet], spectral.to_rgb[3 * triplet + 1], spectral.to_rgb[3 * triplet + 2]);
}

vec3 radiance_sum(vec3 texel[MAX_TRIPLETS]) {
    vec3 sum = vec3(real(0));
    for (int k = 0; k < TRIPLETS; ++k) sum += to_rgb(k, texel[k]);
    return sum;
}

vec3 depth_sum(vec3 texel[MAX_TRIPLETS]) {
    vec3 clearest = texel[0];
    vec3 darkest = texel[0];
    for (int k = 1; k < TRIPLETS; ++k) {
        clearest = min(clearest, texel[k]);
        darkest = max(darkest, texel[k]);
    }
    real least = min(clearest.x, min(clearest.y, clearest.z));
    real most = max(darkest.x, max(darkest.y, darkest.z));
    vec3 sum = vec3(real(0));  // relative to the clearest: air through which float sees nothing keeps its depth
    for (int k = 0; k < TRIPLETS; ++k) sum += to_rgb(k, exp(vec3(least) - texel[k]));
    return clamp(vec3(least) - log(max(sum, vec3(real(1e-30)))), vec3(least), vec3(most));
}

vec4 spectral_texel(AUREOLE_TEXEL at) {
    vec3 texel[MAX_TRIPLETS];
    texel[0] = vec3(texelFetch(table_0, at, 0));
    texel[1] = TRIPLETS > 1 ? vec3(texelFetch(table_1, at, 0)) : texel[0];
    texel[2] = TRIPLETS > 2 ? vec3(texelFetch(table_2, at, 0)) : texel[0];
    texel[3] = TRIPLETS > 3 ? vec3(texelFetch(table_3, at, 0)) : texel[0];
    texel[4] = TRIPLETS > 4 ? vec3(texelFetch(table_4, at, 0)) : texel[0];
    texel[5] = TRIPLETS > 5 ? vec3(texelFetch(table_5, at, 0)) : texel[0];
    texel[6] = TRIPLETS > 6 ? vec3(texelFetch(table_6, at, 0)) : texel[0];
    texel[7] = TRIPLETS > 7 ? vec3(texelFetch(table_7, at, 0)) : texel[0];
    texel[8] = TRIPLETS > 8 ? vec3(texelFetch(table_8, at, 0)) : texel[0];
    texel[9] = TRIPLETS > 9 ? vec3(texelFetch(table_9, at, 0)) : texel[0];
    texel[10] = TRIPLETS > 10 ? vec3(texelFetch(table_10, at, 0)) : texel[0];
    texel[11] = TRIPLETS > 11 ? vec3(texelFetch(table_11, at, 0)) : texel[0];
    texel[12] = TRIPLETS > 12 ? vec3(texelFetch(table_12, at, 0)) : texel[0];
    texel[13] = TRIPLETS > 13 ? vec3(texelFetch(table_13, at, 0)) : texel[0];
    return vec4(OPTICAL_DEPTH ? depth_sum(texel) : radiance_sum(texel), real(0));
}

#endif
