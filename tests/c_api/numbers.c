/* Settings of models by number: the pictures that C++ makes of the same fields, and what is no such number. */
#include "c_api/small_rig.h"

struct choice {
    const char *model, *quality;
    aureole_number numbers[8]; /* To the first without a name. */
};
static const struct choice choices[SMALL_MODELS] = {
    [SMALL_FOG] = {"fog", "default", {{"mode", 0}, {"colour.g", 0.2}, {"density_per_m", 2e-5}}},
    [SMALL_SINGLE] = {"single",
                      "default",
                      {{"view_steps", 5}, {"dome.size.width", 12}, {"dome.size.height", 16}, {"dome.phase", 1}}},
    [SMALL_SINGLE_LUT] = {"single-lut", "default", {{"steps", 1}, {"view_steps", 20}, {"table.width", 32}}},
    [SMALL_HILLAIRE] = {"hillaire", "default", {{"fast_sky", 0}, {"march_steps", 12}, {"multi_scatter.height", 16}}},
    [SMALL_AUREOLE] = {"aureole",
                       "low",
                       {{"sky_view.width", 24},
                        {"sky_view_nodes", 9}, /* the last of a name counts */
                        {"angular_order", 2},
                        {"ground_light", 0},
                        {"table_format", AUREOLE_FORMAT_RGBA32_FLOAT},
                        {"sky_view_nodes", 4}}},
    [SMALL_BRUNETON] = {"bruneton",
                        "low",
                        {{"altitude_nodes", 4},
                         {"view_nodes", 16},
                         {"sun_nodes", 8},
                         {"nu_nodes", 4},
                         {"orders", 2},
                         {"combined", 0},
                         {"lowest_sun_deg", 97.5}}},
    [SMALL_REFERENCE] = {"reference", "low", {{"paths_per_frame", 2}, {"seed", 5}, {"light_paths", 0}, {"max_order", 2}}},
};

static aureole_setting setting_of(const struct choice* choice) {
    aureole_setting setting = {.struct_size = sizeof setting};
    CHECK_OK(aureole_setting_defaults(&setting));
    setting.model = choice->model;
    setting.quality = choice->quality;
    setting.numbers = choice->numbers;
    while (setting.number_count < 8 && choice->numbers[setting.number_count].name) ++setting.number_count;
    return setting;
}

static void small_picture_by_c(struct small_rig* rig, const aureole_setting* setting, float out[SMALL_FLOATS]) {
    aureole_parameters earth = {.struct_size = sizeof earth};
    aureole_composite_settings composite = {.struct_size = sizeof composite};
    const aureole_camera camera = small_camera(1500);
    const aureole_sun sun = small_sun(20);
    aureole_atmosphere* atmosphere = NULL;
    aureole_view* view = NULL;
    aureole_commands* commands;
    CHECK_OK(aureole_preset("earth", &earth));
    CHECK_OK(aureole_create_atmosphere(rig->device, &earth, setting, &atmosphere));
    CHECK_OK(aureole_composite_settings_defaults(&composite));
    composite.target_format = AUREOLE_FORMAT_RGBA32_FLOAT;
    CHECK_OK(aureole_create_view(atmosphere, NULL, &composite, &view));
    CHECK_OK(aureole_prepare_composite(view, &rig->targets));
    CHECK_OK(aureole_update_view(view, &camera, &sun, 1));
    commands = begin_small(rig);
    CHECK_OK(aureole_record_atmosphere(atmosphere, commands, -1));
    CHECK_OK(aureole_record_view(view, commands, -1));
    CHECK_OK(aureole_record_composite(view, commands, &rig->targets, -1));
    end_small(rig, commands, out);
    CHECK_OK(aureole_destroy_view(view));
    CHECK_OK(aureole_destroy_atmosphere(atmosphere));
}

/* Each number of the model is what it was set to, and nothing that no model takes is taken. */
static void check_each(const struct choice* choice) {
    static const double wrong[] = {NAN, -1, 1e12};
    aureole_setting setting = setting_of(choice);
    aureole_number number = {NULL, 0}, kept;
    uint32_t i, count = 0;
    size_t k;
    setting.numbers = NULL, setting.number_count = 0;
    CHECK_OK(aureole_get_setting_number(&setting, 0, NULL, &count));
    CHECK(count >= 7);
    for (i = 0; i < count; ++i) {
        setting.numbers = NULL, setting.number_count = 0;
        CHECK_OK(aureole_get_setting_number(&setting, i, &number, NULL));
        setting.numbers = &number, setting.number_count = 1;
        kept = number;
        CHECK_OK(aureole_get_setting_number(&setting, i, &kept, &count));
        CHECK(kept.value == number.value && strcmp(kept.name, number.name) == 0);
        for (k = 0; k < sizeof wrong / sizeof wrong[0]; ++k) {
            number.value = wrong[k];
            CHECK(aureole_get_setting_number(&setting, i, &kept, &count) == AUREOLE_INVALID_ARGUMENT);
            CHECK(strncmp(aureole_last_error_field(), choice->model, 3) == 0); /* "aureole.sky_view.width" */
            CHECK(aureole_last_error_allowed()[0] != 0 && strstr(aureole_last_error_allowed(), "as documented") == NULL);
        }
    }
    setting.numbers = choice->numbers;
    for (setting.number_count = 0; choice->numbers[setting.number_count].name;) ++setting.number_count;
    for (i = 0; i < count; ++i) {
        CHECK_OK(aureole_get_setting_number(&setting, i, &number, NULL));
        for (k = setting.number_count; k-- > 0;)
            if (strcmp(choice->numbers[k].name, number.name) == 0) {
                CHECK(number.value == choice->numbers[k].value);
                break;
            }
    }
    CHECK(aureole_get_setting_number(&setting, count, &number, NULL) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strcmp(aureole_last_error_field(), "index") == 0);
}

static void check_refused(struct small_rig* rig, const aureole_setting* setting, const char* field, const char* words) {
    aureole_parameters earth = {.struct_size = sizeof earth};
    aureole_atmosphere* atmosphere = NULL;
    CHECK_OK(aureole_preset("earth", &earth));
    CHECK(aureole_create_atmosphere(rig->device, &earth, setting, &atmosphere) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strcmp(aureole_last_error_field(), field) == 0);
    CHECK(strstr(aureole_last_error(), words) != NULL);
    CHECK(atmosphere == NULL);
}

static void check_refusals(struct small_rig* rig) {
    static const char* const simplified[] = {"half the samples"};
    static const char* const term[] = {"ozone"};
    aureole_number number = {"sky_view_node", 4};
    aureole_setting setting = setting_of(&choices[SMALL_AUREOLE]);
    float texels[SMALL_FLOATS];
    setting.numbers = &number, setting.number_count = 1;
    check_refused(rig, &setting, "setting.numbers[0].name", "sky_view_nodes");
    number.name = NULL;
    check_refused(rig, &setting, "setting.numbers[0].name", "NULL");
    setting.numbers = NULL;
    check_refused(rig, &setting, "setting.numbers", "NULL");
    setting.numbers = &number;
    number.name = "sky_view_nodes";
    number.value = 17;
    check_refused(rig, &setting, "aureole.sky_view_nodes", "17");
    number.value = 4.5;
    check_refused(rig, &setting, "aureole.sky_view_nodes", "4.5 is not allowed; allowed: whole numbers: in [2, 16]");
    number.name = "ground_light";
    number.value = 2;
    check_refused(rig, &setting, "aureole.ground_light", "2 is not allowed; allowed: 0 or 1");
    number.name = "sky_view.width";
    number.value = -1;
    check_refused(rig, &setting, "aureole.sky_view.width", "-1 is not allowed; allowed: whole numbers: in [4, 4096]");
    setting.model = "single-lut";
    number.name = "steps";
    check_refused(rig, &setting, "single_lut.steps", "-1 is not allowed; allowed: whole numbers: gauss or midpoints");
    setting.model = "aureole";
    number.name = "sky_view_nodes";
    number.value = 4;
    setting.without = simplified, setting.without_count = 1;
    check_refused(rig, &setting, "setting.without", "half the samples");
    setting.number_count = 0;
    CHECK(aureole_get_setting_number(&setting, 0, &number, NULL) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strcmp(aureole_last_error_field(), "setting.without") == 0);
    setting.without_count = 0;
    setting.spectral = "a few";
    CHECK(aureole_get_setting_number(&setting, 0, &number, NULL) == AUREOLE_INVALID_ARGUMENT);
    setting.number_count = setting.without_count = 1;
    setting.without = term;
    setting.spectral = "4";
    small_picture_by_c(rig, &setting, texels);
    CHECK(sum_of(texels) > 0);
}

void check_numbers(void) {
    struct small_rig rig;
    float by_c[SMALL_FLOATS], by_cpp[SMALL_FLOATS];
    int i;
    open_small(&rig);
    for (i = 0; i < SMALL_MODELS; ++i) {
        const aureole_setting setting = setting_of(&choices[i]);
        memset(by_c, 0, sizeof by_c);
        small_picture_by_c(&rig, &setting, by_c);
        CHECK(small_picture_by_cpp(i, by_cpp) == 0);
        CHECK(sum_of(by_c) > 0);
        CHECK(memcmp(by_c, by_cpp, sizeof by_c) == 0);
        printf("%s by %u numbers\n", choices[i].model, setting.number_count);
        check_each(&choices[i]);
    }
    check_refusals(&rig);
    close_small(&rig);
}
