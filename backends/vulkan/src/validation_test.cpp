// The validation layer really watches: mistakes made on purpose are found. Without this, its silence elsewhere means nothing.
#include <doctest/doctest.h>

#include "aureole_rhi_tests_shaders.h"
#include "rhi/harness.h"
#include "test_support.h"

using namespace aureole;
using namespace aureole::rhi;
using aureole::vulkan::test::TestDevice;

namespace {

/// Two dispatches, the second reading what the first wrote. `after_write`: the state the texture is moved to between them.
void write_then_read(TestDevice& vulkan, bool barrier_between) {
    conformance::Harness h({vulkan.device(), vulkan.queue()});
    const Usage usage = Usage::sampled | Usage::storage | Usage::copy_destination;
    const auto first = h.texture("first texture", Format::rgba32_float, {8, 8, 1}, usage);
    const auto second = h.texture("second texture", Format::rgba32_float, {8, 8, 1}, usage);
    const auto third = h.texture("third texture", Format::rgba32_float, {8, 8, 1}, usage);
    const auto pipeline = h.compute(shaders::conformance_copy);
    const auto sampler = h.sampler(Filter::nearest);
    const auto one = h.bind(pipeline, {{0, first, sampler, {}}, {1, second, {}, {}}});
    const auto two = h.bind(pipeline, {{0, second, sampler, {}}, {1, third, {}, {}}});
    h.use(first, State::sampled);
    h.use(second, State::storage_write);
    h.use(third, State::storage_write);
    h.dispatch(pipeline, one, {1, 2, 1});
    if (barrier_between) h.use(second, State::sampled);
    h.dispatch(pipeline, two, {1, 2, 1});
    h.run();
}

}  // namespace

TEST_CASE("a missing barrier is found by the synchronization checks, with the texture's name") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice vulkan;
    write_then_read(vulkan, false);
    CHECK(vulkan.messages.mention("SYNC-HAZARD-READ-AFTER-WRITE"));  // the hazard itself
    CHECK(vulkan.messages.mention("VUID-"));                         // and the layout, a core rule
    CHECK(vulkan.messages.mention("second texture"));
    vulkan.messages.texts.clear();

    write_then_read(vulkan, true);
    CHECK(vulkan.messages.joined() == "");
}

TEST_CASE("each kind of reading waits for the write, also after another kind") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice vulkan;
    conformance::Harness h({vulkan.device(), vulkan.queue()});
    // Written by an update, read as constants, then by a copy.
    const auto block = h.buffer("block", 96, Usage::constants | Usage::copy_source);
    const auto image = h.texture("image", Format::rgba32_float, {6, 1, 1}, Usage::storage);
    const auto texture = h.texture("texture", Format::rgba32_float, {6, 1, 1}, Usage::copy_destination | Usage::copy_source);
    const auto pipeline = h.compute(shaders::conformance_constants);
    const auto set = h.bind(pipeline, {{0, {}, {}, block}, {1, image, {}, {}}});
    h.use(block, State::copy_destination);
    const float values[24] = {1, 2, 3, 4};
    h.list().update_constants(block, conformance::bytes_of(values));
    h.use(block, State::constants);
    h.use(image, State::storage_write);
    const float push[8] = {};
    h.dispatch(pipeline, set, {1, 1, 1}, conformance::bytes_of(push));
    h.use(block, State::copy_source);
    h.use(texture, State::copy_destination);
    h.list().copy(BufferToTexture{block, texture});
    CHECK(h.read(texture)[0] == conformance::Texel{1, 2, 3, 4});
    CHECK(vulkan.messages.joined() == "");

    // Its contents are replaced: the copy must be over before.
    h.use(block, State::copy_source);
    h.use(texture, State::copy_destination);
    h.list().copy(BufferToTexture{block, texture});
    const BufferBarrier discard{block, State::undefined, State::copy_destination};
    h.list().barrier({}, {&discard, 1});
    h.list().update_constants(block, conformance::bytes_of(values));
    const BufferBarrier written{block, State::copy_destination, State::copy_source};
    h.list().barrier({}, {&written, 1});
    const TextureBarrier again{texture, State::undefined, State::copy_destination};
    h.list().barrier({&again, 1}, {});
    h.list().copy(BufferToTexture{block, texture});
    h.run();
}

TEST_CASE("findings of the layer reach the device's message callback as errors") {
    AUREOLE_NEEDS_VULKAN;
    struct Seen {
        int errors = 0;
    } seen;
    TestDevice vulkan;
    vulkan.device().set_message_callback(
        [](void* user, Severity severity, const char*) { static_cast<Seen*>(user)->errors += severity == Severity::error; },
        &seen);
    write_then_read(vulkan, true);
    CHECK(seen.errors == 0);
    write_then_read(vulkan, false);
    CHECK(seen.errors > 0);
    vulkan.messages.texts.clear();
}

TEST_CASE("an object that is never destroyed goes with the device") {
    AUREOLE_NEEDS_VULKAN;
    TestDevice vulkan;
    (void)vulkan.device().create_texture({"kept", Dimension::d2, Format::rgba16_float, {4, 4, 1}, Usage::sampled});
    (void)vulkan.device().create_sampler({});
    (void)vulkan.device().create_compute_pipeline({"kept", &shaders::conformance_copy, {}});
    const Texture doomed =
        vulkan.device().create_texture({"doomed", Dimension::d2, Format::rgba16_float, {4, 4, 1}, Usage::sampled});
    vulkan.device().destroy(doomed, 1000);  // a frame that never comes
}
