#ifndef AUREOLE_TESTS_C_API_PICTURE_BY_C_H
#define AUREOLE_TESTS_C_API_PICTURE_BY_C_H

#include <aureole.h>

#include "c_api/picture.h"

/* Begins a list of the device, ends it and sees that it has run. */
struct runner {
    aureole_commands* (*begin)(void* user, aureole_device* device);
    void (*run)(void* user, aureole_device* device);
    void* user;
};
/* Of a device with a queue of its own. */
extern const struct runner own_queue;

/* Renders the scene by the C API; failures are told by check.h. */
void picture_by_c(aureole_device* device, const struct runner* runner, struct picture* out);

#endif
