#include "test_host.h"

#include <doctest/doctest.h>

namespace aureole::vulkan::test {
namespace {

constexpr VkDeviceSize staging_size = 1 << 20;

}  // namespace

Host::Host(bool validation) : validation_(validation) {
    VkApplicationInfo application = {};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_1;
    const VkValidationFeatureEnableEXT enabled[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features = {};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = enabled;
    const char* layers[] = {"VK_LAYER_KHRONOS_validation"};
    const char* extensions[] = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    VkInstanceCreateInfo instance = {};
    instance.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    instance.pApplicationInfo = &application;
    if (validation) {
        instance.pNext = &features;
        instance.enabledLayerCount = 1;
        instance.ppEnabledLayerNames = layers;
        instance.enabledExtensionCount = 2;
        instance.ppEnabledExtensionNames = extensions;
    }
    REQUIRE(vkCreateInstance(&instance, nullptr, &instance_) == VK_SUCCESS);
    if (validation) messenger_ = std::make_unique<Messenger>(instance_, messages);
    std::uint32_t count = 1;
    REQUIRE(vkEnumeratePhysicalDevices(instance_, &count, &physical_) >= VK_SUCCESS);

    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue = {};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const VkPhysicalDeviceFeatures enabled_features = lend().enabled_features;
    VkDeviceCreateInfo device = {};
    device.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    device.queueCreateInfoCount = 1;
    device.pQueueCreateInfos = &queue;
    device.pEnabledFeatures = &enabled_features;
    REQUIRE(vkCreateDevice(physical_, &device, nullptr, &device_) == VK_SUCCESS);
    vkGetDeviceQueue(device_, 0, 0, &queue_);

    VkCommandPoolCreateInfo pool = {};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    REQUIRE(vkCreateCommandPool(device_, &pool, nullptr, &pool_) == VK_SUCCESS);
    VkCommandBufferAllocateInfo commands = {};
    commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    commands.commandPool = pool_;
    commands.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    commands.commandBufferCount = 1;
    REQUIRE(vkAllocateCommandBuffers(device_, &commands, &commands_) == VK_SUCCESS);
    staging_ = &make_buffer(staging_size, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
}

Host::~Host() {
    for (const auto& image : images_) {
        vkDestroyImage(device_, image->image, nullptr);
        vkFreeMemory(device_, image->memory, nullptr);
    }
    for (const auto& buffer : buffers_) {
        vkDestroyBuffer(device_, buffer->buffer, nullptr);
        vkFreeMemory(device_, buffer->memory, nullptr);
    }
    vkDestroyPipelineCache(device_, pipeline_cache_, nullptr);
    vkDestroyCommandPool(device_, pool_, nullptr);
    vkDestroyDevice(device_, nullptr);
    messenger_.reset();
    vkDestroyInstance(instance_, nullptr);
    CHECK(messages.joined() == "");
}

BorrowedVulkan Host::lend() const {
    BorrowedVulkan host;
    host.instance = instance_;
    host.physical_device = physical_;
    host.device = device_;
    host.get_instance_proc_addr = vkGetInstanceProcAddr;
    host.api_version = VK_API_VERSION_1_1;
    host.queue_family = 0;
    host.enabled_features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
    host.debug_utils = validation_;
    return host;
}

VkPipelineCache Host::make_pipeline_cache() {
    VkPipelineCacheCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    REQUIRE(vkCreatePipelineCache(device_, &info, nullptr, &pipeline_cache_) == VK_SUCCESS);
    return pipeline_cache_;
}

std::uint32_t Host::memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const {
    VkPhysicalDeviceMemoryProperties memory = {};
    vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
        if ((allowed & (1u << i)) && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    FAIL("no such memory");
    return 0;
}

HostBuffer& Host::make_buffer(VkDeviceSize size, VkBufferUsageFlags usage) {
    HostBuffer& made = *buffers_.emplace_back(std::make_unique<HostBuffer>());
    VkBufferCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = size;
    info.usage = usage;
    REQUIRE(vkCreateBuffer(device_, &info, nullptr, &made.buffer) == VK_SUCCESS);
    VkMemoryRequirements need = {};
    vkGetBufferMemoryRequirements(device_, made.buffer, &need);
    VkMemoryAllocateInfo memory = {};
    memory.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    memory.allocationSize = need.size;
    memory.memoryTypeIndex =
        memory_type(need.memoryTypeBits, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    REQUIRE(vkAllocateMemory(device_, &memory, nullptr, &made.memory) == VK_SUCCESS);
    REQUIRE(vkBindBufferMemory(device_, made.buffer, made.memory, 0) == VK_SUCCESS);
    void* bytes = nullptr;
    REQUIRE(vkMapMemory(device_, made.memory, 0, VK_WHOLE_SIZE, 0, &bytes) == VK_SUCCESS);
    made.bytes = {static_cast<std::byte*>(bytes), static_cast<std::size_t>(size)};
    return made;
}

HostImage& Host::make_image(VkImageCreateInfo info, VkImageAspectFlags aspect) {
    HostImage& made = *images_.emplace_back(std::make_unique<HostImage>());
    made.aspect = aspect;
    made.layers = info.arrayLayers;
    REQUIRE(vkCreateImage(device_, &info, nullptr, &made.image) == VK_SUCCESS);
    VkMemoryRequirements need = {};
    vkGetImageMemoryRequirements(device_, made.image, &need);
    VkMemoryAllocateInfo memory = {};
    memory.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    memory.allocationSize = need.size;
    memory.memoryTypeIndex = memory_type(need.memoryTypeBits, 0);
    REQUIRE(vkAllocateMemory(device_, &memory, nullptr, &made.memory) == VK_SUCCESS);
    REQUIRE(vkBindImageMemory(device_, made.image, made.memory, 0) == VK_SUCCESS);
    return made;
}

HostImage& Host::make_image_2d(VkFormat format, VkExtent2D extent, VkImageUsageFlags usage) {
    VkImageCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    return make_image(info, format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT);
}

VkCommandBuffer Host::commands() {
    if (recording_) return commands_;
    VkCommandBufferBeginInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    REQUIRE(vkBeginCommandBuffer(commands_, &info) == VK_SUCCESS);
    recording_ = true;
    return commands_;
}

void Host::submit_and_wait() {
    commands();
    REQUIRE(vkEndCommandBuffer(commands_) == VK_SUCCESS);
    recording_ = false;
    VkSubmitInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands_;
    REQUIRE(vkQueueSubmit(queue_, 1, &info, VK_NULL_HANDLE) == VK_SUCCESS);
    REQUIRE(vkQueueWaitIdle(queue_) == VK_SUCCESS);
}

void Host::move(HostImage& image, VkImageLayout layout) {
    VkImageMemoryBarrier barrier = {};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.oldLayout = image.layout;
    barrier.newLayout = layout;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.image;
    barrier.subresourceRange = {image.aspect, 0, 1, 0, image.layers};
    vkCmdPipelineBarrier(commands(), VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0,
                         nullptr, 1, &barrier);
    image.layout = layout;
}

void Host::clear_color(HostImage& image, float r, float g, float b, float a) {
    move(image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkClearColorValue color = {{r, g, b, a}};
    const VkImageSubresourceRange range = {image.aspect, 0, 1, 0, image.layers};
    vkCmdClearColorImage(commands(), image.image, image.layout, &color, 1, &range);
}

void Host::clear_depth(HostImage& image, float depth) {
    move(image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkClearDepthStencilValue value = {depth, 0};
    const VkImageSubresourceRange range = {image.aspect, 0, 1, 0, image.layers};
    vkCmdClearDepthStencilImage(commands(), image.image, image.layout, &value, 1, &range);
}

void Host::publish(VkPipelineStageFlags stage, VkAccessFlags writes) {
    VkMemoryBarrier visible = {};
    visible.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    visible.srcAccessMask = writes;
    visible.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands(), stage, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &visible, 0, nullptr, 0, nullptr);
}

void Host::publish_shader_writes() { publish(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT); }

std::vector<std::byte> Host::read(HostImage& image, VkExtent3D extent, std::size_t bytes) {
    const VkImageLayout before = image.layout;
    move(image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkBufferImageCopy region = {};
    region.imageSubresource = {image.aspect, 0, 0, 1};
    region.imageExtent = extent;
    vkCmdCopyImageToBuffer(commands(), image.image, image.layout, staging_->buffer, 1, &region);
    move(image, before);
    publish(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT);
    submit_and_wait();
    REQUIRE(bytes <= staging_size);
    return {staging_->bytes.data(), staging_->bytes.data() + bytes};
}

}  // namespace aureole::vulkan::test
