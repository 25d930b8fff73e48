// A Vulkan loader that lies on request: functions can be missing or replaced, so that tests see what happens on devices that
// fail, lack something, or run out of memory. One for the program; tests run one after the other.
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>

namespace aureole::vulkan::test {

/// The loader. Tells the truth until told otherwise.
[[nodiscard]] PFN_vkGetInstanceProcAddr lying_loader();

/// Lies last as long as this object.
class Lies {
public:
    Lies() = default;
    ~Lies();
    Lies(const Lies&) = delete;
    Lies& operator=(const Lies&) = delete;
    /// `name` is `replacement` from the next look-up on; null: it is not there.
    void tell(const std::string& name, PFN_vkVoidFunction replacement);
    template <class Function>
    void tell(const std::string& name, Function* replacement) {
        tell(name, reinterpret_cast<PFN_vkVoidFunction>(replacement));
    }
};

/// The real function, as it was looked up last.
[[nodiscard]] PFN_vkVoidFunction truth(const std::string& name);
template <class Function>
[[nodiscard]] Function truth_of(const char* name) {
    return reinterpret_cast<Function>(truth(name));
}

}  // namespace aureole::vulkan::test
