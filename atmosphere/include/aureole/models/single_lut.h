// Single scattering as in models/single.h, with the nested march replaced by a look-up in a table of optical depth over
// altitude and sun zenith (O'Neal, "Accurate Atmospheric Scattering", GPU Gems 2, 2005). Its equations and when they fail:
// models/single_lut/single_lut.md.
#pragma once

#include <aureole/models/single.h>

namespace aureole::models {

/// A value out of range is Error(invalid_argument) from `validate` and `single_lut`; a table that the device cannot hold is
/// Error(unsupported) from the constructor of Atmosphere or View.
struct SingleLutSettings {
    Steps steps = Steps::gauss;     ///< Where its nodes are.
    int view_steps = 8;             ///< As SingleSettings::view_steps.
    rhi::Extent table{128, 32, 1};  ///< Optical depth: sun zenith x altitude nodes, each in [2, 4096]; depth is 1.
    int table_nodes = 8;            ///< Gauss nodes a ray of the table, in [2, 16].
    rhi::Format table_format = rhi::Format::rgba32_float;  ///< rgba16_float or rgba32_float.
    Dome dome;                                             ///< A table of the sky, if any.

    /// "low": a dome of 24 x 64 vertices, 6 nodes, table 64 x 16. "default": each pixel, 8 nodes, table 128 x 32. "high": each
    /// pixel, 12 nodes, table 256 x 64. "converged": 16 nodes, table 1024 x 256. Anything else: Error(invalid_argument).
    [[nodiscard]] static SingleLutSettings by_name(std::string_view quality);
};

/// Throws Error(invalid_argument) at the first field outside its range.
void validate(const SingleLutSettings& settings);

/// The model "single-lut".
[[nodiscard]] ModelPtr single_lut(const SingleLutSettings& settings = {});

}  // namespace aureole::models
