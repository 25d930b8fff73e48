// Single scattering, marched for each pixel with a nested march towards the sun (Nishita, Sirai, Tadamura & Nakamae, "Display
// of the Earth Taking into Account Atmospheric Scattering", SIGGRAPH 1993). No table, but for the dome if it is asked for. Its
// equations and when they fail: models/single/single.md.
#pragma once

#include <aureole/model.h>

namespace aureole::models {

/// How a ray is sampled.
enum class Steps : std::uint8_t {
    gauss,      ///< Ours: Gauss-Legendre nodes on each smooth piece of the ray (docs/quadrature.md).
    midpoints,  ///< Uniform steps, each as its middle: the papers'.
};

/// The cheap variant: the sky is marched at the vertices of a dome around the camera, and a pixel interpolates between four of
/// them. Geometry is still marched pixel by pixel.
struct Dome {
    /// Azimuth x elevation: over half a turn from the sun, and from nadir to zenith, half of the rows below the horizon and
    /// dense there. Both 0: no dome. Else width in [4, 4096], height even in [4, 4096]; depth is 1.
    rhi::Extent size{0, 0, 1};
    /// Where the phase functions of aerosols are applied.
    enum class Phase : std::uint8_t {
        at_look_up,  ///< At the pixel: the sun's aureole stays sharp. A layer of the table for each.
        in_table,    ///< At the vertex, as the first domes did: the aureole is as coarse as the dome.
    };
    Phase phase = Phase::at_look_up;                                                        ///< Where it is applied.
    rhi::Format format = rhi::Format::rgba32_float;                                         ///< rgba16_float or rgba32_float.
    [[nodiscard]] bool used() const noexcept { return size.width > 0 || size.height > 0; }  ///< Whether there is a dome.
};

/// A value out of range is Error(invalid_argument) from `validate` and `single`; a dome that the device cannot hold is
/// Error(unsupported) from the constructor of Atmosphere or View.
struct SingleSettings {
    Steps steps = Steps::gauss;  ///< Where its nodes are.
    int view_steps =
        8;  ///< Gauss nodes a smooth piece of the view ray, in [2, 16]; or uniform steps of all of it, in [1, 256].
    int light_steps = 6;  ///< The same for the ray to the sun.
    Dome dome;            ///< A table of the sky, if any.

    /// "low": a dome of 24 x 64 vertices, 6 and 5 nodes. "default": each pixel, 8 and 6 nodes. "high": each pixel, 12 and 10
    /// nodes. "converged": 16 and 16. Anything else: Error(invalid_argument).
    [[nodiscard]] static SingleSettings by_name(std::string_view quality);
};

/// Throws Error(invalid_argument) at the first field outside its range.
void validate(const SingleSettings& settings);

[[nodiscard]] ModelPtr single(const SingleSettings& settings = {});  ///< Throws Error naming a setting out of range.

}  // namespace aureole::models
