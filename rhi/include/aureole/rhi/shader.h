// A shader as one object: SPIR-V, GLSL source and a CPU entry, so that a host with its own shader path takes what it needs.
#pragma once

#include <aureole/rhi/types.h>

#include <cstdint>
#include <span>
#include <string_view>

namespace aureole::rhi {

/// What stands in a slot.
enum class SlotKind : std::uint8_t { sampled_texture, storage_texture, constants };
[[nodiscard]] const char* to_string(SlotKind kind) noexcept;  ///< As written here.

/// One resource that a shader reads or writes: `layout(set = 0, binding = slot)` in GLSL.
struct SlotDesc {
    std::uint32_t slot = 0;                     ///< The binding.
    SlotKind kind = SlotKind::sampled_texture;  ///< What the shader does with it.
    Dimension dimension = Dimension::d2;        ///< Of textures. A cube's storage view has six layers (image2DArray).
    std::string_view name{};                    ///< As in the GLSL source; used in messages.
};

/// Value of a specialization constant: `layout(constant_id = id)`. Bits of an int32 (bools are 0 or 1) or of a float.
struct Specialization {
    std::uint32_t id = 0;    ///< The constant_id.
    std::uint32_t bits = 0;  ///< Its value.
};

/** What a specialization constant is. */ enum class ConstantKind : std::uint8_t { boolean, integer, real };

/// A specialization constant that a shader declares: `layout(constant_id = id)`.
struct ConstantDesc {
    std::uint32_t id = 0;                       ///< The constant_id.
    ConstantKind kind = ConstantKind::integer;  ///< What the bits of a Specialization stand for: bool, int32 or float.
    std::uint32_t default_bits = 0;             ///< Of pipelines made without a value for it.
    std::string_view name{};                    ///< As in the GLSL source.
};

/// A texture or uniform block as the CPU kernels see it. Texels are RGBA in the arithmetic type of the kernel (float or
/// double), row by row, slice by slice, already decoded; a cube has depth 6.
struct CpuBinding {
    SlotKind kind = SlotKind::sampled_texture;  ///< What stands in the slot.
    Format format = Format::undefined;          ///< Stores round to it (half really to half), unless `exact`.
    bool exact = false;                         ///< Keep every bit of the arithmetic type: the reference does not round.
    Extent extent{};                            ///< Texels.
    Filter filter = Filter::linear;             ///< The sampler's.
    Address address_u = Address::clamp, address_v = Address::clamp, address_w = Address::clamp;  ///< The sampler's.
    void* texels = nullptr;                                                                      ///< float* or double*.
    const std::byte* constants = nullptr;  ///< Uniform blocks hold 32-bit floats only.
    std::uint64_t constants_size = 0;      ///< Bytes.
};

/// What a range of invocations did. Exact, the same for every thread count, and free of any cost in SPIR-V.
struct CpuCounts {
    std::uint64_t evaluations = 0;  ///< COUNT(n) in the kernel: evaluations of the medium.
    std::uint64_t samples = 0;      ///< SAMPLE: filtered look-ups.
    std::uint64_t fetches = 0;      ///< texelFetch.
    std::uint64_t stores = 0;       ///< Texels written by imageStore and by fragment kernels.
    std::uint64_t bytes = 0;        ///< Their size in the textures' formats.

    constexpr CpuCounts& operator+=(const CpuCounts& other) noexcept {  ///< Sums.
        evaluations += other.evaluations, samples += other.samples, fetches += other.fetches;
        stores += other.stores, bytes += other.bytes;
        return *this;
    }
};

/// Everything a CPU kernel needs beside its invocation number.
struct CpuArguments {
    std::span<const Specialization> specialization{};  ///< Constants not named here have their defaults.
    std::span<const CpuBinding> bindings{};            ///< Indexed by slot.
    std::span<const std::byte> push_constants{};       ///< The shader's push_constant_bytes.
    CpuCounts* counts = nullptr;                       ///< Null: nothing is counted. Used by one thread at a time.
};

/// Half-open box of invocations (compute) or pixels (fragment).
struct CpuRange {
    std::uint32_t begin[3] = {0, 0, 0};  ///< First of x, y and z.
    std::uint32_t end[3] = {0, 0, 0};    ///< One beyond the last.
};

/// Runs a range of invocations in the calling thread. Ranges of one dispatch are disjoint and may run at the same time.
/// `target` is the colour target of a fragment kernel, null for compute.
using CpuRun = void (*)(const CpuArguments& arguments, const CpuRange& range, const CpuBinding* target);

/// A kernel on the CPU, in float and in double.
struct CpuEntry {
    CpuRun run_float = nullptr;   ///< In 32-bit arithmetic, as a GPU does it.
    CpuRun run_double = nullptr;  ///< In 64-bit arithmetic: the reference.
};

/// What a shader runs as.
enum class Stage : std::uint8_t {
    compute,
    fragment,  ///< Drawn as a triangle that covers the target.
};

/// All members refer to static storage: a shader object lives as long as the program.
struct Shader {
    std::string_view name{};                    ///< Of the kernel, as its file is named.
    Stage stage = Stage::compute;               ///< How it is run.
    std::uint32_t local_size[3] = {1, 1, 1};    ///< Invocations of a workgroup. Of compute.
    std::uint32_t push_constant_bytes = 0;      ///< At most 128.
    std::span<const SlotDesc> slots{};          ///< Every resource that it reads or writes, by rising slot.
    std::span<const std::uint32_t> spirv{};     ///< SPIR-V 1.3, entry "main", validated at build time.
    std::string_view glsl{};                    ///< One self-contained source, `#version 450`. Without sets: plain_glsl.h.
    CpuEntry cpu;                               ///< The same kernel on the CPU.
    std::span<const ConstantDesc> constants{};  ///< Every specialization constant of the source, by rising id.
};

}  // namespace aureole::rhi
