// volk under names of its own. volk defines global pointers called like Vulkan's functions; in a program that also links
// libvulkan, or volk itself, they would take the place of the host's. volk_names.h (generated from volk.h while configuring)
// renames every one of them for the sources of this backend.
#pragma once

#include "volk_names.h"

#include <volk.h>
