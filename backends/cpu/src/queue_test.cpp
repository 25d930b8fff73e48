// Failures while recording and running, and what recording costs.
#include <doctest/doctest.h>

#include <array>

#include "allocation_counter.h"
#include "test_kernels.h"

using namespace aureole;
using namespace aureole::cpu;
using rhi::Format;

TEST_CASE("failures of kernels come out of submit as errors, and the queue goes on") {
    const auto d = create_cpu_device({.threads = 2});
    const auto target = make_texture(*d, Format::rgba8_unorm, {64, 64, 1});
    const struct {
        std::uint32_t how;
        ErrorCode code;
        const char* words;
    } cases[] = {{1, ErrorCode::internal, "the kernel is tired"},
                 {2, ErrorCode::out_of_memory, "not enough memory"},
                 {3, ErrorCode::internal, "a kernel failed"},
                 {4, ErrorCode::unsupported, "no such thing"}};
    for (const auto& c : cases) {
        const rhi::Specialization how[] = {{0, c.how}};
        const auto pipeline = d->device().create_compute_pipeline({"failing pass", &failing_shader, how});
        const auto set = d->device().create_binding_set({"set", pipeline, std::array{rhi::Binding{0, target, {}, {}}}});
        d->queue().begin().dispatch({pipeline, set, {}, {8, 16, 1}});
        try {
            d->queue().submit();
            FAIL("the failure was lost");
        } catch (const Error& error) {
            CHECK(error.code() == c.code);
            CHECK(std::string(error.what()).find(c.words) != std::string::npos);
        }
    }
    const auto pipeline = d->device().create_compute_pipeline({"failing pass", &failing_shader, {}});
    const auto set = d->device().create_binding_set({"set", pipeline, std::array{rhi::Binding{0, target, {}, {}}}});
    d->queue().begin().dispatch({pipeline, set, {}, {8, 16, 1}});
    CHECK(d->queue().submit() == 1);  // failed frames do not count
    for (const double texel : d->read_texels_double(target)) CHECK(texel == 1);
}

TEST_CASE("begin and submit in the wrong order") {
    const auto d = create_cpu_device({});
    CHECK_THROWS_AS(d->queue().submit(), Error);
    (void)d->queue().begin();
    CHECK_THROWS_AS((void)d->queue().begin(), Error);
    CHECK(d->queue().submit() == 1);
}

TEST_CASE("an object freed between recording and submitting is an error, not a crash") {
    const auto d = create_cpu_device({});
    const auto target = make_texture(*d, Format::rgba8_unorm, {8, 8, 1});
    const auto pipeline = d->device().create_raster_pipeline({"pixel pass", &pixel_shader, {}, Format::rgba8_unorm});
    d->queue().begin().draw_fullscreen({pipeline, {}, {}, target});
    d->device().destroy(target, 3);
    d->device().collect(2);
    CHECK(d->queue().submit() == 1);  // still there
    d->queue().begin().draw_fullscreen({pipeline, {}, {}, make_texture(*d, Format::rgba8_unorm, {8, 8, 1})});
    d->device().destroy(pipeline, 3);
    d->device().collect(3);
    try {
        d->queue().submit();
        FAIL("was accepted");
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::misuse);
        CHECK(std::string(error.what()).find("pipeline was freed") != std::string::npos);
    }
}

TEST_CASE("wrong commands are reported by name and dropped") {
    const auto d = create_cpu_device({});
    std::vector<std::string> messages;
    d->device().set_message_callback(
        [](void* user, rhi::Severity, const char* text) { static_cast<std::vector<std::string>*>(user)->emplace_back(text); },
        &messages);
    const auto small = d->device().create_buffer({"small", 8, rhi::Usage::read_back | rhi::Usage::constants});
    const auto texture = make_texture(*d, Format::rgba8_unorm, {8, 8, 1});
    auto& list = d->queue().begin();
    list.copy(rhi::TextureToBuffer{texture, small});
    list.copy(rhi::TextureToBuffer{texture, rhi::Buffer{99}});
    const std::array<std::byte, 16> block{};
    list.update_constants(small, block);
    list.timestamp(1u << 20);
    list.dispatch({rhi::Pipeline{98}, {}, {}, {1, 1, 1}});
    const rhi::TextureBarrier barrier{rhi::Texture{97}, rhi::State::undefined, rhi::State::sampled};
    list.barrier({&barrier, 1}, {});
    d->device().destroy(rhi::Texture{96}, 0);
    const auto gone = make_texture(*d, Format::rgba8_unorm, {8, 8, 1});
    d->device().destroy(gone, 99);
    list.copy(rhi::TextureToTexture{gone, texture});  // it is still there, but may no longer be recorded
    d->device().destroy(gone, 99);
    CHECK(messages.size() == 9);
    CHECK(messages.at(0).find("buffer \"small\" has 8 bytes") != std::string::npos);
    CHECK(d->queue().submit() == 1);
    std::byte bytes[9];
    CHECK_THROWS_AS(d->device().read_buffer(small, bytes), Error);
    CHECK_THROWS_AS(d->device().write_buffer(small, std::span(bytes).first(4)), Error);
    std::vector<double> times(2000);
    CHECK_THROWS_AS(d->device().read_timestamps(times), Error);
}

TEST_CASE("recording the same work again allocates nothing") {
    const auto d = create_cpu_device({});
    const auto source = make_texture(*d, Format::rgba32_float, {8, 8, 1}),
               target = make_texture(*d, Format::rgba32_float, {8, 8, 1});
    const auto pipeline = d->device().create_compute_pipeline({"thirds pass", &thirds_shader, {}});
    const auto draw = d->device().create_raster_pipeline({"pixel pass", &pixel_shader, {}, Format::rgba32_float});
    const rhi::Binding bindings[] = {{0, source, d->device().create_sampler({}), {}}, {1, target, {}, {}}};
    const auto set = d->device().create_binding_set({"thirds set", pipeline, bindings});
    const auto constants = d->device().create_buffer({"constants", 65536, rhi::Usage::constants});
    const auto read_back = d->device().create_buffer({"read back", 8 * 8 * 16, rhi::Usage::read_back});
    const std::vector<std::byte> block(65536);
    const rhi::TextureBarrier barriers[] = {{target, rhi::State::storage_write, rhi::State::copy_source},
                                            {source, rhi::State::sampled, rhi::State::copy_destination}};
    for (int frame = 0; frame < 3; ++frame) {
        auto& list = d->queue().begin();
        begin_counting_allocations();
        for (int i = 0; i < 10; ++i) {
            list.begin_marker("pass");
            list.update_constants(constants, block);
            list.dispatch({pipeline, set, {}, {1, 2, 1}});
            list.barrier(barriers, {});
            list.draw_fullscreen({draw, {}, {}, source});
            list.copy(rhi::TextureToTexture{target, source});
            list.copy(rhi::TextureToBuffer{target, read_back});
            list.timestamp(3);
            list.end_marker();
        }
        const int allocations = end_counting_allocations();
        CAPTURE(frame);
        CHECK((frame == 0) == (allocations > 0));  // the first frame finds out how much memory is needed
        d->queue().submit();
    }
}
