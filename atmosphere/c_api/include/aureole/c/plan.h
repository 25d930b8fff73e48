/** \file
 * The planner: what a scene needs goes in, the cheapest sky within the error or the budget comes out. See aureole.h. */
#ifndef AUREOLE_C_PLAN_H
#define AUREOLE_C_PLAN_H

#include <aureole/c/view.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What the planner found; made by aureole_make_plan. */
typedef struct aureole_plan aureole_plan;

/** What a scene needs; ranges and meanings are those of PlanRequirements in aureole/plan.h. At least one of tolerance,
 * budget_ms and budget_mib must be given: 0, their default, asks for nothing. */
typedef struct aureole_requirements {
    uint32_t struct_size;
    aureole_projection projection; /**< Default: matrix. */
    const aureole_parameters* air; /**< NULL, the default, is refused. */
    double sun_elevation_deg[2];   /**< Least, most. Default: 0, 90. */
    double altitude_m[2];          /**< Of the camera: least, most. Default: 2, 2. */
    double geometry_range_m;       /**< Default: 96000. */
    uint32_t geometry;             /**< Boolean: the composite gets a host's colour and depth. Default: 0. */
    uint32_t shadows;              /**< Boolean; default: 0. */
    uint32_t light;                /**< Boolean; default: 1. */
    uint32_t suns;                 /**< In [1, 4]. Default: 1. */
    uint32_t views;                /**< In [1, 64]. Default: 1. */
    uint32_t width, height;        /**< Pixels. Default: 1280, 720. */
    uint32_t wavelengths;          /**< Boolean: colours as of wavelengths. Default: 0. */
    double rebuilds_per_frame;     /**< In [0, 1]. Default: 1/3600. */
    double tolerance;              /**< Relative error of 95 of 100 directions, in [1e-4, 10]; 0: none. */
    double budget_ms;              /**< Of a frame, in [1e-9, 1e6]; 0: none. */
    double budget_mib;             /**< Of tables, in [1e-9, 1e6]; 0: none. */
    double speed_composite;        /**< How much slower the device is than the measured one. Default: 1. */
    double speed_tables;           /**< The same of tables. Default: 1. */
} aureole_requirements;
AUREOLE_API aureole_result aureole_requirements_defaults(aureole_requirements* requirements);

/** Touches no device; from any thread. Some milliseconds. */
AUREOLE_API aureole_result aureole_make_plan(const aureole_requirements* requirements, aureole_plan** out_plan);
/** And its strings. NULL: nothing. */
AUREOLE_API aureole_result aureole_destroy_plan(aureole_plan* plan);

/** Strings and what pointers lead to live as long as the plan. */
typedef struct aureole_plan_summary {
    uint32_t struct_size;
    uint32_t tolerable;     /**< Boolean; 0: nothing meets the requirements, and this comes closest. */
    const char* setting;    /**< "aureole default, without ozone". */
    const char* text;       /**< For people: every choice with its reason. */
    double error_median;    /**< Relative error of radiance, likely. */
    double error_p95;       /**< Of 95 of 100 directions, likely. */
    double error_light;     /**< Of light, where it is asked for, likely. */
    double error_bound;     /**< Upper bound of the last two, in 95 of 100 scenes. */
    double frame_ms;        /**< Of a frame that moves camera and sun. */
    double rebuild_ms;      /**< Of the tables of the air. */
    double mebibytes;       /**< Of all tables. */
    double charged_ms;      /**< What a budget bounds. */
    double distance;        /**< From what was measured; above 1 the bound need not hold. */
    uint32_t warning_count; /**< Of aureole_plan_warning. */
} aureole_plan_summary;
/** Its text, its errors and its cost. */
AUREOLE_API aureole_result aureole_get_plan_summary(const aureole_plan* plan, aureole_plan_summary* out_summary);
/** What the figures do not cover, in a sentence. `index` in [0, warning_count). */
AUREOLE_API aureole_result aureole_plan_warning(const aureole_plan* plan, uint32_t index, const char** out_text);

/** What the plan wants: the air with what is left out left out, and settings of the view, to be changed as the host needs. */
AUREOLE_API aureole_result aureole_plan_view_settings(const aureole_plan* plan, aureole_view_settings* out_settings);
/** As aureole_create_atmosphere, of the air and the setting that the plan has chosen. */
AUREOLE_API aureole_result aureole_create_planned_atmosphere(aureole_device* device, const aureole_plan* plan,
                                                             aureole_atmosphere** out_atmosphere);

#ifdef __cplusplus
}
#endif

#endif
