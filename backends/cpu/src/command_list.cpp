#include "command_list.h"

#include <aureole/rhi/checks.h>

#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "device.h"

namespace aureole::cpu {
namespace {

/// Facts of an object that may be missing, and a pointer to them that may be null.
template <class Object>
auto facts_of(const std::shared_ptr<Object>& object) {
    using Facts = decltype(object->facts());
    return object ? std::optional<Facts>(object->facts()) : std::nullopt;
}
template <class Facts>
const Facts* pointer(const std::optional<Facts>& facts) {
    return facts ? &*facts : nullptr;
}

}  // namespace

void CpuCommandList::clear() noexcept {
    commands_.clear();
    incomplete_ = false;
}

template <class Command>
void CpuCommandList::record(const std::string& complaint, const Command& command, std::span<const std::byte> payload) noexcept {
    if (!complaint.empty()) {
        device_.report(rhi::Severity::error, complaint);
        return;
    }
    try {
        commands_.add(command, payload);
    } catch (const std::bad_alloc&) {
        incomplete_ = true;
        device_.report(rhi::Severity::error, "out of memory while recording");
    }
}

void CpuCommandList::update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) {
    record(rhi::complaint(device_.find(buffer), bytes), UpdateCommand{buffer}, bytes);
}

void CpuCommandList::barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier> buffers) {
    // Commands run one after the other and each waits for its threads: there is nothing left to wait for. But contents that
    // may be thrown away are, so that whoever still reads them notices. Those of the host's memory are not ours.
    for (const auto& b : textures) {
        const auto texture = device_.textures().alive(b.texture);
        if (!texture)
            device_.report(rhi::Severity::error, "barrier: unknown or destroyed texture");
        else if (b.before == rhi::State::undefined && b.after != rhi::State::undefined && !texture->of_host())
            record({}, DiscardCommand{b.texture});
    }
    for (const auto& b : buffers)
        if (!device_.find(b.buffer)) device_.report(rhi::Severity::error, "barrier: unknown or destroyed buffer");
}

void CpuCommandList::dispatch(const rhi::DispatchDesc& desc) {
    const auto pipeline = facts_of(device_.pipelines().alive(desc.pipeline));
    const auto bindings = facts_of(device_.binding_sets().alive(desc.bindings));
    record(rhi::complaint(desc, pointer(pipeline), pointer(bindings)),
           DispatchCommand{desc.pipeline, desc.bindings, {desc.groups[0], desc.groups[1], desc.groups[2]}},
           desc.push_constants);
}

void CpuCommandList::draw_fullscreen(const rhi::DrawDesc& desc) {
    const auto pipeline = facts_of(device_.pipelines().alive(desc.pipeline));
    const auto bindings = facts_of(device_.binding_sets().alive(desc.bindings));
    record(rhi::complaint(desc, pointer(pipeline), pointer(bindings), device_.find(desc.target)),
           DrawCommand{desc.pipeline, desc.bindings, desc.target}, desc.push_constants);
}

void CpuCommandList::copy(const rhi::CopyDesc& desc) {
    const std::string complaint = rhi::complaint(desc, device_);
    std::visit([&](const auto& c) { record(complaint, c); }, desc);
}

// Markers are for tools that watch a GPU.
void CpuCommandList::begin_marker(const char*) {}
void CpuCommandList::end_marker() {}

void CpuCommandList::timestamp(std::uint32_t index) {
    std::string complaint;
    if (index >= timestamp_slots)
        complaint =
            "timestamp: " + std::to_string(index) + " is not allowed; allowed: 0 to " + std::to_string(timestamp_slots - 1);
    record(complaint, TimestampCommand{index});
}

}  // namespace aureole::cpu
