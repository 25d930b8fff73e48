/* The C API from plain C11: pictures bit for bit as the C++ API makes them, and what bad input gets. */
#include <stdlib.h>
#include <string.h>

#include "c_api/check.h"
#include "c_api/errors.h"
#include "c_api/picture_by_c.h"
#include "c_api/small_pictures.h"
#ifdef C_API_TEST_OPENS_VULKAN
#include "c_api/borrowed.h"
#endif

int failures = 0;

static void check_same(const char* device, const struct picture* c, const struct picture* cpp) {
    int i;
    double sum = 0;
    printf("%s: %s\n", device, c->setting);
    for (i = 0; i < PICTURE_FLOATS; ++i) sum += c->texels[i];
    CHECK(sum > 0);
    CHECK(memcmp(c->texels, cpp->texels, sizeof c->texels) == 0);
    CHECK(memcmp(c->light, cpp->light, sizeof c->light) == 0);
    CHECK(memcmp(c->sun_irradiance, cpp->sun_irradiance, sizeof c->sun_irradiance) == 0);
    CHECK(memcmp(c->sky_irradiance, cpp->sky_irradiance, sizeof c->sky_irradiance) == 0);
    CHECK(memcmp(c->sky_coefficient, cpp->sky_coefficient, sizeof c->sky_coefficient) == 0);
    CHECK(memcmp(c->vertical_depth, cpp->vertical_depth, sizeof c->vertical_depth) == 0);
    CHECK(strcmp(c->setting, cpp->setting) == 0);
    CHECK(strcmp(c->plan_text, cpp->plan_text) == 0 && strlen(c->plan_text) > 100);
}

static void check_cpu(void) {
    struct picture *c = calloc(1, sizeof *c), *cpp = calloc(1, sizeof *cpp);
    aureole_cpu_device_desc desc = {.struct_size = sizeof desc};
    aureole_capabilities capabilities = {.struct_size = sizeof capabilities};
    aureole_device* device = NULL;
    CHECK_OK(aureole_cpu_device_desc_defaults(&desc));
    CHECK_OK(aureole_create_cpu_device(&desc, &device));
    CHECK_OK(aureole_get_capabilities(device, &capabilities));
    CHECK(strcmp(capabilities.backend, "cpu") == 0 && capabilities.raster == 1);
    picture_by_c(device, &own_queue, c);
    CHECK_OK(aureole_destroy_device(device));
    CHECK(picture_by_cpp_on_cpu(cpp) == 0);
    check_same("CPU", c, cpp);
    free(c);
    free(cpp);
}

static void say(void* user, aureole_severity severity, const char* text) {
    (void)user;
    if (severity == AUREOLE_INFO) return;
    printf("the device says: %s\n", text);
    ++failures;
}

static void check_vulkan(void) {
    struct picture *c = calloc(1, sizeof *c), *cpp = calloc(1, sizeof *cpp);
    aureole_vulkan_device_desc desc = {.struct_size = sizeof desc};
    aureole_device* device = NULL;
    const int opened = picture_by_cpp_on_vulkan(cpp);
    CHECK_OK(aureole_vulkan_device_desc_defaults(&desc));
    if (opened == 2) {
#ifdef C_API_TEST_OPENS_VULKAN
        printf("skipped: no usable Vulkan device.\n");
#endif
    } else {
        CHECK(opened == 0);
        desc.message_callback = say;
        CHECK_OK(aureole_create_vulkan_device(&desc, &device));
        picture_by_c(device, &own_queue, c);
        CHECK_OK(aureole_destroy_device(device));
        check_same("Vulkan", c, cpp);
#ifdef C_API_TEST_OPENS_VULKAN
        memset(c, 0, sizeof *c);
        picture_on_borrowed_vulkan(c, 0);
        check_same("Vulkan, borrowed", c, cpp);
        memset(c, 0, sizeof *c);
        picture_on_borrowed_vulkan(c, 1);
        check_same("Vulkan, borrowed, on the second family", c, cpp);
#endif
    }
    free(c);
    free(cpp);
}

int main(void) {
    check_errors();
    check_cpu();
    check_numbers();
    check_planned_sky();
    check_vulkan();
    if (failures == 0)
        printf("SUCCESS!\n");
    else
        printf("%d checks failed\n", failures);
    return failures == 0 ? 0 : 1;
}
