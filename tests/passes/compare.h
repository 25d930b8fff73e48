// Lines for the table of docs/precision.md, of what rhi/compare.h finds.
#pragma once

#include <string_view>

#include "rhi/compare.h"

namespace aureole::passes {

/// Two differences and what they may be at most.
struct PrecisionRow {
    const Worst &vulkan, &exact;
    double vulkan_bound, exact_bound;
};
/// Prints a row of docs/precision.md: "| pass | what | Vulkan to CPU float (bound) | CPU float to CPU double (bound) |".
void print_precision(std::string_view pass, std::string_view what, const PrecisionRow& row);

}  // namespace aureole::passes
