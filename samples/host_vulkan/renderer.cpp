#include "host_vulkan/renderer.h"

#include <cstring>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace host_vulkan {

Renderer::Renderer(const Device& device, VkExtent2D window, const aureole::app::Scene& scene, const TerrainMesh& mesh,
                   const RendererSettings& settings)
    : device_(device),
      settings_(settings),
      mesh_origin_m_(mesh.origin_m),
      swapchain_(std::make_unique<Swapchain>(device, window, nullptr)),
      sky_(device, scene),
      passes_(device, sky_, mesh, *swapchain_, settings.frames_in_flight, static_cast<std::uint32_t>(settings.spheres.size())),
      ring_(device, settings.frames_in_flight, settings.async_compute, sizeof(FrameBlock)) {
    for (Frame& frame : ring_.all()) frame.set = passes_.make_set(*frame.uniforms);
    sky_.lend_shadow_map(passes_.shadow_map());
    make_targets();
}

Renderer::~Renderer() { vkDeviceWaitIdle(device_.handle); }

void Renderer::make_targets() {
    targets_ = std::make_unique<Targets>(device_, swapchain_->extent());
    for (const Frame& frame : ring_.all()) passes_.show(frame.set, targets_->hdr);
    sky_.lend_targets(targets_->color, targets_->depth, targets_->hdr);
}

void Renderer::resize(VkExtent2D window) {
    check(vkDeviceWaitIdle(device_.handle), "vkDeviceWaitIdle");
    sky_.take_targets_back();
    targets_.reset();
    swapchain_ = std::make_unique<Swapchain>(device_, window, swapchain_.get());
    make_targets();
    if (capture_) start_capture();
}

void Renderer::fill(Frame& frame, const aureole::Camera& camera, std::span<const aureole::Sun> suns, const Cascades& cascades) {
    FrameBlock block = {};
    block.camera_to_clip = glm::mat4(camera.projection * glm::dmat4(glm::dmat3(camera.view)));
    for (std::size_t c = 0; c < Cascades::count; ++c) {
        block.camera_to_map[c] = glm::mat4(cascades.camera_to_map[c]);
        block.texel_m[static_cast<int>(c)] = static_cast<float>(cascades.texel_m[c]);
    }
    block.mesh_origin = glm::vec4(glm::vec3(mesh_origin_m_ - camera.position_m), 0);
    block.up = glm::vec4(glm::vec3(glm::normalize(camera.position_m)), 0);
    for (std::size_t s = 0; s < suns.size(); ++s) block.suns[s] = glm::vec4(glm::vec3(glm::normalize(suns[s].direction)), 0);
    const VkExtent2D size = extent();
    block.counts = glm::vec4(suns.size(), 1.0 / size.width, 1.0 / size.height, number_ % 1024);
    for (std::size_t s = 0; s < settings_.spheres.size(); ++s)
        block.spheres[s] = glm::vec4(settings_.spheres[s] - glm::dvec4(camera.position_m, 0));
    std::memcpy(frame.uniforms->bytes.data(), &block, sizeof(block));
}

void Renderer::record(Frame& frame, const Swapchain::Target& target) {
    const FrameCommands& commands = frame.commands;
    passes_.record_shadows(commands.shadows, frame.set);
    sky_.record_tables(commands.tables, settings_.async_compute ? device_.compute_family : device_.family);
    passes_.record_depth(commands.depth, frame.set, *targets_);

    passes_.record_color(commands.picture, frame.set, *targets_);
    targets_->hdr.move(commands.picture, uses::storage_write, false);
    sky_.record_composite(commands.picture);
    passes_.record_transparents(commands.picture, frame.set, *targets_);
    // The image is there from the stage at which the submission waits for it.
    constexpr Use acquired = {VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, 0};
    barrier(commands.picture, target.image, VK_IMAGE_ASPECT_COLOR_BIT, acquired, uses::color_attachment);
    passes_.record_display(commands.picture, frame.set, *targets_, target.view);
    Use last = uses::color_attachment;
    if (capture_) last = capture_->record(commands.picture, target.image, last);
    barrier(commands.picture, target.image, VK_IMAGE_ASPECT_COLOR_BIT, last, uses::present);
}

bool Renderer::draw(const aureole::Camera& camera, std::span<const aureole::Sun> suns) {
    Frame& frame = ring_.wait();
    sky_.finished(frame.number);
    // Before anything is recorded: what Aureole records is then always submitted, and Atmosphere::invalidate is never needed.
    const std::optional<std::uint32_t> image = swapchain_->acquire(frame.acquired);
    if (!image) return false;
    ring_.begin(frame, ++number_);
    const glm::dvec3 towards_sun = suns.empty() ? glm::normalize(camera.position_m) : glm::normalize(suns.front().direction);
    const Cascades cascades = cascades_around(camera.position_m, towards_sun, settings_.shadow_reach_m);
    sky_.update(number_, camera, suns, cascades);
    fill(frame, camera, suns, cascades);
    record(frame, swapchain_->target(*image));
    ring_.submit(frame, swapchain_->target(*image));
    return swapchain_->present(*image);
}

void Renderer::start_capture() {
    if (!swapchain_->can_be_copied()) throw std::runtime_error("--screenshot: the images of this window cannot be read");
    capture_ = std::make_unique<Capture>(device_, swapchain_->format(), extent());
}

aureole::app::DisplayImage Renderer::take_capture() {
    check(vkDeviceWaitIdle(device_.handle), "vkDeviceWaitIdle");
    const std::unique_ptr<Capture> taken = std::move(capture_);
    return taken->read();
}

}  // namespace host_vulkan
