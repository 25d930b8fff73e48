/* Small pictures by the C API and by the C++ API, to be compared bit for bit: of models by number, and of a sky that follows
 * its plan. All on the CPU device. */
#ifndef AUREOLE_TESTS_C_API_SMALL_PICTURES_H
#define AUREOLE_TESTS_C_API_SMALL_PICTURES_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { SMALL_WIDTH = 8, SMALL_HEIGHT = 5, SMALL_FLOATS = 4 * SMALL_WIDTH * SMALL_HEIGHT };
enum {
    SMALL_FOG,
    SMALL_SINGLE,
    SMALL_SINGLE_LUT,
    SMALL_HILLAIRE,
    SMALL_AUREOLE,
    SMALL_BRUNETON,
    SMALL_REFERENCE,
    SMALL_MODELS
};

/* Earth at 1500 m with a sun at 20 degrees, by a model whose settings differ from its quality's. 0: done; 1: it failed and said
 * why on stderr. */
int small_picture_by_cpp(int model, float out[SMALL_FLOATS]);

/* Frames of a planned sky in which the sun is at 50 degrees, then at 1. */
enum { PLANNED_FRAMES = 6 };
struct planned_frame {
    float texels[SMALL_FLOATS];
    double share, light_share;
    uint64_t table_bytes;
    uint32_t planned, change_count, fading_light;
    char changes[4000]; /* What, before, after and reason of each. */
    char setting[100];
};
int planned_frames_by_cpp(struct planned_frame out[PLANNED_FRAMES]);

/* The same by the C API, compared; and what bad input gets. */
void check_numbers(void);
void check_planned_sky(void);

#ifdef __cplusplus
}
#endif

#endif
