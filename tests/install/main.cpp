// Renders one row of sky through the installed package, on the CPU and, where it was built and has a device, on Vulkan; and
// writes a shader of its own that includes the package's look-ups: outside SHADER_TO_WRITE.
#include <aureole/atmosphere.h>
#include <aureole/cpu/cpu_device.h>
#include <aureole/presets.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <glm/trigonometric.hpp>
#include <span>
#include <vector>
#ifdef OUTSIDE_HAS_VULKAN
#include <aureole/vulkan/vulkan_device.h>
#endif

namespace rhi = aureole::rhi;

namespace {

/// Zenith-to-horizon radiance of a clear noon: RGBA texels, top row first.
std::vector<float> render(rhi::Device& device, rhi::Queue& queue) {
    constexpr rhi::Extent size{4, 8, 1};
    std::vector<float> pixels(4 * size.width * size.height);
    const std::uint64_t bytes = pixels.size() * sizeof(float);

    rhi::Texture target = device.create_texture({.name = "target",
                                                 .dimension = rhi::Dimension::d2,
                                                 .format = rhi::Format::rgba32_float,
                                                 .extent = size,
                                                 .usage = rhi::Usage::storage | rhi::Usage::copy_source});
    rhi::Buffer staging =
        device.create_buffer({.name = "pixels", .size = bytes, .usage = rhi::Usage::read_back | rhi::Usage::copy_destination});
    {
        const aureole::AtmosphereParameters earth = aureole::presets::earth();
        aureole::Atmosphere air(device, earth);
        aureole::View view(air, {}, {.target_format = rhi::Format::rgba32_float});
        aureole::Sun sun;
        sun.direction = {0.6, 0.0, 0.8};
        view.update(aureole::look(earth.planet.bottom_radius_m, 2.0, 0.0, glm::radians(45.0), glm::radians(60.0), 0.5),
                    std::span(&sun, 1));
        aureole::CompositeTargets targets;
        targets.target = target;
        targets.extent = size;
        view.prepare_composite(targets);

        rhi::CommandList& commands = queue.begin();
        const rhi::TextureBarrier to_storage{target, rhi::State::undefined, rhi::State::storage_write};
        const rhi::TextureBarrier to_copy{target, rhi::State::storage_write, rhi::State::copy_source};
        const rhi::BufferBarrier to_staging{staging, rhi::State::undefined, rhi::State::copy_destination};
        commands.barrier(std::span(&to_storage, 1), std::span(&to_staging, 1));
        air.record(commands);
        view.record(commands);
        view.record_composite(commands, targets);
        commands.barrier(std::span(&to_copy, 1), {});
        commands.copy(rhi::TextureToBuffer{target, staging});
        queue.submit();
        queue.wait();
    }
    device.read_buffer(staging, std::as_writable_bytes(std::span(pixels)));
    device.destroy(target, 0);
    device.destroy(staging, 0);
    return pixels;
}

/// Blue above, everything positive and finite.
bool is_sky(const std::vector<float>& pixels, const char* backend) {
    std::printf("%s: zenith %g %g %g\n", backend, double(pixels[0]), double(pixels[1]), double(pixels[2]));
    for (const float value : pixels) {
        if (!std::isfinite(value) || value <= 0) return false;
    }
    return pixels[2] > pixels[0];
}

/// What a host's shader of this air would be.
bool write_shader(rhi::Device& device, const char* path) {
    aureole::Atmosphere air(device, aureole::presets::earth());
    const aureole::View view(air);
    std::ofstream file(path);
    file << "#version 450\n#extension GL_GOOGLE_include_directive : require\n#define AUREOLE_DEFINED_CONSTANTS\n"
         << view.shader_defines() << R"(#include "aureole/glsl/aureole.glsl"
layout(local_size_x = 1) in;
layout(std430, set = 0, binding = 7) writeonly buffer Answer { vec3 answer[]; };
void main() {
    AureoleAir air = aureole_aerial_perspective(0.5, 0.5, 1000.0, vec3(1, 0, 0));
    answer[0] = aureole_sky(vec3(0, 0, 1)) * air.transmittance + air.radiance;
    answer[1] = aureole_sun_irradiance(0, vec3(0)) + aureole_sky_irradiance(vec3(0, 0, 1));
}
)";
    return file.flush().good();
}

}  // namespace

int main(int argc, char** argv) {
    bool good = argc == 2;
    const auto cpu = aureole::cpu::create_cpu_device({});
    good = good && write_shader(cpu->device(), argv[1]);
    good = is_sky(render(cpu->device(), cpu->queue()), "cpu") && good;
#ifdef OUTSIDE_HAS_VULKAN
    for (const auto& info : aureole::vulkan::list_vulkan_devices().devices) {
        if (!info.problem.empty()) continue;
        const auto vulkan = aureole::vulkan::create_vulkan_device({.index = static_cast<int>(info.index)});
        good = is_sky(render(vulkan->device(), vulkan->queue()), info.name.c_str()) && good;
    }
#endif
    return good ? 0 : 1;
}
