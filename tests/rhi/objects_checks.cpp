// Capabilities, refusals at creation, and destruction.
#include <aureole/rhi/error.h>
#include <functional>
#include <string>

#include "aureole_rhi_tests_shaders.h"
#include "rhi/checks.h"
#include "rhi/harness.h"
#include "rhi/report.h"

namespace aureole::conformance {

using namespace aureole::rhi;

void check_capabilities(const Target& target) {
    const Capabilities& c = target.device.capabilities();
    expect(!c.backend.empty() && !c.device.empty() && !c.driver.empty(), "Capabilities say backend, device and driver");
    expect(c.max_texture_2d >= 4096, "Capabilities::max_texture_2d is 4096 at least");
    expect(c.max_texture_3d >= 256, "Capabilities::max_texture_3d is 256 at least");
    expect(c.max_texture_cube >= 1024, "Capabilities::max_texture_cube is 1024 at least");
    expect(c.max_push_constant_bytes >= 128, "Capabilities::max_push_constant_bytes is 128 at least");
    // What Aureole's tables need everywhere.
    for (const Dimension dimension : {Dimension::d2, Dimension::d3}) {
        const FormatSupport half = target.device.format_support(Format::rgba16_float, dimension);
        const Context context(to_string(dimension));
        expect(half.sampled && half.linear_filter && half.storage, "rgba16_float can be sampled, filtered and stored to");
        expect(target.device.format_support(Format::rgba32_float, dimension).sampled, "rgba32_float can be sampled");
    }
    const FormatSupport none = target.device.format_support(Format::undefined, Dimension::d2);
    expect(!none.sampled && !none.storage && !none.color_attachment && !none.linear_filter,
           "Format::undefined can be used for nothing");
}

namespace {

/// The call throws an Error with this code that names the object.
void check_refused(const char* what, ErrorCode code, const std::string& name, const std::function<void()>& call) {
    const Context context(what);
    try {
        call();
        fail("was accepted; wanted: an Error that names " + name);
    } catch (const Error& error) {
        expect(error.code() == code, std::string("Error(") + to_string(error.code()) + "); wanted: " + to_string(code));
        expect(std::string(error.what()).find(name) != std::string::npos,
               std::string("\"") + error.what() + "\" does not name " + name);
    }
}

void check_texture_refused(Device& device, const char* what, ErrorCode code, const TextureDesc& desc) {
    check_refused(what, code, "bad texture", [&] { (void)device.create_texture(desc); });
}

}  // namespace

void check_creation_errors(const Target& target) {
    Device& device = target.device;
    const TextureDesc good{"bad texture", Dimension::d2, Format::rgba16_float, {8, 4, 1}, Usage::sampled | Usage::storage};
    const auto invalid = ErrorCode::invalid_argument;
    TextureDesc d = good;
    d.extent.width = 0;
    check_texture_refused(device, "no width", invalid, d);
    d = good, d.extent.height = device.capabilities().max_texture_2d + 1;
    check_texture_refused(device, "too high", ErrorCode::unsupported, d);
    d = good, d.extent.depth = 2;
    check_texture_refused(device, "a deep 2d texture", invalid, d);
    d = good, d.format = Format::undefined;
    check_texture_refused(device, "no format", invalid, d);
    d = good, d.usage = Usage::none;
    check_texture_refused(device, "no usage", invalid, d);
    d = good, d.usage = Usage::sampled | Usage::constants;
    check_texture_refused(device, "a buffer's usage", invalid, d);
    d = good, d.dimension = Dimension::cube;
    check_texture_refused(device, "a cube that is not square", invalid, d);

    check_refused("empty buffer", invalid, "bad buffer", [&] { (void)device.create_buffer({"bad buffer", 0, Usage::upload}); });
    check_refused("useless buffer", invalid, "bad buffer", [&] { (void)device.create_buffer({"bad buffer", 4, Usage::none}); });
    check_refused("no shader", invalid, "bad pipeline", [&] {
        (void)device.create_compute_pipeline({"bad pipeline", nullptr, {}});
    });
    check_refused("fragment shader in a compute pipeline", invalid, "bad pipeline", [&] {
        (void)device.create_compute_pipeline({"bad pipeline", &shaders::conformance_draw, {}});
    });

    Harness h(target);
    const auto pipeline = h.compute(shaders::conformance_copy);
    const auto source = h.texture("source", Format::rgba32_float, {4, 4, 1}, Usage::sampled | Usage::copy_destination);
    const auto image = h.texture("image", Format::rgba32_float, {4, 4, 1}, Usage::storage | Usage::copy_source);
    const auto sampler = h.sampler(Filter::nearest);
    const auto set = [&](const std::vector<Binding>& bindings) {
        return [&device, pipeline, bindings] { (void)device.create_binding_set({"bad set", pipeline, bindings}); };
    };
    const Binding read{0, source, sampler, {}}, write{1, image, {}, {}};
    check_refused("slot left empty", invalid, "target", set({read}));
    check_refused("slot given twice", invalid, "source", set({read, read, write}));
    check_refused("slot that is not there", invalid, "bad set", set({read, write, {7, image, {}, {}}}));
    check_refused("missing usage", invalid, "image", set({{0, image, sampler, {}}, write}));
    check_refused("no sampler", invalid, "source", set({{0, source, {}, {}}, write}));
    check_refused("unknown texture", invalid, "source", set({{0, Texture{999999}, sampler, {}}, write}));
    const auto volume = h.texture("volume", Format::rgba16_float, {4, 4, 4}, Usage::sampled | Usage::storage, Dimension::d3);
    check_refused("wrong dimension", invalid, "volume", set({read, {1, volume, {}, {}}}));
    const auto fine = h.bind(pipeline, {read, write});
    expect(bool(fine), "a good binding set is no null handle");
}

void check_find(const Target& target) {
    // A device may keep no record; what it says must be right.
    Harness h(target);
    const TextureDesc desc{"found", Dimension::d3, Format::rgba16_float, {5, 4, 3}, Usage::sampled | Usage::storage};
    const auto texture = h.texture(desc.name, desc.format, desc.extent, desc.usage, desc.dimension);
    const TextureDesc* found = target.device.find(texture);
    if (!found) throw Skipped{"Device::find keeps no record"};
    expect(found->extent == desc.extent, "find() says the texture's extent");
    expect(found->format == desc.format && found->dimension == desc.dimension,
           "find() says the texture's format and dimension");
    expect(has(found->usage, desc.usage), "find() says the texture's usage");
    expect(target.device.find(Texture{}) == nullptr, "find() of a null handle is null");
    const Texture short_lived = target.device.create_texture(desc);
    target.device.destroy(short_lived, h.frame());
    h.run();
    target.device.collect(h.frame());
    expect(target.device.find(short_lived) == nullptr, "find() of a texture that was destroyed and collected is null");
}

void check_deferred_destroy(const Target& target) {
    Harness h(target);
    const Extent extent{8, 4, 1};
    const std::vector<Texel> texels(32, Texel{1, 2, 3, 4});
    const auto source = h.filled("source", extent, texels);
    const auto image = h.texture("image", Format::rgba32_float, extent, Usage::storage | Usage::copy_source);
    const auto pipeline = h.compute(shaders::conformance_copy);
    h.run();

    // Made, recorded, destroyed, and only then submitted.
    const Sampler sampler = target.device.create_sampler({Filter::nearest});
    const Binding bindings[] = {{0, source, sampler, {}}, {1, image, {}, {}}};
    const BindingSet set = target.device.create_binding_set({"short-lived set", pipeline, bindings});
    const Texture unused =
        target.device.create_texture({"short-lived texture", Dimension::d2, Format::rgba16_float, {64, 64, 1}, Usage::sampled});
    h.use(image, State::storage_write);
    h.dispatch(pipeline, set, {1, 1, 1});
    target.device.destroy(set, h.frame() + 1);
    target.device.destroy(sampler, h.frame() + 1);
    target.device.destroy(unused, 0);
    target.device.destroy(Texture{}, 0);  // null: nothing
    target.device.collect(h.frame());
    expect_equal("texels written with objects that were destroyed before the list was submitted", h.read(image), texels);
}

void check_lent_textures(const Target& target) {
    if (!target.lend) throw Skipped{"Target::lend is empty"};
    Harness h(target);
    const Extent extent{8, 4, 1};
    const Usage usage = Usage::sampled | Usage::storage | Usage::copy_source | Usage::copy_destination;
    const ExternalTexture host = target.lend({"host's texture", Dimension::d2, Format::rgba32_float, extent, usage});
    require(host.state == State::general, "Target::lend lends in State::general");
    const Texture lent = target.device.wrap_texture(host);
    const auto move = [&](Texture texture, State before, State after) {
        const TextureBarrier barrier{texture, before, after};
        h.list().barrier({&barrier, 1}, {});
    };
    const auto pipeline = h.compute(shaders::conformance_copy);
    const auto sampler = h.sampler(Filter::nearest);
    const auto image = h.texture("image", Format::rgba32_float, extent, Usage::storage | Usage::copy_source);
    const auto other = h.filled("other", extent, std::vector<Texel>(32, Texel{5, 6, 7, 8}));
    const auto from_lent = h.bind(pipeline, {{0, lent, sampler, {}}, {1, image, {}, {}}});
    const auto to_lent = h.bind(pipeline, {{0, other, sampler, {}}, {1, lent, {}, {}}});

    // Out of `general`, into every state that work is done in, and back.
    const std::vector<Texel> texels(32, Texel{1, 2, 3, 4});
    const auto packed = pack(Format::rgba32_float, texels);
    const auto upload = h.buffer("upload", packed.size(), Usage::upload);
    target.device.write_buffer(upload, packed);
    h.use(upload, State::copy_source);
    move(lent, State::general, State::copy_destination);
    h.list().copy(BufferToTexture{upload, lent});
    move(lent, State::copy_destination, State::general);
    h.run();
    move(lent, State::general, State::sampled);
    h.use(image, State::storage_write);
    h.dispatch(pipeline, from_lent, {1, 1, 1});
    move(lent, State::sampled, State::storage_write);
    h.dispatch(pipeline, to_lent, {1, 1, 1});
    move(lent, State::storage_write, State::general);
    expect_equal("texels of the lent texture, as a shader reads them", h.read(image), texels);

    // Lent a second time, and destroyed where it cannot be moved back any more: the device does that at the end of the list.
    ExternalTexture again = host;
    again.desc.name = "bad guest";
    const Texture doomed = target.device.wrap_texture(again);
    move(doomed, State::general, State::storage_write);
    target.device.destroy(doomed, h.frame() + 1);
    h.run();
    const auto read_back = h.buffer("read-back", packed.size(), Usage::read_back);
    h.use(read_back, State::copy_destination);
    move(lent, State::general, State::copy_source);
    h.list().copy(TextureToBuffer{lent, read_back});
    move(lent, State::copy_source, State::general);
    h.run();
    std::vector<std::byte> got(packed.size());
    target.device.read_buffer(read_back, got);
    expect_equal("texels that a shader has stored to the lent texture", unpack(Format::rgba32_float, got),
                 std::vector<Texel>(32, Texel{5, 6, 7, 8}));

    const auto refused = [&](const char* what, State state, Usage allowed) {
        ExternalTexture bad = host;
        bad.desc.name = "bad texture";
        bad.desc.usage = allowed;
        bad.state = state;
        check_refused(what, ErrorCode::invalid_argument, "bad texture", [&] { (void)target.device.wrap_texture(bad); });
    };
    refused("a state of buffers", State::constants, usage);
    refused("storage writes without the usage", State::storage_write, Usage::sampled);
    refused("depth without a depth format", State::depth_read, usage);
    target.device.destroy(lent, h.frame());
}

}  // namespace aureole::conformance
