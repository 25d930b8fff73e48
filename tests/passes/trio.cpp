#include "passes/trio.h"

#include <doctest/doctest.h>

namespace aureole::passes {

std::string Images::unsound(bool signed_too) const {
    for (const auto& [name, image] : {std::pair("CPU float: ", &single), std::pair("CPU double: ", &exact)}) {
        const std::string problem = passes::unsound(*image, signed_too);
        if (!problem.empty()) return name + problem;
    }
    const std::string problem = vulkan ? passes::unsound(*vulkan, signed_too) : std::string();
    return problem.empty() ? problem : "Vulkan: " + problem;
}

void Precision::compare(const Images& images, std::uint32_t begin, std::uint32_t count, const Measure& measure,
                        std::string_view where) {
    exact.compare(images.single, images.exact, begin, count, measure, where);
    if (images.vulkan) vulkan.compare(*images.vulkan, images.single, begin, count, measure, where);
}

void Precision::check(std::string_view pass, std::string_view what, double vulkan_bound, double exact_bound) const {
    print_precision(pass, what, &vulkan, exact);
    INFO(std::string(pass), ", ", std::string(what));
    INFO("Vulkan and CPU float: ", vulkan.text());
    CHECK(vulkan.error() <= vulkan_bound);
    INFO("CPU float and CPU double: ", exact.text());
    CHECK(exact.error() <= exact_bound);
}

}  // namespace aureole::passes
