// Misuse of everything but states.
#include <aureole/rhi/error.h>

#include "test_rig.h"

using namespace aureole::rhi;
using aureole::Error;
using aureole::ErrorCode;
using aureole::rhi::validation::Rig;

TEST_CASE("handles that are unknown or destroyed") {
    Rig r;
    r.prepare();
    const std::size_t before = r.passed_on();
    r.device->destroy(r.paint_lake, 99);
    r.list->draw_fullscreen({r.paint, r.paint_lake, {}, r.hill});
    r.check_reported({"draw_fullscreen", "binding set \"paint lake\"", "after it was destroyed"});
    r.list->dispatch({Pipeline{4711}, r.lake_to_hill, {}, {1, 1, 1}});
    r.check_reported({"dispatch", "unknown pipeline", "4711"});
    r.list->dispatch({{}, r.lake_to_hill, {}, {1, 1, 1}});
    r.check_reported({"dispatch", "no pipeline is given"});
    r.device->destroy(r.lake, 99);
    r.dispatch(r.lake_to_hill);
    r.check_reported({"dispatch", "binding set \"lake to hill\"", "texture \"lake\"", "after it was destroyed"});
    r.move(r.lake, State::sampled, State::copy_source);
    r.check_reported({"barrier", "texture \"lake\"", "after it was destroyed"});
    r.list->copy(TextureToBuffer{r.lake, r.read_back});
    r.check_reported({"copy", "texture \"lake\"", "after it was destroyed"});
    r.device->destroy(r.lake, 99);
    r.check_reported({"destroy", "texture \"lake\"", "after it was destroyed"});
    r.list->update_constants(Buffer{815}, std::as_bytes(std::span(r.push)));
    r.check_reported({"update_constants", "unknown buffer", "815"});
    CHECK(r.passed_on() == before);  // none of this may reach the device
    CHECK_THROWS_AS(r.set("late set", r.lake, r.hill), Error);
    r.check_reported({"binding set \"late set\"", "texture \"lake\"", "after it was destroyed"});
    r.device->destroy(Texture{}, 0);
    CHECK(r.messages.empty());
}

TEST_CASE("what the device refuses at creation is reported with the object's name") {
    Rig r;
    const std::uint64_t before = r.inner.created;
    CHECK_THROWS_AS((void)r.device->create_texture({"wide", Dimension::d2, Format::rgba16_float, {65, 8, 1}, Usage::sampled}),
                    Error);
    r.check_reported({"texture \"wide\" extent.width", "65", "1 to 64"});
    CHECK_THROWS_AS((void)r.device->wrap_texture({{"flat", Dimension::d3, Format::rgba16_float, {8, 8, 0}, Usage::sampled}}),
                    Error);
    r.check_reported({"texture \"flat\" extent.depth", "0"});
    const auto lend = [&](State state, Usage usage) {
        (void)r.device->wrap_texture({.desc = {"lent", Dimension::d2, Format::rgba16_float, {8, 8, 1}, usage}, .state = state});
    };
    CHECK_THROWS_AS(lend(State::constants, Usage::sampled), Error);
    r.check_reported({"texture \"lent\" state", "constants", "a state of textures"});
    CHECK_THROWS_AS(lend(static_cast<State>(77), Usage::sampled), Error);
    r.check_reported({"texture \"lent\" state", "a state of textures"});
    CHECK_THROWS_AS(lend(State::storage_write, Usage::sampled), Error);
    r.check_reported({"texture \"lent\" state", "storage_write", "with usage storage, not sampled"});
    CHECK_THROWS_AS(lend(State::depth_read, Usage::sampled), Error);
    r.check_reported({"texture \"lent\" state", "depth_read", "with format d32_float, not rgba16_float"});
    CHECK_THROWS_AS((void)r.device->create_buffer({"void", 0, Usage::upload}), Error);
    r.check_reported({"buffer \"void\" size", "0"});
    CHECK_THROWS_AS((void)r.device->create_buffer({"wrong", 64, Usage::storage}), Error);
    r.check_reported({"buffer \"wrong\" usage", "storage", "constants"});
    CHECK_THROWS_AS((void)r.device->create_buffer({"large", 65540, Usage::constants}), Error);
    r.check_reported({"buffer \"large\" size", "65540"});
    CHECK_THROWS_AS((void)r.device->create_sampler({static_cast<Filter>(9)}), Error);
    r.check_reported({"sampler filter", "9"});
    CHECK_THROWS_AS((void)r.device->create_compute_pipeline({"none", nullptr, {}}), Error);
    r.check_reported({"pipeline \"none\" shader", "null"});
    const Specialization twice[] = {{3, 1}, {3, 2}};
    CHECK_THROWS_AS((void)r.device->create_compute_pipeline({"double", &validation::compute_shader, twice}), Error);
    r.check_reported({"pipeline \"double\" specialization", "id 3 twice"});
    CHECK_THROWS_AS((void)r.device->create_raster_pipeline({"bare", &validation::draw_shader, {}, Format::rgba32_float}),
                    Error);
    r.check_reported({"pipeline \"bare\" target_format", "rgba32_float"});
    CHECK(r.inner.created == before);
}

TEST_CASE("binding sets with an empty, doubled, unknown or wrongly filled slot") {
    Rig r;
    const Binding input{0, r.lake, r.sampler, {}}, result{1, r.hill, {}, {}}, frame{2, {}, {}, r.frame};
    const auto refuse = [&](std::vector<Binding> bindings, const std::vector<std::string>& words) {
        CHECK_THROWS_AS((void)r.device->create_binding_set({"odd", r.blur, bindings}), Error);
        r.check_reported(words);
    };
    refuse({input, result}, {"binding set \"odd\" slot 2 (frame)", "nothing", "constants"});
    refuse({input, result, result, frame}, {"slot 1 (result)", "2 bindings"});
    refuse({input, result, frame, {5, r.hill, {}, {}}}, {"binding set \"odd\" slot", "5", "blur"});
    refuse({input, {1, {}, {}, r.frame}, frame}, {"slot 1 (result)", "a buffer", "usage storage"});
    refuse({input, result, {2, r.lake, {}, {}}}, {"slot 2 (frame)", "a texture", "usage constants"});
    refuse({input, result, {2, {}, {}, r.upload}}, {"slot 2 (frame)", "buffer \"upload\"", "usage upload"});
    refuse({{0, r.lake, {}, {}}, result, frame}, {"slot 0 (input)", "no sampler"});
    const auto plain = r.texture("plain", Usage::sampled);
    refuse({input, {1, plain, {}, {}}, frame}, {"slot 1 (result)", "texture \"plain\" with usage sampled", "usage storage"});
    const auto volume = r.device->create_texture({"volume", Dimension::d3, Format::rgba16_float, {4, 4, 4}, Usage::sampled});
    refuse({{0, volume, r.sampler, {}}, result, frame}, {"slot 0 (input)", "texture \"volume\" of dimension 3d", "2d"});
    const auto coarse = r.texture("coarse", Usage::sampled, Format::rgba32_float);
    refuse({{0, coarse, r.sampler, {}}, result, frame}, {"slot 0 (input)", "texture \"coarse\"", "linear filter"});
    CHECK_THROWS_AS((void)r.device->create_binding_set({"orphan", Pipeline{99}, {}}), Error);
    r.check_reported({"binding set \"orphan\"", "unknown pipeline"});
}

TEST_CASE("dispatches and draws that do not fit") {
    Rig r;
    r.prepare();
    const std::size_t before = r.passed_on();
    const auto push = std::as_bytes(std::span(r.push));
    r.list->dispatch({r.blur, r.lake_to_hill, push.first(12), {1, 1, 1}});
    r.check_reported({"dispatch", "pipeline \"blur pass\"", "16 bytes of push constants, not 12"});
    r.list->dispatch({r.blur, r.lake_to_hill, push, {1, 0, 1}});
    r.check_reported({"pipeline \"blur pass\" groups[1]", "0", "1 to 65535"});
    r.list->dispatch({r.blur, r.lake_to_hill, push, {1, 1, 65536}});
    r.check_reported({"groups[2]", "65536"});
    r.list->dispatch({r.blur, {}, push, {1, 1, 1}});
    r.check_reported({"no binding set for pipeline \"blur pass\""});
    r.list->dispatch({r.blur, r.paint_lake, push, {1, 1, 1}});
    r.check_reported({"binding set \"paint lake\"", "shader paint", "pipeline \"blur pass\""});
    r.list->dispatch({r.paint, r.paint_lake, {}, {1, 1, 1}});
    r.check_reported({"pipeline \"paint pass\" is a raster pipeline"});
    r.list->draw_fullscreen({r.blur, r.lake_to_hill, push, r.hill});
    r.check_reported({"pipeline \"blur pass\" is a compute pipeline"});
    const auto other = r.texture("other", Usage::color_attachment, Format::rgba8_unorm);
    r.list->draw_fullscreen({r.paint, r.paint_lake, {}, other});
    r.check_reported({"target texture \"other\" is rgba8_unorm", "rgba16_float"});
    const auto plain = r.texture("plain", Usage::sampled);
    r.list->draw_fullscreen({r.paint, r.paint_lake, {}, plain});
    r.check_reported({"target texture \"plain\"", "not color_attachment"});
    r.list->draw_fullscreen({r.paint, r.paint_lake, {}, {}});
    r.check_reported({"draw_fullscreen", "no texture is given"});
    CHECK(r.passed_on() == before);
}

TEST_CASE("updates and copies of a wrong size or usage") {
    Rig r;
    r.prepare();
    const std::size_t before = r.passed_on();
    const std::vector<std::byte> bytes(65540);
    const auto update = [&](Buffer buffer, std::size_t size) {
        r.list->update_constants(buffer, std::span(bytes).first(size));
    };
    update(r.frame, 6);
    r.check_reported({"update_constants", "buffer \"frame\"", "6 bytes"});
    update(r.frame, 0);
    r.check_reported({"buffer \"frame\"", "0 bytes"});
    update(r.frame, 65540);
    r.check_reported({"buffer \"frame\"", "65540 bytes"});
    update(r.frame, 68);
    r.check_reported({"buffer \"frame\" has 64 bytes, not 68"});
    update(r.upload, 16);
    r.check_reported({"buffer \"upload\" has usage upload, not constants"});
    const auto small = r.device->create_buffer({"small", 511, Usage::read_back});
    r.list->copy(TextureToBuffer{r.lake, small});
    r.check_reported({"copy", "buffer \"small\" has 511 bytes", "texture \"lake\" needs 512"});
    r.list->copy(TextureToBuffer{r.lake, r.upload});
    r.check_reported({"copy", "buffer \"upload\"", "not copy_destination"});
    r.list->copy(TextureToTexture{r.lake, r.lake});
    r.check_reported({"copy", "texture \"lake\" is both"});
    const auto other = r.texture("other", Usage::copy_destination, Format::rgba8_unorm);
    r.list->copy(TextureToTexture{r.lake, other});
    r.check_reported({"copy", "texture \"lake\" and texture \"other\" differ"});
    const auto plain = r.texture("plain", Usage::sampled);
    r.list->copy(TextureToTexture{plain, r.hill});
    r.check_reported({"copy", "texture \"plain\" has usage sampled, not copy_source"});
    CHECK(r.passed_on() == before);
}

TEST_CASE("markers, timestamps and lists") {
    Rig r;
    CHECK_THROWS_AS(r.queue->submit(), Error);
    r.check_reported({"submit", "no list"});
    r.begin();
    CHECK_THROWS_AS((void)r.queue->begin(), Error);
    r.check_reported({"begin", "not been submitted"});
    r.list->end_marker();
    r.check_reported({"end_marker", "no marker"});
    r.list->begin_marker(nullptr);
    r.check_reported({"begin_marker", "no name"});
    r.list->timestamp(4);
    r.check_reported({"timestamp", "slot 4", "4"});
    r.list->begin_marker("forgotten");
    r.list->timestamp(0);
    r.submit();
    r.check_reported({"marker \"forgotten\" has not been ended"});
    r.list->timestamp(0);
    r.check_reported({"timestamp", "outside begin and submit"});
    double times[5];
    r.device->read_timestamps(std::span(times).first(1));
    r.check_reported({"read_timestamps", "slot 0 is written by frame 1, which has not finished"});
    r.queue->wait();
    r.device->read_timestamps(std::span(times).first(1));
    CHECK(r.messages.empty());
    r.device->read_timestamps(std::span(times).first(2));
    r.check_reported({"read_timestamps", "slot 1 has never been written"});
    CHECK_THROWS_AS(r.device->read_timestamps(times), Error);
    r.check_reported({"read_timestamps", "5 slots"});
}

TEST_CASE("the CPU's hands on buffers") {
    Rig r;
    std::byte bytes[513] = {};
    const auto span = std::span(bytes);
    CHECK_THROWS_AS(r.device->read_buffer(r.read_back, span.first(4)), Error);
    r.check_reported({"read_buffer", "buffer \"read back\"", "nothing has been written"});
    CHECK_THROWS_AS(r.device->write_buffer(r.read_back, span.first(4)), Error);
    r.check_reported({"write_buffer", "buffer \"read back\" has usage read_back, not upload"});
    CHECK_THROWS_AS(r.device->write_buffer(r.upload, span), Error);
    r.check_reported({"buffer \"upload\" has 512 bytes, not 513"});
    CHECK_THROWS_AS(r.device->write_buffer(Buffer{}, span), Error);
    r.check_reported({"write_buffer", "no buffer is given"});
    r.prepare();
    r.submit();
    CHECK_THROWS_AS(r.device->write_buffer(r.upload, span.first(4)), Error);
    r.check_reported({"buffer \"upload\" is in use by frame 1"});
    r.queue->wait();
    r.device->write_buffer(r.upload, span.first(4));
    CHECK(r.messages.empty());
}

TEST_CASE("objects destroyed too early") {
    Rig r;
    r.prepare();
    r.dispatch(r.lake_to_hill);
    r.submit();
    r.device->destroy(r.lake_to_hill, 0);
    r.check_reported({"destroy", "binding set \"lake to hill\"", "last used by frame 0", "frame 1"});
    CHECK(r.inner.destroyed_frames.back() == 1);  // kept until it is safe
    r.device->destroy(r.hill, 1);
    r.queue->wait();
    r.device->destroy(r.blur, 0);
    CHECK(r.messages.empty());
}

TEST_CASE("objects that are left") {
    Rig r;
    r.device->destroy(r.hill, 0);
    r.queue.reset();
    r.device.reset();
    REQUIRE(r.messages.size() == 9);
    int lakes = 0;
    for (const std::string& text : r.messages) {
        CHECK(text.find("has not been destroyed") != std::string::npos);
        CHECK(text.find("\"hill\"") == std::string::npos);
        lakes += text.find("texture \"lake\"") != std::string::npos;
    }
    CHECK(lakes == 1);
}

TEST_CASE("misuse can be asked to throw, and is counted") {
    Rig r({.throw_on_misuse = true});
    r.prepare();
    CHECK(r.device->misuse_count() == 0);
    try {
        r.list->dispatch({r.blur, r.lake_to_hill, {}, {1, 1, 1}});
        FAIL("nothing was thrown");
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::misuse);
        CHECK(std::string(error.what()) == r.messages.at(0));
    }
    CHECK(r.device->misuse_count() == 1);
    r.messages.clear();
    r.list->begin_marker("open");
    CHECK_THROWS_AS(r.submit(), Error);
    CHECK(r.inner_queue.frame == 1);  // the inner list is not left open
}

TEST_CASE("messages of the inner device pass through, and a host's lists can be wrapped") {
    Rig r;
    r.inner.say(Severity::warning, "from inside");
    r.check_reported({"from inside"});
    CHECK(r.device->misuse_count() == 0);
    validation::NullCommandList host_list;
    CommandList& list = r.device->begin_list(host_list, 1);
    CHECK_THROWS_AS((void)r.device->begin_list(host_list, 1), Error);
    r.check_reported({"begin_list", "not been ended"});
    list.timestamp(1);
    CHECK(host_list.log == std::vector<std::string>{"timestamp 1"});
    r.device->end_list();
    CHECK_THROWS_AS(r.device->end_list(), Error);
    r.check_reported({"end_list", "no list"});
}

TEST_CASE("a host's own lists: what they use is in use until the host says that their frame is complete") {
    Rig r;
    r.queue.reset();
    validation::NullCommandList host_list;
    const auto record_copy = [&](std::uint64_t frame) {
        r.list = &r.device->begin_list(host_list, frame);
        r.move(r.upload, State::undefined, State::copy_source);
        r.move(r.lake, State::undefined, State::copy_destination);
        r.list->copy(BufferToTexture{r.upload, r.lake});
        r.list->timestamp(0);
        CHECK(r.messages.empty());
    };
    std::byte bytes[4] = {};
    double time[1];
    r.device->write_buffer(r.upload, bytes);
    record_copy(7);
    CHECK_THROWS_AS(r.device->write_buffer(r.upload, bytes), Error);
    r.check_reported({"write_buffer", "buffer \"upload\" is in use by frame 7"});
    r.device->read_timestamps(time);
    r.check_reported({"read_timestamps", "slot 0 is written by frame 7, which has not finished"});
    r.device->collect(1000);
    r.check_reported({"collect: frame 1000", "frame 7 is still being recorded"});
    CHECK(r.inner.collected_frames.back() == 6);  // nothing that is in use is freed
    r.device->destroy(r.lake, 6);
    r.check_reported({"destroy", "texture \"lake\"", "last used by frame 6", "frame 7 uses it"});
    CHECK(r.inner.destroyed_frames.back() == 7);
    r.device->end_list();
    CHECK_THROWS_AS(r.device->write_buffer(r.upload, bytes), Error);  // recorded, but not complete
    r.check_reported({"buffer \"upload\" is in use by frame 7"});
    r.device->collect(6);
    CHECK_THROWS_AS(r.device->write_buffer(r.upload, bytes), Error);
    r.check_reported({"buffer \"upload\" is in use by frame 7"});
    r.device->collect(7);
    r.device->write_buffer(r.upload, bytes);
    r.device->read_timestamps(time);
    r.device->destroy(r.upload, 0);
    r.device->collect(12);  // the host's frames go on without us
    CHECK(r.messages.empty());

    for (const std::uint64_t late : {std::uint64_t{0}, std::uint64_t{12}}) {
        (void)r.device->begin_list(host_list, late);
        r.check_reported({"begin_list: frame " + std::to_string(late)});
        r.device->end_list();
    }
    (void)r.device->begin_list(host_list, 20);
    r.device->end_list();
    (void)r.device->begin_list(host_list, 20);  // several lists to a frame
    r.device->end_list();
    CHECK(r.messages.empty());
    (void)r.device->begin_list(host_list, 19);
    r.check_reported({"begin_list: frame 19", "frame 20 has been recorded"});
    r.device->end_list();
}

TEST_CASE("what a list of a host's leaves unfinished ends with its frame, and no earlier") {
    Rig r;
    r.queue.reset();
    validation::NullCommandList host_list;
    const auto record_update = [&](std::uint64_t frame, State before) {
        r.list = &r.device->begin_list(host_list, frame);
        if (before == State::undefined) r.move(r.frame, before, State::copy_destination);
        r.list->update_constants(r.frame, std::as_bytes(std::span(r.push)));
        r.device->end_list();
    };
    record_update(1, State::undefined);
    record_update(2, State::copy_destination);
    r.check_reported({"update_constants", "buffer \"frame\"", "written without a barrier"});
    r.device->collect(1);
    record_update(3, State::copy_destination);
    r.check_reported({"update_constants", "buffer \"frame\"", "written without a barrier"});
    r.device->collect(3);
    record_update(4, State::copy_destination);
    CHECK(r.messages.empty());
}

TEST_CASE("with a queue, no frame is complete that was not submitted") {
    Rig r;
    r.prepare();
    r.submit();
    r.device->collect(2);
    r.check_reported({"collect: frame 2", "the last one submitted is frame 1"});
    CHECK(r.inner.collected_frames.back() == 1);
}
