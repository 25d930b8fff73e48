/* A device, a target and a way to read it, for small pictures in C. */
#ifndef AUREOLE_TESTS_C_API_SMALL_RIG_H
#define AUREOLE_TESTS_C_API_SMALL_RIG_H

#include <math.h>
#include <string.h>

#include "c_api/check.h"
#include "c_api/small_pictures.h"

struct small_rig {
    aureole_device* device;
    aureole_composite_targets targets;
    aureole_buffer staging;
};

static inline void open_small(struct small_rig* rig) {
    aureole_cpu_device_desc desc = {.struct_size = sizeof desc};
    aureole_texture_desc target = {.struct_size = sizeof target};
    memset(rig, 0, sizeof *rig);
    CHECK_OK(aureole_cpu_device_desc_defaults(&desc));
    CHECK_OK(aureole_create_cpu_device(&desc, &rig->device));
    CHECK_OK(aureole_texture_desc_defaults(&target));
    target.format = AUREOLE_FORMAT_RGBA32_FLOAT;
    target.width = SMALL_WIDTH, target.height = SMALL_HEIGHT;
    target.usage = AUREOLE_USAGE_STORAGE | AUREOLE_USAGE_COPY_SOURCE;
    rig->targets.struct_size = sizeof rig->targets;
    rig->targets.width = SMALL_WIDTH, rig->targets.height = SMALL_HEIGHT;
    CHECK_OK(aureole_create_texture(rig->device, &target, &rig->targets.target));
    CHECK_OK(
        aureole_create_buffer(rig->device, "staging", sizeof(float) * SMALL_FLOATS, AUREOLE_USAGE_READ_BACK, &rig->staging));
}

static inline void close_small(struct small_rig* rig) {
    CHECK_OK(aureole_destroy_texture(rig->device, rig->targets.target, 0));
    CHECK_OK(aureole_destroy_buffer(rig->device, rig->staging, 0));
    CHECK_OK(aureole_destroy_device(rig->device));
}

static inline aureole_commands* begin_small(struct small_rig* rig) {
    aureole_commands* commands = NULL;
    CHECK_OK(aureole_begin(rig->device, NULL, &commands));
    CHECK_OK(aureole_barrier_texture(commands, rig->targets.target, AUREOLE_STATE_UNDEFINED, AUREOLE_STATE_STORAGE_WRITE));
    return commands;
}

static inline void end_small(struct small_rig* rig, aureole_commands* commands, float out[SMALL_FLOATS]) {
    const aureole_texture target = rig->targets.target;
    CHECK_OK(aureole_barrier_texture(commands, target, AUREOLE_STATE_STORAGE_WRITE, AUREOLE_STATE_COPY_SOURCE));
    CHECK_OK(aureole_barrier_buffer(commands, rig->staging, AUREOLE_STATE_UNDEFINED, AUREOLE_STATE_COPY_DESTINATION));
    CHECK_OK(aureole_copy_texture_to_buffer(commands, target, rig->staging));
    CHECK_OK(aureole_end(rig->device, NULL));
    CHECK_OK(aureole_wait(rig->device));
    CHECK_OK(aureole_read_buffer(rig->device, rig->staging, out, sizeof(float) * SMALL_FLOATS));
}

static inline aureole_camera small_camera(double altitude_m) {
    aureole_camera camera = {.struct_size = sizeof camera};
    CHECK_OK(aureole_look(6360e3, altitude_m, 0.3, 0.2, 1.2, 1.6, 0.1, &camera));
    return camera;
}

static inline aureole_sun small_sun(double elevation_deg) {
    const double elevation = elevation_deg * 3.14159265358979323846 / 180;
    aureole_sun sun = {.struct_size = sizeof sun};
    CHECK_OK(aureole_sun_defaults(&sun));
    sun.direction[0] = cos(elevation), sun.direction[1] = 0, sun.direction[2] = sin(elevation);
    return sun;
}

static inline double sum_of(const float texels[SMALL_FLOATS]) {
    double sum = 0;
    int i;
    for (i = 0; i < SMALL_FLOATS; ++i) sum += (i % 4 < 3) ? texels[i] : 0;
    return sum;
}

#endif
