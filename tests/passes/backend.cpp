#include "passes/backend.h"

#include <aureole/rhi/checks.h>
#include <aureole/rhi/texel.h>
#include <doctest/doctest.h>

#ifdef AUREOLE_TESTS_HAVE_VULKAN
#include <aureole/vulkan/vulkan_device.h>
#endif

#include <algorithm>
#include <utility>

namespace aureole::passes {
namespace {

struct OpenCpu final : OpenDevice {
    explicit OpenCpu(const cpu::CpuDeviceDesc& desc) : made(cpu::create_cpu_device(desc)) {}
    [[nodiscard]] rhi::Device& device() override { return made->device(); }
    [[nodiscard]] rhi::Queue& queue() override { return made->queue(); }
    [[nodiscard]] const cpu::CpuDevice* cpu() const override { return made.get(); }
    std::unique_ptr<cpu::CpuDevice> made;
};

#ifdef AUREOLE_TESTS_HAVE_VULKAN
struct OpenVulkan final : OpenDevice {
    explicit OpenVulkan(const vulkan::VulkanDeviceDesc& desc) : made(vulkan::create_vulkan_device(desc)) {}
    [[nodiscard]] rhi::Device& device() override { return made->device(); }
    [[nodiscard]] rhi::Queue& queue() override { return made->queue(); }
    std::unique_ptr<vulkan::VulkanDevice> made;
};

/// Empty if tests can run there.
std::string vulkan_problem() {
    const vulkan::VulkanDeviceList list = vulkan::list_vulkan_devices();
    const bool usable = std::any_of(list.devices.begin(), list.devices.end(), [](const auto& d) { return d.problem.empty(); });
    if (!usable) return "no usable Vulkan device. " + list.problem;
    return list.validation_available ? "" : "the Vulkan validation layer is not installed";
}
#endif

std::vector<glm::dvec4> decode(rhi::Format format, const std::vector<std::byte>& packed) {
    std::vector<glm::dvec4> texels(packed.size() / rhi::bytes_per_texel(format));
    rhi::decode_texels(format, packed, std::span(&texels[0].x, 4 * texels.size()));
    return texels;
}

std::vector<std::byte> encode(rhi::Format format, const std::vector<glm::dvec4>& texels) {
    std::vector<std::byte> packed(texels.size() * rhi::bytes_per_texel(format));
    rhi::encode_texels(format, std::span(&texels[0].x, 4 * texels.size()), packed);
    return packed;
}

void move(rhi::CommandList& commands, rhi::Texture texture, rhi::State before, rhi::State after) {
    const rhi::TextureBarrier barrier{texture, before, after};
    commands.barrier({&barrier, 1}, {});
}
void move(rhi::CommandList& commands, rhi::Buffer buffer, rhi::State after) {
    const rhi::BufferBarrier barrier{buffer, rhi::State::undefined, after};
    commands.barrier({}, {&barrier, 1});
}

}  // namespace

Backend::Backend(std::string name, std::unique_ptr<OpenDevice> inner)
    : name_(std::move(name)),
      inner_(std::move(inner)),
      validation_(rhi::create_validation_device(inner_->device())),
      queue_(rhi::create_validation_queue(*validation_, inner_->queue())),
      counting_(std::make_unique<CountingDevice>(*validation_)) {
    validation_->set_message_callback(collect, this);
}

Backend::~Backend() {
    std::for_each(made_.rbegin(), made_.rend(), [&](const auto& handle) { counting_->destroy(handle, 0); });
    CHECK(counting_->live() == 0);
    queue_->wait();
    queue_.reset();
    validation_.reset();  // reports what is left
    inner_->device().set_message_callback(collect, this);
    inner_.reset();  // here the layer does
    INFO(name_);
    CHECK(take_messages() == "");
}

void Backend::collect(void* backend, rhi::Severity severity, const char* text) {
    if (severity != rhi::Severity::info) static_cast<Backend*>(backend)->messages_.emplace_back(text);
}

std::string Backend::take_messages() {
    std::string all;
    for (const std::string& text : std::exchange(messages_, {})) all += text + "\n";
    return all;
}

CommandCounts Backend::run(const std::function<void(rhi::CommandList&)>& record) {
    CountingList list(queue_->begin());
    record(list);
    queue_->submit();
    queue_->wait();
    return list.counts;
}

Image Backend::read(rhi::Texture texture, rhi::State state) {
    const rhi::TextureDesc& desc = counting_->desc(texture);
    if (const cpu::CpuDevice* cpu = inner_->cpu()) {
        const std::vector<double> numbers = cpu->read_texels_double(texture);  // in double nothing is rounded
        Image image{desc.extent, std::vector<glm::dvec4>(numbers.size() / 4)};
        std::copy(numbers.begin(), numbers.end(), &image.texels[0].x);
        return image;
    }
    std::vector<std::byte> packed(static_cast<std::size_t>(rhi::packed_size(desc)));
    const rhi::Buffer staging = validation_->create_buffer({"read-back of " + desc.name, packed.size(), rhi::Usage::read_back});
    run([&](rhi::CommandList& commands) {
        move(commands, staging, rhi::State::copy_destination);
        move(commands, texture, state, rhi::State::copy_source);
        commands.copy(rhi::TextureToBuffer{texture, staging});
        move(commands, texture, rhi::State::copy_source, state);
    });
    validation_->read_buffer(staging, packed);
    validation_->destroy(staging, 0);
    return {desc.extent, decode(desc.format, packed)};
}

void Backend::write(rhi::Texture texture, const Image& image, rhi::State state) {
    const rhi::TextureDesc& desc = counting_->desc(texture);
    REQUIRE(image.extent == desc.extent);
    const std::vector<std::byte> packed = encode(desc.format, image.texels);
    const rhi::Buffer staging = validation_->create_buffer({"upload to " + desc.name, packed.size(), rhi::Usage::upload});
    validation_->write_buffer(staging, packed);
    run([&](rhi::CommandList& commands) {
        move(commands, staging, rhi::State::copy_source);
        move(commands, texture, rhi::State::undefined, rhi::State::copy_destination);
        commands.copy(rhi::BufferToTexture{staging, texture});
        move(commands, texture, rhi::State::copy_destination, state);
    });
    validation_->destroy(staging, 0);
}

rhi::Texture Backend::make(const std::string& name, rhi::Format format, const Image& image) {
    const auto dimension = image.extent.depth > 1 ? rhi::Dimension::d3 : rhi::Dimension::d2;
    const rhi::Texture texture = counting_->create_texture({name, dimension, format, image.extent, rhi::Usage::sampled});
    made_.emplace_back(texture);
    write(texture, image);
    return texture;
}

rhi::Texture Backend::make_target(rhi::Format format, rhi::Extent extent, rhi::State state) {
    const auto use = state == rhi::State::color_attachment ? rhi::Usage::color_attachment : rhi::Usage::storage;
    const rhi::Texture texture = counting_->create_texture({"target", rhi::Dimension::d2, format, extent, use});
    made_.emplace_back(texture);
    run([&](rhi::CommandList& commands) { move(commands, texture, rhi::State::undefined, state); });
    return texture;
}

std::unique_ptr<Backend> open_cpu_float(unsigned threads) {
    return std::make_unique<Backend>("CPU float", std::make_unique<OpenCpu>(cpu::CpuDeviceDesc{.threads = threads}));
}

std::unique_ptr<Backend> open_cpu_double() {
    return std::make_unique<Backend>("CPU double",
                                     std::make_unique<OpenCpu>(cpu::CpuDeviceDesc{.precision = cpu::Precision::float64}));
}

std::unique_ptr<Backend> open_vulkan() {
#ifdef AUREOLE_TESTS_HAVE_VULKAN
    static const std::string problem = vulkan_problem();
#else
    static const std::string problem = "built without the Vulkan backend";
#endif
    if (!problem.empty()) {
        MESSAGE("skipped: ", problem);
        return nullptr;
    }
#ifdef AUREOLE_TESTS_HAVE_VULKAN
    vulkan::VulkanDeviceDesc desc;
    desc.validation = true;
    return std::make_unique<Backend>("Vulkan", std::make_unique<OpenVulkan>(desc));
#endif
    return nullptr;
}

}  // namespace aureole::passes
