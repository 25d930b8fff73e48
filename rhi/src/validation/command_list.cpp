#include "command_list.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "device.h"

namespace aureole::rhi::validation {

void WatchingCommandList::begin(CommandList& inner) {
    inner_ = &inner;
    markers_.clear();
}

void WatchingCommandList::end() {
    inner_ = nullptr;
    for (const std::string& name : markers_)
        device_.reporter().misuse("end of list: marker \"" + name + "\" has not been ended");
}

bool WatchingCommandList::recording(const char* function) {
    texture_accesses_.clear();
    buffer_accesses_.clear();
    if (!open()) device_.reporter().misuse(std::string(function) + ": recorded outside begin and submit");
    return open();
}

bool WatchingCommandList::fine(const std::string& complaint) {
    if (!complaint.empty()) device_.reporter().misuse(complaint);
    return complaint.empty();
}

bool WatchingCommandList::collect(Texture texture, State state, bool write, const char* function) {
    TextureRecord* record = device_.recorded(texture, function);
    if (record) texture_accesses_.push_back({record, state, write});
    return record != nullptr;
}

bool WatchingCommandList::collect(Buffer buffer, State state, bool write, const char* function) {
    BufferRecord* record = device_.recorded(buffer, function);
    if (record) buffer_accesses_.push_back({record, state, write});
    return record != nullptr;
}

bool WatchingCommandList::collect(const BindingSetRecord& set, const char* function) {
    const std::string where = std::string(function) + ": " + quoted(set);
    bool all = true;
    for (const SlotDesc& slot : set.shader->slots) {
        const Binding& b = *std::find_if(set.bindings.begin(), set.bindings.end(),
                                         [&](const Binding& binding) { return binding.slot == slot.slot; });
        switch (slot.kind) {
            case SlotKind::sampled_texture:
                all = collect(b.texture, State::sampled, false, where.c_str()) && all;
                all = device_.recorded(b.sampler, where.c_str()) && all;
                break;
            case SlotKind::storage_texture:
                all = collect(b.texture, State::storage_write, true, where.c_str()) && all;
                break;
            case SlotKind::constants:
                all = collect(b.buffer, State::constants, false, where.c_str()) && all;
                break;
        }
    }
    return all;
}

void WatchingCommandList::check_accesses(const std::string& who) {
    use(texture_accesses_, buffer_accesses_, who, device_.reporter());
}

void WatchingCommandList::update_constants(Buffer buffer, std::span<const std::byte> bytes) {
    if (!recording("update_constants")) return;
    if (!collect(buffer, State::copy_destination, true, "update_constants")) return;
    if (!fine(complaint(device_.find(buffer), bytes))) return;
    check_accesses("update_constants");
    inner_->update_constants(buffer, bytes);
}

void WatchingCommandList::barrier(std::span<const TextureBarrier> textures, std::span<const BufferBarrier> buffers) {
    if (!recording("barrier")) return;
    bool all = true;
    const auto handle_all = [&](auto barriers, auto member) {
        for (std::size_t i = 0; i < barriers.size(); ++i) {
            const auto handle = barriers[i].*member;
            auto* record = device_.recorded(handle, "barrier");
            all = all && record;
            if (!record) continue;
            const auto before = barriers.first(i);
            if (std::any_of(before.begin(), before.end(), [&](const auto& b) { return b.*member == handle; })) {
                device_.reporter().misuse("barrier: " + quoted(*record) + " is given twice");
                all = false;
                continue;
            }
            move(*record, barriers[i].before, barriers[i].after, device_.reporter());
        }
    };
    handle_all(textures, &TextureBarrier::texture);
    handle_all(buffers, &BufferBarrier::buffer);
    if (all) inner_->barrier(textures, buffers);
}

void WatchingCommandList::dispatch(const DispatchDesc& desc) {
    if (!recording("dispatch")) return;
    const PipelineRecord* pipeline = device_.recorded(desc.pipeline, "dispatch");
    if (!pipeline) return;
    const BindingSetRecord* set = desc.bindings ? device_.recorded(desc.bindings, "dispatch") : nullptr;
    if (desc.bindings && !set) return;
    const PipelineFacts facts = pipeline->facts();
    const auto set_facts = set ? std::optional(set->facts()) : std::nullopt;
    if (!fine(complaint(desc, &facts, set_facts ? &*set_facts : nullptr))) return;
    if (set && !collect(*set, "dispatch")) return;
    check_accesses("dispatch of " + quoted(*pipeline));
    inner_->dispatch(desc);
}

void WatchingCommandList::draw_fullscreen(const DrawDesc& desc) {
    if (!recording("draw_fullscreen")) return;
    const PipelineRecord* pipeline = device_.recorded(desc.pipeline, "draw_fullscreen");
    if (!pipeline) return;
    const BindingSetRecord* set = desc.bindings ? device_.recorded(desc.bindings, "draw_fullscreen") : nullptr;
    if (desc.bindings && !set) return;
    const TextureRecord* target = device_.recorded(desc.target, "draw_fullscreen");
    if (!target) return;
    const PipelineFacts facts = pipeline->facts();
    const auto set_facts = set ? std::optional(set->facts()) : std::nullopt;
    if (!fine(complaint(desc, &facts, set_facts ? &*set_facts : nullptr, &target->desc))) return;
    if (set && !collect(*set, "draw_fullscreen")) return;
    if (!collect(desc.target, State::color_attachment, true, "draw_fullscreen")) return;
    check_accesses("draw_fullscreen of " + quoted(*pipeline));
    inner_->draw_fullscreen(desc);
}

void WatchingCommandList::copy(const CopyDesc& desc) {
    if (!recording("copy")) return;
    const bool alive = std::visit(
        [&](const auto& c) {
            return collect(c.source, State::copy_source, false, "copy") &&
                   collect(c.destination, State::copy_destination, true, "copy");
        },
        desc);
    if (!alive || !fine(complaint(desc, device_))) return;
    check_accesses("copy");
    inner_->copy(desc);
}

void WatchingCommandList::begin_marker(const char* name) {
    if (!recording("begin_marker")) return;
    if (!name) {
        device_.reporter().misuse("begin_marker: no name is given");
        return;
    }
    markers_.emplace_back(name);
    inner_->begin_marker(name);
}

void WatchingCommandList::end_marker() {
    if (!recording("end_marker")) return;
    if (markers_.empty()) {
        device_.reporter().misuse("end_marker: no marker has been begun");
        return;
    }
    markers_.pop_back();
    inner_->end_marker();
}

void WatchingCommandList::timestamp(std::uint32_t index) {
    if (!recording("timestamp")) return;
    const std::uint32_t slots = device_.capabilities().timestamp_slots;
    if (index >= slots) {
        device_.reporter().misuse("timestamp: slot " + std::to_string(index) + " is not allowed; this device has " +
                                  std::to_string(slots));
        return;
    }
    device_.note_timestamp(index);
    inner_->timestamp(index);
}

}  // namespace aureole::rhi::validation
