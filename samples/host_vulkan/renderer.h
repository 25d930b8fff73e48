// The host's frame, from waiting for its turn to the window.
#pragma once

#include "host_vulkan/capture.h"
#include "host_vulkan/frame_ring.h"
#include "host_vulkan/passes.h"
#include "io/image.h"

namespace host_vulkan {

struct RendererSettings {
    std::uint32_t frames_in_flight = 2;
    bool async_compute = false;
    std::vector<glm::dvec4> spheres;  ///< Centre from the planet's centre, radius; metres.
    double shadow_reach_m = 15e3;
};

class Renderer {
public:
    Renderer(const Device& device, VkExtent2D window, const aureole::app::Scene& scene, const TerrainMesh& mesh,
             const RendererSettings& settings);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Draws one frame and shows it. False if the window has another size by now: nothing was drawn, or it may not be seen;
    /// `resize`, and draw again. The camera is one for a picture of the shape of extent().
    [[nodiscard]] bool draw(const aureole::Camera& camera, std::span<const aureole::Sun> suns);
    void resize(VkExtent2D window);
    /// From here on frames are copied, too. Throws std::runtime_error where windows cannot be read here.
    void start_capture();
    /// What the window showed last; waits for it, and ends the copying.
    [[nodiscard]] aureole::app::DisplayImage take_capture();

    [[nodiscard]] VkExtent2D extent() const { return swapchain_->extent(); }
    [[nodiscard]] Sky& sky() noexcept { return sky_; }

private:
    void make_targets();
    void fill(Frame& frame, const aureole::Camera& camera, std::span<const aureole::Sun> suns, const Cascades& cascades);
    void record(Frame& frame, const Swapchain::Target& target);

    const Device& device_;
    const RendererSettings settings_;
    const glm::dvec3 mesh_origin_m_;
    std::unique_ptr<Swapchain> swapchain_;
    Sky sky_;
    Passes passes_;
    FrameRing ring_;
    std::unique_ptr<Targets> targets_;
    std::uint64_t number_ = 0;
    std::unique_ptr<Capture> capture_;  ///< Null while nothing is captured.
};

}  // namespace host_vulkan
