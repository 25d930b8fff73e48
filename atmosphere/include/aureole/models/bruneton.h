// Precomputed atmospheric scattering, Bruneton & Neyret 2008 in the form of Bruneton 2017: light of any number of scatterings
// over (altitude, view zenith, sun zenith, angle between view and sun). Made once for an air; then each pixel takes a few
// look-ups for any camera and sun. See models/bruneton/bruneton.md.
#pragma once

#include <aureole/model.h>

namespace aureole::models {

/// How integrals are sampled.
enum class BrunetonSampling : std::uint8_t {
    gauss,  ///< Ours: Gauss-Legendre nodes along the sunlit part of a ray and over directions; peaks of phase functions cut off
            ///< at the Legendre degree that the directions resolve.
    published,  ///< The author's: 50 even steps a ray, 16 x 32 even directions, whole phase functions. Slower, less accurate.
};

/// A value out of range is Error(invalid_argument) from `bruneton`, naming field, value and range; a size or format that the
/// device lacks is Error(unsupported) from Atmosphere's constructor. Sizes and orders by default: the author's.
struct BrunetonSettings {
    rhi::Extent transmittance{256, 64, 1};  ///< Zenith x altitude nodes. Each in [2, 4096]; depth 1.
    rhi::Extent irradiance{64, 16, 1};  ///< Sun-zenith x altitude nodes of the sky's irradiance. Each in [2, 1024]; depth 1.
    int altitude_nodes = 32;            ///< R. In [2, 256].
    int view_nodes = 128;               ///< MU, one half each above and below the horizon. Even, in [4, 512].
    int sun_nodes = 32;                 ///< MU_S. In [2, 256].
    int nu_nodes = 8;  ///< NU, cosine of the angle between view and sun. In [2, 64]; times sun_nodes at most 2048.

    int orders = 4;  ///< Scatterings, in [1, 64]: 1 is single scattering alone, 4 within about 1 % of all by day.
    /// One texture instead of two or more: the red of the aerosol's single scattering in the fourth component, the rest of it
    /// extrapolated from the molecules' (Bruneton 2008, section 4). For air of molecules (RayleighPhase) and one other phase
    /// function, where the ratio of the vertical scattering depths of all to that of the molecules is the same for red, green
    /// and blue within a tenth (clear Earth); other air (haze, Mars), and sums of several wavelengths, get separate textures
    /// all the same, and a change from the one to the other is a change of the structure. Half the memory; errors near sunset.
    bool combined = false;
    rhi::Format format = rhi::Format::rgba16_float;  ///< Of the 4D tables: rgba16_ or rgba32_float.

    BrunetonSampling sampling = BrunetonSampling::gauss;  ///< How its integrals are summed.
    int transmittance_nodes = 10;                         ///< Gauss nodes of a ray to the top, in [2, 16]. Of both samplings.
    int ray_nodes = 8;      ///< Gauss nodes a piece of ray, in [2, 16]. Ignored by `published`, as the next two.
    int zenith_nodes = 6;   ///< Directions on each side of the horizon, in [2, 16].
    int azimuth_nodes = 8;  ///< Directions on a half circle, in [2, 16].

    /// The lowest sun that is told from lower ones, as a zenith angle in degrees, in [91, 120]. Air whose top sees a lower sun
    /// is given that one.
    double lowest_sun_deg = 102;

    /// Budget: altitude slices of a 4D table (of which a solution has altitude_nodes x (2 orders - 1)) computed by each
    /// Atmosphere::record, and each of the orders - 1 passes over the field of arriving light counts as one more, though it is
    /// recorded whole at any budget; 0: all at once. In [0, 1000000]. With a budget the tables in use stay complete, and what
    /// is shown changes when the new ones are: a second set is kept (table_bytes). Views have nothing to show before the first
    /// solution is complete (Atmosphere::progress). A change meanwhile waits until the solution in work is shown; other
    /// planet's radii are solved at once.
    int slices_per_frame = 0;

    [[nodiscard]] static BrunetonSettings low();       ///< 16 x 64 x 24 x 8 nodes, combined where the air allows.
    [[nodiscard]] static BrunetonSettings standard();  ///< "default": the author's sizes, in separate textures, our sampling.
    [[nodiscard]] static BrunetonSettings high();      ///< Twice the nodes of mu_s, eight orders.
    /// As fine as memory and patience allow (0.7 GB, half a minute or more): for measuring, not for use.
    [[nodiscard]] static BrunetonSettings converged();
    [[nodiscard]] static BrunetonSettings published();  ///< As the author's demonstration: combined, half, his sampling.
    /// "low", "default", "high", "converged" or "published"; anything else throws Error naming them.
    [[nodiscard]] static BrunetonSettings by_name(std::string_view name);
};

/// Throws Error(invalid_argument) at the first field outside its range.
void validate(const BrunetonSettings& settings);

/// Throws Error(invalid_argument) at the first setting outside its range.
[[nodiscard]] ModelPtr bruneton(const BrunetonSettings& settings = BrunetonSettings::standard());

}  // namespace aureole::models
