#include "common/host_air.h"

#include <cstring>
#include <span>

namespace aureole::detail {
namespace {

/// CPU kernels read four channels a texel.
std::vector<double> widen(const std::vector<double>& table) {
    std::vector<double> texels(4 * table.size(), 0.0);
    for (std::size_t i = 0; i < table.size(); ++i) texels[4 * i] = table[i];
    return texels;
}

rhi::CpuBinding table_binding(std::vector<double>& texels) {
    rhi::CpuBinding binding;
    binding.kind = rhi::SlotKind::sampled_texture;
    binding.format = rhi::Format::r32_float;
    binding.extent = {table_width, static_cast<std::uint32_t>(texels.size() / (4 * table_width)), 1};
    binding.texels = texels.data();
    return binding;
}

rhi::CpuBinding block_binding() {
    rhi::CpuBinding binding;
    binding.kind = rhi::SlotKind::constants;
    return binding;
}

std::uint32_t bits(int value) { return static_cast<std::uint32_t>(value); }

}  // namespace

HostAir::HostAir(const ExactAtmosphere& air)
    : phase_texels_(widen(air.phase_table)),
      profile_texels_(widen(air.profile_table)),
      bindings_{table_binding(phase_texels_), table_binding(profile_texels_), block_binding()},
      specialization_{{{0, bits(air.structure.term_count)},
                       {1, bits(air.structure.term_kinds)},
                       {2, bits(air.structure.term_phases)},
                       {3, bits(air.structure.phase_count)},
                       {4, bits(air.structure.phase_kinds)}}},
      arguments_{.specialization = specialization_, .bindings = bindings_, .push_constants = {}},
      formulas_(arguments_) {
    // Uniform blocks travel in float; here the exact numbers take their place.
    static_assert(sizeof(formulas_.atm) == sizeof(air.block));
    std::memcpy(static_cast<void*>(&formulas_.atm), &air.block, sizeof air.block);
}

}  // namespace aureole::detail
