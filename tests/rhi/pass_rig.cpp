#include "rhi/pass_rig.h"

#include <aureole/rhi/checks.h>
#include <aureole/rhi/texel.h>

#include <algorithm>
#include <cmath>

namespace aureole::conformance {
namespace {

void move(rhi::CommandList& commands, rhi::Texture texture, rhi::State before, rhi::State after) {
    const rhi::TextureBarrier barrier{texture, before, after};
    commands.barrier({&barrier, 1}, {});
}

void collect(void* user, rhi::Severity severity, const char* text) {
    if (severity != rhi::Severity::info) *static_cast<std::string*>(user) += std::string(text) + "\n";
}

/// Tables are in half floats where the device cannot store and filter 32-bit ones.
PassSetup with_formats_of(const rhi::Device& device, PassSetup setup) {
    const auto takes_floats = [&](rhi::Dimension dimension) {
        const rhi::FormatSupport support = device.format_support(rhi::Format::rgba32_float, dimension);
        return support.sampled && support.linear_filter && support.storage;
    };
    if (!takes_floats(rhi::Dimension::d2)) setup.quality.table_format = rhi::Format::rgba16_float;
    if (!takes_floats(rhi::Dimension::d3)) setup.quality.froxel_format = rhi::Format::rgba16_float;
    return setup;
}

}  // namespace

rhi::FormatSupport TableDevice::format_support(rhi::Format format, rhi::Dimension dimension) const {
    const rhi::FormatSupport a = inner_.format_support(format, dimension), b = other_.format_support(format, dimension);
    return {a.sampled && b.sampled, a.linear_filter && b.linear_filter, a.storage && b.storage,
            a.color_attachment && b.color_attachment};
}

rhi::Texture TableDevice::create_texture(const rhi::TextureDesc& desc) {
    rhi::TextureDesc open = desc;
    open.usage = open.usage | rhi::Usage::copy_source | rhi::Usage::copy_destination;
    const rhi::Texture texture = inner_.create_texture(open);
    descs_[texture.value] = open;
    return texture;
}

PassRig::PassRig(rhi::Device& inner, rhi::Queue& queue, const rhi::Device& other, const PassSetup& setup)
    : device(inner, other), air(device, setup.air, setup.quality), queue_(queue) {
    if (setup.view) view = std::make_unique<View>(air, *setup.view, setup.composite);
}

PassRig::~PassRig() {
    std::for_each(made_.rbegin(), made_.rend(), [&](const auto& handle) { device.destroy(handle, 0); });
}

void PassRig::run(const std::function<void(rhi::CommandList&)>& record) {
    record(queue_.begin());
    queue_.submit();
    queue_.wait();
}

Image PassRig::read(rhi::Texture texture, rhi::State state) {
    const rhi::TextureDesc& desc = device.desc(texture);
    std::vector<std::byte> packed(static_cast<std::size_t>(rhi::packed_size(desc)));
    const rhi::Buffer staging = device.create_buffer({"read-back of " + desc.name, packed.size(), rhi::Usage::read_back});
    const rhi::BufferBarrier writable{staging, rhi::State::undefined, rhi::State::copy_destination};
    run([&](rhi::CommandList& commands) {
        commands.barrier({}, {&writable, 1});
        move(commands, texture, state, rhi::State::copy_source);
        commands.copy(rhi::TextureToBuffer{texture, staging});
        move(commands, texture, rhi::State::copy_source, state);
    });
    device.read_buffer(staging, packed);
    device.destroy(staging, 0);
    Image image{desc.extent, std::vector<glm::dvec4>(packed.size() / rhi::bytes_per_texel(desc.format))};
    rhi::decode_texels(desc.format, packed, std::span(&image.texels[0].x, 4 * image.texels.size()));
    return image;
}

void PassRig::write(rhi::Texture texture, const Image& image, rhi::State state) {
    const rhi::TextureDesc& desc = device.desc(texture);
    std::vector<std::byte> packed(static_cast<std::size_t>(rhi::packed_size(desc)));
    rhi::encode_texels(desc.format, std::span(&image.texels[0].x, 4 * image.texels.size()), packed);
    const rhi::Buffer staging = device.create_buffer({"upload to " + desc.name, packed.size(), rhi::Usage::upload});
    device.write_buffer(staging, packed);
    run([&](rhi::CommandList& commands) {
        move(commands, texture, rhi::State::undefined, rhi::State::copy_destination);
        commands.copy(rhi::BufferToTexture{staging, texture});
        move(commands, texture, rhi::State::copy_destination, state);
    });
    device.destroy(staging, 0);
}

rhi::Texture PassRig::make(const std::string& name, rhi::Format format, const Image& image, rhi::State state) {
    const rhi::Texture texture = device.create_texture({name, rhi::Dimension::d2, format, image.extent, rhi::Usage::sampled});
    made_.emplace_back(texture);
    write(texture, image, state);
    return texture;
}

Image PassRig::show(CompositeTargets targets, rhi::Format format, bool drawn) {
    const auto usage = drawn ? rhi::Usage::color_attachment : rhi::Usage::storage;
    const auto state = drawn ? rhi::State::color_attachment : rhi::State::storage_write;
    targets.target = device.create_texture({"target", rhi::Dimension::d2, format, targets.extent, usage});
    made_.emplace_back(targets.target);
    view->prepare_composite(targets);
    run([&](rhi::CommandList& commands) {
        move(commands, targets.target, rhi::State::undefined, state);
        view->record_composite(commands, targets);
    });
    return read(targets.target, state);
}

PassPair::Listener::Listener(rhi::Device& to) : device(to) { device.set_message_callback(collect, &complaints); }

PassPair::Listener::~Listener() {
    device.set_message_callback(nullptr, nullptr);
    if (!complaints.empty()) fail("the device complains:\n" + complaints);
}

PassPair::PassPair(const Target& target, const PassSetup& wanted) : listener_(target.device), cpu_(cpu::create_cpu_device()) {
    const PassSetup setup = with_formats_of(target.device, wanted);
    reference = std::make_unique<PassRig>(cpu_->device(), cpu_->queue(), target.device, setup);
    checked = std::make_unique<PassRig>(target.device, target.queue, cpu_->device(), setup);
}

void PassPair::record_air() {
    each([](PassRig& rig) { rig.run([&](rhi::CommandList& commands) { rig.air.record(commands); }); });
}

void PassPair::share_air() const {
    checked->write(checked->air.transmittance_table(), reference->read(reference->air.transmittance_table()));
    checked->write(checked->air.multi_scatter_table(), reference->read(reference->air.multi_scatter_table()));
}

void PassPair::record_view(const Camera& camera, const Sun& sun) {
    each([&](PassRig& rig) {
        rig.view->update(camera, {&sun, 1});
        rig.run([&](rhi::CommandList& commands) { rig.view->record(commands); });
    });
}

PassPair::Tables PassPair::read(const std::function<rhi::Texture(const PassRig&)>& table) const {
    return {checked->read(table(*checked)), reference->read(table(*reference))};
}

std::string PlaceAndHour::name() const { return print(altitude_m) + " m, sun at " + print(elevation_deg) + " deg"; }

void Difference::compare(const PassPair::Tables& tables, std::uint32_t begin, std::uint32_t count, const Measure& measure,
                         const std::string& where) {
    worst_.compare(tables.checked, tables.reference, begin, count, measure, where);
}

void Difference::add(double checked, double reference, double error, const std::string& where) {
    worst_.add(error, checked, reference, where);
}

void Difference::tell(double allowed) const {
    require(worst_.compared(), "internal: nothing was compared");
    const std::string text = quantity_ + " is off by " + worst_.text() + "; allowed: " + passes::print(allowed);
    worst_.error() <= allowed ? note(text) : fail(text);
}

}  // namespace aureole::conformance
