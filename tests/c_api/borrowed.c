/* A host in C with a Vulkan device of its own, which it lends. */
#include "c_api/borrowed.h"

#include <string.h>
#include <vulkan/vulkan.h>

#include "c_api/check.h"
#include "c_api/picture_by_c.h"

struct host {
    VkInstance instance;
    VkPhysicalDevice physical_device;
    VkDevice device;
    VkQueue queue;
    VkCommandPool pool;
    VkCommandBuffer commands;
    uint32_t family, recorded_for; /* UINT32_MAX: the first, unsaid. */
    VkPhysicalDeviceFeatures features;
};

/* No driver that every machine has offers two families: here one pretends to, with a second that cannot draw. The device makes
 * everything of its true one, which has nothing to share. */
static void VKAPI_CALL two_families(VkPhysicalDevice device, uint32_t* count, VkQueueFamilyProperties* families) {
    uint32_t one = 1;
    VkQueueFamilyProperties truly = {0};
    vkGetPhysicalDeviceQueueFamilyProperties(device, &one, &truly);
    *count = 2;
    if (!families) return;
    families[0] = families[1] = truly;
    families[1].queueFlags = VK_QUEUE_COMPUTE_BIT | VK_QUEUE_TRANSFER_BIT;
    families[1].timestampValidBits = 0;
}
static PFN_vkVoidFunction VKAPI_CALL pretend(VkInstance instance, const char* name) {
    if (strcmp(name, "vkGetPhysicalDeviceQueueFamilyProperties") == 0) return (PFN_vkVoidFunction)two_families;
    return vkGetInstanceProcAddr(instance, name);
}

static uint32_t graphics_family(VkPhysicalDevice device) {
    VkQueueFamilyProperties families[16];
    uint32_t i, count = 16;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families);
    for (i = 0; i < count; ++i)
        if (families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) return i;
    return 0;
}

static void open_host(struct host* host) {
    const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_1};
    const VkInstanceCreateInfo instance = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &application};
    const float priority = 1;
    VkDeviceQueueCreateInfo queue = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
    VkDeviceCreateInfo device = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .queueCreateInfoCount = 1, .pQueueCreateInfos = &queue};
    VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                    .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT};
    VkCommandBufferAllocateInfo commands = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, .commandBufferCount = 1};
    uint32_t count = 1;
    VkResult found;
    CHECK(vkCreateInstance(&instance, NULL, &host->instance) == VK_SUCCESS);
    found = vkEnumeratePhysicalDevices(host->instance, &count, &host->physical_device);
    CHECK((found == VK_SUCCESS || found == VK_INCOMPLETE) && count == 1);
    queue.queueFamilyIndex = pool.queueFamilyIndex = host->family = graphics_family(host->physical_device);
    host->features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
    device.pEnabledFeatures = &host->features;
    CHECK(vkCreateDevice(host->physical_device, &device, NULL, &host->device) == VK_SUCCESS);
    vkGetDeviceQueue(host->device, host->family, 0, &host->queue);
    CHECK(vkCreateCommandPool(host->device, &pool, NULL, &host->pool) == VK_SUCCESS);
    commands.commandPool = host->pool;
    CHECK(vkAllocateCommandBuffers(host->device, &commands, &host->commands) == VK_SUCCESS);
}

static void close_host(struct host* host) {
    vkDestroyCommandPool(host->device, host->pool, NULL);
    vkDestroyDevice(host->device, NULL);
    vkDestroyInstance(host->instance, NULL);
}

static aureole_commands* begin(void* user, aureole_device* device) {
    const VkCommandBufferBeginInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    struct host* host = user;
    aureole_commands* commands = NULL;
    CHECK(vkBeginCommandBuffer(host->commands, &info) == VK_SUCCESS);
    CHECK(aureole_begin_on(device, host->commands, 17, &commands) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strcmp(aureole_last_error_field(), "queue_family") == 0 && strcmp(aureole_last_error_value(), "17") == 0);
    if (host->recorded_for == UINT32_MAX)
        CHECK_OK(aureole_begin(device, host->commands, &commands));
    else
        CHECK_OK(aureole_begin_on(device, host->commands, host->recorded_for, &commands));
    return commands;
}

static void run(void* user, aureole_device* device) {
    struct host* host = user;
    const VkSubmitInfo submit = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &host->commands};
    uint64_t frame = 99;
    CHECK_OK(aureole_end(device, &frame));
    CHECK(frame == 0);
    CHECK(vkEndCommandBuffer(host->commands) == VK_SUCCESS);
    CHECK(vkQueueSubmit(host->queue, 1, &submit, VK_NULL_HANDLE) == VK_SUCCESS);
    CHECK(vkQueueWaitIdle(host->queue) == VK_SUCCESS);
    CHECK(aureole_wait(device) == AUREOLE_UNSUPPORTED);
    CHECK_OK(aureole_collect(device, 1));
}

void picture_on_borrowed_vulkan(struct picture* out, int on_second_family) {
    struct host host = {0};
    struct runner runner = {begin, run, NULL};
    aureole_borrowed_vulkan lent = {.struct_size = sizeof lent};
    aureole_device* device = NULL;
    runner.user = &host;
    open_host(&host);
    host.recorded_for = on_second_family ? 1 : UINT32_MAX;
    CHECK_OK(aureole_borrowed_vulkan_defaults(&lent));
    CHECK(lent.second_queue_family == UINT32_MAX);
    CHECK(aureole_borrow_vulkan_device(&lent, &device) == AUREOLE_INVALID_ARGUMENT); /* nothing is lent yet */
    lent.api_version = VK_API_VERSION_1_1;
    lent.instance = host.instance;
    lent.physical_device = host.physical_device;
    lent.device = host.device;
    lent.get_instance_proc_addr = (void (*)(void))vkGetInstanceProcAddr;
    lent.queue_family = host.family;
    lent.enabled_features = &host.features;
    lent.second_queue_family = 17;
    CHECK(aureole_borrow_vulkan_device(&lent, &device) == AUREOLE_INVALID_ARGUMENT);
    CHECK(strcmp(aureole_last_error_field(), "second_queue_family") == 0);
    lent.second_queue_family = on_second_family ? 1 : host.family;
    if (on_second_family) lent.get_instance_proc_addr = (void (*)(void))pretend;
    CHECK_OK(aureole_borrow_vulkan_device(&lent, &device));
    picture_by_c(device, &runner, out);
    CHECK_OK(aureole_destroy_device(device));
    close_host(&host);
}
