// Misuse of states and barriers.
#include "test_rig.h"

using namespace aureole::rhi;
using aureole::rhi::validation::Rig;

TEST_CASE("correct use reports nothing, and everything is passed on") {
    Rig r;
    r.prepare();
    r.list->begin_marker("work");
    r.list->timestamp(0);
    r.dispatch(r.lake_to_hill);
    r.move(r.hill, State::storage_write, State::storage_write);
    r.dispatch(r.lake_to_hill);
    r.move(r.hill, State::storage_write, State::copy_source);
    r.move(r.read_back, State::undefined, State::copy_destination);
    r.list->copy(TextureToBuffer{r.hill, r.read_back});
    r.move(r.hill, State::copy_source, State::color_attachment);
    r.list->draw_fullscreen({r.paint, r.paint_lake, {}, r.hill});
    r.list->timestamp(1);
    r.list->end_marker();
    r.submit();
    r.queue->wait();
    std::byte bytes[16];
    double times[2];
    r.device->read_buffer(r.read_back, bytes);
    r.device->read_timestamps(times);
    CHECK(r.passed_on() == 7 + 13);
    CHECK(r.inner.accesses == 3);
    r.destroy_all();
    CHECK(r.inner.destroyed_frames.size() == 10);
    r.device->collect(1);
    CHECK(r.inner.collected_frames == std::vector<std::uint64_t>{1});
    r.queue.reset();
    r.device.reset();
    CHECK(r.messages.empty());
    CHECK(!r.inner.has_callback());
}

TEST_CASE("a read without a barrier after the write") {
    Rig r;
    r.prepare();
    r.dispatch(r.lake_to_hill);
    const auto back = r.set("hill to lake", r.hill, r.lake);
    r.move(r.lake, State::sampled, State::storage_write);
    r.dispatch(back);
    r.check_reported({"dispatch of pipeline \"blur pass\"", "texture \"hill\"", "read without a barrier", "last write"});
    CHECK(r.inner_queue.list.log.back() == "dispatch");  // only ordered wrongly: passed on
}

TEST_CASE("two writes without a barrier between them") {
    Rig r;
    r.prepare();
    r.dispatch(r.lake_to_hill);
    r.dispatch(r.lake_to_hill);
    r.check_reported({"texture \"hill\"", "written without a barrier after its last write"});
    const auto update = std::as_bytes(std::span(r.push));
    r.move(r.frame, State::constants, State::copy_destination);
    r.list->update_constants(r.frame, update);
    r.list->update_constants(r.frame, update);
    r.check_reported({"update_constants", "buffer \"frame\"", "written without a barrier"});
}

TEST_CASE("waiting for the queue ends what was unfinished") {
    Rig r;
    r.prepare();
    r.dispatch(r.lake_to_hill);
    r.submit();
    r.begin();
    r.dispatch(r.lake_to_hill);
    r.check_reported({"texture \"hill\"", "without a barrier"});  // submitting alone is no barrier
    r.submit();
    r.queue->wait();
    r.begin();
    r.dispatch(r.lake_to_hill);
    CHECK(r.messages.empty());
}

TEST_CASE("work in a wrong state") {
    Rig r;
    r.prepare();
    r.move(r.lake, State::sampled, State::copy_source);
    r.dispatch(r.lake_to_hill);
    r.check_reported({"texture \"lake\"", "is in state copy_source", "needed: sampled"});
    r.move(r.lake, State::copy_source, State::sampled);
    r.move(r.hill, State::storage_write, State::sampled);
    r.dispatch(r.lake_to_hill);
    r.check_reported({"texture \"hill\"", "is in state sampled", "needed: storage_write"});
    r.move(r.frame, State::constants, State::copy_destination);
    r.move(r.hill, State::sampled, State::storage_write);
    r.dispatch(r.lake_to_hill);
    r.check_reported({"buffer \"frame\"", "is in state copy_destination", "needed: constants"});
    r.move(r.read_back, State::undefined, State::copy_destination);
    r.list->copy(TextureToBuffer{r.lake, r.read_back});
    r.check_reported({"copy", "texture \"lake\"", "is in state sampled", "needed: copy_source"});
    r.list->draw_fullscreen({r.paint, r.paint_lake, {}, r.lake});
    r.check_reported({"draw_fullscreen of pipeline \"paint pass\"", "texture \"lake\"", "needed: color_attachment"});
}

TEST_CASE("contents that were never written, or thrown away") {
    Rig r;
    r.prepare();
    const auto back = r.set("hill to lake", r.hill, r.lake);
    r.move(r.hill, State::storage_write, State::sampled);
    r.move(r.lake, State::sampled, State::storage_write);
    r.dispatch(back);
    r.check_reported({"texture \"hill\"", "nothing has been written into it"});
    // Written now, then thrown away by a barrier from undefined.
    r.move(r.lake, State::undefined, State::sampled);
    r.move(r.hill, State::sampled, State::storage_write);
    r.dispatch(r.lake_to_hill);
    r.check_reported({"texture \"lake\"", "nothing has been written into it"});
    // A buffer keeps its bytes.
    r.move(r.frame, State::undefined, State::constants);
    r.move(r.hill, State::storage_write, State::storage_write);
    r.move(r.lake, State::sampled, State::copy_destination);
    r.move(r.upload, State::undefined, State::copy_source);
    r.list->copy(BufferToTexture{r.upload, r.lake});
    r.move(r.lake, State::copy_destination, State::sampled);
    r.dispatch(r.lake_to_hill);
    CHECK(r.messages.empty());
}

TEST_CASE("upload buffers start as sources of copies") {
    Rig r;
    r.begin();
    r.device->write_buffer(r.upload, std::as_bytes(std::span(r.push)));
    r.move(r.lake, State::undefined, State::copy_destination);
    r.list->copy(BufferToTexture{r.upload, r.lake});
    CHECK(r.messages.empty());
    const Buffer unwritten = r.device->create_buffer({"unwritten", 8 * 8 * 8, Usage::upload});
    r.move(r.lake, State::copy_destination, State::copy_destination);
    r.list->copy(BufferToTexture{unwritten, r.lake});
    r.check_reported({"buffer \"unwritten\"", "nothing has been written into it"});
}

TEST_CASE("barriers that name a wrong state are told once") {
    Rig r;
    r.prepare();
    r.move(r.lake, State::copy_source, State::copy_destination);
    r.check_reported({"barrier", "texture \"lake\"", "is in state sampled, not in copy_source"});
    r.move(r.lake, State::copy_destination, State::sampled);  // the wrapper followed
    r.move(r.lake, State::sampled, State::undefined);
    r.check_reported({"barrier", "texture \"lake\"", "cannot be moved to state undefined"});
    r.move(r.hill, State::storage_write, State::constants);
    r.check_reported({"texture \"hill\"", "cannot be moved to state constants"});
    r.move(r.frame, State::constants, State::color_attachment);
    r.check_reported({"buffer \"frame\"", "cannot be moved to state color_attachment"});
    r.move(r.upload, State::copy_source, State::copy_destination);
    r.check_reported({"buffer \"upload\"", "has usage upload", "copy_destination"});
    const auto plain = r.texture("plain", Usage::sampled | Usage::copy_destination);
    r.move(plain, State::undefined, State::storage_write);
    r.check_reported({"texture \"plain\"", "usage sampled|copy_destination", "storage_write needs storage"});
    const TextureBarrier twice[] = {{r.hill, State::undefined, State::sampled}, {r.hill, State::undefined, State::sampled}};
    r.list->barrier(twice, {});
    r.check_reported({"texture \"hill\"", "given twice"});
}

TEST_CASE("the general state is for lending: barriers lead out of it and back, and nothing is done in it") {
    Rig r;
    ExternalTexture external{{"host image", Dimension::d2, Format::rgba16_float, {8, 8, 1}, Usage::sampled | Usage::storage}};
    external.state = State::general;
    const auto host = r.device->wrap_texture(external);
    r.prepare();
    const auto from_host = r.set("from host", host, r.hill);
    const auto to_host = r.set("to host", r.lake, host);
    r.dispatch(from_host);
    r.check_reported({"dispatch", "texture \"host image\"", "is in state general", "needed: sampled"});
    r.move(r.hill, State::storage_write, State::storage_write);
    r.dispatch(to_host);
    r.check_reported({"dispatch", "texture \"host image\"", "is in state general", "needed: storage_write"});
    r.move(host, State::general, State::sampled);
    r.dispatch(from_host);
    r.move(host, State::sampled, State::general);
    r.submit();
    CHECK(r.messages.empty());
    r.begin();
    r.move(r.lake, State::sampled, State::general);
    r.check_reported({"barrier", "texture \"lake\"", "cannot be moved to state general"});
    r.move(r.frame, State::constants, State::general);
    r.check_reported({"barrier", "buffer \"frame\"", "cannot be moved to state general"});
}

TEST_CASE("depth textures are read in either sampled state") {
    Rig r;
    r.prepare();
    const auto depth = r.texture("depth", Usage::sampled | Usage::copy_destination, Format::d32_float);
    const auto from_depth = r.set("from depth", depth, r.hill);
    r.move(depth, State::undefined, State::copy_destination);
    r.list->copy(BufferToTexture{r.upload, depth});
    r.move(depth, State::copy_destination, State::depth_read);
    r.dispatch(from_depth);
    r.move(depth, State::depth_read, State::sampled);
    r.move(r.hill, State::storage_write, State::storage_write);
    r.dispatch(from_depth);
    CHECK(r.messages.empty());
    r.move(r.lake, State::sampled, State::depth_read);
    r.move(r.hill, State::storage_write, State::storage_write);
    r.dispatch(r.lake_to_hill);
    r.check_reported({"texture \"lake\"", "is in state depth_read", "needed: sampled"});
}

TEST_CASE("a host's texture is left as it came") {
    Rig r;
    ExternalTexture external{{"host colour", Dimension::d2, Format::rgba16_float, {8, 8, 1}, Usage::sampled | Usage::storage}};
    external.state = State::sampled;
    const auto host = r.device->wrap_texture(external);
    r.prepare();
    const auto from_host = r.set("from host", host, r.hill);
    r.dispatch(from_host);
    CHECK(r.messages.empty());
    r.move(host, State::sampled, State::storage_write);
    r.submit();
    r.check_reported({"end of list", "texture \"host colour\"", "left in state storage_write, not in sampled"});
    r.begin();
    r.move(r.hill, State::storage_write, State::storage_write);
    r.dispatch(from_host);  // the next list starts in the host's state again
    r.submit();
    CHECK(r.messages.empty());
}

TEST_CASE("a host's texture that is destroyed in an open list must be in its state, for nobody can move it any more") {
    Rig r;
    ExternalTexture external{{"host colour", Dimension::d2, Format::rgba16_float, {8, 8, 1}, Usage::sampled | Usage::storage}};
    external.state = State::sampled;
    r.prepare();
    const auto back = r.device->wrap_texture(external), away = r.device->wrap_texture(external);
    for (const auto host : {back, away}) r.move(host, State::sampled, State::storage_write);
    r.move(back, State::storage_write, State::sampled);
    r.device->destroy(back, 1);
    CHECK(r.messages.empty());
    r.device->destroy(away, 1);
    r.check_reported({"destroy", "texture \"host colour\"", "left in state storage_write, not in sampled"});
    r.submit();
    CHECK(r.messages.empty());
}
