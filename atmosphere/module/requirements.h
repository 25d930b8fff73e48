// What the module needs of a device, checked before anything is made.
#pragma once

#include <aureole/atmosphere.h>

namespace aureole::detail {

/// Throws Error(unsupported) naming the format, feature or limit that is missing.
void require_device(const rhi::Device& device, const QualitySettings& quality);
void require_target(const rhi::Device& device, const CompositeSettings& settings);

}  // namespace aureole::detail
