/* Bad input: a result, a message that names field, value and range, and nothing else. */
#include <math.h>
#include <string.h>

#include "c_api/check.h"
#include "c_api/errors.h"

#define CHECK_INVALID(call, field, value, allowed)                    \
    do {                                                              \
        CHECK((call) == AUREOLE_INVALID_ARGUMENT);                    \
        CHECK(strcmp(aureole_last_error_field(), field) == 0);        \
        CHECK(strcmp(aureole_last_error_value(), value) == 0);        \
        CHECK(strstr(aureole_last_error_allowed(), allowed) != NULL); \
        CHECK(strstr(aureole_last_error(), field) != NULL);           \
        CHECK(strstr(aureole_last_error(), value) != NULL);           \
    } while (0)

static void check_names(void) {
    const char* name = NULL;
    uint32_t count = 0;
    CHECK(strcmp(aureole_result_name(AUREOLE_OK), "ok") == 0);
    CHECK(strcmp(aureole_result_name(AUREOLE_MISUSE), "misuse") == 0);
    CHECK(strcmp(aureole_result_name(99), "unknown") == 0);
    CHECK(strcmp(aureole_result_name(-1), "unknown") == 0);
    CHECK(strlen(aureole_version()) >= 5);
    while (aureole_preset_name(count, &name) == AUREOLE_OK) {
        aureole_parameters air = {.struct_size = sizeof air};
        CHECK_OK(aureole_preset(name, &air));
        CHECK_OK(aureole_validate_parameters(&air));
        ++count;
    }
    CHECK(count == 6);
    CHECK(aureole_last_error()[0] != 0);
}

static void check_air(void) {
    aureole_parameters air = {.struct_size = sizeof air}, wrong;
    aureole_term terms[8];
    uint32_t i;
    CHECK_OK(aureole_preset("earth", &air));
    for (i = 0; i < air.term_count; ++i) terms[i] = air.terms[i];
    air.terms = terms;
    CHECK_OK(aureole_validate_parameters(&air));

    wrong = air;
    wrong.bottom_radius_m = -1;
    CHECK_INVALID(aureole_validate_parameters(&wrong), "planet.bottom_radius_m", "-1", "1000");
    wrong.bottom_radius_m = NAN;
    CHECK(aureole_validate_parameters(&wrong) == AUREOLE_INVALID_ARGUMENT);
    terms[1].phase.g = 2;
    CHECK_INVALID(aureole_validate_parameters(&air), "terms[1].phase.g", "2", "0.999");
    terms[1].phase.kind = 77;
    CHECK_INVALID(aureole_validate_parameters(&air), "terms[1].phase.kind", "77", "0 to 4");
    terms[1].phase.kind = AUREOLE_PHASE_TABULATED;
    terms[1].phase.count = 3;
    CHECK_INVALID(aureole_validate_parameters(&air), "terms[1].phase.angle_rad", "NULL", "pointer");
    terms[1] = terms[0];
    terms[1].profile.kind = 3;
    CHECK_INVALID(aureole_validate_parameters(&air), "terms[1].profile.kind", "3", "0 to 2");
    terms[1] = terms[0];
    wrong = air;
    wrong.terms = NULL;
    CHECK_INVALID(aureole_validate_parameters(&wrong), "terms", "NULL", "pointer");
    CHECK_INVALID(aureole_validate_parameters(NULL), "parameters", "NULL", "pointer");
    CHECK(aureole_preset("pluto", &air) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strstr(aureole_last_error(), "pluto") != NULL && strstr(aureole_last_error(), "titan") != NULL);
    CHECK(aureole_preset_earth_with_visibility(1, &air) == AUREOLE_INVALID_ARGUMENT);
    CHECK_OK(aureole_preset_earth_with_visibility(5e4, &air));
}

static void check_sizes(void) {
    aureole_parameters air = {.struct_size = sizeof air};
    aureole_camera camera = {0};
    aureole_sun sun = {.struct_size = sizeof sun + 8};
    air.struct_size = sizeof air + 1; /* of a header that is newer than the library */
    CHECK(aureole_preset("earth", &air) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strcmp(aureole_last_error_field(), "out_parameters.struct_size") == 0);
    CHECK(aureole_camera_defaults(&camera) == AUREOLE_INVALID_ARGUMENT); /* forgotten */
    CHECK_INVALID(aureole_camera_defaults(&camera), "camera.struct_size", "0", "sizeof");
    CHECK(aureole_sun_defaults(&sun) == AUREOLE_INVALID_ARGUMENT);
}

static void listen(void* user, aureole_severity severity, const char* text) {
    if (severity == AUREOLE_WARNING) snprintf(user, 1000, "%s", text);
}

static void check_envelope(aureole_device* device) {
    aureole_parameters air = {.struct_size = sizeof air};
    aureole_term terms[8];
    aureole_outside outside[4] = {{.struct_size = sizeof outside[0]}};
    aureole_atmosphere* atmosphere = NULL;
    char warned[1000] = "";
    uint32_t i, count = 99;
    CHECK_OK(aureole_preset("earth", &air));
    CHECK_OK(aureole_envelope_of_air(&air, NULL, 0, &count));
    CHECK(count == 0);
    for (i = 0; i < air.term_count; ++i) terms[i] = air.terms[i];
    air.terms = terms;
    terms[1].phase.g = 0.998;
    CHECK_OK(aureole_envelope_of_air(&air, outside, 4, &count));
    CHECK(count == 1 && strcmp(outside[0].field, "terms[1].phase.g") == 0 && outside[0].value == 0.998);
    CHECK(outside[0].greatest < 0.998 && strstr(outside[0].text, "envelope") != NULL);
    CHECK_INVALID(aureole_envelope_of_air(&air, NULL, 1, &count), "out", "NULL", "pointer");

    CHECK_OK(aureole_set_log(listen, warned));
    CHECK_OK(aureole_create_atmosphere(device, &air, NULL, &atmosphere));
    CHECK_OK(aureole_set_log(NULL, NULL));
    CHECK(strstr(warned, "terms[1].phase.g") != NULL);
    CHECK_OK(aureole_destroy_atmosphere(atmosphere));
}

static void check_objects(aureole_device* device) {
    aureole_parameters air = {.struct_size = sizeof air};
    aureole_setting setting = {.struct_size = sizeof setting};
    aureole_view_settings settings = {.struct_size = sizeof settings};
    aureole_camera camera = {.struct_size = sizeof camera};
    aureole_outside outside = {.struct_size = sizeof outside};
    aureole_sun sun = {.struct_size = sizeof sun};
    aureole_texture_desc desc = {.struct_size = sizeof desc};
    aureole_native_texture native = {.struct_size = sizeof native};
    aureole_atmosphere* atmosphere = NULL;
    aureole_view* view = NULL;
    aureole_commands* commands = NULL;
    aureole_texture texture = 7;
    uint32_t count = 0;
    static const char* nothing[] = {"nitrogen"};

    CHECK_OK(aureole_preset("earth", &air));
    CHECK_OK(aureole_setting_defaults(&setting));
    setting.model = "clouds";
    CHECK(aureole_create_atmosphere(device, &air, &setting, &atmosphere) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strstr(aureole_last_error(), "clouds") != NULL && strstr(aureole_last_error(), "bruneton") != NULL);
    setting.model = NULL;
    setting.without = nothing;
    setting.without_count = 1;
    CHECK(aureole_create_atmosphere(device, &air, &setting, &atmosphere) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strstr(aureole_last_error(), "nitrogen") != NULL);
    CHECK(atmosphere == NULL);
    setting.without_count = 0;
    setting.quality = "low";
    CHECK_OK(aureole_create_atmosphere(device, &air, &setting, &atmosphere));
    CHECK(aureole_set_multi_scatter_passes_per_frame(atmosphere, 65, 0) == AUREOLE_INVALID_ARGUMENT);
    CHECK(aureole_set_multi_scatter_passes_per_frame(atmosphere, 4000000000u, 0) == AUREOLE_INVALID_ARGUMENT);
    CHECK_INVALID(aureole_set_multi_scatter_passes_per_frame(atmosphere, 1, 2), "first_too", "2", "0 or 1");

    CHECK_OK(aureole_view_settings_defaults(&settings));
    settings.max_suns = 5;
    CHECK_INVALID(aureole_create_view(atmosphere, &settings, NULL, &view), "view.max_suns", "5", "4");
    settings.max_suns = 1;
    settings.light = 3;
    CHECK_INVALID(aureole_create_view(atmosphere, &settings, NULL, &view), "view.light", "3", "0 or 1");
    settings.light = 1;
    CHECK_OK(aureole_create_view(atmosphere, &settings, NULL, &view));
    CHECK_OK(aureole_look(air.bottom_radius_m, 2, 0, 0, 1, 1, 0.1, &camera));
    CHECK_OK(aureole_sun_defaults(&sun));
    camera.row_order = 9;
    CHECK_INVALID(aureole_update_view(view, &camera, &sun, 1), "camera.row_order", "9", "0 to 1");
    camera.row_order = AUREOLE_ROWS_TOP_FIRST;
    sun.irradiance[1] = -1;
    CHECK(aureole_update_view(view, &camera, &sun, 1) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strstr(aureole_last_error_field(), "irradiance") != NULL);
    sun.irradiance[1] = 1;
    CHECK_INVALID(aureole_update_view(view, &camera, NULL, 1), "suns", "NULL", "pointer");
    CHECK_OK(aureole_update_view(view, &camera, NULL, 0));
    CHECK_OK(aureole_update_view(view, &camera, &sun, 1));
    CHECK_OK(aureole_envelope_of_view(view, &camera, &sun, 1, &outside, 1, &count));
    CHECK(count == 0);
    CHECK(aureole_set_exposure(view, 0) == AUREOLE_INVALID_ARGUMENT);

    CHECK(aureole_end(device, NULL) == AUREOLE_MISUSE);
    CHECK(aureole_begin(device, &count, &commands) == AUREOLE_INVALID_ARGUMENT);
    CHECK_INVALID(aureole_begin_on(device, NULL, 0, &commands), "queue_family", "0", "UINT32_MAX");
    CHECK_OK(aureole_begin(device, NULL, &commands));
    CHECK(aureole_begin(device, NULL, &commands) == AUREOLE_MISUSE);
    CHECK_INVALID(aureole_barrier_texture(commands, 1, 0, 40), "after", "40", "0 to 8");
    CHECK_INVALID(aureole_record_atmosphere(atmosphere, commands, -2), "first_timestamp", "-2", "-1");
    CHECK_OK(aureole_end(device, NULL));
    CHECK(aureole_record_atmosphere(atmosphere, commands, -1) == AUREOLE_MISUSE);

    CHECK_OK(aureole_texture_desc_defaults(&desc));
    CHECK(aureole_create_texture(device, &desc, &texture) == AUREOLE_INVALID_ARGUMENT);
    CHECK(texture == 7); /* outputs of what failed are not written */
    desc.format = AUREOLE_FORMAT_RGBA32_FLOAT;
    desc.usage = 1u << 20;
    CHECK_INVALID(aureole_create_texture(device, &desc, &texture), "desc.usage", "1048576", "flags");
    CHECK_INVALID(aureole_destroy_view(view) == AUREOLE_OK ? aureole_get_view_tables(NULL, NULL) : AUREOLE_OK, "view", "NULL",
                  "pointer");
    CHECK(aureole_get_native_texture(device, 1, &native) == AUREOLE_UNSUPPORTED);
    CHECK_OK(aureole_destroy_atmosphere(atmosphere));
    CHECK_OK(aureole_destroy_atmosphere(NULL));
    CHECK_OK(aureole_destroy_view(NULL));
    CHECK_OK(aureole_destroy_device(NULL));
}

static void check_plans(void) {
    aureole_requirements needs = {.struct_size = sizeof needs};
    aureole_parameters air = {.struct_size = sizeof air};
    aureole_plan* plan = NULL;
    const char* text = NULL;
    CHECK_OK(aureole_requirements_defaults(&needs));
    CHECK_INVALID(aureole_make_plan(&needs, &plan), "air", "NULL", "pointer");
    CHECK_OK(aureole_preset("earth", &air));
    needs.air = &air;
    CHECK(aureole_make_plan(&needs, &plan) == AUREOLE_INVALID_ARGUMENT); /* nothing says what is tolerable */
    needs.tolerance = 20;
    CHECK(aureole_make_plan(&needs, &plan) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strstr(aureole_last_error(), "tolerance") != NULL && strstr(aureole_last_error(), "20") != NULL);
    needs.tolerance = 0.05;
    CHECK_OK(aureole_make_plan(&needs, &plan));
    CHECK(aureole_plan_warning(plan, 1000, &text) == AUREOLE_INVALID_ARGUMENT);
    CHECK_OK(aureole_destroy_plan(plan));
}

void check_errors(void) {
    aureole_cpu_device_desc desc = {.struct_size = sizeof desc};
    aureole_device* device = NULL;
    CHECK(aureole_last_error()[0] == 0);
    check_names();
    check_air();
    check_sizes();
    check_plans();
    CHECK_OK(aureole_cpu_device_desc_defaults(&desc));
    desc.threads = 5000;
    CHECK_INVALID(aureole_create_cpu_device(&desc, &device), "threads", "5000", "1024");
    desc.threads = 0;
    CHECK_OK(aureole_create_cpu_device(&desc, &device));
    check_envelope(device);
    check_objects(device);
    CHECK_OK(aureole_destroy_device(device));
}
