// How finely the tables are made: the knobs that trade speed for accuracy, and three named settings.
#pragma once

#include <aureole/rhi/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace aureole {

/// Settings of the model `aureole`. A value out of range is Error(invalid_argument) from `validate` and from Atmosphere's
/// constructor; a size that the device cannot hold is Error(unsupported) from the constructor of Atmosphere or View. What each
/// knob does: quality.md.
struct QualitySettings {
    std::string name = "default";  ///< For messages and reports; anything.

    rhi::Extent transmittance{128, 32, 1};  ///< Sun-zenith x altitude nodes. Each in [2, 4096]; depth of 2D tables is 1.
    int transmittance_nodes = 8;            ///< Gauss nodes a ray, in [2, 16].

    rhi::Extent multi_scatter{24, 12, 1};  ///< Sun-cosine x altitude nodes. Each in [2, 256].
    int angular_order = 4;                 ///< L of the moments: 0 (mean alone), 2, 4, 6 or 8; (L+1)(L+2)/2 layers.
    bool angular_order_as_needed = true;   ///< Take a lower order for air that makes no use of more (angular_order.h), and
                                           ///< more directions where the order is high (at least
                                           ///< angular_order + 2 of each): set_parameters may then make pipelines.
    int multi_scatter_zenith = 5;          ///< Gauss directions on each side of the horizon, in [2, 16].
    int multi_scatter_azimuth = 4;         ///< Directions on a half circle, in [2, 32].
    int multi_scatter_nodes = 8;           ///< Gauss nodes a ray for light scattered once, in [2, 16].
    int multi_scatter_later_nodes = 5;     ///< Gauss nodes a ray for all later orders, whose field is smooth, in [2, 16]. In
                                           ///< thick air (order_ratio.h: above 0.7) at least as many as for the first.
    int multi_scatter_orders = 3;          ///< Passes of the fixed point before the rest is extrapolated from the last two, in
                                           ///< [2, 64]. Air in which orders fade more slowly than in a clear sky gets more, up
                                           ///< to 64. Or 0: single scattering alone. Then there is no table of moments, and
                                           ///< the ground is lit by the sun alone.
    bool ground_light = true;              ///< What the ground reflects lights the air. False: it does not, and the ground
                                           ///< itself looks as it does, lit by the sun and by the sky over black ground.

    rhi::Extent sky_view{40, 192, 1};  ///< Azimuth x elevation nodes. Each in [4, 4096]; elevations even: half of them below
                                       ///< the horizon, half above.
    int sky_view_nodes = 10;           ///< Gauss nodes a ray segment, in [2, 16].

    rhi::Extent aerial_perspective{32, 32, 32};  ///< Screen x screen x slices. Each in [2, 256].
    int aerial_perspective_nodes = 1;            ///< Slabs of constant air a slice, in [1, 8].

    /// Transmittance and sky-view: rgba16_ or rgba32_float. (Moments are rgba32_float, or half where a device cannot filter
    /// that.)
    rhi::Format table_format = rhi::Format::rgba32_float;
    rhi::Format froxel_format = rhi::Format::rgba16_float;  ///< Aerial perspective: rgba16_ or rgba32_float.

    [[nodiscard]] static QualitySettings low();       ///< "low"
    [[nodiscard]] static QualitySettings standard();  ///< "default"
    [[nodiscard]] static QualitySettings high();      ///< "high"
    /// So fine that more makes no difference that matters: what remains is the model's own error. For measuring, not for use.
    [[nodiscard]] static QualitySettings converged();
    /// One of quality_names(), or "converged"; anything else throws Error naming them.
    [[nodiscard]] static QualitySettings by_name(std::string_view name);

    [[nodiscard]] bool operator==(const QualitySettings&) const = default;
};

/// Every model comes in these: "low", "default", "high". For measuring there is "converged", too, which is in no list.
[[nodiscard]] std::span<const std::string_view> quality_names();

/// Throws Error(invalid_argument) at the first field outside its range.
void validate(const QualitySettings& settings);

}  // namespace aureole
