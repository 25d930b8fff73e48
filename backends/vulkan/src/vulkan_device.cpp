// Entry points: list, create, borrow.
#include <aureole/vulkan/vulkan_device.h>

#include "instance.h"
#include "queue.h"
#include "result.h"

#include <optional>

namespace aureole::vulkan {
namespace {

/// A VkDevice of our own with one queue.
class NativeDevice {
public:
    NativeDevice(const Instance& instance, const PhysicalDevice& physical, std::uint32_t queue_family)
        : device_(create(instance, physical, queue_family)),
          destroy_(
              reinterpret_cast<PFN_vkDestroyDevice>(instance.functions().vkGetDeviceProcAddr(device_, "vkDestroyDevice"))) {}
    ~NativeDevice() {
        if (destroy_) destroy_(device_, nullptr);
    }
    NativeDevice(const NativeDevice&) = delete;
    NativeDevice& operator=(const NativeDevice&) = delete;
    [[nodiscard]] VkDevice get() const noexcept { return device_; }

private:
    static VkDevice create(const Instance& instance, const PhysicalDevice& physical, std::uint32_t queue_family) {
        const float priority = 1.0f;
        VkDeviceQueueCreateInfo queue = {};
        queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
        queue.queueFamilyIndex = queue_family;
        queue.queueCount = 1;
        queue.pQueuePriorities = &priority;
        VkPhysicalDeviceFeatures features = {};
        features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
        VkDeviceCreateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
        info.queueCreateInfoCount = 1;
        info.pQueueCreateInfos = &queue;
        info.pEnabledFeatures = &features;
        VkDevice device = VK_NULL_HANDLE;
        const auto make = instance.functions().vkCreateDevice;
        check_result(make(physical.handle, &info, nullptr, &device), "vkCreateDevice", physical.properties.deviceName);
        return device;
    }

    VkDevice device_;
    PFN_vkDestroyDevice destroy_;
};

class OwnDevice final : public VulkanDevice {
public:
    explicit OwnDevice(const VulkanDeviceDesc& desc)
        : sink_(sink_of(desc)), instance_(open_vulkan(desc.loader), desc.validation, sink_) {
        const std::vector<PhysicalDevice> found = enumerate(instance_.functions(), instance_.handle());
        const std::vector<const PhysicalDevice*> usable = choose(found, desc);
        ErrorCode code = ErrorCode::unsupported;
        std::string reasons;
        for (std::size_t i = 0; i < usable.size() && !queue_; ++i) {
            try {
                open(*usable[i]);
            } catch (const Error& error) {
                close();
                if (usable.size() == 1) throw;
                if (i == 0) code = error.code();
                const std::string reason = usable[i]->properties.deviceName + std::string(": ") + error.what();
                sink_.send(rhi::Severity::warning, ("this Vulkan device cannot be opened: " + reason).c_str());
                reasons += (reasons.empty() ? "" : "; ") + reason;
            }
        }
        if (!queue_) throw Error(code, "no Vulkan device can be opened: " + reasons);
    }
    /// A lost device waits for nothing; its objects may and must still be freed.
    ~OwnDevice() override { device_->context().fn.vkDeviceWaitIdle(handles_.device); }

    [[nodiscard]] rhi::Device& device() override { return *device_; }
    [[nodiscard]] rhi::Queue& queue() override { return *queue_; }
    [[nodiscard]] VulkanHandles handles() const override { return handles_; }
    [[nodiscard]] NativeTexture native(rhi::Texture texture) const override { return device_->native(texture); }
    [[nodiscard]] VkBuffer native(rhi::Buffer buffer) const override { return device_->native(buffer); }

private:
    static MessageSink sink_of(const VulkanDeviceDesc& desc) {
        MessageSink sink;
        sink.set(desc.message_callback, desc.message_user);
        return sink;
    }

    void open(const PhysicalDevice& physical) {
        handles_.instance = instance_.handle();
        handles_.physical_device = physical.handle;
        handles_.queue_family = choose_queue_family(physical);
        native_.emplace(instance_, physical, handles_.queue_family);
        handles_.device = native_->get();

        ContextDesc context;
        context.functions = instance_.functions();
        context.instance = handles_.instance;
        context.physical = physical;
        context.device = handles_.device;
        context.queue_family = handles_.queue_family;
        context.ownership = Ownership::own;
        context.debug_utils = instance_.debug_utils();
        device_.emplace(context, sink_);
        device_->context().fn.vkGetDeviceQueue(handles_.device, handles_.queue_family, 0, &handles_.queue);
        queue_.emplace(*device_, handles_.queue);
    }
    /// What `open` made before it failed.
    void close() noexcept {
        queue_.reset();
        device_.reset();
        native_.reset();
    }

    // Destroyed from the last to the first.
    MessageSink sink_;
    Instance instance_;
    VulkanHandles handles_;
    std::optional<NativeDevice> native_;
    std::optional<Device> device_;
    std::optional<Queue> queue_;
};

void check_host(const BorrowedVulkan& host) {
    const auto refuse_null = [](bool null, const char* field) {
        if (null) throw Error(ErrorCode::invalid_argument, field, "null", "the host's");
    };
    refuse_null(host.instance == VK_NULL_HANDLE, "instance");
    refuse_null(host.physical_device == VK_NULL_HANDLE, "physical_device");
    refuse_null(host.device == VK_NULL_HANDLE, "device");
    refuse_null(host.get_instance_proc_addr == nullptr, "get_instance_proc_addr");
    if (host.api_version < VK_API_VERSION_1_1)
        throw Error(ErrorCode::unsupported, "api_version", version_text(host.api_version), "1.1 or later");
}

void check_family(const PhysicalDevice& physical, const char* field, std::uint32_t family) {
    const std::size_t families = physical.queue_families.size();
    if (family >= families)
        throw Error(ErrorCode::invalid_argument, field, std::to_string(family), "0 to " + std::to_string(families - 1));
    if (!(physical.queue_families[family].queueFlags & VK_QUEUE_COMPUTE_BIT))
        throw Error(ErrorCode::unsupported, field, std::to_string(family), "a family with compute");
}

ContextDesc context_of(const BorrowedVulkan& host) {
    check_host(host);
    ContextDesc context;
    context.functions =
        load_instance_functions(host.get_instance_proc_addr, host.instance, Ownership::borrowed, host.debug_utils);
    context.instance = host.instance;
    context.physical = describe(context.functions, host.physical_device);
    context.device = host.device;
    context.queue_family = host.queue_family;
    if (host.second_queue_family != host.queue_family) context.second_queue_family = host.second_queue_family;
    context.ownership = Ownership::borrowed;
    context.debug_utils = host.debug_utils;
    context.pipeline_cache = host.pipeline_cache;

    if (const std::string problem = problem_of(context.physical, host.enabled_features); !problem.empty())
        throw Error(ErrorCode::unsupported, "the host's device " + problem);
    check_family(context.physical, "queue_family", host.queue_family);
    if (context.second_queue_family != VK_QUEUE_FAMILY_IGNORED)
        check_family(context.physical, "second_queue_family", host.second_queue_family);
    return context;
}

class GuestDevice final : public BorrowedVulkanDevice {
public:
    explicit GuestDevice(const BorrowedVulkan& host) : device_(context_of(host), sink_), list_(device_) {}

    [[nodiscard]] rhi::Device& device() override { return device_; }
    [[nodiscard]] rhi::CommandList& begin_recording(VkCommandBuffer commands, std::uint32_t queue_family) override {
        if (!commands) throw Error(ErrorCode::invalid_argument, "commands", "null", "a command buffer in the recording state");
        const auto& families = device_.context().families;
        if (queue_family == VK_QUEUE_FAMILY_IGNORED) queue_family = families[0];
        if (queue_family != families[0] && queue_family != families[1])
            throw Error(ErrorCode::invalid_argument, "queue_family", std::to_string(queue_family),
                        "BorrowedVulkan's queue_family or second_queue_family");
        if (list_.is_recording()) sink_.misuse("begin_recording: the recording before was not ended and is forgotten");
        list_.begin(commands, queue_family);
        return list_;
    }
    void end_recording() noexcept override { list_.end(); }
    [[nodiscard]] NativeTexture native(rhi::Texture texture) const override { return device_.native(texture); }
    [[nodiscard]] VkBuffer native(rhi::Buffer buffer) const override { return device_.native(buffer); }

private:
    MessageSink sink_;
    Device device_;
    CommandList list_;
};

}  // namespace

VulkanDeviceList list_vulkan_devices(PFN_vkGetInstanceProcAddr loader) {
    VulkanDeviceList list;
    try {
        const MessageSink silent;
        const GlobalFunctions global = open_vulkan(loader);
        list.validation_available = has_layer(global, validation_layer);
        const Instance instance(global, false, silent);
        for (const PhysicalDevice& device : enumerate(instance.functions(), instance.handle()))
            list.devices.push_back(info_of(device, static_cast<std::uint32_t>(list.devices.size())));
        if (list.devices.empty()) list.problem = "no Vulkan driver is installed that works here";
    } catch (const Error& error) {
        list.problem = error.what();
    }
    return list;
}

std::unique_ptr<VulkanDevice> create_vulkan_device(const VulkanDeviceDesc& desc) { return std::make_unique<OwnDevice>(desc); }

std::unique_ptr<BorrowedVulkanDevice> borrow_vulkan_device(const BorrowedVulkan& host) {
    return std::make_unique<GuestDevice>(host);
}

}  // namespace aureole::vulkan
