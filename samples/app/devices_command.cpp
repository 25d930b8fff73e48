#include "app/commands.h"

#include <aureole/cpu/cpu_device.h>
#ifdef AUREOLE_HAS_VULKAN
#include <aureole/vulkan/vulkan_device.h>
#endif

#include <cstdio>

namespace aureole::app {
namespace {

void print_vulkan() {
#ifdef AUREOLE_HAS_VULKAN
    const vulkan::VulkanDeviceList list = vulkan::list_vulkan_devices();
    if (!list.problem.empty())
        std::printf("vulkan      cannot run: %s\n", list.problem.c_str());
    else if (list.devices.empty())
        std::printf("vulkan      cannot run: the Vulkan loader finds no device\n");
    for (const vulkan::VulkanDeviceInfo& d : list.devices) {
        std::printf("vulkan      %s\n", d.name.c_str());
        std::printf("            device %u, type %s, Vulkan %s, driver %s\n", d.index, d.type.c_str(), d.api_version.c_str(),
                    d.driver.c_str());
        std::printf("            %s\n", d.problem.empty() ? "can run" : ("cannot run: " + d.problem).c_str());
    }
    std::printf("            validation layer: %s\n",
                list.validation_available ? "installed" : "not installed (--validation cannot run)");
#else
    std::printf("vulkan      cannot run: this program was built without the Vulkan backend (AUREOLE_BUILD_VULKAN)\n");
#endif
}

void print_cpu(const char* name, cpu::Precision precision, const char* what) {
    try {
        const auto device = cpu::create_cpu_device({.precision = precision});
        const rhi::Capabilities& c = device->device().capabilities();
        std::printf("%-11s %s\n            %s, %u threads\n            can run\n", name, c.device.c_str(), what, c.threads);
    } catch (const Error& problem) {
        std::printf("%-11s cannot run: %s\n", name, problem.what());
    }
}

}  // namespace

void add_devices_command(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("devices", "What can run here, and why something cannot; and the models there are");
    command->callback([] {
        print_vulkan();
        print_cpu("cpu", cpu::Precision::float32, "float arithmetic, textures rounded to their formats");
        print_cpu("cpu-double", cpu::Precision::float64, "double arithmetic, nothing rounded: the reference");
        std::printf("\nmodels, on every backend (--model NAME):\n%s\n", list_models("  ").c_str());
    });
}

}  // namespace aureole::app
