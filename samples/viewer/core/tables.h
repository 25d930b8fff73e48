// Tables of a model as pictures: which there are, and what stands in them.
#pragma once

#include "app/backend.h"

#include <aureole/atmosphere.h>

#include <string>
#include <vector>

namespace aureole::viewer {

struct TableInfo {
    std::string
        name;  ///< "transmittance", "multi_scatter", "sky_view", "aerial_perspective", "film", "light", "phase", "profile".
    rhi::Texture texture{};
    rhi::Format format{};
    rhi::Extent extent{};
    int slices = 1;  ///< Of a 3D table; 6 faces of a cube.
};
/// Those that this air and view keep, as the device describes them (rhi::Device::find).
[[nodiscard]] std::vector<TableInfo> tables_of(const Atmosphere& air, const View& view);

/// One slice of a table: RGBA, row by row.
struct TableSlice {
    std::string name;
    rhi::Format format{};
    std::uint32_t width = 0, height = 0;
    int slice = 0, slices = 1;
    std::vector<float> rgba;
    /// Greatest absolute value of red, green and blue: what a picture of it is scaled by.
    float greatest = 0;

    /// Outside of the slice: Error(invalid_argument).
    [[nodiscard]] const float* texel(std::uint32_t x, std::uint32_t y) const;
};
/// Reads it back. The table was recorded; it is in State::sampled before and after. A slice that there is not is the nearest.
[[nodiscard]] TableSlice read_slice(app::Backend& backend, const TableInfo& table, int slice);

}  // namespace aureole::viewer
