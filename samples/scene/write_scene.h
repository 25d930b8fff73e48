// A scene back into a scene file (docs/scenes.md).
#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace aureole::app {

/// What parse_scene reads as this scene, to the last bit; the air is written out in full, without a preset. Height maps are
/// named relative to `folder`, where the file will be. Throws Error(invalid_argument) for a scene that no file can state: two
/// terms of one name, more than four suns.
[[nodiscard]] std::string print_scene(const Scene& scene, const std::filesystem::path& folder = {});
/// The same into a file, which appears complete or not at all. Throws Error(io) too.
void write_scene(const std::filesystem::path& path, const Scene& scene);

}  // namespace aureole::app
