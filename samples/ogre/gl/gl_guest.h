// An adapter: Aureole's render interface on an OpenGL 4.3 context of a host's (an engine, a toolkit). Nothing of it is known to
// the module, and nothing of the engine to it. How it was made, and what to mind: ../ogre.md.
//
//     auto guest = gl::borrow_context();                    // once; the context is current here and in every call below
//     Atmosphere air(guest->device(), presets::earth());
//     while (next_frame()) {                                // where no draw of the host's is half set up
//         rhi::CommandList& list = guest->begin_recording();
//         air.record(list);                                 // runs as it is recorded: OpenGL has one queue, the context
//         guest->end_recording();                           // the host's state is as it was
//     }
#pragma once

#include <aureole/rhi/device.h>

#include <cstdint>
#include <memory>

namespace aureole::gl {

/// All calls come from the thread in which the context is current, the destructor included.
class Guest {
public:
    virtual ~Guest() = default;

    /// `wrap_texture` takes the name of a texture as ExternalTexture::native; its size and format are compared with the
    /// descriptor. `destroy` frees at once, whatever the frame: OpenGL itself keeps what unfinished work reads.
    [[nodiscard]] virtual rhi::Device& device() noexcept = 0;

    /// Commands of the list are issued as they are recorded, in the order of the host's own. Whatever binding or setting a
    /// command touches is read first, and put back by end_recording. Recording twice is Error(misuse).
    [[nodiscard]] virtual rhi::CommandList& begin_recording() = 0;
    /// After it, what was written is visible to all that the host does. Error(misuse) without begin_recording.
    virtual void end_recording() = 0;
    /// begin_recording and end_recording, for programs without frames of their own.
    [[nodiscard]] virtual rhi::Queue& queue() noexcept = 0;

    /// OpenGL's name of a texture or buffer, for the host's own shaders. The adapter keeps it. Error(invalid_argument) if
    /// unknown.
    [[nodiscard]] virtual std::uint32_t native(rhi::Texture texture) const = 0;
    [[nodiscard]] virtual std::uint32_t native(rhi::Buffer buffer) const = 0;
};

/// Throws Error(unsupported) where the context is no desktop OpenGL of version 4.3 or later. A context must be current.
[[nodiscard]] std::unique_ptr<Guest> borrow_context();

}  // namespace aureole::gl
