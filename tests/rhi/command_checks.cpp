// Commands and their order: constants, barriers, draws, timestamps, frames.
#include <bit>
#include <string>

#include "aureole_rhi_tests_shaders.h"
#include "rhi/checks.h"
#include "rhi/harness.h"
#include "rhi/report.h"

namespace aureole::conformance {

using namespace aureole::rhi;

namespace {

/// Uniforms of conformance_constants: vec4, mat4 by columns, vec4.
struct Uniforms {
    float first[4], matrix[16], last[4];
};

/// A pipeline of conformance_constants with its own target and uniforms.
struct ConstantsRig {
    ConstantsRig(Harness& harness, std::span<const Specialization> specialization) : h(harness) {
        image = h.texture("image", Format::rgba32_float, {6, 1, 1}, Usage::storage | Usage::copy_source);
        buffer = h.buffer("uniforms", sizeof(Uniforms), Usage::constants);
        pipeline = h.compute(shaders::conformance_constants, specialization);
        set = h.bind(pipeline, {{0, {}, {}, buffer}, {1, image, {}, {}}});
    }

    void update(const Uniforms& uniforms) {
        h.use(buffer, State::copy_destination);
        h.list().update_constants(buffer, bytes_of(uniforms));
        h.use(buffer, State::constants);
    }
    void dispatch(const std::array<float, 8>& push) {
        h.use(image, State::storage_write);
        h.dispatch(pipeline, set, {1, 1, 1}, bytes_of(push));
    }

    Harness& h;
    Texture image;
    Buffer buffer;
    Pipeline pipeline;
    BindingSet set;
};

}  // namespace

void check_specialization(const Target& target) {
    Harness h(target);
    ConstantsRig plain(h, {});
    plain.update({});
    plain.dispatch({});
    expect_equal("default values", h.read(plain.image)[0], {7, 1, 0.5, 0});

    const Specialization values[] = {{2, std::bit_cast<std::uint32_t>(-3.25f)}, {0, static_cast<std::uint32_t>(-12)}, {1, 0}};
    ConstantsRig special(h, values);
    special.update({});
    special.dispatch({});
    expect_equal("specialized values", h.read(special.image)[0], {-12, 0, -3.25, 0});
}

void check_constants(const Target& target) {
    Harness h(target);
    ConstantsRig rig(h, {});
    Uniforms u{{1, 2, 3, 4}, {}, {-1, 0.5f, 1e6f, 1e-6f}};
    for (int i = 0; i < 16; ++i) u.matrix[i] = static_cast<float>(i);
    rig.update(u);
    rig.dispatch({10, 20, 30, 40, 50, 60, 70, 80});
    const auto got = h.read(rig.image);
    expect_equal("push constants, first vector", got[1], {10, 20, 30, 40});
    expect_equal("push constants, second vector", got[2], {50, 60, 70, 80});
    expect_equal("uniforms, first vector", got[3], {1, 2, 3, 4});
    expect_equal("uniforms, matrix by columns times (1, 10, 100, 1000)", got[4],
                 {0 + 40 + 800 + 12000, 1 + 50 + 900 + 13000, 2 + 60 + 1000 + 14000, 3 + 70 + 1100 + 15000});
    expect_equal("uniforms, last vector", got[5], {-1, 0.5, 1e6, double(1e-6f)});
}

void check_update_order(const Target& target) {
    // One buffer, updated between three dispatches of one list: each sees what was recorded before it.
    Harness h(target);
    ConstantsRig rig(h, {});
    const auto kept = h.texture("kept", Format::rgba32_float, {6, 1, 1}, Usage::copy_source | Usage::copy_destination);
    Uniforms u{};
    u.first[0] = 1;
    rig.update(u);
    rig.dispatch({5});
    h.use(rig.image, State::copy_source);
    h.use(kept, State::copy_destination);
    h.list().copy(TextureToTexture{rig.image, kept});
    u.first[0] = 2;
    rig.update(u);
    rig.dispatch({6});
    const auto second = h.read(rig.image);
    const auto first = h.read(kept);
    expect_equal("uniforms as the first dispatch sees them", first[3][0], 1);
    expect_equal("push constants as the first dispatch sees them", first[1][0], 5);
    expect_equal("uniforms as the second dispatch sees them", second[3][0], 2);
    expect_equal("push constants as the second dispatch sees them", second[1][0], 6);

    // A shorter update leaves the rest.
    h.use(rig.buffer, State::copy_destination);
    const float start[1] = {9};
    h.list().update_constants(rig.buffer, bytes_of(start));
    h.use(rig.buffer, State::constants);
    rig.dispatch({});
    expect_equal("uniforms after an update of four bytes", h.read(rig.image)[3], {9, 0, 0, 0});
}

namespace {

/// Two textures that conformance_increment writes from one into the other and back.
struct PingPong {
    PingPong(Harness& h, Extent size) {
        for (int i = 0; i < 2; ++i)
            image[i] = h.texture(i == 0 ? "ping" : "pong", Format::rgba32_float, size,
                                 Usage::sampled | Usage::storage | Usage::copy_source | Usage::copy_destination);
        h.upload(image[0], pack(Format::rgba32_float, std::vector<Texel>(size.width * size.height, Texel{0, 1, 2, 3})));
        pipeline = h.compute(shaders::conformance_increment);
        const auto sampler = h.sampler(Filter::nearest);
        for (int i = 0; i < 2; ++i) set[i] = h.bind(pipeline, {{0, image[i], sampler, {}}, {1, image[1 - i], {}, {}}});
    }
    /// image[to] = image[1 - to] + amount
    void step(Harness& h, int to, float amount, std::array<std::uint32_t, 3> groups) {
        const float push[4] = {amount, 0, amount, 0};
        h.use(image[1 - to], State::sampled);
        h.use(image[to], State::storage_write);
        h.dispatch(pipeline, set[1 - to], groups, bytes_of(push));
    }
    Texture image[2];
    Pipeline pipeline;
    BindingSet set[2];
};

}  // namespace

void check_barriers(const Target& target) {
    Harness h(target);
    const Extent extent{61, 47, 1};
    PingPong p(h, extent);
    for (int i = 0; i < 100; ++i) p.step(h, 1 - i % 2, static_cast<float>(i % 7), {8, 6, 1});
    double sum = 0;
    for (int i = 0; i < 100; ++i) sum += i % 7;
    expect_equal("after 100 dispatches, each of which reads what the one before has written", h.read(p.image[0]),
                 std::vector<Texel>(extent.width * extent.height, Texel{sum, 1, 2 + sum, 3}));
}

void check_edges(const Target& target) {
    // Groups reach past the image on both sides; what they store there vanishes.
    Harness h(target);
    const Extent extent{9, 3, 1};
    PingPong p(h, extent);
    p.step(h, 1, 1, {5, 4, 1});
    expect_equal("image smaller than its groups", h.read(p.image[1]), std::vector<Texel>(27, Texel{1, 1, 3, 3}));
    // And groups that do not cover the image leave the rest as it was.
    p.step(h, 0, 4, {1, 1, 1});
    const auto got = h.read(p.image[0]);
    expect_equal("last texel of the group", got[7], {5, 1, 7, 3});
    expect_equal("first texel beside the group", got[8], {0, 1, 2, 3});
}

void check_raster(const Target& target) {
    if (!target.device.capabilities().raster) throw Skipped{"Capabilities::raster is false"};
    // The pixel's number counts from the top left, whatever the target's shape.
    for (const Extent extent : {Extent{7, 5, 1}, Extent{1, 9, 1}, Extent{64, 33, 1}}) {
        Harness h(target);
        std::vector<Texel> canvas_texels, wanted;
        for (std::uint32_t y = 0; y < extent.height; ++y)
            for (std::uint32_t x = 0; x < extent.width; ++x) {
                canvas_texels.push_back({0, 0, double(x * y), 0.5});
                wanted.push_back({2.0 * x + 1, 3.0 * y - 1, double(x * y) + 10, 0.5 + 4});
            }
        const auto canvas = h.filled("canvas", extent, canvas_texels);
        const auto image = h.texture("image", Format::rgba32_float, extent, Usage::color_attachment | Usage::copy_source);
        const auto pipeline = h.raster(shaders::conformance_draw, Format::rgba32_float);
        const auto set = h.bind(pipeline, {{0, canvas, h.sampler(Filter::nearest), {}}});
        h.use(image, State::color_attachment);
        const float push[8] = {2, 3, 0, 4, 1, -1, 10, 0};
        h.list().draw_fullscreen({pipeline, set, bytes_of(push), image});
        expect_equal("target of " + std::to_string(extent.width) + "x" + std::to_string(extent.height), h.read(image), wanted);
    }
}

void check_raster_barriers(const Target& target) {
    if (!target.device.capabilities().raster) throw Skipped{"Capabilities::raster is false"};
    // Draws read what dispatches have stored, and dispatches what draws have drawn.
    Harness h(target);
    const Extent extent{33, 17, 1};
    const Usage usage = Usage::sampled | Usage::copy_source | Usage::copy_destination;
    const auto stored = h.texture("stored", Format::rgba32_float, extent, usage | Usage::storage);
    const auto drawn = h.texture("drawn", Format::rgba32_float, extent, usage | Usage::color_attachment);
    h.upload(drawn, pack(Format::rgba32_float, std::vector<Texel>(extent.width * extent.height, Texel{0, 1, 2, 3})));
    const auto step = h.compute(shaders::conformance_increment);
    const auto draw = h.raster(shaders::conformance_draw, Format::rgba32_float);
    const auto sampler = h.sampler(Filter::nearest);
    const auto into_stored = h.bind(step, {{0, drawn, sampler, {}}, {1, stored, {}, {}}});
    const auto into_drawn = h.bind(draw, {{0, stored, sampler, {}}});
    const float amount[4] = {1, 0, 1, 0}, nothing[8] = {};
    for (int i = 0; i < 40; ++i) {
        h.use(drawn, State::sampled);
        h.use(stored, State::storage_write);
        h.dispatch(step, into_stored, {5, 3, 1}, bytes_of(amount));
        h.use(stored, State::sampled);
        h.use(drawn, State::color_attachment);
        h.list().draw_fullscreen({draw, into_drawn, bytes_of(nothing), drawn});
    }
    expect_equal("after 40 dispatches and draws, each of which reads what the one before has written", h.read(drawn),
                 std::vector<Texel>(extent.width * extent.height, Texel{40, 1, 42, 3}));
}

void check_timestamps(const Target& target) {
    const std::uint32_t slots = target.device.capabilities().timestamp_slots;
    if (slots < 3) throw Skipped{"Capabilities::timestamp_slots is below 3"};
    Harness h(target);
    PingPong p(h, {64, 64, 1});
    h.list().timestamp(0);
    p.step(h, 1, 1, {8, 8, 1});
    h.list().timestamp(1);
    p.step(h, 0, 1, {8, 8, 1});
    h.list().timestamp(2);
    h.run();
    double times[3] = {};
    target.device.read_timestamps(times);
    expect(times[0] <= times[1] && times[1] <= times[2], "timestamps do not fall in the order of recording");
    expect(times[2] - times[0] > 0, "time passes between the first timestamp and the third");
    expect(times[2] - times[0] < 60e9, "two dispatches take less than a minute (timestamps are in nanoseconds)");
}

void check_markers_and_messages(const Target& target) {
    Harness h(target);
    std::string messages;
    const auto collect = [](void* user, Severity severity, const char* text) {
        if (severity != Severity::info) *static_cast<std::string*>(user) += std::string(text) + "\n";
    };
    target.device.set_message_callback(collect, &messages);
    h.list().begin_marker("outer");
    h.list().begin_marker("inner");
    PingPong p(h, {8, 8, 1});
    p.step(h, 1, 1, {1, 1, 1});
    h.list().end_marker();
    h.list().end_marker();
    h.run();
    expect(messages.empty(), "correct work brings no warnings and no errors; here: " + messages);

    // Recording never throws: a wrong command is dropped and reported.
    h.list().dispatch({p.pipeline, p.set[0], {}, {1, 1, 1}});  // push constants are missing
    expect(messages.find("conformance_increment") != std::string::npos,
           "a dispatch without its push constants is reported, naming the pipeline; here: " + messages);
    h.run();
    target.device.set_message_callback(nullptr, nullptr);
}

void check_frames(const Target& target) {
    Harness h(target);
    PingPong p(h, {8, 8, 1});
    h.run();
    (void)target.queue.begin();
    const std::uint64_t first = target.queue.submit();  // an empty list is fine
    (void)target.queue.begin();
    const std::uint64_t second = target.queue.submit();
    expect_equal("number of the second frame after the first", double(second - first), 1);
    target.queue.wait();
    target.queue.wait();
    p.step(h, 1, 1, {1, 1, 1});
    expect_equal("texel written after two empty lists", h.read(p.image[1])[0], {1, 1, 3, 3});
}

}  // namespace aureole::conformance
