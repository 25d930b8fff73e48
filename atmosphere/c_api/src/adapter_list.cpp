#include "adapter_list.h"

#include <array>
#include <cstddef>
#include <variant>

#include "guard.h"

namespace aureole::c_api {
namespace {

/// Calls `act` with the texture's or buffer's barriers in C, some at a time: recording allocates nothing.
template <class InC, class Barrier, class Convert, class Act>
void in_pieces(std::span<const Barrier> barriers, const Convert& convert, const Act& act) {
    std::array<InC, 16> piece;
    std::uint32_t count = 0;
    for (const Barrier& barrier : barriers) {
        piece[count++] = convert(barrier);
        if (count < piece.size()) continue;
        act(piece.data(), count);
        count = 0;
    }
    if (count > 0) act(piece.data(), count);
}

}  // namespace

bool AdapterDevice::List::good(const char* function, const std::string& complaint) const noexcept {
    if (!complaint.empty()) d_.tell(std::string(function) + ": " + complaint);
    return complaint.empty();
}

void AdapterDevice::List::update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) {
    if (!good("update_constants", rhi::complaint(d_.find(buffer), bytes))) return;
    d_.c_.update_constants(d_.c_.user, host_, buffer.value, bytes.data(), bytes.size());
}

void AdapterDevice::List::barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier> buffers) {
    for (const rhi::TextureBarrier& b : textures)
        if (!d_.find(b.texture)) return d_.tell("barrier: a texture is unknown or destroyed");
    for (const rhi::BufferBarrier& b : buffers)
        if (!d_.find(b.buffer)) return d_.tell("barrier: a buffer is unknown or destroyed");
    in_pieces<aureole_texture_barrier>(
        textures,
        [](const rhi::TextureBarrier& b) {
            return aureole_texture_barrier{b.texture.value, number(b.before), number(b.after)};
        },
        [&](const aureole_texture_barrier* piece, std::uint32_t count) {
            d_.c_.barrier(d_.c_.user, host_, piece, count, nullptr, 0);
        });
    in_pieces<aureole_buffer_barrier>(
        buffers,
        [](const rhi::BufferBarrier& b) {
            return aureole_buffer_barrier{b.buffer.value, number(b.before), number(b.after)};
        },
        [&](const aureole_buffer_barrier* piece, std::uint32_t count) {
            d_.c_.barrier(d_.c_.user, host_, nullptr, 0, piece, count);
        });
}

void AdapterDevice::List::dispatch(const rhi::DispatchDesc& desc) {
    const PipelineRecord* pipeline = record_of(d_.pipelines_, desc.pipeline.value);
    const SetRecord* set = record_of(d_.sets_, desc.bindings.value);
    const rhi::PipelineFacts of_pipeline{
        pipeline ? pipeline->name : std::string_view(), pipeline ? pipeline->shader : nullptr, {}};
    const rhi::BindingSetFacts of_set{set ? set->name : std::string_view(), set ? set->shader : nullptr};
    if (!good("dispatch", rhi::complaint(desc, pipeline ? &of_pipeline : nullptr, set ? &of_set : nullptr))) return;
    const aureole_dispatch c{desc.pipeline.value,
                             desc.bindings.value,
                             desc.push_constants.data(),
                             static_cast<std::uint32_t>(desc.push_constants.size()),
                             {desc.groups[0], desc.groups[1], desc.groups[2]}};
    d_.c_.dispatch(d_.c_.user, host_, &c);
}

void AdapterDevice::List::draw_fullscreen(const rhi::DrawDesc& desc) {
    const PipelineRecord* pipeline = record_of(d_.pipelines_, desc.pipeline.value);
    const SetRecord* set = record_of(d_.sets_, desc.bindings.value);
    const rhi::PipelineFacts of_pipeline{pipeline ? pipeline->name : std::string_view(), pipeline ? pipeline->shader : nullptr,
                                         pipeline ? pipeline->target_format : rhi::Format::undefined};
    const rhi::BindingSetFacts of_set{set ? set->name : std::string_view(), set ? set->shader : nullptr};
    if (!good("draw_fullscreen",
              rhi::complaint(desc, pipeline ? &of_pipeline : nullptr, set ? &of_set : nullptr, d_.find(desc.target))))
        return;
    const aureole_draw c{desc.pipeline.value, desc.bindings.value, desc.push_constants.data(),
                         static_cast<std::uint32_t>(desc.push_constants.size()), desc.target.value};
    d_.c_.draw_fullscreen(d_.c_.user, host_, &c);
}

void AdapterDevice::List::copy(const rhi::CopyDesc& desc) {
    if (!good("copy", rhi::complaint(desc, d_))) return;
    const aureole_adapter& c = d_.c_;
    if (const auto* down = std::get_if<rhi::TextureToBuffer>(&desc))
        c.copy_texture_to_buffer(c.user, host_, down->source.value, down->destination.value);
    if (const auto* up = std::get_if<rhi::BufferToTexture>(&desc))
        c.copy_buffer_to_texture(c.user, host_, up->source.value, up->destination.value);
    if (const auto* across = std::get_if<rhi::TextureToTexture>(&desc))
        c.copy_texture_to_texture(c.user, host_, across->source.value, across->destination.value);
}

void AdapterDevice::List::begin_marker(const char* name) {
    if (d_.c_.begin_marker) d_.c_.begin_marker(d_.c_.user, host_, name);
}

void AdapterDevice::List::end_marker() {
    if (d_.c_.begin_marker) d_.c_.end_marker(d_.c_.user, host_);
}

void AdapterDevice::List::timestamp(std::uint32_t index) {
    if (index >= d_.capabilities_.timestamp_slots)
        return d_.tell("timestamp: slot " + std::to_string(index) + " is none of the device's");
    d_.c_.timestamp(d_.c_.user, host_, index);
}

}  // namespace aureole::c_api
