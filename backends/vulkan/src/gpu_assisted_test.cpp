// The layer's GPU-assisted checks really watch: a kernel that reads past the end of a buffer is found, as nothing else would.
#include <doctest/doctest.h>

#include "aureole_rhi_tests_shaders.h"
#include "rhi/harness.h"
#include "test_support.h"
#include "vulkan_test_shaders.h"

#include <cstdlib>

using namespace aureole;
using namespace aureole::rhi;
using aureole::vulkan::test::TestDevice;

namespace {

/// The layer's own switch, as docs/vulkan.md has it for every program; as it was, afterwards.
class GpuAssisted {
public:
    GpuAssisted() { setenv(name, "VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT", 1); }
    ~GpuAssisted() {
        if (had_)
            setenv(name, before_.c_str(), 1);
        else
            unsetenv(name);
    }
    GpuAssisted(const GpuAssisted&) = delete;
    GpuAssisted& operator=(const GpuAssisted&) = delete;

private:
    static constexpr const char* name = "VK_LAYER_ENABLES";
    bool had_ = std::getenv(name) != nullptr;
    std::string before_ = had_ ? std::getenv(name) : "";
};

}  // namespace

TEST_CASE("a read past the end of a buffer is found by the GPU-assisted checks") {
    AUREOLE_NEEDS_VULKAN;
    const GpuAssisted switched_on;
    TestDevice vulkan;
    const auto read_row = [&](float row) {
        conformance::Harness h({vulkan.device(), vulkan.queue()});
        const auto table = h.buffer("table", 64, Usage::constants);
        const auto target = h.texture("target", Format::rgba32_float, {1, 1, 1}, Usage::storage);
        const auto pipeline = h.compute(shaders::out_of_bounds);
        const auto set = h.bind(pipeline, {{0, {}, {}, table}, {1, target, {}, {}}});
        h.use(table, State::copy_destination);
        const float rows[16] = {};
        h.list().update_constants(table, conformance::bytes_of(rows));
        h.use(table, State::constants);
        h.use(target, State::storage_write);
        const float push[4] = {row, 0, 0, 0};
        h.dispatch(pipeline, set, {1, 1, 1}, conformance::bytes_of(push));
        h.run();
    };
    read_row(3);
    CHECK(vulkan.messages.joined() == "");
    read_row(4);
    CHECK(vulkan.messages.mention("highest byte accessed"));
    vulkan.messages.texts.clear();
}
