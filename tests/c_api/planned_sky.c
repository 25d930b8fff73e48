/* A sky that follows its plan, frame by frame as C++ makes it. */
#include <stdlib.h>

#include "c_api/small_rig.h"

static void scene(aureole_parameters* earth, aureole_requirements* needs) {
    earth->struct_size = sizeof *earth;
    needs->struct_size = sizeof *needs;
    CHECK_OK(aureole_preset("earth", earth));
    CHECK_OK(aureole_requirements_defaults(needs));
    needs->air = earth;
    needs->sun_elevation_deg[0] = -6, needs->sun_elevation_deg[1] = 70;
    needs->rebuilds_per_frame = 1; /* no plan that takes seconds */
    needs->tolerance = 0.05;
}

static void update(aureole_planned_sky* sky, double sun_deg, struct planned_frame* out) {
    const aureole_camera camera = small_camera(2);
    const aureole_sun sun = small_sun(sun_deg);
    aureole_plan_update update = {.struct_size = sizeof update};
    aureole_plan_change change = {.struct_size = sizeof change};
    aureole_plan_summary summary = {.struct_size = sizeof summary};
    aureole_plan* plan = NULL;
    uint32_t i;
    CHECK_OK(aureole_update_planned_sky(sky, &camera, &sun, 1, &update));
    out->planned = update.planned, out->share = update.share, out->change_count = update.change_count;
    for (i = 0; i < update.change_count; ++i) {
        const size_t used = strlen(out->changes);
        CHECK_OK(aureole_get_plan_change(sky, i, &change));
        snprintf(out->changes + used, sizeof out->changes - used, "%s|%s|%s|%s;", change.what, change.before, change.after,
                 change.reason);
    }
    CHECK(aureole_get_plan_change(sky, update.change_count, &change) == AUREOLE_INVALID_ARGUMENT);
    CHECK_OK(aureole_copy_plan(sky, &plan));
    CHECK_OK(aureole_get_plan_summary(plan, &summary));
    snprintf(out->setting, sizeof out->setting, "%s", summary.setting);
    CHECK_OK(aureole_destroy_plan(plan));
}

static void frame(struct small_rig* rig, aureole_planned_sky* sky, int number, struct planned_frame* out) {
    aureole_planned_light light = {.struct_size = sizeof light};
    aureole_commands* commands;
    CHECK_OK(aureole_set_planned_frame(sky, (uint64_t)number + 1));
    update(sky, number < 2 ? 50 : 1, out);
    commands = begin_small(rig);
    CHECK_OK(aureole_record_planned_sky(sky, commands));
    CHECK_OK(aureole_record_planned_composite(sky, commands, &rig->targets));
    end_small(rig, commands, out->texels);
    CHECK_OK(aureole_get_planned_light(sky, &light));
    CHECK(light.before != 0);
    out->fading_light = light.after != 0;
    out->light_share = light.share;
    CHECK_OK(aureole_planned_table_bytes(sky, &out->table_bytes));
}

static void check_refusals(struct small_rig* rig) {
    aureole_parameters earth;
    aureole_requirements needs;
    aureole_follow_settings follow = {.struct_size = sizeof follow};
    aureole_planned_sky* sky = NULL;
    aureole_plan_update update = {0};
    const aureole_camera camera = small_camera(2);
    aureole_sun sun = small_sun(20);
    scene(&earth, &needs);
    CHECK_OK(aureole_follow_settings_defaults(&follow));
    follow.margin = NAN;
    CHECK(aureole_create_planned_sky(rig->device, &needs, NULL, &follow, &sky) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strstr(aureole_last_error_field(), "margin") != NULL);
    follow.margin = 0.5;
    follow.passes_per_frame = 4000000000u;
    CHECK(aureole_create_planned_sky(rig->device, &needs, NULL, &follow, &sky) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strstr(aureole_last_error_field(), "passes_per_frame") != NULL);
    follow.passes_per_frame = 0;
    follow.fade_frames = 100001;
    CHECK(aureole_create_planned_sky(rig->device, &needs, NULL, &follow, &sky) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strstr(aureole_last_error_field(), "fade_frames") != NULL);
    needs.views = 2;
    CHECK(aureole_create_planned_sky(rig->device, &needs, NULL, NULL, &sky) == AUREOLE_INVALID_ARGUMENT);
    needs.views = 1;
    needs.tolerance = 0;
    CHECK(aureole_create_planned_sky(rig->device, &needs, NULL, NULL, &sky) == AUREOLE_INVALID_ARGUMENT);
    CHECK(sky == NULL);
    needs.tolerance = 0.05;
    CHECK(aureole_create_planned_sky(NULL, &needs, NULL, NULL, &sky) == AUREOLE_INVALID_ARGUMENT);
    CHECK(aureole_create_planned_sky(rig->device, &needs, NULL, NULL, NULL) == AUREOLE_INVALID_ARGUMENT);
    CHECK_OK(aureole_create_planned_sky(rig->device, &needs, NULL, NULL, &sky));
    CHECK(aureole_destroy_device(rig->device) == AUREOLE_MISUSE);
    CHECK(aureole_set_planned_exposure(sky, NAN) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strcmp(aureole_last_error_field(), "composite.exposure") == 0);
    earth.bottom_radius_m = NAN;
    CHECK(aureole_set_planned_air(sky, &earth) == AUREOLE_INVALID_ARGUMENT);
    CHECK(aureole_update_planned_sky(sky, &camera, &sun, 1, &update) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strcmp(aureole_last_error_field(), "out_update.struct_size") == 0);
    sun.direction[0] = NAN;
    CHECK(aureole_update_planned_sky(sky, &camera, &sun, 1, NULL) == AUREOLE_INVALID_ARGUMENT);
    CHECK(aureole_record_planned_sky(sky, NULL) == AUREOLE_INVALID_ARGUMENT);
    CHECK(aureole_prepare_planned_composite(sky, NULL) == AUREOLE_INVALID_ARGUMENT);
    CHECK_OK(aureole_destroy_planned_sky(sky));
    CHECK_OK(aureole_destroy_planned_sky(NULL));
}

void check_planned_sky(void) {
    struct planned_frame *by_c = calloc(PLANNED_FRAMES, sizeof *by_c), *by_cpp = calloc(PLANNED_FRAMES, sizeof *by_cpp);
    struct small_rig rig;
    aureole_parameters earth;
    aureole_requirements needs;
    aureole_composite_settings composite = {.struct_size = sizeof composite};
    aureole_follow_settings follow = {.struct_size = sizeof follow};
    aureole_planned_sky* sky = NULL;
    int i;
    open_small(&rig);
    scene(&earth, &needs);
    CHECK_OK(aureole_composite_settings_defaults(&composite));
    composite.target_format = AUREOLE_FORMAT_RGBA32_FLOAT;
    CHECK_OK(aureole_follow_settings_defaults(&follow));
    follow.margin = 0.1;
    follow.fade_frames = 3;
    follow.passes_per_frame = 0;
    CHECK_OK(aureole_create_planned_sky(rig.device, &needs, &composite, &follow, &sky));
    CHECK_OK(aureole_prepare_planned_composite(sky, &rig.targets));
    CHECK_OK(aureole_set_planned_exposure(sky, 10));
    for (i = 0; i < PLANNED_FRAMES; ++i) frame(&rig, sky, i, &by_c[i]);
    CHECK_OK(aureole_invalidate_planned_sky(sky));
    CHECK_OK(aureole_set_planned_air(sky, &earth));
    CHECK_OK(aureole_release_planned_composite(sky, &rig.targets));
    CHECK_OK(aureole_destroy_planned_sky(sky));
    CHECK(planned_frames_by_cpp(by_cpp) == 0);
    CHECK(by_c[0].planned == 1 && by_c[1].planned == 0 && by_c[2].planned == 1);
    for (i = 0; i < PLANNED_FRAMES; ++i) {
        CHECK(sum_of(by_c[i].texels) > 0);
        CHECK(by_c[i].table_bytes > 0);
        CHECK(memcmp(&by_c[i], &by_cpp[i], sizeof by_c[i]) == 0);
        printf("planned sky: %s, share %g, %u changes\n", by_c[i].setting, by_c[i].share, by_c[i].change_count);
    }
    check_refusals(&rig);
    close_small(&rig);
    free(by_c);
    free(by_cpp);
}
