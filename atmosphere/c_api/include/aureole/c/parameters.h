/** \file
 * What an atmosphere is made of, in SI units; colours are scene-linear Rec.709 (r, g, b). Ranges are those of
 * aureole/parameters.h, and each field is checked where it is used. See aureole.h. */
#ifndef AUREOLE_C_PARAMETERS_H
#define AUREOLE_C_PARAMETERS_H

#include <aureole/c/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How density changes with altitude. 1 means the coefficients as stated. */
typedef uint32_t aureole_profile_kind;
enum {
    AUREOLE_PROFILE_EXPONENTIAL = 0, /**< exp(-h / scale_height_m). */
    AUREOLE_PROFILE_TENT = 1,        /**< max(0, 1 - |h - center_m| / half_width_m). */
    AUREOLE_PROFILE_TABULATED = 2    /**< Linear between samples, constant beyond them. */
};
/** Fields of other kinds than `kind` are ignored. Part of aureole_term, whose struct_size covers it. */
typedef struct aureole_profile {
    aureole_profile_kind kind; /**< Which of the profiles. */
    uint32_t count;            /**< Of samples: 2 to 4096. */
    double scale_height_m;     /**< In [0.01, 1e12]. */
    double center_m;           /**< In [-1e12, 1e12]. */
    double half_width_m;       /**< In [0.01, 1e12]. */
    const double* altitude_m;  /**< `count` altitudes, strictly increasing, in [-1e12, 1e12]. */
    const double* density;     /**< `count` densities, in [0, 1e6]. */
} aureole_profile;

/** Phase functions, 1/sr, each integrating to 1 over the sphere. */
typedef uint32_t aureole_phase_kind;
enum {
    AUREOLE_PHASE_RAYLEIGH = 0,                 /**< 3/(16 pi) (1 + cos^2). */
    AUREOLE_PHASE_HENYEY_GREENSTEIN = 1,        /**< By g. */
    AUREOLE_PHASE_CORNETTE_SHANKS = 2,          /**< By g. */
    AUREOLE_PHASE_HENYEY_GREENSTEIN_DRAINE = 3, /**< By g_hg, g_draine, alpha, weight: fog and cloud. */
    AUREOLE_PHASE_TABULATED = 4                 /**< Linear in the angle; renormalized. */
};
/** Fields of other kinds than `kind` are ignored. Part of aureole_term, whose struct_size covers it. */
typedef struct aureole_phase {
    aureole_phase_kind kind; /**< Which of the phase functions. */
    uint32_t count;          /**< Of samples: 2 to 4096. */
    double g;                /**< In [-0.999, 0.999]. */
    double g_hg, g_draine;   /**< In [-0.999, 0.999]. */
    double alpha;            /**< In [0, 1e4]. */
    double weight;           /**< Of the Draine lobe, in [0, 1]. */
    const double* angle_rad; /**< `count` angles from 0 to pi, strictly increasing. */
    const double* value;     /**< `count` values in [0, 1e100], not all 0. */
} aureole_phase;

/** One constituent: molecules, an aerosol, an absorber. */
typedef struct aureole_term {
    uint32_t struct_size;
    const char* name;           /**< For messages. NULL: none. */
    aureole_profile profile;    /**< Density at each altitude. */
    double scattering_per_m[3]; /**< At density 1. In [0, 1e6]. */
    double absorption_per_m[3]; /**< At density 1. In [0, 1e6]. */
    aureole_phase phase;        /**< Unused where scattering is 0. */
    double scattering_scale;    /**< Artists' factors; 1, the default, changes nothing. In [0, 1e6]. */
    double absorption_scale;    /**< The same of absorption. In [0, 1e6]. */
} aureole_term;
AUREOLE_API aureole_result aureole_term_defaults(aureole_term* term);

/** A planet and its air. */
typedef struct aureole_parameters {
    uint32_t struct_size;
    uint32_t term_count;       /**< Of `terms`. */
    double bottom_radius_m;    /**< Of the ground. In [1e3, 1e12]. */
    double top_radius_m;       /**< Where the air ends. At least 1 m above the bottom, at most 11 bottom radii. */
    double ground_albedo[3];   /**< In [0, 1]. */
    const aureole_term* terms; /**< `term_count` of them, all with the struct_size of the first. NULL: no air. */
} aureole_parameters;
/** A planet of Earth's size without air. */
AUREOLE_API aureole_result aureole_parameters_defaults(aureole_parameters* parameters);
/** "earth", "hazy_earth", "mars", "airless", "us_standard_1976", "titan": what they are made of says aureole/presets.h. Terms
 * and what they point to stay valid for good: change a copy of them. */
AUREOLE_API aureole_result aureole_preset(const char* name, aureole_parameters* out_parameters);
/** Name `index`; AUREOLE_INVALID_ARGUMENT at and beyond the last, so that all can be listed. Static. */
AUREOLE_API aureole_result aureole_preset_name(uint32_t index, const char** out_name);
/** Earth with as much aerosol as this visibility takes, 1e3 to 2.2e5 metres. Terms stay valid until the next call in this
 * thread. */
AUREOLE_API aureole_result aureole_preset_earth_with_visibility(double visibility_m, aureole_parameters* out_parameters);
/** Checks every field, and names the first that is outside its range. */
AUREOLE_API aureole_result aureole_validate_parameters(const aureole_parameters* parameters);
/** Optical depth of the vertical column from the ground to the top: all terms together. */
AUREOLE_API aureole_result aureole_vertical_optical_depth(const aureole_parameters* parameters, double out_depth[3]);

/** A number outside of the envelope of stability (docs/stability.md): allowed, but less exact. Strings stay valid until the
 * next call of an aureole_envelope_ function in this thread. */
typedef struct aureole_outside {
    uint32_t struct_size;
    const char* field;             /**< As errors name it: "terms[1].phase.g". */
    double value, least, greatest; /**< What was given, and what is inside. */
    const char* text;              /**< A sentence with all of it, and what to expect. */
} aureole_outside;
/** What of this air is outside: `out_count` gets how many numbers are, and `out` as many of them as `capacity` holds. `out`
 * may be NULL where `capacity` is 0; else out[0].struct_size is set, and all have that size. */
AUREOLE_API aureole_result aureole_envelope_of_air(const aureole_parameters* parameters, aureole_outside* out,
                                                   uint32_t capacity, uint32_t* out_count);

#ifdef __cplusplus
}
#endif

#endif
