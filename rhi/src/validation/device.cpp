#include "device.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "hazards.h"

namespace aureole::rhi::validation {

WatchingDevice::WatchingDevice(Device& inner, const ValidationDesc& desc)
    : inner_(inner), reporter_(desc), list_(*this), timestamp_frames_(inner.capabilities().timestamp_slots, 0) {
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
        check(external, capabilities(), format_support(external.desc.format, external.desc.dimension));
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
    // Nobody can move it any more: what must hold at the end of the list must hold now.
    std::string left;
    if constexpr (std::is_same_v<Handle, Texture>)
        if (list_.open()) left = complain_left(*record, "destroy");
    all.destroy(handle);
    inner_.destroy(handle, frame);
    for (const std::string& text : {complaint, left})
        if (!text.empty()) reporter_.misuse(text);
}

void WatchingDevice::destroy(AnyHandle handle, std::uint64_t last_used_frame) {
    std::visit([&](auto h) { destroy_one(h, last_used_frame); }, handle);
}

std::string WatchingDevice::complain_left(const TextureRecord& texture, const char* when) {
    if (!texture.of_host || texture.host_state == State::undefined || texture.contents.state == texture.host_state) return {};
    return std::string(when) + ": " + quoted(texture) + " of the host is left in state " + to_string(texture.contents.state) +
           ", not in " + to_string(texture.host_state);
}

void WatchingDevice::collect(std::uint64_t completed_frame) {
    // What is being recorded has not been submitted, let alone finished.
    std::uint64_t possible = completed_frame;
    if (list_.open()) possible = std::min(possible, recording_frame_ - 1);
    if (submitted_frame_) possible = std::min(possible, *submitted_frame_);
    complete(possible);
    inner_.collect(possible);
    if (possible < completed_frame)
        reporter_.misuse("collect: frame " + std::to_string(completed_frame) + " is said to be complete, but " +
                         (list_.open() && possible == recording_frame_ - 1
                              ? "frame " + std::to_string(recording_frame_) + " is still being recorded"
                              : "the last one submitted is frame " + std::to_string(*submitted_frame_)));
}

void WatchingDevice::complete(std::uint64_t frame) {
    completed_frame_ = std::max(completed_frame_, frame);
    const auto finish_all = [&](auto& records) {
        for (auto& [handle, record] : records.alive())
            if (record.last_frame <= completed_frame_) finish(record.contents);
    };
    finish_all(textures);
    finish_all(buffers);
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
    if (out_nanoseconds.size() > timestamp_frames_.size())
        reporter_.misuse_and_throw("read_timestamps: " + std::to_string(out_nanoseconds.size()) +
                                   " slots are not allowed; allowed: up to " + std::to_string(timestamp_frames_.size()));
    inner_.read_timestamps(out_nanoseconds);
    const auto frames = std::span(timestamp_frames_).first(out_nanoseconds.size());
    const auto wrong = std::find_if(frames.begin(), frames.end(), [&](auto f) { return f == 0 || f > completed_frame_; });
    if (wrong == frames.end()) return;
    reporter_.misuse("read_timestamps: slot " + std::to_string(wrong - frames.begin()) +
                     (*wrong == 0 ? std::string(" has never been written")
                                  : " is written by frame " + std::to_string(*wrong) + ", which has not finished"));
}

CommandList& WatchingDevice::begin_list(CommandList& inner, std::uint64_t frame) {
    if (list_.open()) reporter_.misuse_and_throw("begin_list: the list begun before has not been ended");
    std::string wrong;
    if (frame <= completed_frame_)
        wrong = frame == 0 ? "allowed: 1 or more" : "frame " + std::to_string(completed_frame_) + " is complete";
    else if (frame < recording_frame_)
        wrong = "frame " + std::to_string(recording_frame_) + " has been recorded";
    recording_frame_ = std::max(frame, recording_frame_);
    for (auto& [handle, texture] : textures.alive()) {
        if (!texture.of_host) continue;
        texture.contents = {texture.host_state, texture.host_state != State::undefined, {}};
    }
    list_.begin(inner);
    if (!wrong.empty()) reporter_.misuse("begin_list: frame " + std::to_string(frame) + " cannot be recorded: " + wrong);
    return list_;
}

void WatchingDevice::end_list() {
    if (!list_.open()) reporter_.misuse_and_throw("end_list: no list has been begun");
    list_.end();
    for (const auto& [handle, texture] : textures.alive())
        if (const std::string text = complain_left(texture, "end of list"); !text.empty()) reporter_.misuse(text);
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
