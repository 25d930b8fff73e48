/* The same picture by the C API and by the C++ API, to be compared bit for bit. */
#ifndef AUREOLE_TESTS_C_API_PICTURE_H
#define AUREOLE_TESTS_C_API_PICTURE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { PICTURE_WIDTH = 37, PICTURE_HEIGHT = 23, PICTURE_FLOATS = 4 * PICTURE_WIDTH * PICTURE_HEIGHT, LIGHT_FLOATS = 80 };

/* What a device makes of the scene: earth with more haze, two suns, from 1500 m. */
struct picture {
    float texels[PICTURE_FLOATS];
    float light[LIGHT_FLOATS];
    double sun_irradiance[3], sky_irradiance[3], sky_coefficient[3]; /* Of the second sun; upwards; 3 of the first sun. */
    double vertical_depth[3];
    char setting[64];
    char plan_text[20000];
};

/* By the C++ API. 0: done; 1: it failed and said why on stderr; 2: there is no such device. */
int picture_by_cpp_on_cpu(struct picture* out);
int picture_by_cpp_on_vulkan(struct picture* out);

#ifdef __cplusplus
}
#endif

#endif
