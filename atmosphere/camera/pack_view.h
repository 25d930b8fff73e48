// From a camera and its suns to the uniform block that the view's kernels read, in double precision.
#pragma once

#include "common/host_blocks.h"

#include <aureole/camera.h>
#include <aureole/parameters.h>

#include <span>

namespace aureole::detail {

struct ViewInputs {
    double aerial_perspective_distance_m = 96000;  ///< Depth of the last slice. In [1e-3, 1e13].
    double exposure = 1;                           ///< Of the composite. In [1e-30, 1e30].
    double shadow_distance_m = 8000;               ///< Depth of the last slice of shadows. In [1e-3, 1e13].
    std::uint32_t shadowed_sun = 0;                ///< Below max_suns.
    double sun_lobe_g = 0;                         ///< Of the composite. In [0, 0.9999].
};

/// Validates camera, suns and inputs (the planet must be valid), then packs. Suns are named "suns[1].irradiance.r".
[[nodiscard]] ViewBlock pack_view(const Camera& camera, std::span<const Sun> suns, const Planet& planet,
                                  const ViewInputs& inputs = {});

}  // namespace aureole::detail
