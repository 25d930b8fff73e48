// The picture by the C++ API.
#include "c_api/picture.h"

#include <aureole/atmosphere.h>
#include <aureole/cpu/cpu_device.h>
#include <aureole/light.h>
#include <aureole/plan.h>
#include <aureole/presets.h>
#ifdef C_API_TEST_OPENS_VULKAN
#include <aureole/vulkan/vulkan_device.h>
#endif

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <span>

using namespace aureole;

namespace {

AtmosphereParameters scene_air() {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = {0.1, 0.2, 0.3};
    air.terms[1].scattering_per_m *= 3;
    air.terms[1].phase = HenyeyGreensteinPhase{0.7};
    air.terms[1].profile = TabulatedProfile{{0, 500, 3000}, {1, 0.5, 0}};
    return air;
}

void copy(const Rgb& from, double* to) { to[0] = from.x, to[1] = from.y, to[2] = from.z; }

void copy(const std::string& from, std::span<char> to) {
    const std::size_t size = std::min(from.size(), to.size() - 1);
    std::memcpy(to.data(), from.data(), size);
    to[size] = 0;
}

rhi::Buffer read_back(rhi::Device& device, rhi::CommandList& commands, rhi::Texture texture, rhi::State state,
                      std::size_t bytes) {
    const rhi::Buffer buffer = device.create_buffer({"read back", bytes, rhi::Usage::read_back | rhi::Usage::copy_destination});
    const rhi::BufferBarrier writable{buffer, rhi::State::undefined, rhi::State::copy_destination};
    const rhi::TextureBarrier readable{texture, state, rhi::State::copy_source}, back{texture, rhi::State::copy_source, state};
    commands.barrier({&readable, 1}, {&writable, 1});
    commands.copy(rhi::TextureToBuffer{texture, buffer});
    commands.barrier({&back, 1}, {});
    return buffer;
}

void render(rhi::Device& device, rhi::Queue& queue, picture& out) {
    const AtmosphereParameters parameters = scene_air();
    Atmosphere air(device, parameters, model_by_name("aureole", "low"));
    CompositeSettings composite;
    composite.target_format = rhi::Format::rgba32_float;
    composite.exposure = 1.5;
    ViewSettings settings;
    settings.max_suns = 2;
    View view(air, settings, composite);
    CompositeTargets targets;
    targets.extent = {PICTURE_WIDTH, PICTURE_HEIGHT, 1};
    targets.target = device.create_texture({"target", rhi::Dimension::d2, rhi::Format::rgba32_float, targets.extent,
                                            rhi::Usage::storage | rhi::Usage::copy_source});
    view.prepare_composite(targets);
    Sun suns[2];
    suns[0].direction = {0.6, 0.1, 0.8};
    suns[0].irradiance = {10, 9, 8};
    suns[1].direction = {-1, 0.5, 0.02};
    suns[1].angular_radius_rad = 0.03;
    suns[1].limb_darkening = LimbDarkening::none;
    view.update(look(parameters.planet.bottom_radius_m, 1500, 0.3, 0.1, 1.2, 1.5), suns);

    rhi::CommandList& commands = queue.begin();
    const rhi::TextureBarrier writable{targets.target, rhi::State::undefined, rhi::State::storage_write};
    commands.barrier({&writable, 1}, {});
    air.record(commands);
    view.record(commands);
    view.record_composite(commands, targets);
    const rhi::Buffer texels = read_back(device, commands, targets.target, rhi::State::storage_write, sizeof out.texels);
    const rhi::Buffer light = read_back(device, commands, view.light_table(), rhi::State::sampled, sizeof out.light);
    queue.submit();
    queue.wait();
    device.read_buffer(texels, std::as_writable_bytes(std::span(out.texels)));
    device.read_buffer(light, std::as_writable_bytes(std::span(out.light)));
    for (const rhi::AnyHandle handle : {rhi::AnyHandle(texels), rhi::AnyHandle(light), rhi::AnyHandle(targets.target)})
        device.destroy(handle, 0);

    const LightTable table(out.light);
    copy(table.sun_irradiance(1), out.sun_irradiance);
    copy(table.sky_irradiance({0, 0, 2}), out.sky_irradiance);
    copy(table.sky_coefficient(3, 0), out.sky_coefficient);
    copy(vertical_optical_depth(parameters), out.vertical_depth);
    PlanRequirements needs;
    needs.air = presets::earth();
    needs.altitude_m = {2, 3000};
    needs.geometry = true;
    needs.tolerance = 0.05;
    const Plan chosen = plan(needs);
    copy(chosen.setting.id(), out.setting);
    copy(chosen.text(), out.plan_text);
}

template <class Act>
int told(const Act& act) {
    try {
        return act();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "C++: %s\n", error.what());
        return 1;
    }
}

}  // namespace

int picture_by_cpp_on_cpu(picture* out) {
    return told([&] {
        const auto cpu = cpu::create_cpu_device();
        render(cpu->device(), cpu->queue(), *out);
        return 0;
    });
}

int picture_by_cpp_on_vulkan(picture* out) {
#ifdef C_API_TEST_OPENS_VULKAN
    return told([&] {
        const auto list = vulkan::list_vulkan_devices();
        if (std::none_of(list.devices.begin(), list.devices.end(), [](const auto& d) { return d.problem.empty(); })) return 2;
        const auto own = vulkan::create_vulkan_device({});
        render(own->device(), own->queue(), *out);
        return 0;
    });
#else
    (void)out;
    return 2;
#endif
}
