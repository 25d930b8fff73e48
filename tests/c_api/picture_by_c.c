/* The picture by the C API. */
#include "c_api/picture_by_c.h"

#include <string.h>

#include "c_api/check.h"

static aureole_commands* begin_own(void* user, aureole_device* device) {
    aureole_commands* commands = NULL;
    (void)user;
    CHECK_OK(aureole_begin(device, NULL, &commands));
    return commands;
}
static void run_own(void* user, aureole_device* device) {
    uint64_t frame = 0;
    (void)user;
    CHECK_OK(aureole_end(device, &frame));
    CHECK(frame > 0);
    CHECK_OK(aureole_wait(device));
}
const struct runner own_queue = {begin_own, run_own, NULL};

static void scene_air(aureole_parameters* air, aureole_term terms[8]) {
    static const double altitude_m[] = {0, 500, 3000}, density[] = {1, 0.5, 0};
    uint32_t i;
    air->struct_size = sizeof *air;
    CHECK_OK(aureole_preset("earth", air));
    for (i = 0; i < air->term_count && i < 8; ++i) terms[i] = air->terms[i];
    air->terms = terms;
    air->ground_albedo[0] = 0.1, air->ground_albedo[1] = 0.2, air->ground_albedo[2] = 0.3;
    for (i = 0; i < 3; ++i) terms[1].scattering_per_m[i] *= 3;
    terms[1].phase.kind = AUREOLE_PHASE_HENYEY_GREENSTEIN;
    terms[1].phase.g = 0.7;
    terms[1].profile.kind = AUREOLE_PROFILE_TABULATED;
    terms[1].profile.altitude_m = altitude_m;
    terms[1].profile.density = density;
    terms[1].profile.count = 3;
}

static void scene_suns(aureole_sun suns[2]) {
    static const double high[3] = {0.6, 0.1, 0.8}, low[3] = {-1, 0.5, 0.02}, strong[3] = {10, 9, 8};
    int i;
    for (i = 0; i < 2; ++i) {
        suns[i].struct_size = sizeof suns[i];
        CHECK_OK(aureole_sun_defaults(&suns[i]));
    }
    memcpy(suns[0].direction, high, sizeof high);
    memcpy(suns[0].irradiance, strong, sizeof strong);
    memcpy(suns[1].direction, low, sizeof low);
    suns[1].angular_radius_rad = 0.03;
    suns[1].limb_darkening = AUREOLE_LIMB_NONE;
}

static aureole_view* scene_view(aureole_atmosphere* atmosphere) {
    aureole_view_settings settings = {.struct_size = sizeof settings};
    aureole_composite_settings composite = {.struct_size = sizeof composite};
    aureole_view* view = NULL;
    CHECK_OK(aureole_view_settings_defaults(&settings));
    settings.max_suns = 2;
    CHECK_OK(aureole_composite_settings_defaults(&composite));
    composite.target_format = AUREOLE_FORMAT_RGBA32_FLOAT;
    composite.exposure = 1.5;
    CHECK_OK(aureole_create_view(atmosphere, &settings, &composite, &view));
    return view;
}

static aureole_buffer read_back(aureole_device* device, aureole_commands* commands, aureole_texture texture,
                                aureole_state state, uint64_t bytes) {
    aureole_buffer buffer = 0;
    CHECK_OK(
        aureole_create_buffer(device, "read back", bytes, AUREOLE_USAGE_READ_BACK | AUREOLE_USAGE_COPY_DESTINATION, &buffer));
    CHECK_OK(aureole_barrier_buffer(commands, buffer, AUREOLE_STATE_UNDEFINED, AUREOLE_STATE_COPY_DESTINATION));
    CHECK_OK(aureole_barrier_texture(commands, texture, state, AUREOLE_STATE_COPY_SOURCE));
    CHECK_OK(aureole_copy_texture_to_buffer(commands, texture, buffer));
    CHECK_OK(aureole_barrier_texture(commands, texture, AUREOLE_STATE_COPY_SOURCE, state));
    return buffer;
}

static void record_and_read(aureole_device* device, const struct runner* runner, aureole_atmosphere* atmosphere,
                            aureole_view* view, const aureole_composite_targets* targets, struct picture* out) {
    aureole_view_tables tables = {.struct_size = sizeof tables};
    aureole_commands* commands = runner->begin(runner->user, device);
    aureole_buffer texels, light;
    CHECK_OK(aureole_get_view_tables(view, &tables));
    CHECK_OK(aureole_barrier_texture(commands, targets->target, AUREOLE_STATE_UNDEFINED, AUREOLE_STATE_STORAGE_WRITE));
    CHECK_OK(aureole_record_atmosphere(atmosphere, commands, -1));
    CHECK_OK(aureole_record_view(view, commands, -1));
    CHECK_OK(aureole_record_composite(view, commands, targets, -1));
    texels = read_back(device, commands, targets->target, AUREOLE_STATE_STORAGE_WRITE, sizeof out->texels);
    light = read_back(device, commands, tables.light, AUREOLE_STATE_SAMPLED, sizeof out->light);
    runner->run(runner->user, device);
    CHECK_OK(aureole_read_buffer(device, texels, out->texels, sizeof out->texels));
    CHECK_OK(aureole_read_buffer(device, light, out->light, sizeof out->light));
    CHECK_OK(aureole_destroy_buffer(device, texels, 0));
    CHECK_OK(aureole_destroy_buffer(device, light, 0));
}

static void check_reports(const aureole_atmosphere* atmosphere, const aureole_view* view) {
    aureole_pass_report reports[8] = {{.struct_size = sizeof reports[0]}};
    uint32_t count = 0;
    double progress = 0;
    CHECK_OK(aureole_atmosphere_reports(atmosphere, reports, 8, &count));
    CHECK(count == 2 && strcmp(reports[0].name, "transmittance") == 0 && reports[1].recorded == 1);
    CHECK_OK(aureole_view_reports(view, NULL, 0, &count));
    CHECK(count > 2 && count <= 8);
    CHECK_OK(aureole_view_reports(view, reports, 8, &count));
    CHECK(strcmp(reports[count - 1].name, "composite") == 0 &&
          reports[count - 1].bytes_written == sizeof(float) * PICTURE_FLOATS);
    CHECK_OK(aureole_get_progress(atmosphere, &progress));
    CHECK(progress == 1);
}

static void plan_by_c(struct picture* out) {
    aureole_parameters earth = {.struct_size = sizeof earth};
    aureole_requirements needs = {.struct_size = sizeof needs};
    aureole_plan_summary summary = {.struct_size = sizeof summary};
    aureole_plan* plan = NULL;
    CHECK_OK(aureole_preset("earth", &earth));
    CHECK_OK(aureole_requirements_defaults(&needs));
    needs.air = &earth;
    needs.altitude_m[1] = 3000;
    needs.geometry = 1;
    needs.tolerance = 0.05;
    CHECK_OK(aureole_make_plan(&needs, &plan));
    CHECK_OK(aureole_get_plan_summary(plan, &summary));
    snprintf(out->setting, sizeof out->setting, "%s", summary.setting);
    snprintf(out->plan_text, sizeof out->plan_text, "%s", summary.text);
    CHECK_OK(aureole_destroy_plan(plan));
}

void picture_by_c(aureole_device* device, const struct runner* runner, struct picture* out) {
    aureole_parameters air;
    aureole_term terms[8];
    aureole_setting setting = {.struct_size = sizeof setting};
    aureole_camera camera = {.struct_size = sizeof camera};
    aureole_sun suns[2];
    aureole_texture_desc desc = {.struct_size = sizeof desc};
    aureole_composite_targets targets = {.struct_size = sizeof targets};
    aureole_atmosphere* atmosphere = NULL;
    aureole_view* view;
    static const double up[3] = {0, 0, 2};

    scene_air(&air, terms);
    scene_suns(suns);
    CHECK_OK(aureole_setting_defaults(&setting));
    setting.quality = "low";
    CHECK_OK(aureole_create_atmosphere(device, &air, &setting, &atmosphere));
    view = scene_view(atmosphere);
    CHECK_OK(aureole_texture_desc_defaults(&desc));
    desc.name = "target";
    desc.format = AUREOLE_FORMAT_RGBA32_FLOAT;
    desc.width = PICTURE_WIDTH, desc.height = PICTURE_HEIGHT;
    desc.usage = AUREOLE_USAGE_STORAGE | AUREOLE_USAGE_COPY_SOURCE;
    CHECK_OK(aureole_composite_targets_defaults(&targets));
    targets.width = PICTURE_WIDTH, targets.height = PICTURE_HEIGHT;
    CHECK_OK(aureole_create_texture(device, &desc, &targets.target));
    CHECK_OK(aureole_prepare_composite(view, &targets));
    CHECK_OK(aureole_look(air.bottom_radius_m, 1500, 0.3, 0.1, 1.2, 1.5, 0.1, &camera));
    CHECK_OK(aureole_update_view(view, &camera, suns, 2));
    record_and_read(device, runner, atmosphere, view, &targets, out);
    check_reports(atmosphere, view);

    CHECK_OK(aureole_sun_irradiance(out->light, LIGHT_FLOATS, 1, out->sun_irradiance));
    CHECK_OK(aureole_sky_irradiance(out->light, LIGHT_FLOATS, up, out->sky_irradiance));
    CHECK_OK(aureole_sky_coefficient(out->light, LIGHT_FLOATS, 3, 0, out->sky_coefficient));
    CHECK_OK(aureole_vertical_optical_depth(&air, out->vertical_depth));
    plan_by_c(out);

    CHECK(aureole_destroy_device(device) == AUREOLE_MISUSE);
    CHECK(aureole_destroy_atmosphere(atmosphere) == AUREOLE_MISUSE);
    CHECK_OK(aureole_release_composite(view, &targets));
    CHECK_OK(aureole_destroy_view(view));
    CHECK_OK(aureole_destroy_texture(device, targets.target, 0));
    CHECK_OK(aureole_destroy_atmosphere(atmosphere));
}
