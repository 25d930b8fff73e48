// What the module needs of a device, checked before anything is made.
#pragma once

#include <aureole/atmosphere.h>

namespace aureole::detail {

/// Throws Error(unsupported) naming the format, feature or limit that is missing: for any model, and for one with these tables.
void require_device(const rhi::Device& device);
void require_table(const rhi::Device& device, rhi::Format format, rhi::Dimension dimension, bool filtered = true);
void require_size(const char* what, std::uint32_t limit, std::uint32_t needed);
void require_tables(const rhi::Device& device, const QualitySettings& quality);
/// The view's tables stack the layers of all suns: the same, naming the setting that makes them too high. `froxels` false:
/// there is no aerial perspective.
void require_view(const rhi::Device& device, const QualitySettings& quality, std::uint32_t suns, std::uint32_t layers_per_sun,
                  bool froxels);
void require_target(const rhi::Device& device, const CompositeSettings& settings);

}  // namespace aureole::detail
