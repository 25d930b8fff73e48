#include "result.h"

#include <doctest/doctest.h>

#include <string>

using namespace aureole;
using namespace aureole::vulkan;

TEST_CASE("success passes, failures say what was called for what") {
    CHECK_NOTHROW(check_result(VK_SUCCESS, "vkCall", "thing"));
    CHECK_NOTHROW(check_result(VK_INCOMPLETE, "vkCall", "thing"));
    try {
        check_result(VK_ERROR_DEVICE_LOST, "vkQueueSubmit", "queue");
        FAIL("did not throw");
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::device_lost);
        CHECK(std::string(error.what()) == "queue: vkQueueSubmit returned VK_ERROR_DEVICE_LOST (-4)");
    }
}

TEST_CASE("results have the codes that a host switches on") {
    for (const VkResult r : {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY, VK_ERROR_TOO_MANY_OBJECTS,
                             VK_ERROR_OUT_OF_POOL_MEMORY, VK_ERROR_FRAGMENTED_POOL, VK_ERROR_MEMORY_MAP_FAILED})
        CHECK(error_code(r) == ErrorCode::out_of_memory);
    for (const VkResult r : {VK_ERROR_FEATURE_NOT_PRESENT, VK_ERROR_EXTENSION_NOT_PRESENT, VK_ERROR_LAYER_NOT_PRESENT,
                             VK_ERROR_FORMAT_NOT_SUPPORTED, VK_ERROR_INCOMPATIBLE_DRIVER, VK_ERROR_INITIALIZATION_FAILED})
        CHECK(error_code(r) == ErrorCode::unsupported);
    CHECK(error_code(VK_ERROR_DEVICE_LOST) == ErrorCode::device_lost);
    CHECK(error_code(VK_ERROR_UNKNOWN) == ErrorCode::internal);
    CHECK(std::string(to_string(VK_ERROR_OUT_OF_DEVICE_MEMORY)) == "VK_ERROR_OUT_OF_DEVICE_MEMORY");
    CHECK(std::string(to_string(static_cast<VkResult>(-123456))) == "VkResult");
}
