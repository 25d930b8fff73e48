// The names of the Vulkan functions that the backend calls, from its own lists.
#pragma once

#include <string>
#include <vector>

namespace aureole::vulkan::test {

/// On a host's device with VK_EXT_debug_utils.
[[nodiscard]] std::vector<std::string> functions_of_guests();
/// Only on instances and devices of its own.
[[nodiscard]] std::vector<std::string> functions_of_owners();

}  // namespace aureole::vulkan::test
