// For tests: kernels written here in C++ with the words of the kernel language, and a little harness.
#pragma once

#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi/error.h>
#include <aureole/rhi/kernel/cpu_kernel.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace aureole::kernels {

/// target(x, y) = source(x, y) / 3 + invocation number.
AUREOLE_DEFINE_CPU_KERNEL(thirds_kernel)
SAMPLER_2D(0, source)
IMAGE_2D(1, target)

COMPUTE_MAIN(id) {
    ivec2 p = ivec2(id.x, id.y);
    COUNT(2);
    vec4 looked_up = SAMPLE(source, vec2(real(0.5), real(0.5)));
    imageStore(target, p, texelFetch(source, p, 0) / real(3) + real(0) * looked_up);
}
};

/// Counts how often each invocation of a 64 x 64 x 64 box runs.
inline std::vector<std::atomic<int>> visits(64 * 64 * 64);
AUREOLE_DEFINE_CPU_KERNEL(visit_kernel)
COMPUTE_MAIN(id) { ++visits[(std::size_t(id.z) * 64 + std::size_t(id.y)) * 64 + std::size_t(id.x)]; }
}
;

/// Fails at one invocation, as told by the specialization constant.
AUREOLE_DEFINE_CPU_KERNEL(failing_kernel)
IMAGE_2D(0, target)
SPEC_INT(0, HOW, 0)
COMPUTE_MAIN(id) {
    imageStore(target, ivec2(id.x, id.y), vec4(real(1)));
    if (id.x != 5 || id.y != 3) return;
    if (HOW == 1) throw std::runtime_error("the kernel is tired");
    if (HOW == 2) throw std::bad_alloc();
    if (HOW == 3) throw 42;
    if (HOW == 4) throw Error(ErrorCode::unsupported, "no such thing");
}
}
;

AUREOLE_DEFINE_CPU_KERNEL(pixel_kernel)
FRAGMENT_MAIN(pixel) { return vec4(real(pixel.x), real(pixel.y), real(0.25), real(1)) / real(8); }
}
;

}  // namespace aureole::kernels

namespace aureole::cpu {

inline constexpr rhi::SlotDesc thirds_slots[] = {{0, rhi::SlotKind::sampled_texture, rhi::Dimension::d2, "source"},
                                                 {1, rhi::SlotKind::storage_texture, rhi::Dimension::d2, "target"}};
inline constexpr rhi::SlotDesc failing_slots[] = {{0, rhi::SlotKind::storage_texture, rhi::Dimension::d2, "target"}};
inline constexpr rhi::Shader thirds_shader = {
    "thirds", rhi::Stage::compute, {8, 4, 1}, 0, thirds_slots, {}, {}, AUREOLE_CPU_ENTRY(kernels::thirds_kernel)};
inline constexpr rhi::Shader visit_shader = {
    "visit", rhi::Stage::compute, {1, 1, 1}, 0, {}, {}, {}, AUREOLE_CPU_ENTRY(kernels::visit_kernel)};
inline constexpr rhi::Shader failing_shader = {
    "failing", rhi::Stage::compute, {8, 4, 1}, 0, failing_slots, {}, {}, AUREOLE_CPU_ENTRY(kernels::failing_kernel)};
inline constexpr rhi::Shader pixel_shader = {
    "pixel", rhi::Stage::fragment, {1, 1, 1}, 0, {}, {}, {}, AUREOLE_CPU_ENTRY(kernels::pixel_kernel)};

inline constexpr rhi::Usage any_usage = rhi::Usage::sampled | rhi::Usage::storage | rhi::Usage::color_attachment |
                                        rhi::Usage::copy_source | rhi::Usage::copy_destination;

inline rhi::Texture make_texture(CpuDevice& d, rhi::Format format, rhi::Extent extent) {
    return d.device().create_texture({"texture", rhi::Dimension::d2, format, extent, any_usage});
}

/// source / 3 -> target.
inline void run_thirds(CpuDevice& d, rhi::Texture source, rhi::Texture target, rhi::Extent extent) {
    rhi::Device& device = d.device();
    const auto pipeline = device.create_compute_pipeline({"thirds pass", &thirds_shader, {}});
    const auto sampler = device.create_sampler({});
    const rhi::Binding bindings[] = {{0, source, sampler, {}}, {1, target, {}, {}}};
    const auto set = device.create_binding_set({"thirds set", pipeline, bindings});
    d.queue().begin().dispatch({pipeline, set, {}, {(extent.width + 7) / 8, (extent.height + 3) / 4, 1}});
    d.queue().submit();
    d.queue().wait();
    for (const rhi::AnyHandle h : {rhi::AnyHandle(set), rhi::AnyHandle(sampler), rhi::AnyHandle(pipeline)})
        device.destroy(h, 0);
}

/// Copies floats (RGBA for each texel) into an rgba32_float texture.
inline void fill(CpuDevice& d, rhi::Texture texture, const std::vector<float>& rgba) {
    const auto bytes = std::as_bytes(std::span(rgba));
    const auto upload = d.device().create_buffer({"upload", bytes.size(), rhi::Usage::upload});
    d.device().write_buffer(upload, bytes);
    d.queue().begin().copy(rhi::BufferToTexture{upload, texture});
    d.queue().submit();
    d.device().destroy(upload, 0);
}

}  // namespace aureole::cpu
