// Every Vulkan call that may fail, failing at each time it is made: one Error that names the call, nothing leaks, and the same
// device works afterwards.
#include <aureole/rhi/error.h>
#include <doctest/doctest.h>

#include <array>
#include <map>
#include <optional>

#include "aureole_rhi_tests_shaders.h"
#include "result.h"
#include "rhi/harness.h"
#include "test_loader.h"
#include "test_support.h"

using namespace aureole;
using namespace aureole::rhi;
using namespace aureole::vulkan;
using namespace aureole::vulkan::test;

namespace {

/// What fails next, and when: the call of this name after `more` further ones.
struct Fault {
    std::string call;
    int more = 0;
    VkResult result = VK_SUCCESS;
};
std::optional<Fault> fault;
std::map<std::string, int> calls;  ///< How often each was made.

/// The result to fail with, once.
std::optional<VkResult> due(const char* call) {
    ++calls[call];
    if (!fault || fault->call != call || fault->more-- > 0) return std::nullopt;
    const VkResult result = fault->result;
    fault.reset();
    return result;
}

/// Stands for a function of Vulkan. One that waits does so before it fails: the device is not lost in truth, and what it works
/// at may not be freed under it.
template <class Function, const auto& Name>
struct Failing;
template <class... Arguments, const auto& Name>
struct Failing<VkResult (*)(Arguments...), Name> {
    static VkResult call(Arguments... arguments) {
        using Function = VkResult (*)(Arguments...);
        const std::optional<VkResult> failure = due(Name.data());
        if (failure && std::string(Name.data()) != "vkWaitForFences") return *failure;
        const VkResult truth = truth_of<Function>(Name.data())(arguments...);
        return failure ? *failure : truth;
    }
};

/// The functions that may fail, by which errors the specification gives them.
#define AUREOLE_FALLIBLE_FUNCTIONS(X) \
    X(vkAllocateCommandBuffers)       \
    X(vkAllocateDescriptorSets)       \
    X(vkAllocateMemory)               \
    X(vkBeginCommandBuffer)           \
    X(vkBindBufferMemory)             \
    X(vkBindImageMemory)              \
    X(vkCreateBuffer)                 \
    X(vkCreateCommandPool)            \
    X(vkCreateComputePipelines)       \
    X(vkCreateDescriptorPool)         \
    X(vkCreateDescriptorSetLayout)    \
    X(vkCreateDevice)                 \
    X(vkCreateFence)                  \
    X(vkCreateFramebuffer)            \
    X(vkCreateGraphicsPipelines)      \
    X(vkCreateImage)                  \
    X(vkCreateImageView)              \
    X(vkCreateInstance)               \
    X(vkCreatePipelineCache)          \
    X(vkCreatePipelineLayout)         \
    X(vkCreateQueryPool)              \
    X(vkCreateRenderPass)             \
    X(vkCreateSampler)                \
    X(vkCreateShaderModule)           \
    X(vkEndCommandBuffer)             \
    X(vkGetQueryPoolResults)          \
    X(vkMapMemory)                    \
    X(vkQueueSubmit)                  \
    X(vkResetCommandPool)             \
    X(vkResetFences)                  \
    X(vkWaitForFences)

#define AUREOLE_NAME(name) constexpr std::array name_of_##name = std::to_array(#name);
AUREOLE_FALLIBLE_FUNCTIONS(AUREOLE_NAME)
#undef AUREOLE_NAME

std::vector<std::string> fallible_functions() {
    return {
#define AUREOLE_NAME(name) #name,
        AUREOLE_FALLIBLE_FUNCTIONS(AUREOLE_NAME)
#undef AUREOLE_NAME
    };
}

void replace_all(Lies& lies) {
#define AUREOLE_TELL(name) lies.tell(#name, &Failing<PFN_##name, name_of_##name>::call);
    AUREOLE_FALLIBLE_FUNCTIONS(AUREOLE_TELL)
#undef AUREOLE_TELL
}

std::vector<VkResult> failures_of(const std::string& call) {
    std::vector<VkResult> results{VK_ERROR_OUT_OF_DEVICE_MEMORY};
    for (const char* lossy : {"vkCreateDevice", "vkGetQueryPoolResults", "vkQueueSubmit", "vkWaitForFences"})
        if (call == lossy) results.push_back(VK_ERROR_DEVICE_LOST);
    if (call == "vkMapMemory") results.push_back(VK_ERROR_MEMORY_MAP_FAILED);
    // A driver's compiler that gives up: VK_NV_glsl_shader's name for it, and no name at all.
    for (const char* compiler : {"vkCreateShaderModule", "vkCreateComputePipelines", "vkCreateGraphicsPipelines"})
        if (call == compiler) results.insert(results.end(), {VK_ERROR_INVALID_SHADER_NV, VK_ERROR_UNKNOWN});
    return results;
}

/// A frame with one of everything, on objects that go with it. Returns what the first texel holds: 3.
double frame(VulkanDevice& vulkan) {
    conformance::Harness h({vulkan.device(), vulkan.queue()});
    const auto source = h.filled("source", {2, 1, 1}, {{3, 0, 0, 0}, {3, 0, 0, 0}});
    const auto image = h.texture("image", Format::rgba32_float, {2, 1, 1}, Usage::storage | Usage::copy_source);
    const auto target = h.texture("target", Format::rgba16_float, {4, 4, 1}, Usage::color_attachment | Usage::copy_source);
    const auto copy = h.compute(shaders::conformance_copy);
    (void)h.raster(shaders::conformance_draw, Format::rgba16_float);
    const auto bindings = h.bind(copy, {{0, source, h.sampler(Filter::nearest), {}}, {1, image, {}, {}}});
    h.use(source, State::sampled);
    h.use(image, State::storage_write);
    h.use(target, State::color_attachment);
    h.list().timestamp(0);
    h.dispatch(copy, bindings, {1, 1, 1});
    h.run();
    double time = 0;
    vulkan.device().read_timestamps({&time, 1});
    return h.read(image)[0][0];
}

VulkanDeviceDesc lied_to() {
    VulkanDeviceDesc desc;
    desc.loader = lying_loader();
    return desc;
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("injected failures: whatever call fails whenever, one Error names it, nothing leaks, and the device goes on") {
    AUREOLE_NEEDS_VULKAN;
    Lies lies;
    replace_all(lies);
    calls.clear();
    std::map<std::string, int> to_open;
    {
        TestDevice vulkan(lied_to());
        to_open = calls;
        calls.clear();
        CHECK(frame(vulkan.native()) == 3);
    }
    const std::map<std::string, int> to_draw = calls;
    for (const std::string& call : fallible_functions()) {
        CAPTURE(call);
        CHECK(to_open.count(call) + to_draw.count(call) > 0);  // or it is not tested
        for (const VkResult result : failures_of(call)) {
            const auto check = [&](const Error& error) {
                const std::string said = error.what();
                CAPTURE(said);
                CHECK(error.code() == error_code(result));
                CHECK(mentions(said, call + " returned "));
                CHECK(mentions(said, std::to_string(static_cast<int>(result))));
                CHECK(!fault);  // it was that one
            };
            const auto count = [&](const std::map<std::string, int>& made) {
                const auto found = made.find(call);
                return found == made.end() ? 0 : found->second;
            };
            for (int more = 0; more < count(to_open); ++more) {
                CAPTURE(more);
                fault = Fault{call, more, result};
                try {
                    const TestDevice vulkan(lied_to());
                    FAIL_CHECK("a device was made");
                } catch (const Error& error) {
                    check(error);
                }
                fault.reset();
            }
            TestDevice vulkan(lied_to());  // fails the test if the layer finds anything, or anything is left
            for (int more = 0; more < count(to_draw); ++more) {
                CAPTURE(more);
                fault = Fault{call, more, result};
                try {
                    (void)frame(vulkan.native());
                    FAIL_CHECK("a frame was drawn");
                } catch (const Error& error) {
                    check(error);
                }
                fault.reset();
            }
            CHECK(frame(vulkan.native()) == 3);
        }
    }
}
