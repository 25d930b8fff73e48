// What a command list records, and the memory that it records into.
#pragma once

#include <aureole/rhi/device.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace aureole::cpu {

// A command is followed by its payload: push constants, or the bytes of an update.
struct UpdateCommand {
    rhi::Buffer buffer;
};
struct DispatchCommand {
    rhi::Pipeline pipeline;
    rhi::BindingSet bindings;
    std::uint32_t groups[3];
};
struct DrawCommand {
    rhi::Pipeline pipeline;
    rhi::BindingSet bindings;
    rhi::Texture target;
};
/// A barrier from State::undefined.
struct DiscardCommand {
    rhi::Texture texture;
};
struct TimestampCommand {
    std::uint32_t index;
};

enum class CommandType : std::uint32_t {
    update,
    dispatch,
    draw,
    texture_to_buffer,
    buffer_to_texture,
    texture_to_texture,
    discard,
    timestamp
};

template <class Command>
constexpr CommandType command_type();
template <>
constexpr CommandType command_type<UpdateCommand>() {
    return CommandType::update;
}
template <>
constexpr CommandType command_type<DispatchCommand>() {
    return CommandType::dispatch;
}
template <>
constexpr CommandType command_type<DrawCommand>() {
    return CommandType::draw;
}
template <>
constexpr CommandType command_type<rhi::TextureToBuffer>() {
    return CommandType::texture_to_buffer;
}
template <>
constexpr CommandType command_type<rhi::BufferToTexture>() {
    return CommandType::buffer_to_texture;
}
template <>
constexpr CommandType command_type<rhi::TextureToTexture>() {
    return CommandType::texture_to_texture;
}
template <>
constexpr CommandType command_type<DiscardCommand>() {
    return CommandType::discard;
}
template <>
constexpr CommandType command_type<TimestampCommand>() {
    return CommandType::timestamp;
}

/// Commands one after the other. Grows when it must and never shrinks, so that recording the same work again allocates
/// nothing.
class CommandArena {
public:
    CommandArena() { bytes_.reserve(64 * 1024); }

    void clear() noexcept { bytes_.clear(); }

    template <class Command>
    void add(const Command& command, std::span<const std::byte> payload = {}) {
        static_assert(std::is_trivially_copyable_v<Command>);
        const Header header{command_type<Command>(), static_cast<std::uint32_t>(payload.size())};
        const std::size_t at = bytes_.size();
        bytes_.resize(at + sizeof header + sizeof command + payload.size());
        std::memcpy(bytes_.data() + at, &header, sizeof header);
        std::memcpy(bytes_.data() + at + sizeof header, &command, sizeof command);
        if (!payload.empty()) std::memcpy(bytes_.data() + at + sizeof header + sizeof command, payload.data(), payload.size());
    }

    /// Calls visitor(command, payload) for every command in order.
    template <class Visitor>
    void visit(Visitor&& visitor) const {
        for (std::size_t at = 0; at < bytes_.size();) {
            Header header;
            std::memcpy(&header, bytes_.data() + at, sizeof header);
            at += sizeof header;
            switch (header.type) {
                case CommandType::update:
                    at += call<UpdateCommand>(visitor, at, header.payload);
                    break;
                case CommandType::dispatch:
                    at += call<DispatchCommand>(visitor, at, header.payload);
                    break;
                case CommandType::draw:
                    at += call<DrawCommand>(visitor, at, header.payload);
                    break;
                case CommandType::texture_to_buffer:
                    at += call<rhi::TextureToBuffer>(visitor, at, header.payload);
                    break;
                case CommandType::buffer_to_texture:
                    at += call<rhi::BufferToTexture>(visitor, at, header.payload);
                    break;
                case CommandType::texture_to_texture:
                    at += call<rhi::TextureToTexture>(visitor, at, header.payload);
                    break;
                case CommandType::discard:
                    at += call<DiscardCommand>(visitor, at, header.payload);
                    break;
                case CommandType::timestamp:
                    at += call<TimestampCommand>(visitor, at, header.payload);
                    break;
            }
        }
    }

private:
    struct Header {
        CommandType type;
        std::uint32_t payload;  // bytes
    };

    template <class Command, class Visitor>
    std::size_t call(Visitor& visitor, std::size_t at, std::uint32_t payload) const {
        Command command;
        std::memcpy(&command, bytes_.data() + at, sizeof command);
        visitor(command, std::span(bytes_).subspan(at + sizeof command, payload));
        return sizeof command + payload;
    }

    std::vector<std::byte> bytes_;
};

}  // namespace aureole::cpu
