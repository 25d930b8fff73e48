// Apart from the other tests: functions.h gives Vulkan's functions private names.
#include "test_function_names.h"

#include "functions.h"

namespace aureole::vulkan::test {

#define AUREOLE_NAME(name) #name,

std::vector<std::string> functions_of_guests() {
    return {AUREOLE_INSTANCE_FUNCTIONS(AUREOLE_NAME) AUREOLE_DEBUG_FUNCTIONS(AUREOLE_NAME)
                AUREOLE_DEVICE_FUNCTIONS(AUREOLE_NAME)};
}

std::vector<std::string> functions_of_owners() {
    return {AUREOLE_OWN_INSTANCE_FUNCTIONS(AUREOLE_NAME) AUREOLE_OWN_DEVICE_FUNCTIONS(AUREOLE_NAME)};
}

#undef AUREOLE_NAME

}  // namespace aureole::vulkan::test
