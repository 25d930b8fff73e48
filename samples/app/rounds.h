// How a picture by the model `reference` is traced: in short rounds, so that no dispatch takes long and progress can be told.
#pragma once

#include "scene/scene.h"

#include <aureole/models/reference.h>

#include <optional>

namespace aureole::app {

struct Rounds {
    models::ReferenceSettings settings;  ///< Of the view that is shown.
    std::uint32_t count = 1;
    /// The picture is the mean of the rounds' composites, where there is no film: it holds no geometry.
    [[nodiscard]] bool averaged() const { return settings.film_width == 0; }
};

/// Paths of a pixel of the picture: 16, 64 or 256 by quality, shared out to the pixels of its composite
/// (FrameOptions::samples), rounded up. Without land a film of the composite's size takes one path in each round. With land
/// each round's composite traces four. None for other models.
[[nodiscard]] std::optional<Rounds> rounds_of(const SceneModel& model, std::uint32_t width, std::uint32_t height,
                                              std::uint32_t samples, bool land);

/// The model that meters a scene and lights its land: itself, but the few paths of `reference` at low quality, first order on
/// coarser nodes.
[[nodiscard]] ModelPtr metering_model(const SceneModel& model);

}  // namespace aureole::app
