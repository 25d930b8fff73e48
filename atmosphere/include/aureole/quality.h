// How finely the tables are made: the knobs that trade speed for accuracy, and four named settings.
#pragma once

#include <aureole/rhi/types.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace aureole {

/// Which sampling the kernels use.
enum class Sampling : std::uint8_t {
    gauss,           ///< Ours: Gauss-Legendre nodes on the sunlit part of each ray (docs/quadrature.md).
    published_2020,  ///< Hillaire, EGSR 2020: uniform steps, mean-only multiple scattering; for comparison.
};

/// A value out of range is Error(invalid_argument) from `validate` and from Atmosphere's constructor; a size that the device
/// cannot hold is Error(unsupported) from the constructor of Atmosphere or View. What each knob does: quality.md.
struct QualitySettings {
    std::string name = "default";  ///< For messages and reports; anything.
    Sampling sampling = Sampling::gauss;

    rhi::Extent transmittance{128, 32, 1};  ///< Sun-zenith x altitude nodes. Each in [2, 4096]; depth of 2D tables is 1.
    int transmittance_nodes = 8;            ///< Gauss nodes a ray (uniform steps in published_2020), in [2, 16] ([1, 256]).

    rhi::Extent multi_scatter{24, 12, 1};  ///< Sun-cosine x altitude nodes. Each in [2, 256].
    int angular_order = 2;                 ///< L of the moments: 0 (mean alone), 2, 4 or 8; (L+1)(L+2)/2 layers. In
                                           ///< published_2020 0.
    bool angular_order_as_needed = false;  ///< Take a lower order for air that makes no use of more (angular_order.h), and
                                           ///< more directions where the order is high: set_parameters may then make pipelines.
    int multi_scatter_zenith = 4;          ///< Gauss directions on each side of the horizon, in [2, 16]. Ignored by
                                           ///< published_2020, as the next: 8 x 8 over the sphere.
    int multi_scatter_azimuth = 4;         ///< Directions on a half circle, in [2, 32].
    int multi_scatter_nodes = 8;           ///< Gauss nodes a ray (uniform steps in published_2020), in [2, 16] ([1, 256]).
    int multi_scatter_orders = 3;          ///< Passes of the fixed point before the rest is extrapolated from the last two, in
                                           ///< [2, 64]. Air in which orders fade more slowly than in a clear sky gets more, up
                                           ///< to 64. Ignored by published_2020 ([1, 64]), which sums them all from the first.

    rhi::Extent sky_view{40, 192, 1};  ///< Azimuth x elevation nodes. Each in [4, 4096]; elevations even: half of them below
                                       ///< the horizon, half above.
    int sky_view_nodes = 10;           ///< Gauss nodes a ray segment (uniform steps in published_2020), in [2, 16] ([1, 256]).

    rhi::Extent aerial_perspective{32, 32, 32};  ///< Screen x screen x slices. Each in [2, 256].
    int aerial_perspective_nodes = 1;            ///< Slabs of constant air a slice, in [1, 8].

    /// Transmittance and sky-view: rgba16_ or rgba32_float. (Moments are rgba32_float, or half where a device cannot filter
    /// that.)
    rhi::Format table_format = rhi::Format::rgba32_float;
    rhi::Format froxel_format = rhi::Format::rgba16_float;  ///< Aerial perspective: rgba16_ or rgba32_float.

    [[nodiscard]] static QualitySettings low();
    [[nodiscard]] static QualitySettings standard();  ///< "default"
    [[nodiscard]] static QualitySettings high();
    /// Transmittance 256x64 with 40 steps; multi-scatter 32x32, 64 directions x 20 steps; sky-view 200x100 with 30 uniform
    /// steps; froxels 32^3, each marched from the camera. Hillaire, EGSR 2020.
    [[nodiscard]] static QualitySettings published_2020();
    /// "low", "default", "high" or "published-2020"; anything else throws Error naming the four.
    [[nodiscard]] static QualitySettings by_name(std::string_view name);
};

/// Throws Error(invalid_argument) at the first field outside its range.
void validate(const QualitySettings& settings);

}  // namespace aureole
