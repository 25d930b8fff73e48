// The kernels' count of moments, for the host.
#pragma once

#include <cstdint>

namespace aureole::detail {

struct Moments {
#include "multi_scatter/moments.glsl"
};
#undef AUREOLE_MOMENTS_GLSL  // kernels included after this header define theirs

/// Layers of the multi-scatter table; `angular_order`: 0 to 8.
[[nodiscard]] inline std::uint32_t moment_count(int angular_order) {
    return static_cast<std::uint32_t>(Moments().moments_up_to(angular_order));
}

}  // namespace aureole::detail
