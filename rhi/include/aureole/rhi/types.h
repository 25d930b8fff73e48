// Plain descriptors of the render-hardware interface: formats, usages, states, handles. No graphics API in sight.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace aureole::rhi {

/// Texel formats that Aureole may ask for. `float` formats are scene-linear.
enum class Format : std::uint8_t {
    undefined,
    r8_unorm,
    rgba8_unorm,
    rgba8_srgb,
    bgra8_unorm,
    r16_float,
    rg16_float,
    rgba16_float,
    r32_float,
    rg32_float,
    rgba32_float,
    r11g11b10_float,
    d32_float,
};

/// Bytes of one texel; 0 for `undefined`.
[[nodiscard]] std::uint32_t bytes_per_texel(Format format) noexcept;
/// Number of channels that the format stores; 0 for `undefined`.
[[nodiscard]] std::uint32_t channel_count(Format format) noexcept;
/// Name as written in this header, e.g. "rgba16_float".
[[nodiscard]] const char* to_string(Format format) noexcept;

/// What a texture or buffer may be used for; or-ed together.
enum class Usage : std::uint32_t {
    none = 0,
    sampled = 1u << 0,           ///< Read through a sampler, in compute and fragment shaders.
    storage = 1u << 1,           ///< Texture written as a storage image in compute shaders.
    color_attachment = 1u << 2,  ///< Target of draw_fullscreen.
    copy_source = 1u << 3,       ///< Read by copies.
    copy_destination = 1u << 4,  ///< Written by copies.
    constants = 1u << 5,         ///< Buffer read as a uniform block.
    read_back = 1u << 6,         ///< Buffer whose bytes the CPU reads after the work has finished. Implies copy_destination.
    upload = 1u << 7,  ///< Buffer whose bytes the CPU writes before the work starts. Implies copy_source, its first state.
};
[[nodiscard]] constexpr Usage operator|(Usage a, Usage b) noexcept {  ///< Both.
    return static_cast<Usage>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
[[nodiscard]] constexpr bool has(Usage set, Usage flags) noexcept {  ///< Whether all of the flags are in the set.
    return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(flags)) == static_cast<std::uint32_t>(flags);
}

/// What a resource is being used for right now. `CommandList::barrier` moves a resource from one state to another and makes
/// earlier writes visible to what follows.
enum class State : std::uint8_t {
    undefined,         ///< Contents may be thrown away.
    sampled,           ///< Sampled-texture reads by compute and fragment shaders.
    depth_read,        ///< A depth texture sampled by shaders.
    storage_write,     ///< Storage-image writes by compute shaders.
    color_attachment,  ///< Target of draw_fullscreen.
    copy_source,       ///< Read by copies.
    copy_destination,  ///< Written by copies.
    constants,         ///< Uniform-block reads by compute and fragment shaders.
    general,  ///< Of a lent texture whose state has no name here. No work is done in it: barriers lead out of it and back.
};
[[nodiscard]] const char* to_string(State state) noexcept;  ///< As written in this header.

/// What a texture is; a cube has six square faces.
enum class Dimension : std::uint8_t { d2, d3, cube };
[[nodiscard]] const char* to_string(Dimension dimension) noexcept;  ///< "d2", "d3" or "cube".

/// Size in texels. For 2D and cube textures depth is 1 (a cube's six faces are implied).
struct Extent {
    std::uint32_t width = 1, height = 1, depth = 1;  ///< Texels.
    [[nodiscard]] constexpr bool operator==(const Extent&) const noexcept = default;
};

/// Typed handle of a device object. 0 is null. A handle is never reused while the device lives.
template <class Tag>
struct Handle {
    std::uint64_t value = 0;  ///< The device's own number for the object.
    [[nodiscard]] constexpr explicit operator bool() const noexcept { return value != 0; }  ///< Whether it is of an object.
    [[nodiscard]] constexpr bool operator==(const Handle&) const noexcept = default;
};
using Texture = Handle<struct TextureTag>;        ///< By Device::create_texture or wrap_texture.
using Buffer = Handle<struct BufferTag>;          ///< By Device::create_buffer.
using Sampler = Handle<struct SamplerTag>;        ///< By Device::create_sampler.
using Pipeline = Handle<struct PipelineTag>;      ///< By Device::create_compute_pipeline or create_raster_pipeline.
using BindingSet = Handle<struct BindingSetTag>;  ///< By Device::create_binding_set.

/// A texture of one mip level and one sample.
struct TextureDesc {
    std::string name{};                   ///< Shown by debuggers and in messages.
    Dimension dimension = Dimension::d2;  ///< A cube is written as an array of six layers.
    Format format = Format::undefined;    ///< Of its texels; `undefined` is refused.
    Extent extent{};                      ///< Each at least 1 and at most the device's limit.
    Usage usage = Usage::none;            ///< All that it is made for; `none` is refused.
};

/// A buffer of constants, or of bytes to upload or read back.
struct BufferDesc {
    std::string name{};         ///< Shown by debuggers and in messages.
    std::uint64_t size = 0;     ///< Bytes, at least 1.
    Usage usage = Usage::none;  ///< All that it is made for; `none` is refused.
};

/// How texels are read between their centres.
enum class Filter : std::uint8_t { nearest, linear };
/// What is outside of [0, 1]: the edge again, or the texture again.
enum class Address : std::uint8_t { clamp, repeat };

/// Texel centres are at (i + 1/2) / size; outside [0, 1] `address` holds (cubes: filters cross the faces' edges). No mips.
struct SamplerDesc {
    Filter filter = Filter::linear;  ///< For smaller and larger alike.
    Address address_u = Address::clamp, address_v = Address::clamp, address_w = Address::clamp;  ///< Along x, y, z.
};

/// A host's own texture, lent to Aureole. The host keeps ownership.
struct ExternalTexture {
    TextureDesc desc{};             ///< What the texture is.
    std::uint64_t native = 0;       ///< The device's own object, in bits: its page says which. Unused on the CPU.
    std::uint64_t native_view = 0;  ///< Optional, its view where a device has such; 0 lets the backend make one.
    void* cpu_texels = nullptr;     ///< CPU backend: the host's texels, tightly packed in `desc.format`.
    /// State the texture is in when recording starts, and is left in when it ends. A state with a usage of its own needs it in
    /// `desc.usage`; `undefined` and `general` need none. `depth_read` is for depth formats, `constants` is no texture's.
    State state = State::undefined;
};

}  // namespace aureole::rhi
