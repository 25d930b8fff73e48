// How slowly the orders of scattering fade in a given air.
#pragma once

#include <aureole/parameters.h>

namespace aureole::detail {

/// About the share of one order of scattering that is scattered once more, in the channel where it is greatest; in [0, 1].
///
/// Of light that sets out evenly in a flat layer of optical depth t, (1 - 2 E_3(t)) / (2 t) leaves it unscattered, half of that
/// downwards, where the ground returns its albedo and 1 - 2 E_3(t) of this is caught again. Of what is caught, the layer's
/// single-scattering albedo goes on. Clear air: 0.35; a layer of dust of depth 2: 0.7; a cloud that absorbs nothing: 1.
/// `ground_light` false (QualitySettings): as over black ground.
[[nodiscard]] double order_ratio(const AtmosphereParameters& parameters, bool ground_light = true);

/// Above this ratio later orders take as many nodes a ray as the first (QualitySettings::multi_scatter_later_nodes).
inline constexpr double slow_order_ratio = 0.7;

/// Passes that leave as small a share of the orders to extrapolation as `orders` passes do in air of ratio 0.4; at least
/// `orders`, at most 64.
[[nodiscard]] int passes_for(double ratio, int orders);

/// A bound for the ratio of successive orders at single nodes, for extrapolation. Where little light has come in the first
/// orders they may still grow (in a planet's shadow, under a cloud), which must not be taken for their way to infinity.
[[nodiscard]] double greatest_ratio(double ratio);

}  // namespace aureole::detail
