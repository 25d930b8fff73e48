// What the camera sees in each frame: the scene's view, turned by keys or by a script.
#pragma once

#include "host_vulkan/options.h"
#include "host_vulkan/terrain_mesh.h"
#include "host_vulkan/window.h"

#include <aureole/parameters.h>

#include <vector>

namespace host_vulkan {

/// Glass balls before the scene's camera, lower than it, near ones small and far ones large: centre and radius.
[[nodiscard]] std::vector<glm::dvec4> place_spheres(const aureole::app::Scene& scene, const TerrainMesh& mesh,
                                                    std::uint32_t count);

class Script {
public:
    Script(const aureole::app::Scene& scene, const Options& options, double altitude_m, double exposure);

    /// Turns by the window's keys.
    void turn(const Window::Turn& turn);
    /// The suns of a frame; their light is exposed, so that half floats hold what a display shows.
    [[nodiscard]] const std::vector<aureole::Sun>& suns(std::uint32_t frame);
    [[nodiscard]] aureole::Camera camera(std::uint32_t frame, VkExtent2D size);
    /// The size that the window is to have in a frame.
    [[nodiscard]] VkExtent2D size(std::uint32_t frame) const;

private:
    [[nodiscard]] double sway(std::uint32_t frame) const;

    // Copies of a scene and lists of suns come from the heap: both are made once, and changed in place.
    aureole::app::Scene scene_;
    const Options options_;
    const double altitude_m_;
    std::vector<aureole::Sun> suns_;
};

}  // namespace host_vulkan
