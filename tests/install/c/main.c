/* Renders a row of sky through the installed C API, on the CPU. */
#include <aureole.h>
#include <stdio.h>

enum { WIDTH = 4, HEIGHT = 8 };

static int failed(const char* what) {
    printf("%s: %s\n", what, aureole_last_error());
    return 1;
}

int main(void) {
    aureole_cpu_device_desc desc = {.struct_size = sizeof desc};
    aureole_parameters earth = {.struct_size = sizeof earth};
    aureole_composite_settings composite = {.struct_size = sizeof composite};
    aureole_texture_desc target = {.struct_size = sizeof target};
    aureole_composite_targets targets = {.struct_size = sizeof targets};
    aureole_camera camera = {.struct_size = sizeof camera};
    aureole_sun sun = {.struct_size = sizeof sun};
    aureole_device* device = NULL;
    aureole_atmosphere* atmosphere = NULL;
    aureole_view* view = NULL;
    aureole_commands* commands = NULL;
    aureole_buffer staging = 0;
    float texels[4 * WIDTH * HEIGHT];

    if (aureole_cpu_device_desc_defaults(&desc) || aureole_create_cpu_device(&desc, &device)) return failed("device");
    if (aureole_preset("earth", &earth) || aureole_create_atmosphere(device, &earth, NULL, &atmosphere)) return failed("air");
    if (aureole_composite_settings_defaults(&composite)) return failed("settings");
    composite.target_format = AUREOLE_FORMAT_RGBA32_FLOAT;
    if (aureole_create_view(atmosphere, NULL, &composite, &view)) return failed("view");
    if (aureole_texture_desc_defaults(&target) || aureole_composite_targets_defaults(&targets)) return failed("target");
    target.format = AUREOLE_FORMAT_RGBA32_FLOAT;
    target.width = targets.width = WIDTH;
    target.height = targets.height = HEIGHT;
    target.usage = AUREOLE_USAGE_STORAGE | AUREOLE_USAGE_COPY_SOURCE;
    if (aureole_create_texture(device, &target, &targets.target) || aureole_prepare_composite(view, &targets) ||
        aureole_create_buffer(device, "texels", sizeof texels, AUREOLE_USAGE_READ_BACK, &staging))
        return failed("objects");
    if (aureole_sun_defaults(&sun)) return failed("sun");
    sun.direction[0] = 0.6, sun.direction[2] = 0.8;
    if (aureole_look(earth.bottom_radius_m, 2, 0, 0.7, 1, 0.5, 0.1, &camera) || aureole_update_view(view, &camera, &sun, 1))
        return failed("camera");

    if (aureole_begin(device, NULL, &commands) ||
        aureole_barrier_texture(commands, targets.target, AUREOLE_STATE_UNDEFINED, AUREOLE_STATE_STORAGE_WRITE) ||
        aureole_barrier_buffer(commands, staging, AUREOLE_STATE_UNDEFINED, AUREOLE_STATE_COPY_DESTINATION) ||
        aureole_record_atmosphere(atmosphere, commands, -1) || aureole_record_view(view, commands, -1) ||
        aureole_record_composite(view, commands, &targets, -1) ||
        aureole_barrier_texture(commands, targets.target, AUREOLE_STATE_STORAGE_WRITE, AUREOLE_STATE_COPY_SOURCE) ||
        aureole_copy_texture_to_buffer(commands, targets.target, staging) || aureole_end(device, NULL) ||
        aureole_wait(device) || aureole_read_buffer(device, staging, texels, sizeof texels))
        return failed("frame");

    printf("aureole %s in C: zenith %g %g %g\n", aureole_version(), texels[0], texels[1], texels[2]);
    aureole_destroy_view(view);
    aureole_destroy_texture(device, targets.target, 0);
    aureole_destroy_buffer(device, staging, 0);
    if (aureole_destroy_atmosphere(atmosphere) || aureole_destroy_device(device)) return failed("end");
    return texels[2] > texels[0] && texels[0] > 0 ? 0 : 1;
}
