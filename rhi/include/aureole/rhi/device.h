// The render-hardware interface: what a host implements (or takes from a backend) so that Aureole can work on its device.
//
// Threading: one thread at a time may use a device; command lists of one device are recorded one at a time.
// Lifetime: objects live until `destroy`; the device must outlive whoever uses it.
// Errors: creation functions throw aureole::Error and leave nothing behind; recording functions never throw: misuse is
// reported through the message callback (and in detail by the validation wrapper, validation.h).
#pragma once

#include <aureole/rhi/error.h>
#include <aureole/rhi/shader.h>
#include <aureole/rhi/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <variant>

namespace aureole::rhi {

/// Names and limits of a device.
struct Capabilities {
    std::string backend{};      ///< "cpu", or the name of what it stands on, in small letters.
    std::string device{};       ///< Name of the device, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
    std::string driver{};       ///< Driver and version.
    std::uint32_t threads = 0;  ///< Worker threads of a CPU backend; 0 elsewhere.
    std::uint32_t max_texture_2d = 0, max_texture_3d = 0, max_texture_cube = 0;  ///< Texels along a side.
    std::uint32_t max_push_constant_bytes = 0;                                   ///< Aureole needs 16.
    std::uint32_t timestamp_slots = 0;                                           ///< 0: timestamps are not supported.
    bool storage_write_without_format = false;  ///< Storage images of any supported format can be written.
    bool raster = false;                        ///< create_raster_pipeline and draw_fullscreen work.
};

/// Which uses of a format the device supports.
struct FormatSupport {
    bool sampled = false, linear_filter = false, storage = false, color_attachment = false;  ///< As in Usage.
};

/// A compute shader with its specialization.
struct ComputePipelineDesc {
    std::string name{};                                ///< Shown by debuggers and in messages.
    const Shader* shader = nullptr;                    ///< A compute shader.
    std::span<const Specialization> specialization{};  ///< Copied.
};

/// A fragment shader that is drawn over a whole target, with its specialization.
struct RasterPipelineDesc {
    std::string name{};                                ///< Shown by debuggers and in messages.
    const Shader* shader = nullptr;                    ///< A fragment shader; the vertex stage (one triangle) is the backend's.
    std::span<const Specialization> specialization{};  ///< Copied.
    Format target_format = Format::undefined;          ///< Of every target that it will draw to.
};

/// What stands in one slot of a binding set. Textures carry the sampler to read them with (ignored for storage).
struct Binding {
    std::uint32_t slot = 0;  ///< SlotDesc::slot of the shader.
    Texture texture{};       ///< For sampled and storage slots.
    Sampler sampler{};       ///< For sampled slots.
    Buffer buffer{};         ///< For constants: the whole buffer.
};

/// One object for each slot of a pipeline's shader.
struct BindingSetDesc {
    std::string name{};                   ///< Shown by debuggers and in messages.
    Pipeline pipeline{};                  ///< The set fits every pipeline made from the same shader.
    std::span<const Binding> bindings{};  ///< One for each slot of the shader.
};

/// Work of a compute pipeline.
struct DispatchDesc {
    Pipeline pipeline{};                          ///< Made by create_compute_pipeline or create_raster_pipeline.
    BindingSet bindings{};                        ///< Null if the shader has no slots.
    std::span<const std::byte> push_constants{};  ///< Exactly the shader's push_constant_bytes. Copied.
    std::uint32_t groups[3] = {1, 1, 1};          ///< Workgroups.
};

/// A full-screen draw of a raster pipeline.
struct DrawDesc {
    Pipeline pipeline{};                          ///< Made by create_compute_pipeline or create_raster_pipeline.
    BindingSet bindings{};                        ///< Null if the shader has no slots.
    std::span<const std::byte> push_constants{};  ///< Exactly the shader's push_constant_bytes. Copied.
    Texture target{};                             ///< In State::color_attachment; every texel is written.
};

/// Ends accesses in `before`, makes their writes visible, allows accesses in `after`.
struct TextureBarrier {
    Texture texture{};                                          ///< Lent or made.
    State before = State::undefined, after = State::undefined;  ///< The state that it is in, and the one it goes to.
};
/// The same for a buffer.
struct BufferBarrier {
    Buffer buffer{};                                            ///< Of any usage.
    State before = State::undefined, after = State::undefined;  ///< The state that it is in, and the one it goes to.
};

/// Whole-resource copies. Buffers hold tightly packed texels (rows, then slices or faces).
struct TextureToBuffer {
    Texture source{};      ///< In State::copy_source.
    Buffer destination{};  ///< In State::copy_destination; holds as many bytes at least.
};
/// Into a texture in `copy_destination`.
struct BufferToTexture {
    Buffer source{};        ///< In State::copy_source; holds as many bytes at least.
    Texture destination{};  ///< In State::copy_destination.
};
/// From one texture into another.
struct TextureToTexture {
    Texture source{}, destination{};  ///< Same format and extent.
};
using CopyDesc = std::variant<TextureToBuffer, BufferToTexture, TextureToTexture>;  ///< One of the copies.

/// Of a message; what is misused is an error.
enum class Severity : std::uint8_t { info, warning, error };
/// Receives messages of the device. Must not throw. May be called from any thread that uses the device.
using MessageCallback = void (*)(void* user, Severity severity, const char* text);

/// Records work into something that the host submits. Nothing here allocates, submits or waits.
class CommandList {
public:
    virtual ~CommandList() = default;

    /// Replaces the first bytes of a constants buffer, ordered with the commands around it: `buffer` is in
    /// State::copy_destination. At most 65536 bytes, a multiple of 4. Copied.
    virtual void update_constants(Buffer buffer, std::span<const std::byte> bytes) = 0;
    /// Ends earlier accesses in `before`, makes their writes visible, and allows accesses in `after`.
    virtual void barrier(std::span<const TextureBarrier> textures, std::span<const BufferBarrier> buffers) = 0;
    virtual void dispatch(const DispatchDesc& desc) = 0;  ///< Runs a compute shader.
    /// Runs a fragment shader once for every texel of the target.
    virtual void draw_fullscreen(const DrawDesc& desc) = 0;
    /// Source in State::copy_source, destination in State::copy_destination. A read_back buffer may be read by the CPU once
    /// the submitted work has finished.
    virtual void copy(const CopyDesc& desc) = 0;
    virtual void begin_marker(const char* name) = 0;  ///< Of a group of commands, for debuggers. May do nothing.
    virtual void end_marker() = 0;                    ///< Of the group begun last.
    /// Writes the time at which the work recorded before has finished into slot `index` (< timestamp_slots).
    virtual void timestamp(std::uint32_t index) = 0;
};

using AnyHandle = std::variant<Texture, Buffer, Sampler, Pipeline, BindingSet>;  ///< An object of any kind.

/// Creates and destroys objects. Safe to call between frames; creation may be slow (pipelines), destruction is deferred.
class Device {
public:
    virtual ~Device() = default;

    [[nodiscard]] virtual const Capabilities& capabilities() const = 0;  ///< The same for as long as the device lives.
    [[nodiscard]] virtual FormatSupport format_support(Format format, Dimension dimension) const = 0;  ///< Never throws.

    /// What is known of a texture that lives, lent ones included. Null for others, and from a device that keeps no such record:
    /// sizes that do not fit each other are then found out later, or by nobody.
    [[nodiscard]] virtual const TextureDesc* find(Texture texture) const {
        (void)texture;
        return nullptr;
    }

    [[nodiscard]] virtual Texture create_texture(const TextureDesc& desc) = 0;  ///< Its contents are undefined.
    /// Lends a host's texture. `destroy` forgets it; the host's object stays.
    [[nodiscard]] virtual Texture wrap_texture(const ExternalTexture& external) = 0;
    [[nodiscard]] virtual Buffer create_buffer(const BufferDesc& desc) = 0;     ///< Its contents are undefined.
    [[nodiscard]] virtual Sampler create_sampler(const SamplerDesc& desc) = 0;  ///< For the slots of binding sets.
    [[nodiscard]] virtual Pipeline create_compute_pipeline(const ComputePipelineDesc& desc) = 0;  ///< May take long.
    [[nodiscard]] virtual Pipeline create_raster_pipeline(const RasterPipelineDesc& desc) = 0;    ///< May take long.
    [[nodiscard]] virtual BindingSet create_binding_set(const BindingSetDesc& desc) = 0;          ///< Its objects outlive it.

    /// The object is no longer used by anything recorded after this call; it is freed once frame `last_used_frame` (in the
    /// host's own counting) has been reported complete. Null handles are ignored.
    virtual void destroy(AnyHandle handle, std::uint64_t last_used_frame) = 0;
    /// Frees what was destroyed with a frame number up to `completed_frame`.
    virtual void collect(std::uint64_t completed_frame) = 0;

    /// CPU writes into an upload buffer; CPU reads of a read_back buffer. The caller has waited for the device.
    virtual void write_buffer(Buffer buffer, std::span<const std::byte> bytes) = 0;
    virtual void read_buffer(Buffer buffer, std::span<std::byte> bytes) = 0;  ///< From the start of it; as write_buffer.
    /// Times in nanoseconds of slots [0, out.size()), from an arbitrary origin. The caller has waited for the device.
    virtual void read_timestamps(std::span<double> out_nanoseconds) = 0;

    virtual void set_message_callback(MessageCallback callback, void* user) = 0;  ///< Null: silent.
};

/// For programs without a frame loop of their own (tools, tests): records and runs one command list at a time. A host with a
/// device of its own never needs this.
class Queue {
public:
    virtual ~Queue() = default;
    /// The list to record into; valid until `submit`.
    [[nodiscard]] virtual CommandList& begin() = 0;
    /// Starts the recorded work and returns its frame number (1, 2, ...).
    virtual std::uint64_t submit() = 0;
    /// Waits for everything submitted and collects what was destroyed. Throws Error(device_lost).
    virtual void wait() = 0;
};

}  // namespace aureole::rhi
