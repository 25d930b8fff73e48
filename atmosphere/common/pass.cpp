#include "common/pass.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace aureole::detail {

Objects::~Objects() {
    // Users before what they use.
    std::for_each(handles_.rbegin(), handles_.rend(), [&](const auto& handle) { device_->destroy(handle, *frame_); });
}

TrackedTexture Objects::texture(const rhi::TextureDesc& desc) {
    handles_.reserve(handles_.size() + 1);  // so that nothing is lost between creation and remembering
    TrackedTexture texture;
    rhi::TextureDesc readable = desc;
    readable.usage = desc.usage | rhi::Usage::copy_source;  // for debuggers and tools, which read tables back
    texture.handle = device_->create_texture(readable);
    handles_.emplace_back(texture.handle);
    texture.extent = desc.extent;
    texture.format = desc.format;
    texture.dimension = desc.dimension;
    texture.bytes =
        std::uint64_t{desc.extent.width} * desc.extent.height * desc.extent.depth * rhi::bytes_per_texel(desc.format);
    texture_bytes_ += texture.bytes;
    return texture;
}

TrackedBuffer Objects::constants(std::string_view name, std::size_t size) {
    handles_.reserve(handles_.size() + 1);
    TrackedBuffer buffer;
    buffer.handle = device_->create_buffer({std::string(name), size, rhi::Usage::constants | rhi::Usage::copy_destination});
    handles_.emplace_back(buffer.handle);
    return buffer;
}

TrackedBuffer Objects::upload(std::string_view name, std::span<const std::byte> bytes) {
    handles_.reserve(handles_.size() + 1);
    TrackedBuffer buffer;
    buffer.handle = device_->create_buffer({std::string(name), bytes.size(), rhi::Usage::upload | rhi::Usage::copy_source});
    handles_.emplace_back(buffer.handle);
    device_->write_buffer(buffer.handle, bytes);
    return buffer;
}

rhi::Sampler Objects::sampler(rhi::Filter filter) {
    handles_.reserve(handles_.size() + 1);
    rhi::SamplerDesc desc;
    desc.filter = filter;
    const rhi::Sampler sampler = device_->create_sampler(desc);
    handles_.emplace_back(sampler);
    return sampler;
}

template <class Create>
rhi::Pipeline Objects::pipeline(const rhi::Shader& shader, std::span<const rhi::Specialization> values, rhi::Format target,
                                const Create& create) {
    const auto same = [](const rhi::Specialization& a, const rhi::Specialization& b) {
        return a.id == b.id && a.bits == b.bits;
    };
    for (const MadePipeline& made : pipelines_)
        if (made.shader == &shader && made.target == target && std::ranges::equal(made.values, values, same))
            return made.handle;
    handles_.reserve(handles_.size() + 1);
    pipelines_.reserve(pipelines_.size() + 1);
    MadePipeline made{&shader, {values.begin(), values.end()}, target, {}};
    made.handle = create();
    handles_.emplace_back(made.handle);
    pipelines_.push_back(std::move(made));
    return pipelines_.back().handle;
}

rhi::Pipeline Objects::compute(const rhi::Shader& shader, std::span<const rhi::Specialization> values) {
    return pipeline(shader, values, rhi::Format::undefined, [&] {
        return device_->create_compute_pipeline({std::string(shader.name), &shader, values});
    });
}

rhi::Pipeline Objects::raster(const rhi::Shader& shader, std::span<const rhi::Specialization> values, rhi::Format target) {
    return pipeline(shader, values, target, [&] {
        return device_->create_raster_pipeline({std::string(shader.name), &shader, values, target});
    });
}

rhi::BindingSet Objects::bindings(std::string_view name, rhi::Pipeline pipeline, std::span<const rhi::Binding> slots) {
    handles_.reserve(handles_.size() + 1);
    const rhi::BindingSet set = device_->create_binding_set({std::string(name), pipeline, slots});
    handles_.emplace_back(set);
    return set;
}

Specialize::Specialize(const AirStructure& air) {
    set(0, air.term_count).set(1, air.term_kinds).set(2, air.term_phases).set(3, air.phase_count).set(4, air.phase_kinds);
    set(5, static_cast<int>(air.sharp_phases));
}

Specialize& Specialize::set(std::uint32_t id, int value) { return set({id, static_cast<std::uint32_t>(value)}); }

Specialize& Specialize::set(const rhi::Specialization& value) {
    for (rhi::Specialization& s : values_) {
        if (s.id != value.id) continue;
        s.bits = value.bits;
        return *this;
    }
    values_.push_back(value);
    return *this;
}

Specialize& Specialize::storing(rhi::Format format) {
    const bool wide = rhi::bytes_per_texel(format) == 4 * rhi::channel_count(format);
    return set({54, std::bit_cast<std::uint32_t>(wide ? 1e38F : 64512.0F)});
}

void move(rhi::CommandList& commands, std::initializer_list<Move> moves) {
    std::array<rhi::TextureBarrier, 8> barriers;
    std::size_t count = 0;
    for (const Move& m : moves) {
        const bool write_again = m.after == rhi::State::storage_write;
        if (m.texture->state == m.after && !write_again) continue;
        barriers.at(count++) = {m.texture->handle, m.texture->state, m.after};
        m.texture->state = m.after;
    }
    if (count > 0) commands.barrier(std::span(barriers.data(), count), {});
}

void copy_texture(rhi::CommandList& commands, TrackedTexture& from, TrackedTexture& to) {
    move(commands, {{&from, rhi::State::copy_source}, {&to, rhi::State::copy_destination}});
    commands.copy(rhi::TextureToTexture{from.handle, to.handle});
    move(commands, {{&from, rhi::State::sampled}, {&to, rhi::State::sampled}});
}

void update(rhi::CommandList& commands, TrackedBuffer& buffer, std::span<const std::byte> bytes) {
    const rhi::BufferBarrier before{buffer.handle, buffer.state, rhi::State::copy_destination};
    commands.barrier({}, std::span(&before, 1));
    commands.update_constants(buffer.handle, bytes);
    const rhi::BufferBarrier after{buffer.handle, rhi::State::copy_destination, rhi::State::constants};
    commands.barrier({}, std::span(&after, 1));
    buffer.state = rhi::State::constants;
}

bool TableKernel::has_quadrature() const {
    return std::any_of(shader->slots.begin(), shader->slots.end(), [](const rhi::SlotDesc& slot) { return slot.slot == 1; });
}

PassScope::PassScope(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index)
    : commands_(commands), report_(report), timestamps_(timestamps), index_(index) {
    report_.recorded = true;
    report_.invocations = 0;
    commands_.begin_marker(report_.name.data());  // names are string literals
    if (timestamps_.enabled) commands_.timestamp(timestamps_.first + 2 * index_);
}

PassScope::~PassScope() {
    if (timestamps_.enabled) commands_.timestamp(timestamps_.first + 2 * index_ + 1);
    commands_.end_marker();
}

void PassScope::dispatch(const rhi::Shader& shader, rhi::Pipeline pipeline, rhi::BindingSet bindings, rhi::Extent invocations,
                         std::span<const std::byte> push_constants) {
    const auto groups = [](std::uint32_t size, std::uint32_t local) { return (size + local - 1) / local; };
    rhi::DispatchDesc desc;
    desc.pipeline = pipeline;
    desc.bindings = bindings;
    desc.push_constants = push_constants;
    desc.groups[0] = groups(invocations.width, shader.local_size[0]);
    desc.groups[1] = groups(invocations.height, shader.local_size[1]);
    desc.groups[2] = groups(invocations.depth, shader.local_size[2]);
    commands_.dispatch(desc);
    report_.invocations += std::uint64_t{invocations.width} * invocations.height * invocations.depth;
}

}  // namespace aureole::detail
