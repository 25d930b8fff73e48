#include "passes/compare.h"

#include <cstdio>
#include <string>

namespace aureole::passes {

void print_precision(std::string_view pass, std::string_view what, const PrecisionRow& row) {
    const auto cell = [](const Worst& worst, double bound) {
        return worst.compared() ? print(worst.error()) + " (" + print(bound) + ")" : "not run";
    };
    std::printf("| %s | %s | %s | %s |\n", std::string(pass).c_str(), std::string(what).c_str(),
                cell(row.vulkan, row.vulkan_bound).c_str(), cell(row.exact, row.exact_bound).c_str());
    std::fflush(stdout);
}

}  // namespace aureole::passes
