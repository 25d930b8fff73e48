// The uniform blocks as the host fills them. One definition for host, kernels and shaders: common/blocks.glsl.
//
// The host computes them in double and rounds once, at the end.
#pragma once

#include <aureole/rhi/kernel/cpu_kernel.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace aureole::detail {

template <class real>
struct Blocks {
    AUREOLE_KERNEL_TYPES
#include "common/blocks.glsl"
};
#undef AUREOLE_BLOCKS_GLSL  // kernels included after this header define theirs

using AtmosphereBlock = Blocks<float>::AtmosphereBlock;
using QuadratureBlock = Blocks<float>::QuadratureBlock;
using ViewBlock = Blocks<float>::ViewBlock;
using ShadowBlock = Blocks<float>::ShadowBlock;
using TripletBlock = Blocks<float>::TripletBlock;

inline constexpr int max_suns = Blocks<float>::MAX_SUNS;
inline constexpr int max_nodes = Blocks<float>::MAX_NODES;
static_assert(Blocks<float>::MAX_PHASES == 4, "the limit stated in parameters.h");

/// A block in double, rounded to what the device gets.
template <class Float, class Double>
[[nodiscard]] Float round_block(const Double& block) {
    static_assert(std::is_trivially_copyable_v<Float> && std::is_trivially_copyable_v<Double>);
    static_assert(sizeof(Double) == 2 * sizeof(Float) && sizeof(Float) % sizeof(float) == 0);
    constexpr std::size_t count = sizeof(Float) / sizeof(float);
    double exact[count];
    float rounded[count];
    std::memcpy(exact, &block, sizeof exact);
    for (std::size_t i = 0; i < count; ++i) rounded[i] = static_cast<float>(exact[i]);
    Float result;
    std::memcpy(static_cast<void*>(&result), rounded, sizeof rounded);
    return result;
}

}  // namespace aureole::detail
