// What the module needs of a device, checked before anything is made.
#pragma once

#include <aureole/atmosphere.h>

namespace aureole::detail {

/// Throws Error(unsupported) naming the format, feature or limit that is missing: for any model, and for one with these tables.
void require_device(const rhi::Device& device);
void require_tables(const rhi::Device& device, const QualitySettings& quality);
/// Texels of a layer, one on top of the other; 0: there is no such table.
struct ViewTableSizes {
    std::uint32_t sky_view_height, froxels_height;
};
/// The view's tables stack the layers of all suns: the same, naming the setting of `model` that makes them too high.
void require_view(const rhi::Device& device, std::string_view model, const ViewTableSizes& sizes, std::uint32_t suns,
                  std::uint32_t layers_per_sun);
/// The parts of these: a format that tables can have; a side of a texture; layers of all suns stacked in one texture.
void require_table(const rhi::Device& device, rhi::Format format, rhi::Dimension dimension, bool filtered = true);
void require_size(const char* what, std::uint32_t limit, std::uint32_t needed);
void require_rows(const std::string& field, std::uint32_t height, std::uint32_t suns, std::uint32_t layers_per_sun,
                  const char* limit_name, std::uint32_t limit);
void require_target(const rhi::Device& device, const CompositeSettings& settings);

}  // namespace aureole::detail
