// The technique of Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique" (EGSR 2020): a march in
// steps, isotropic multiple scattering of all orders as a geometric series, sky-view table and froxels. See
// models/hillaire/hillaire.md.
#pragma once

#include <aureole/model.h>

#include <string>

namespace aureole::models {

/// A value out of range is Error(invalid_argument) naming the field; a size that the device cannot hold is Error(unsupported)
/// from the constructor of Atmosphere or View. Defaults are as published, with sky and aerial perspective by their tables.
struct HillaireSettings {
    rhi::Extent transmittance{256, 64, 1};  ///< View-zenith x altitude texels. Each in [2, 4096]; depth of 2D tables is 1.
    int transmittance_steps = 40;           ///< Even steps to the top of the air, in [1, 4096].

    rhi::Extent multi_scatter{32, 32, 1};  ///< Sun-cosine x altitude texels. Each in [2, 256]; width x height at most half of
                                           ///< what the device takes as a 2D texture's side.
    int multi_scatter_steps = 20;          ///< Even steps on each of the 64 rays of a texel, in [1, 4096].

    bool fast_sky = true;               ///< The sky from the sky-view table; false: a march for each pixel.
    rhi::Extent sky_view{200, 100, 1};  ///< Azimuth x elevation texels. Each in [4, 4096]; elevations even: half of them below
                                        ///< the horizon, half above. The light table (ViewSettings::light) needs it too.
    int sky_view_steps = 30;            ///< Steps for each texel, growing with distance, in [1, 4096].

    bool fast_aerial_perspective = true;         ///< Aerial perspective from the froxels; false: a march for each pixel.
    rhi::Extent aerial_perspective{32, 32, 32};  ///< Screen x screen x slices, each froxel with a march of two steps a slice.
                                                 ///< Each in [2, 256].
    bool grey_transmittance = true;  ///< Aerial perspective dims all colours by the mean of their transmittances, as published
                                     ///< (one number in alpha); false: each colour by its own.

    int march_steps = 30;  ///< Steps of a march for a pixel, growing with distance, in [1, 4096]. Ignored where both are fast.

    rhi::Format table_format = rhi::Format::rgba16_float;   ///< 2D tables: rgba16_ or rgba32_float.
    rhi::Format froxel_format = rhi::Format::rgba16_float;  ///< Froxels: the same choice.

    /// For phones, section 7 of the paper: sky-view 96x50 with 8 steps, froxels 32x32x16.
    [[nodiscard]] static HillaireSettings low();
    [[nodiscard]] static HillaireSettings standard();  ///< "default": the published one.
    /// Sky and aerial perspective marched for each pixel, 30 steps, each colour dimmed by its own transmittance.
    [[nodiscard]] static HillaireSettings high();
    /// So fine that more makes no difference that matters: what remains is the model's own error. For measuring, not for use.
    [[nodiscard]] static HillaireSettings converged();
    /// One of quality_names(), or "converged"; anything else is Error(invalid_argument).
    [[nodiscard]] static HillaireSettings by_name(std::string_view name);
};

/// Throws Error(invalid_argument) at the first field outside its range.
void validate(const HillaireSettings& settings);

/// Throws as validate() does.
[[nodiscard]] ModelPtr hillaire(const HillaireSettings& settings = HillaireSettings::standard());

}  // namespace aureole::models
