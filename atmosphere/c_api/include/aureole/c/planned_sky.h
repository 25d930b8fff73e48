/** \file
 * A sky that follows its plan: planned anew as sun and camera move, faded from one to the next. See aureole.h. */
#ifndef AUREOLE_C_PLANNED_SKY_H
#define AUREOLE_C_PLANNED_SKY_H

#include <aureole/c/plan.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A planner, and the sky that it has chosen for the moment; two of them during a fade. */
typedef struct aureole_planned_sky aureole_planned_sky;

/** How it follows sun and camera; meanings are those of FollowSettings in aureole/planned_sky.h. */
typedef struct aureole_follow_settings {
    uint32_t struct_size;
    uint32_t fade_frames;      /**< Over which the old sky gives way, in [0, 100000]; 0: at once. Default: 30. */
    double margin;             /**< How far sun or camera go before another plan is made, in [0.01, 100]. Default: 0.5. */
    uint32_t passes_per_frame; /**< Of aureole_set_multi_scatter_passes_per_frame, in [0, 64]; 0: all at once. Default: 1. */
    uint32_t shadow_cascades;  /**< In [1, 4]; with aureole_requirements::shadows, as the next three. Default: 1. */
    double shadow_distance_m;  /**< As aureole_view_settings has it. */
    uint32_t shadow_size[3];   /**< As aureole_view_settings has it. */
    uint32_t shadow_samples;   /**< As aureole_view_settings has it. */
} aureole_follow_settings;
AUREOLE_API aureole_result aureole_follow_settings_defaults(aureole_follow_settings* follow);

/** `requirements`: ranges of the whole scene; `views` 1, and `geometry` where `composite` has scene_depth. `composite` and
 * `follow` NULL: as their defaults functions have them. The first plan is made by the first update. */
AUREOLE_API aureole_result aureole_create_planned_sky(aureole_device* device, const aureole_requirements* requirements,
                                                      const aureole_composite_settings* composite,
                                                      const aureole_follow_settings* follow, aureole_planned_sky** out_sky);
/** Frees its sky, or both; recordings of it have been executed. */
AUREOLE_API aureole_result aureole_destroy_planned_sky(aureole_planned_sky* sky);

/** What an update has done. */
typedef struct aureole_plan_update {
    uint32_t struct_size;
    uint32_t planned;      /**< Boolean: a plan has been made; it may be the same as before. */
    double share;          /**< Of the newest plan's sky in what will be shown, in [0, 1]; below 1 during a fade. */
    uint32_t change_count; /**< Of aureole_get_plan_change. */
} aureole_plan_update;
/** The frame's camera and suns, as aureole_update_view; a new sky where they call for one, which may take a moment. What fails
 * has changed nothing. `out_update` may be NULL. */
AUREOLE_API aureole_result aureole_update_planned_sky(aureole_planned_sky* sky, const aureole_camera* camera,
                                                      const aureole_sun* suns, uint32_t sun_count,
                                                      aureole_plan_update* out_update);
/** Something that the plan of the latest update does otherwise. Strings live until the next update. */
typedef struct aureole_plan_change {
    uint32_t struct_size;
    const char* what;   /**< "model", "ozone", "sky-view table" ... */
    const char* before; /**< What it was in the plan before; "" where there was none. */
    const char* after;  /**< What it is now. */
    const char* reason; /**< Of the new plan. */
} aureole_plan_change;
/** `index` in [0, change_count). */
AUREOLE_API aureole_result aureole_get_plan_change(const aureole_planned_sky* sky, uint32_t index,
                                                   aureole_plan_change* out_change);
/** A copy of the newest plan, to be destroyed by aureole_destroy_plan. Before the first update: for the whole of the ranges.
 */
AUREOLE_API aureole_result aureole_copy_plan(const aureole_planned_sky* sky, aureole_plan** out_plan);

/** Other air: planned for by the next update. */
AUREOLE_API aureole_result aureole_set_planned_air(aureole_planned_sky* sky, const aureole_parameters* air);
/** In [1e-30, 1e30]. */
AUREOLE_API aureole_result aureole_set_planned_exposure(aureole_planned_sky* sky, double exposure);
/** With aureole_requirements::shadows. */
AUREOLE_API aureole_result aureole_set_planned_shadow_map(aureole_planned_sky* sky, const aureole_shadow_map* map);
/** As aureole_set_frame: a sky that was given up dies after it. */
AUREOLE_API aureole_result aureole_set_planned_frame(aureole_planned_sky* sky, uint64_t frame);

/** As aureole_prepare_composite, but at most 8, which stay until they are released; two textures of the target's size are made
 * for fades, unless fade_frames is 0: of a format that can be sampled. */
AUREOLE_API aureole_result aureole_prepare_planned_composite(aureole_planned_sky* sky,
                                                             const aureole_composite_targets* targets);
/** As aureole_release_composite. */
AUREOLE_API aureole_result aureole_release_planned_composite(aureole_planned_sky* sky,
                                                             const aureole_composite_targets* targets);
/** Each frame after the update: tables of air and camera, then the composite; during a fade two of them, and one over the
 * other. Nothing is allocated. */
AUREOLE_API aureole_result aureole_record_planned_sky(aureole_planned_sky* sky, aureole_commands* commands);
/** As aureole_record_composite, after aureole_record_planned_sky. */
AUREOLE_API aureole_result aureole_record_planned_composite(aureole_planned_sky* sky, aureole_commands* commands,
                                                            const aureole_composite_targets* targets);
/** As aureole_invalidate; a fade begins anew. */
AUREOLE_API aureole_result aureole_invalidate_planned_sky(aureole_planned_sky* sky);

/** Light tables for the host's own materials: `after` fades in by `share`. Textures live until the next update. */
typedef struct aureole_planned_light {
    uint32_t struct_size;
    aureole_texture before; /**< 0 before the first recording, after an invalidation until the next, and where
                               aureole_requirements::light is 0. */
    aureole_texture after;  /**< 0 unless a new sky is fading in. */
    double share;           /**< Of `after`, in [0, 1]. */
} aureole_planned_light;
/** Those of the latest recording. */
AUREOLE_API aureole_result aureole_get_planned_light(const aureole_planned_sky* sky, aureole_planned_light* out_light);
/** Of all skies there are at the moment; 0 before the first update. */
AUREOLE_API aureole_result aureole_planned_table_bytes(const aureole_planned_sky* sky, uint64_t* out_bytes);

#ifdef __cplusplus
}
#endif

#endif
