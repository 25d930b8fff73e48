// From parameters to what the kernels read: uniform block, specialization, tables.
#pragma once

#include "common/host_blocks.h"

#include <aureole/parameters.h>

#include <vector>

namespace aureole::detail {

/// Texels of one row of the profile and phase tables.
inline constexpr int table_width = 4096;

/// The structure of the air: values of the constants in common/specialization.glsl.
struct AirStructure {
    int term_count = 0, term_kinds = 0, term_phases = 0, phase_count = 1, phase_kinds = 0;
    unsigned sharp_phases = 0;  ///< Bit c: phase function c is not Rayleigh's, so it may peak.
    [[nodiscard]] bool operator==(const AirStructure&) const noexcept = default;
};

/// The air in double precision, without Legendre moments: what the host's own formulas work with.
struct ExactAtmosphere {
    Blocks<double>::AtmosphereBlock block{};
    AirStructure structure;
    std::vector<double> profile_table, phase_table;  ///< table_width texels a row; empty without tabulated terms.
    std::vector<PhaseFunction> phases;               ///< By phase index; Rayleigh, if present, is 0.
};
/// Terms are those of `merged_terms` (medium/merge.h); equal phase functions become one. `parameters` must be valid.
[[nodiscard]] ExactAtmosphere pack_exact(const AtmosphereParameters& parameters);
/// Air without terms whose only phase function is this one.
[[nodiscard]] ExactAtmosphere pack_exact(const PhaseFunction& phase);

/// What goes to the device.
struct PackedAtmosphere : AirStructure {
    AtmosphereBlock block{};           ///< All but sun_mapping, which belongs to the multi-scatter pass.
    std::vector<float> profile_table;  ///< Texels for r32_float, table_width x profile_rows.
    std::vector<float> phase_table;    ///< Texels for r32_float, table_width x phase_rows.
    int profile_rows = 0, phase_rows = 0;
};
/// Validates, then packs.
[[nodiscard]] PackedAtmosphere pack_atmosphere(const AtmosphereParameters& parameters);

}  // namespace aureole::detail
