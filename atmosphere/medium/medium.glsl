// The air at an altitude: scattering coefficient per phase function and extinction, 1/km.
//
// The including kernel declares `UNIFORMS(slot, AtmosphereBlock, atm)` first, and says `#define AUREOLE_PROFILE_TABLE <slot>` if it
// may meet tabulated profiles; the texture `profile_table` is then declared here.
#ifndef AUREOLE_MEDIUM_GLSL
#define AUREOLE_MEDIUM_GLSL

#include "common/blocks.glsl"
#include "common/specialization.glsl"

// Kinds of profile, and what atm.term_profile holds for each (lengths in km). `h` is the altitude.
CONST(int, PROFILE_EXPONENTIAL, 0)  // x: 1 / scale height
CONST(int, PROFILE_TENT, 1)         // x: altitude of the tip, y: 1 / half width
CONST(int, PROFILE_TABULATED, 2)    // w: row of profile_table

struct Medium {
    vec3 scattering[MAX_PHASES];  // by phase function; beyond PHASE_COUNT: 0
    vec3 extinction;              // scattering + absorption
};

// Profile kind and phase function of term i.
int term_kind(int i) { return (TERM_KINDS >> (2 * i)) & 3; }
int term_phase(int i) { return (TERM_PHASES >> (2 * i)) & 3; }

#ifdef AUREOLE_PROFILE_TABLE
SAMPLER_2D(AUREOLE_PROFILE_TABLE, profile_table)

// Rows are sampled evenly in sqrt(h / highest altitude): finest at the ground, where density changes fastest. Two fetches
// rather than a filtered one, as in tabulated_phase.
real tabulated_density(real row, real h) {
    int last = textureSize(profile_table, 0).x - 1;
    real x = min(sqrt(h / atm.tables.y), real(1)) * real(last);
    int i = min(int(x), last - 1);
    real d0 = texelFetch(profile_table, ivec2(i, int(row)), 0).x;
    real d1 = texelFetch(profile_table, ivec2(i + 1, int(row)), 0).x;
    return mix(d0, d1, x - real(i));
}
#endif

// Relative density of term i (1: the coefficients as stated) at an altitude >= 0.
//   exponential: exp(-h / H), a gas or aerosol in hydrostatic balance at one temperature;
//   tent: max(0, 1 - |h - c| / w), Bruneton's ozone layer;
//   tabulated: linear between samples.
real term_density(int i, real altitude_km) {
    vec4 profile = atm.term_profile[i];
    int kind = term_kind(i);
#ifdef AUREOLE_PROFILE_TABLE
    if (kind == PROFILE_TABULATED) return tabulated_density(profile.w, altitude_km);
#endif
    if (kind == PROFILE_TENT) return max(real(0), 1 - abs(altitude_km - profile.x) * profile.y);
    return exp(-altitude_km * profile.x);
}

// Everything about the air at an altitude; below the ground: as on the ground.
Medium sample_medium(real altitude_km) {
    COUNT(1);
    real h = max(altitude_km, real(0));
    Medium medium;
    medium.extinction = vec3(real(0));
    for (int c = 0; c < MAX_PHASES; ++c) medium.scattering[c] = vec3(real(0));
    for (int i = 0; i < TERM_COUNT; ++i) {
        real density = term_density(i, h);
        medium.extinction += density * vec3(atm.term_extinction[i]);
        medium.scattering[term_phase(i)] += density * vec3(atm.term_scattering[i]);
    }
    return medium;
}

// Extinction alone.
vec3 medium_extinction(real altitude_km) {
    COUNT(1);
    real h = max(altitude_km, real(0));
    vec3 extinction = vec3(real(0));
    for (int i = 0; i < TERM_COUNT; ++i) extinction += term_density(i, h) * vec3(atm.term_extinction[i]);
    return extinction;
}

// Extinction, mean of the channels, and how fast its exponential terms thin with height: 1 / scale height, by their share; 1/km.
vec2 extinction_and_decay(real altitude_km) {
    COUNT(1);
    real extinction = real(0);
    real decay = real(0);
    for (int i = 0; i < TERM_COUNT; ++i) {
        vec3 e = vec3(atm.term_extinction[i]) * term_density(i, altitude_km);
        real mean = (e.x + e.y + e.z) / 3;
        extinction += mean;
        if (term_kind(i) == PROFILE_EXPONENTIAL) decay += mean * atm.term_profile[i].x;
    }
    return vec2(extinction, decay / max(extinction, real(1e-20)));
}

#endif
