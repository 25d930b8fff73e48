#ifndef AUREOLE_TESTS_C_API_BORROWED_H
#define AUREOLE_TESTS_C_API_BORROWED_H

#include "c_api/picture.h"

/* The picture on a VkDevice that this program has made itself. */
void picture_on_borrowed_vulkan(struct picture* out);

#endif
