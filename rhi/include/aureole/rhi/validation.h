// A device around any other device that watches how it is used and reports every misuse once, by the names of the objects
// involved, through the message callback (Severity::error; text "<function>: ...").
//
// Found are: handles that are unknown or destroyed; descriptors, sizes and limits that the device forbids; empty slots, and
// slots with an object of the wrong kind, dimension or usage; push constants, updates and copies of a wrong size; draws to a
// target of another format; barriers that name a wrong state; work on a resource in a wrong state, without a barrier after
// the last write, or on contents that were never written; work recorded outside begin and submit; a host's texture not left
// in the state it came in, or destroyed in another one while a list is open; markers that do not match; timestamps out of
// range, or read before they were written; buffers touched by the CPU while in use; objects destroyed too early; frames said
// to be complete that cannot be; and objects that are left when the validation device goes.
//
// A command that could harm the device is reported and not passed on; one that is only ordered wrongly is passed on.
// States are followed in the order of recording. Textures start in State::undefined (a host's texture: as it says), and so
// do buffers, except upload buffers, which start in State::copy_source: what the CPU wrote before the work is submitted may be
// copied from without a barrier. A barrier from `undefined` throws a texture's contents away, a buffer keeps its bytes. Once
// copied into, and the work finished, read_back buffers may be read by the CPU without more. A frame is unfinished until
// Device::collect says that it is complete, or, with a queue, until Queue::wait has returned.
#pragma once

#include <aureole/rhi/device.h>

#include <cstdint>
#include <memory>

namespace aureole::rhi {

/// How a validation device answers misuse.
struct ValidationDesc {
    /// Throw Error(misuse) after reporting, also from recording functions. Leaks are only reported.
    bool throw_on_misuse = false;
};

/// A device around another one that watches how it is used, and reports each misuse once, by the objects' names.
class ValidationDevice : public Device {
public:
    /// For hosts with command lists of their own: the list to record into instead of `inner`, until `end_list`. One list at
    /// a time. `frame`, 1 or more, is the host's number of the frame that the list belongs to, as in `destroy` and `collect`:
    /// not below the frame of the list before, and above every frame that is complete. Throws Error(misuse) if a list is open.
    virtual CommandList& begin_list(CommandList& inner, std::uint64_t frame) = 0;
    /// Checks what must hold at the end of a list.
    virtual void end_list() = 0;
    /// Misuses reported so far.
    [[nodiscard]] virtual std::uint64_t misuse_count() const = 0;
};

/// `inner` outlives the validation device, which takes over its message callback: set yours on the validation device.
/// Handles are those of `inner`. Objects made before, from `inner` itself, are unknown here.
[[nodiscard]] std::unique_ptr<ValidationDevice> create_validation_device(Device& inner, const ValidationDesc& desc = {});

/// The queue that belongs to it. Both arguments outlive it. `device` was made by create_validation_device.
[[nodiscard]] std::unique_ptr<Queue> create_validation_queue(ValidationDevice& device, Queue& inner);

}  // namespace aureole::rhi
