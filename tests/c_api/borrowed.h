#ifndef AUREOLE_TESTS_C_API_BORROWED_H
#define AUREOLE_TESTS_C_API_BORROWED_H

#include "c_api/picture.h"

/* The picture on a VkDevice that this program has made itself; if so, by recordings for a second family of queues. */
void picture_on_borrowed_vulkan(struct picture* out, int on_second_family);

#endif
