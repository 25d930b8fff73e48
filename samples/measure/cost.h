// What a model costs in an air: milliseconds on a device, and counts that are the same on all.
#pragma once

#include "app/pass_costs.h"
#include "plan/measured.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace aureole::app {

struct CostOptions {
    std::uint32_t width = detail::measured_width, height = detail::measured_height;  ///< Of the composite, pixels.
    std::uint32_t rounds = 20;                                                       ///< Measured, at least 1.
    std::uint32_t warm_up = 2;                    ///< Rounds before them that are thrown away.
    bool features = false;                        ///< As PassCostOptions has it.
    std::vector<std::vector<CostRound>> known{};  ///< As PassCostOptions has them.
    std::function<void(std::size_t subject, const CostRound&)> after_measured{};
    std::vector<CostCounts> known_counts{};
    std::function<void(const CostCounts&)> after_counted{};
};

struct Cost {
    Spread per_frame_ms;           ///< Of a frame that moves camera or sun: tables of the camera, and the composite of sky.
    Spread rebuild_ms;             ///< Tables of the air and of the camera.
    Spread composite_ms;           ///< Sky alone, without geometry: a part of per_frame_ms.
    Spread composite_geometry_ms;  ///< The same over a host's colour and depth; no part of it.
    Spread aerial_perspective_ms;  ///< Froxels: a part of per_frame_ms; 0 of models that keep none.
    Spread light_ms;               ///< Light for a host's materials: a part of per_frame_ms.
    // No parts of it, of CostOptions::features:
    Spread composite_two_suns_ms;  ///< Sky alone under two suns.
    Spread composite_bare_ms;      ///< As composite_geometry_ms, without the air before geometry.
    Spread shadows_ms;             ///< The pass that finds shadows in the air; 0 of models that have none.
    Spread composite_shadows_ms;   ///< As composite_geometry_ms, with those shadows; 0 likewise.
    /// Work of those passes; `bytes` is what they write. The composite's is counted with an eighth of the pixels each way, and
    /// multiplied (exact where width and height are multiples of eight, and every pixel costs the same).
    rhi::CpuCounts per_frame;
    rhi::CpuCounts rebuild;                                     ///< Likewise.
    std::uint64_t table_bytes = 0;                              ///< Device memory of the tables of the air and of one view.
    std::uint64_t air_bytes = 0, aerial_perspective_bytes = 0;  ///< Parts of it.
    std::uint64_t shadow_bytes = 0;                             ///< What shadows add to it.
};

/// Of each subject, measured in turn (pass_costs); counted on the CPU backend. `after_round` is called after each round.
/// Throws Error(invalid_argument) for rounds of 0, (unsupported) if the device has no clock; an error of a subject names its
/// label.
[[nodiscard]] std::vector<Cost> costs(Backend& backend, std::span<const CostSubject> subjects, const CostOptions& options,
                                      const std::function<void()>& after_round = {});

}  // namespace aureole::app
