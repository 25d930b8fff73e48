#include "passes/trio.h"

#include <doctest/doctest.h>

#include <cstdio>

namespace aureole::passes {

std::string Images::unsound(bool signed_too) const {
    for (const auto& [name, image] : {std::pair("CPU float: ", &single), std::pair("CPU double: ", &exact)}) {
        const std::string problem = passes::unsound(*image, signed_too);
        if (!problem.empty()) return name + problem;
    }
    const std::string problem = vulkan ? passes::unsound(*vulkan, signed_too) : std::string();
    return problem.empty() ? problem : "Vulkan: " + problem;
}

void share_view(Trio<Rig>& trio) {
    const Image sky = trio.single.sky_view();
    const bool has_froxels = trio.single.setup.view.aerial_perspective;
    const Image froxels = has_froxels ? trio.single.froxels() : Image{};
    trio.each([&](Rig& rig) {
        rig.backend.write(rig.view.sky_view_table(), sky);
        if (has_froxels) rig.backend.write(rig.view.aerial_perspective_table(), froxels);
    });
}

std::string place_name(std::string_view preset, double altitude_m, double elevation_deg) {
    char text[80];
    std::snprintf(text, sizeof text, "%.*s, %.10g m, sun at %g deg", static_cast<int>(preset.size()), preset.data(), altitude_m,
                  elevation_deg);
    return text;
}

void Precision::compare(const Images& images, std::uint32_t begin, std::uint32_t count, const Measure& with_vulkan,
                        const Measure& with_exact, std::string_view where) {
    exact.compare(images.single, images.exact, begin, count, with_exact, where);
    if (images.vulkan) vulkan.compare(*images.vulkan, images.single, begin, count, with_vulkan, where);
}

void Precision::check(std::string_view pass, std::string_view what, double vulkan_bound, double exact_bound) const {
    print_precision(pass, what, {vulkan, exact, vulkan_bound, exact_bound});
    INFO(std::string(pass), ", ", std::string(what));
    INFO("Vulkan and CPU float: ", vulkan.text());
    CHECK(vulkan.error() <= vulkan_bound);
    INFO("CPU float and CPU double: ", exact.text());
    CHECK(exact.error() <= exact_bound);
}

}  // namespace aureole::passes
