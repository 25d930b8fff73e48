// For tests: a validation device around a null device, a small scene of objects, and what was reported.
#pragma once

#include <aureole/rhi/validation.h>
#include <doctest/doctest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "null_device.h"

namespace aureole::rhi::validation {

inline constexpr SlotDesc compute_slots[] = {{0, SlotKind::sampled_texture, Dimension::d2, "input"},
                                             {1, SlotKind::storage_texture, Dimension::d2, "result"},
                                             {2, SlotKind::constants, Dimension::d2, "frame"}};
inline constexpr SlotDesc draw_slots[] = {{0, SlotKind::sampled_texture, Dimension::d2, "input"}};
inline constexpr Shader compute_shader = {"blur", Stage::compute, {8, 8, 1}, 16, compute_slots, {}, {}, {}};
inline constexpr Shader draw_shader = {"paint", Stage::fragment, {1, 1, 1}, 0, draw_slots, {}, {}, {}};

class Rig {
public:
    explicit Rig(const ValidationDesc& desc = {}) {
        device = create_validation_device(inner, desc);
        queue = create_validation_queue(*device, inner_queue);
        device->set_message_callback(
            [](void* user, Severity, const char* text) { static_cast<std::vector<std::string>*>(user)->emplace_back(text); },
            &messages);
        const Usage all =
            Usage::sampled | Usage::storage | Usage::color_attachment | Usage::copy_source | Usage::copy_destination;
        lake = texture("lake", all);
        hill = texture("hill", all);
        frame = device->create_buffer({"frame", 64, Usage::constants});
        upload = device->create_buffer({"upload", 8 * 8 * 8, Usage::upload});
        read_back = device->create_buffer({"read back", 8 * 8 * 8, Usage::read_back});
        sampler = device->create_sampler({});
        blur = device->create_compute_pipeline({"blur pass", &compute_shader, {}});
        paint = device->create_raster_pipeline({"paint pass", &draw_shader, {}, Format::rgba16_float});
        lake_to_hill = set("lake to hill", lake, hill);
        paint_lake = device->create_binding_set({"paint lake", paint, std::array{Binding{0, lake, sampler, {}}}});
    }

    Texture texture(const char* name, Usage usage, Format format = Format::rgba16_float) const {
        return device->create_texture({name, Dimension::d2, format, {8, 8, 1}, usage});
    }
    BindingSet set(const char* name, Texture input, Texture result) const {
        const Binding bindings[] = {{0, input, sampler, {}}, {1, result, {}, {}}, {2, {}, {}, frame}};
        return device->create_binding_set({name, blur, bindings});
    }
    void begin() { list = &queue->begin(); }
    void submit() const { queue->submit(); }
    void move(Texture texture, State before, State after) const {
        const TextureBarrier barrier{texture, before, after};
        list->barrier({&barrier, 1}, {});
    }
    void move(Buffer buffer, State before, State after) const {
        const BufferBarrier barrier{buffer, before, after};
        list->barrier({}, {&barrier, 1});
    }
    void dispatch(BindingSet bindings) const { list->dispatch({blur, bindings, std::as_bytes(std::span(push)), {1, 1, 1}}); }

    /// Fills `lake` and `frame`, and takes everything to where a dispatch of lake_to_hill needs it.
    void prepare() {
        begin();
        device->write_buffer(upload, std::as_bytes(std::span(push)));
        move(upload, State::undefined, State::copy_source);
        move(lake, State::undefined, State::copy_destination);
        list->copy(BufferToTexture{upload, lake});
        move(lake, State::copy_destination, State::sampled);
        move(frame, State::undefined, State::copy_destination);
        list->update_constants(frame, std::as_bytes(std::span(push)));
        move(frame, State::copy_destination, State::constants);
        move(hill, State::undefined, State::storage_write);
        REQUIRE(messages.empty());
    }

    /// Exactly one message, with these words in it; forgets it.
    void check_reported(const std::vector<std::string>& words) {
        REQUIRE(messages.size() == 1);
        CAPTURE(messages[0]);
        for (const std::string& word : words) {
            CAPTURE(word);
            CHECK(messages[0].find(word) != std::string::npos);
        }
        messages.clear();
    }
    [[nodiscard]] std::size_t passed_on() const { return inner_queue.list.log.size(); }

    void destroy_all() {
        queue->wait();
        for (const AnyHandle h :
             {AnyHandle(paint_lake), AnyHandle(lake_to_hill), AnyHandle(paint), AnyHandle(blur), AnyHandle(sampler),
              AnyHandle(read_back), AnyHandle(upload), AnyHandle(frame), AnyHandle(hill), AnyHandle(lake)})
            device->destroy(h, 0);
    }

    NullDevice inner;
    NullQueue inner_queue;
    std::vector<std::string> messages;
    std::unique_ptr<ValidationDevice> device;
    std::unique_ptr<Queue> queue;
    CommandList* list = nullptr;
    Texture lake, hill;
    Buffer frame, upload, read_back;
    Sampler sampler;
    Pipeline blur, paint;
    BindingSet lake_to_hill, paint_lake;
    std::array<float, 4> push{};
};

}  // namespace aureole::rhi::validation
