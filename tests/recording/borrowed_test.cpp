// The whole module as a guest: a host's device, images and command buffers, under core and synchronization validation.
#include <aureole/rhi/validation.h>
#include <doctest/doctest.h>
#include <vulkan/vulkan.h>

#include <cstring>
#include <limits>

#include "passes/compare.h"
#include "passes/scene.h"
#include "test_host.h"

using namespace aureole;
using namespace aureole::passes;
using namespace aureole::vulkan::test;

namespace {

constexpr rhi::Extent size{20, 12, 1};
constexpr VkExtent2D extent{20, 12};
constexpr double wall_m = 30e3;

/// What a frame shows.
struct Shot {
    Camera camera;
    Sun sun = sun_at(15);
};

Setup setup_of(bool raster) {
    Setup setup;
    setup.composite = {.target_format = rhi::Format::rgba32_float, .raster = raster, .scene_color = true, .scene_depth = true};
    return setup;
}

Shot shot_of(double altitude_m) {
    Shot shot{camera_at(presets::earth().planet, altitude_m)};
    shot.camera.projection = perspective_conventions(20.0 / 12.0).front().projection;
    return shot;
}

/// A wall of one colour at one distance, as the host clears it.
Image expected(Backend& cpu, const Setup& setup, const Shot& shot, double wall) {
    Rig rig(cpu, setup);
    rig.record_air();
    rig.record_view(shot.camera, shot.sun);
    const double stored = perspective_conventions(20.0 / 12.0).front().stored(wall);
    const std::size_t count = std::size_t{size.width} * size.height;
    const rhi::Texture color =
        cpu.make("color", rhi::Format::rgba32_float, {size, std::vector(count, glm::dvec4(0.25, 0.5, 0.75, 1))});
    const rhi::Texture depth =
        cpu.make("depth", rhi::Format::r32_float, {size, std::vector(count, glm::dvec4(stored, 0, 0, 1))});
    return rig.show(size, {.scene_color = color, .scene_depth = depth});
}

rhi::ExternalTexture lend(const HostImage& image, const char* name, rhi::Format format, rhi::Usage usage, rhi::State state) {
    rhi::ExternalTexture external;
    external.desc = {name, rhi::Dimension::d2, format, size, usage};
    external.native = reinterpret_cast<std::uint64_t>(image.image);
    external.state = state;
    return external;
}

/// The host's frame: it draws its scene, lets the guest record, and reads the picture.
class HostFrame {
public:
    HostFrame(Host& host, bool raster)
        : host_(host),
          target_layout_(raster ? VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL : VK_IMAGE_LAYOUT_GENERAL),
          color_(host.make_image_2d(VK_FORMAT_R32G32B32A32_SFLOAT, extent, VK_IMAGE_USAGE_SAMPLED_BIT)),
          depth_(host.make_image_2d(VK_FORMAT_D32_SFLOAT, extent,
                                    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT)),
          target_(host.make_image_2d(VK_FORMAT_R32G32B32A32_SFLOAT, extent,
                                     raster ? VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT : VK_IMAGE_USAGE_STORAGE_BIT)),
          guest_(vulkan::borrow_vulkan_device(host.lend())),
          device_(rhi::create_validation_device(guest_->device())) {
        device_->set_message_callback(Messages::collect, &host.messages);
        const auto use = raster ? rhi::Usage::color_attachment : rhi::Usage::storage;
        const auto state = raster ? rhi::State::color_attachment : rhi::State::storage_write;
        using rhi::Format, rhi::Usage, rhi::State;
        targets.scene_color =
            device_->wrap_texture(lend(color_, "host colour", Format::rgba32_float, Usage::sampled, State::sampled));
        targets.scene_depth =
            device_->wrap_texture(lend(depth_, "host depth", Format::d32_float, Usage::sampled, State::depth_read));
        targets.target = device_->wrap_texture(lend(target_, "host target", Format::rgba32_float, use, state));
        targets.extent = size;
    }
    ~HostFrame() {
        for (const rhi::Texture texture : {targets.scene_color, targets.scene_depth, targets.target})
            device_->destroy(texture, 0);
        device_->collect(std::numeric_limits<std::uint64_t>::max());
        device_.reset();
        guest_->device().set_message_callback(Messages::collect, &host_.messages);
    }
    HostFrame(const HostFrame&) = delete;
    HostFrame& operator=(const HostFrame&) = delete;

    [[nodiscard]] rhi::Device& device() { return *device_; }

    template <class Record>
    Image run(double wall, const Record& record) {
        host_.clear_color(color_, 0.25F, 0.5F, 0.75F, 1);
        host_.clear_depth(depth_, static_cast<float>(perspective_conventions(20.0 / 12.0).front().stored(wall)));
        host_.move(color_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        host_.move(depth_, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL);
        host_.move(target_, target_layout_);
        rhi::CommandList& commands = device_->begin_list(guest_->begin_recording(host_.commands()), ++frame_);
        record(commands);
        device_->end_list();
        guest_->end_recording();
        const std::vector<std::byte> bytes = host_.read(target_, {extent.width, extent.height, 1}, 16 * 20 * 12);
        device_->collect(frame_);
        std::vector<float> numbers(bytes.size() / sizeof(float));
        std::memcpy(numbers.data(), bytes.data(), bytes.size());
        Image image{size, std::vector<glm::dvec4>(numbers.size() / 4)};
        std::copy(numbers.begin(), numbers.end(), &image.texels[0].x);
        return image;
    }

    /// Records into a command buffer that is never submitted, as when the swapchain turns out to be out of date.
    template <class Record>
    void drop(const Record& record) {
        VkCommandPoolCreateInfo pool_info = {};
        pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        pool_info.queueFamilyIndex = host_.lend().queue_family;
        VkCommandPool pool = VK_NULL_HANDLE;
        REQUIRE(vkCreateCommandPool(host_.device(), &pool_info, nullptr, &pool) == VK_SUCCESS);
        VkCommandBufferAllocateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        info.commandPool = pool;
        info.commandBufferCount = 1;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        REQUIRE(vkAllocateCommandBuffers(host_.device(), &info, &commands) == VK_SUCCESS);
        VkCommandBufferBeginInfo begin = {};
        begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        REQUIRE(vkBeginCommandBuffer(commands, &begin) == VK_SUCCESS);
        record(device_->begin_list(guest_->begin_recording(commands), ++frame_));
        device_->end_list();
        guest_->end_recording();
        REQUIRE(vkEndCommandBuffer(commands) == VK_SUCCESS);
        vkDestroyCommandPool(host_.device(), pool, nullptr);
    }

    CompositeTargets targets;

private:
    Host& host_;
    VkImageLayout target_layout_;
    HostImage &color_, &depth_, &target_;
    std::uint64_t frame_ = 0;
    std::unique_ptr<vulkan::BorrowedVulkanDevice> guest_;
    std::unique_ptr<rhi::ValidationDevice> device_;
};

void check_same(const Image& a, const Image& b) {
    Worst worst;
    worst.compare(a, b, {Measure::Kind::relative, 0, 1e-6});
    INFO(worst.text());
    CHECK(worst.error() <= 1e-4);
}

}  // namespace

TEST_CASE("a host's command buffer, images and depth: the module shows in them what it shows elsewhere") {
    AUREOLE_NEEDS_VULKAN;
    for (const bool raster : {false, true}) {
        CAPTURE(raster);
        const auto cpu = open_cpu_float();
        Setup setup = setup_of(raster);
        Host host;
        HostFrame frame(host, raster);
        Atmosphere air(frame.device(), setup.air, setup.quality);
        View view(air, setup.view, setup.composite);
        view.prepare_composite(frame.targets);
        std::uint64_t number = 0;
        const auto show = [&](const Shot& shot, double wall) {
            air.set_frame(++number);
            view.update(shot.camera, std::span(&shot.sun, 1));
            return frame.run(wall, [&](rhi::CommandList& commands) {
                air.record(commands);
                view.record(commands);
                view.record_composite(commands, frame.targets);
            });
        };
        const Shot low = shot_of(100), high = shot_of(12e3);
        check_same(show(low, wall_m), expected(*cpu, setup, low, wall_m));
        check_same(show(low, 500), expected(*cpu, setup, low, 500));  // only the host's scene has changed
        check_same(show(high, std::numeric_limits<double>::infinity()),
                   expected(*cpu, setup, high, std::numeric_limits<double>::infinity()));

        air.set_parameters(presets::mars());  // other pipelines, while the old ones wait for their frame
        setup.air = presets::mars();
        check_same(show(low, wall_m), expected(*cpu, setup, low, wall_m));
        frame.device().collect(number);
        check_same(show(low, wall_m), expected(*cpu, setup, low, wall_m));
        CHECK(host.messages.joined() == "");
    }
}

TEST_CASE("a host's command buffer that is never submitted: once that is said, all is recorded anew") {
    AUREOLE_NEEDS_VULKAN;
    const auto cpu = open_cpu_float();
    const Setup setup = setup_of(false);
    Host host;
    HostFrame frame(host, false);
    Atmosphere air(frame.device(), setup.air, setup.quality);
    View view(air, setup.view, setup.composite);
    view.prepare_composite(frame.targets);
    const auto record = [&](rhi::CommandList& commands) {
        air.record(commands);
        view.record(commands);
        view.record_composite(commands, frame.targets);
    };
    for (const double altitude : {100.0, 12e3}) {  // before anything has been executed, and after
        const Shot shot = shot_of(altitude);
        view.update(shot.camera, std::span(&shot.sun, 1));
        frame.drop(record);
        air.invalidate();
        check_same(frame.run(wall_m, record), expected(*cpu, setup, shot, wall_m));
        check_same(frame.run(wall_m, record), expected(*cpu, setup, shot, wall_m));
    }
    CHECK(host.messages.joined() == "");
}

TEST_CASE("a host's command buffer: what has not changed leaves nothing in it") {
    AUREOLE_NEEDS_VULKAN;
    Host host;
    HostFrame frame(host, false);
    CountingDevice counting(frame.device());
    const Setup setup = setup_of(false);
    Atmosphere air(counting, setup.air, setup.quality);
    View view(air, setup.view, setup.composite);
    const Shot shot = shot_of(100);
    view.update(shot.camera, std::span(&shot.sun, 1));
    for (int repeat = 0; repeat < 2; ++repeat) {
        (void)frame.run(wall_m, [&](rhi::CommandList& commands) {
            CountingList list(commands);
            air.record(list);
            view.record(list);
            CHECK((list.counts.total() == 0) == (repeat == 1));
        });
    }
}
