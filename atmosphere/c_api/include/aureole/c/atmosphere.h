/** \file
 * An atmosphere: the tables of a planet's air on a device. See aureole.h. */
#ifndef AUREOLE_C_ATMOSPHERE_H
#define AUREOLE_C_ATMOSPHERE_H

#include <aureole/c/device.h>
#include <aureole/c/parameters.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The air of one planet on one device: its tables, and what makes them. */
typedef struct aureole_atmosphere aureole_atmosphere;

/** One number of a model's settings, by the name of its field in C++ ("sky_view.width", "orders", "dome.size.height"). Booleans
 * are 0 or 1, enumerators count from 0, formats are those of aureole_format. Fields, meanings and ranges: c_api.md, and
 * aureole/quality.h and the header of the model in aureole/models. */
typedef struct aureole_number {
    const char* name; /**< Of the field. */
    double value;     /**< Within the field's range. */
} aureole_number;

/** Which model, how fine, and what is left out (aureole/setting.h). */
typedef struct aureole_setting {
    uint32_t struct_size;
    uint32_t without_count; /**< Of `without`. */
    const char* model;   /**< "fog", "single", "single-lut", "hillaire", "aureole", "bruneton", "reference". NULL: "aureole". */
    const char* quality; /**< "low", "default", "high" or "converged". NULL: "default". */
    const char* spectral;          /**< "rgb", or a number of wavelengths: "4", "15" ... NULL: "rgb". */
    const char* const* without;    /**< `without_count` names of terms or simplifications. NULL: nothing is left out. */
    const aureole_number* numbers; /**< `number_count` of them, in place of what `quality` has; of one name, the last. Then
                                      `without` names terms alone: numbers say all else. NULL: as `quality` has it. */
    uint32_t number_count;         /**< Of `numbers`. */
} aureole_setting;
/** aureole, default, rgb, nothing left out. */
AUREOLE_API aureole_result aureole_setting_defaults(aureole_setting* setting);
/** What `setting` makes of number `index` of its model, in [0, out_count): its name, which lives as long as the library, and
 * its value. `out_count` may be NULL, and so may `out_number`, to learn the count alone. Simplifications in `without` are
 * refused, as beside numbers. AUREOLE_INVALID_ARGUMENT for a number that there is not, is no number or is out of its range: as
 * aureole_create_atmosphere has it. */
AUREOLE_API aureole_result aureole_get_setting_number(const aureole_setting* setting, uint32_t index,
                                                      aureole_number* out_number, uint32_t* out_count);

/** Makes pipelines and tables; may take a moment. `setting` NULL: as aureole_setting_defaults has it. AUREOLE_UNSUPPORTED
 * names what the device lacks. */
AUREOLE_API aureole_result aureole_create_atmosphere(aureole_device* device, const aureole_parameters* parameters,
                                                     const aureole_setting* setting, aureole_atmosphere** out_atmosphere);
/** AUREOLE_MISUSE while a view of it lives. */
AUREOLE_API aureole_result aureole_destroy_atmosphere(aureole_atmosphere* atmosphere);

/** New air or ground; tables are made anew by the next record. What the setting leaves out is left out of it, too. Other
 * numbers make no objects; other terms or kinds make pipelines. */
AUREOLE_API aureole_result aureole_set_parameters(aureole_atmosphere* atmosphere, const aureole_parameters* parameters);
/** Spreads the multi-scatter solution over frames: `passes` for each record, in [0, 64]; 0, as at the start: at once. */
AUREOLE_API aureole_result aureole_set_multi_scatter_passes_per_frame(aureole_atmosphere* atmosphere, uint32_t passes,
                                                                      uint32_t first_too);
/** Number, in the host's counting, of the frame that is recorded next: what is replaced dies after it. It must not fall. */
AUREOLE_API aureole_result aureole_set_frame(aureole_atmosphere* atmosphere, uint64_t frame);
/** A list that was recorded is never executed: the next record makes everything anew, views too. */
AUREOLE_API aureole_result aureole_invalidate(aureole_atmosphere* atmosphere);
/** Records what has changed; nothing where nothing has. Timestamps go to slots from `first_timestamp` on, two for each of
 * aureole_atmosphere_reports; -1: none. Nothing is allocated. */
AUREOLE_API aureole_result aureole_record_atmosphere(aureole_atmosphere* atmosphere, aureole_commands* commands,
                                                     int32_t first_timestamp);
/** Share of the tables that has been recorded, in [0, 1]. */
AUREOLE_API aureole_result aureole_get_progress(const aureole_atmosphere* atmosphere, double* out_progress);
/** Bytes of device memory of the tables. */
AUREOLE_API aureole_result aureole_atmosphere_table_bytes(const aureole_atmosphere* atmosphere, uint64_t* out_bytes);

/** What one pass did in the latest recording. */
typedef struct aureole_pass_report {
    uint32_t struct_size;
    uint32_t recorded;      /**< Boolean; 0: nothing it depends on had changed, and the rest is of an earlier time. */
    const char* name;       /**< "transmittance", "sky_view", "composite" ... Valid as long as the library. */
    uint64_t invocations;   /**< Of shaders. */
    uint64_t bytes_written; /**< To tables and targets. */
} aureole_pass_report;
/** `out_count` gets how many there are, and `out` as many as `capacity` holds. `out` may be NULL where `capacity` is 0; else
 * out[0].struct_size is set, and all have that size. */
AUREOLE_API aureole_result aureole_atmosphere_reports(const aureole_atmosphere* atmosphere, aureole_pass_report* out,
                                                      uint32_t capacity, uint32_t* out_count);

#ifdef __cplusplus
}
#endif

#endif
