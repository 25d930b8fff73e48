#include "device.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "hazards.h"

namespace aureole::rhi::validation {

WatchingDevice::WatchingDevice(Device& inner, const ValidationDesc& desc)
    : inner_(inner), reporter_(desc), list_(*this), timestamp_written_(inner.capabilities().timestamp_slots, false) {
    inner_.set_message_callback(
        [](void* user, Severity severity, const char* text) { static_cast<Reporter*>(user)->pass_on(severity, text); },
        &reporter_);
}

WatchingDevice::~WatchingDevice() {
    const auto tell_left = [&](auto& records) {
        for (const auto& [handle, record] : records.alive())
            reporter_.tell("the device goes, but " + quoted(record) + " has not been destroyed");
    };
    tell_left(textures);
    tell_left(buffers);
    tell_left(samplers);
    tell_left(pipelines);
    tell_left(binding_sets);
    inner_.set_message_callback(nullptr, nullptr);
}

FormatSupport WatchingDevice::format_support(Format format, Dimension dimension) const {
    return inner_.format_support(format, dimension);
}

template <class Make>
auto WatchingDevice::created(const Make& make) {
    try {
        return make();
    } catch (const Error& error) {
        reporter_.tell(error.what());
        throw;
    }
}

Texture WatchingDevice::create_texture(const TextureDesc& desc) {
    const Texture texture = created([&] {
        check(desc, capabilities(), format_support(desc.format, desc.dimension));
        return inner_.create_texture(desc);
    });
    textures.add(texture, {desc, {}, false, State::undefined, 0});
    return texture;
}

Texture WatchingDevice::wrap_texture(const ExternalTexture& external) {
    const Texture texture = created([&] {
        check(external.desc, capabilities(), format_support(external.desc.format, external.desc.dimension));
        return inner_.wrap_texture(external);
    });
    TextureRecord record{external.desc, {}, true, external.state, 0};
    record.contents.state = external.state;
    record.contents.defined = external.state != State::undefined;
    textures.add(texture, std::move(record));
    return texture;
}

Buffer WatchingDevice::create_buffer(const BufferDesc& desc) {
    const Buffer buffer = created([&] {
        check(desc);
        return inner_.create_buffer(desc);
    });
    Contents contents;
    if (has(desc.usage, Usage::upload)) contents.state = State::copy_source;
    buffers.add(buffer, {desc, contents, 0});
    return buffer;
}

Sampler WatchingDevice::create_sampler(const SamplerDesc& desc) {
    const Sampler sampler = created([&] {
        check(desc);
        return inner_.create_sampler(desc);
    });
    samplers.add(sampler, {desc, 0});
    return sampler;
}

Pipeline WatchingDevice::create_compute_pipeline(const ComputePipelineDesc& desc) {
    const Pipeline pipeline = created([&] {
        check(desc, capabilities());
        return inner_.create_compute_pipeline(desc);
    });
    pipelines.add(pipeline, {desc.name, desc.shader, Format::undefined, 0});
    return pipeline;
}

Pipeline WatchingDevice::create_raster_pipeline(const RasterPipelineDesc& desc) {
    const Pipeline pipeline = created([&] {
        check(desc, capabilities(), format_support(desc.target_format, Dimension::d2));
        return inner_.create_raster_pipeline(desc);
    });
    pipelines.add(pipeline, {desc.name, desc.shader, desc.target_format, 0});
    return pipeline;
}

BindingSet WatchingDevice::create_binding_set(const BindingSetDesc& desc) {
    // Destroyed objects by name, before the general rules call them unknown.
    const std::string start = field_name("binding set", desc.name, "");
    const auto must_live = [&](const auto& records, auto handle, const std::string& where) {
        if (handle && !records.find(handle))
            reporter_.misuse_and_throw(start + where + ": " + records.explain(handle), ErrorCode::invalid_argument);
    };
    const PipelineRecord* pipeline = pipelines.find(desc.pipeline);
    if (!pipeline) reporter_.misuse_and_throw(start + ": " + pipelines.explain(desc.pipeline), ErrorCode::invalid_argument);
    for (const SlotDesc& slot : pipeline->shader->slots) {
        const std::string where = " slot " + std::to_string(slot.slot) + " (" + std::string(slot.name) + ")";
        for (const Binding& b : desc.bindings) {
            if (b.slot != slot.slot) continue;
            must_live(textures, b.texture, where);
            must_live(samplers, b.sampler, where);
            must_live(buffers, b.buffer, where);
        }
    }
    const BindingSet set = created([&] {
        check(desc, *pipeline->shader, *this, inner_);
        return inner_.create_binding_set(desc);
    });
    binding_sets.add(set, {desc.name, pipeline->shader, {desc.bindings.begin(), desc.bindings.end()}, 0});
    return set;
}

template <class Handle>
void WatchingDevice::destroy_one(Handle handle, std::uint64_t last_used_frame) {
    if (!handle) return;
    auto& all = records(handle);
    const auto* record = all.find(handle);
    if (!record) {
        reporter_.misuse("destroy: " + all.explain(handle));
        return;
    }
    std::string complaint;
    if (record->last_frame > completed_frame_ && record->last_frame > last_used_frame)
        complaint = "destroy: " + quoted(*record) + " is said to be last used by frame " + std::to_string(last_used_frame) +
                    ", but frame " + std::to_string(record->last_frame) + " uses it and has not finished";
    // Too early for the inner device: kept until the last frame that really uses it.
    const std::uint64_t frame = complaint.empty() ? last_used_frame : record->last_frame;
    all.destroy(handle);
    inner_.destroy(handle, frame);
    if (!complaint.empty()) reporter_.misuse(complaint);
}

void WatchingDevice::destroy(AnyHandle handle, std::uint64_t last_used_frame) {
    std::visit([&](auto h) { destroy_one(h, last_used_frame); }, handle);
}

void WatchingDevice::check_cpu_access(Buffer buffer, const char* function, Usage usage, std::size_t bytes) {
    const BufferRecord* record = buffers.find(buffer);
    const std::string start = std::string(function) + ": ";
    if (!record) reporter_.misuse_and_throw(start + buffers.explain(buffer));
    if (!has(record->desc.usage, usage))
        reporter_.misuse_and_throw(start + quoted(*record) + " has usage " + to_string(record->desc.usage) + ", not " +
                                   to_string(usage));
    if (bytes > record->desc.size)
        reporter_.misuse_and_throw(start + quoted(*record) + " has " + std::to_string(record->desc.size) + " bytes, not " +
                                   std::to_string(bytes));
    if (record->last_frame > completed_frame_)
        reporter_.misuse_and_throw(start + quoted(*record) + " is in use by frame " + std::to_string(record->last_frame) +
                                   ", which has not finished");
    if (usage == Usage::read_back && !record->contents.defined)
        reporter_.misuse_and_throw(start + quoted(*record) + " is read, but nothing has been written into it");
}

void WatchingDevice::write_buffer(Buffer buffer, std::span<const std::byte> bytes) {
    check_cpu_access(buffer, "write_buffer", Usage::upload, bytes.size());
    inner_.write_buffer(buffer, bytes);
    buffers.find(buffer)->contents.defined = true;
}

void WatchingDevice::read_buffer(Buffer buffer, std::span<std::byte> bytes) {
    check_cpu_access(buffer, "read_buffer", Usage::read_back, bytes.size());
    inner_.read_buffer(buffer, bytes);
}

void WatchingDevice::read_timestamps(std::span<double> out_nanoseconds) {
    if (out_nanoseconds.size() > timestamp_written_.size())
        reporter_.misuse_and_throw("read_timestamps: " + std::to_string(out_nanoseconds.size()) +
                                   " slots are not allowed; allowed: up to " + std::to_string(timestamp_written_.size()));
    const auto end = timestamp_written_.begin() + static_cast<std::ptrdiff_t>(out_nanoseconds.size());
    const auto missing = std::find(timestamp_written_.begin(), end, false);
    if (missing != end)
        reporter_.misuse("read_timestamps: slot " + std::to_string(missing - timestamp_written_.begin()) +
                         " has never been written");
    inner_.read_timestamps(out_nanoseconds);
}

CommandList& WatchingDevice::begin_list(CommandList& inner) {
    if (list_.open()) reporter_.misuse_and_throw("begin_list: the list begun before has not been ended");
    for (auto& [handle, texture] : textures.alive()) {
        if (!texture.of_host) continue;
        texture.contents = {texture.host_state, texture.host_state != State::undefined, {}, {}};
    }
    list_.begin(inner);
    return list_;
}

void WatchingDevice::end_list() {
    if (!list_.open()) reporter_.misuse_and_throw("end_list: no list has been begun");
    list_.end();
    for (const auto& [handle, texture] : textures.alive())
        if (texture.of_host && texture.host_state != State::undefined && texture.contents.state != texture.host_state)
            reporter_.misuse("end of list: " + quoted(texture) + " of the host is left in state " +
                             to_string(texture.contents.state) + ", not in " + to_string(texture.host_state));
}

void WatchingDevice::set_frames(std::uint64_t recording, std::uint64_t completed) {
    recording_frame_ = recording;
    completed_frame_ = completed;
}

void WatchingDevice::finish_all() {
    for (auto& [handle, texture] : textures.alive()) finish(texture.contents);
    for (auto& [handle, buffer] : buffers.alive()) finish(buffer.contents);
}

const TextureDesc* WatchingDevice::find(Texture texture) const {
    const auto* record = textures.find(texture);
    return record ? &record->desc : nullptr;
}
const BufferDesc* WatchingDevice::find(Buffer buffer) const {
    const auto* record = buffers.find(buffer);
    return record ? &record->desc : nullptr;
}
const SamplerDesc* WatchingDevice::find(Sampler sampler) const {
    const auto* record = samplers.find(sampler);
    return record ? &record->desc : nullptr;
}

}  // namespace aureole::rhi::validation

namespace aureole::rhi {

std::unique_ptr<ValidationDevice> create_validation_device(Device& inner, const ValidationDesc& desc) {
    return std::make_unique<validation::WatchingDevice>(inner, desc);
}

}  // namespace aureole::rhi
