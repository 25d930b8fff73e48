// Vulkan devices in C: Aureole's own, and guests on a host's.
#ifdef AUREOLE_C_HAS_VULKAN
#include <aureole/vulkan/vulkan_device.h>
#endif

#include "convert.h"
#include "handles.h"

using namespace aureole;
using namespace aureole::c_api;

namespace {

const aureole_vulkan_device_desc default_own{sizeof(aureole_vulkan_device_desc), -1, nullptr, 0, nullptr, nullptr};
const aureole_borrowed_vulkan default_borrowed{
    sizeof(aureole_borrowed_vulkan), 0, nullptr, nullptr, nullptr, nullptr, 0, 0, nullptr, 0, no_queue_family};

#ifdef AUREOLE_C_HAS_VULKAN

/// Numbers of non-dispatchable handles, which are pointers on some platforms.
template <class Object>
std::uint64_t bits(Object object) {
    return (std::uint64_t)object;  // NOLINT: a pointer or a number, by platform
}

template <class Made>
void write_native(const Made& made, rhi::Texture texture, aureole_native_texture& out) {
    const vulkan::NativeTexture native = made.native(texture);
    out.sampled_layout = number(native.sampled_layout);
    out.image = bits(native.image);
    out.sampled_view = bits(native.sampled_view);
}

struct OwnVulkan final : aureole_device {
    explicit OwnVulkan(const aureole_vulkan_device_desc& c) {
        vulkan::VulkanDeviceDesc desc;
        desc.index = c.index;
        desc.name = text(c.name);
        desc.validation = boolean(c.validation, "desc.validation");
        listener_ = {c.message_callback, c.message_user};
        desc.message_callback = &aureole_device::tell;
        desc.message_user = static_cast<aureole_device*>(this);
        made = vulkan::create_vulkan_device(desc);
    }
    [[nodiscard]] rhi::Device& rhi_device() override { return made->device(); }
    [[nodiscard]] rhi::CommandList& begin(void* host_list) override {
        if (host_list)
            throw Error(ErrorCode::invalid_argument, "host_list", "a pointer", "NULL: this device has its own queue");
        return made->queue().begin();
    }
    std::uint64_t end() override { return made->queue().submit(); }
    void wait() override { made->queue().wait(); }
    void native(rhi::Texture texture, aureole_native_texture& out) const override { write_native(*made, texture, out); }
    [[nodiscard]] std::uint64_t native(rhi::Buffer buffer) const override { return bits(made->native(buffer)); }

    std::unique_ptr<vulkan::VulkanDevice> made;
};

vulkan::BorrowedVulkan to_cpp(const aureole_borrowed_vulkan& c) {
    vulkan::BorrowedVulkan host;
    host.instance = static_cast<VkInstance>(c.instance);
    host.physical_device = static_cast<VkPhysicalDevice>(c.physical_device);
    host.device = static_cast<VkDevice>(c.device);
    host.get_instance_proc_addr = reinterpret_cast<PFN_vkGetInstanceProcAddr>(c.get_instance_proc_addr);
    host.api_version = c.api_version;
    host.queue_family = c.queue_family;
    host.second_queue_family = c.second_queue_family;
    if (c.enabled_features) host.enabled_features = *static_cast<const VkPhysicalDeviceFeatures*>(c.enabled_features);
    host.debug_utils = boolean(c.debug_utils, "host.debug_utils");
    host.pipeline_cache = (VkPipelineCache)c.pipeline_cache;  // NOLINT: a pointer or a number, by platform
    return host;
}

struct GuestOnVulkan final : aureole_device {
    explicit GuestOnVulkan(const vulkan::BorrowedVulkan& host) : made(vulkan::borrow_vulkan_device(host)) {}
    [[nodiscard]] rhi::Device& rhi_device() override { return made->device(); }
    [[nodiscard]] rhi::CommandList& begin(void* host_list) override {
        return made->begin_recording(static_cast<VkCommandBuffer>(host_list));
    }
    [[nodiscard]] rhi::CommandList& begin_on(void* host_list, std::uint32_t queue_family) override {
        static_assert(no_queue_family == VK_QUEUE_FAMILY_IGNORED);
        return made->begin_recording(static_cast<VkCommandBuffer>(host_list), queue_family);
    }
    std::uint64_t end() override {
        made->end_recording();
        return 0;
    }
    void native(rhi::Texture texture, aureole_native_texture& out) const override { write_native(*made, texture, out); }
    [[nodiscard]] std::uint64_t native(rhi::Buffer buffer) const override { return bits(made->native(buffer)); }

    std::unique_ptr<vulkan::BorrowedVulkanDevice> made;
};

aureole_device* make_own(const aureole_vulkan_device_desc& desc) { return new OwnVulkan(desc); }
aureole_device* make_guest(const aureole_borrowed_vulkan& host) { return new GuestOnVulkan(to_cpp(host)); }

#else

[[noreturn]] void not_built() { throw Error(ErrorCode::unsupported, "this library was built without the Vulkan backend"); }
aureole_device* make_own(const aureole_vulkan_device_desc&) { not_built(); }
aureole_device* make_guest(const aureole_borrowed_vulkan&) { not_built(); }

#endif

}  // namespace

aureole_result aureole_vulkan_device_desc_defaults(aureole_vulkan_device_desc* desc) {
    return guarded([&] { write(desc, "desc", default_own); });
}

aureole_result aureole_create_vulkan_device(const aureole_vulkan_device_desc* desc, aureole_device** out_device) {
    return guarded([&] {
        const aureole_vulkan_device_desc c = read(desc, "desc", default_own);
        aureole_device*& out = given(out_device, "out_device");
        out = make_own(c);
    });
}

aureole_result aureole_borrowed_vulkan_defaults(aureole_borrowed_vulkan* host) {
    return guarded([&] { write(host, "host", default_borrowed); });
}

aureole_result aureole_borrow_vulkan_device(const aureole_borrowed_vulkan* host, aureole_device** out_device) {
    return guarded([&] {
        const aureole_borrowed_vulkan c = read(host, "host", default_borrowed);
        aureole_device*& out = given(out_device, "out_device");
        out = make_guest(c);
    });
}
