// Checks of what every rhi::Device must do. A backend's test program makes a device of its own and calls run_all; failures
// are doctest's. Device limits are respected: what a device says it cannot do is not tried.
#pragma once

#include <aureole/rhi/device.h>

#include <cstddef>
#include <functional>
#include <span>

namespace aureole::conformance {

struct Target {
    rhi::Device& device;
    rhi::Queue& queue;
    /// The device rounds every store to nearest even and filters in full precision (the CPU backend). Otherwise either
    /// neighbour of the exact value is accepted, denormals may vanish, and filter weights may have 8 bits.
    bool exact = false;
    /// Makes a texture of a host's and lends it in State::general; it stays as long as the device. Empty: nothing can be lent,
    /// and lent textures are not checked.
    std::function<rhi::ExternalTexture(const rhi::TextureDesc&)> lend{};
};

struct Check {
    const char* name;
    void (*run)(const Target&);
};
[[nodiscard]] std::span<const Check> checks();

/// Every check, its name shown with each failure.
void run_all(const Target& target);

// The checks, by the file that holds them.
void check_capabilities(const Target&);  // objects_checks.cpp
void check_creation_errors(const Target&);
void check_deferred_destroy(const Target&);
void check_lent_textures(const Target&);
void check_texel_round_trips(const Target&);  // copy_checks.cpp
void check_texture_copies(const Target&);
void check_cube_copies(const Target&);
void check_storage_formats(const Target&);  // format_checks.cpp
void check_attachment_formats(const Target&);
void check_format_reads(const Target&);
void check_nearest(const Target&);  // sampling_checks.cpp
void check_linear(const Target&);
void check_linear_repeat(const Target&);
void check_3d(const Target&);
void check_cube(const Target&);
void check_cube_edges(const Target&);
void check_specialization(const Target&);  // command_checks.cpp
void check_constants(const Target&);
void check_update_order(const Target&);
void check_barriers(const Target&);
void check_edges(const Target&);
void check_raster(const Target&);
void check_timestamps(const Target&);
void check_markers_and_messages(const Target&);
void check_frames(const Target&);

}  // namespace aureole::conformance
