#include "common/check_table.h"

#include "common/check.h"

#include <aureole/quality.h>

namespace aureole::detail {
namespace {

void check_size(const std::string& field, const rhi::Extent& size, double low, double high) {
    check(field + ".width", size.width, low, high);
    check(field + ".height", size.height, low, high);
}

}  // namespace

void check_size_2d(const std::string& field, const rhi::Extent& size, double low, double high) {
    check_size(field, size, low, high);
    check(field + ".depth", size.depth, 1, 1);
}

void check_froxels(const std::string& field, const rhi::Extent& size) {
    check_size(field, size, 2, 256);
    check(field + ".depth", size.depth, 2, 256);
}

void check_sky_view(const std::string& field, const rhi::Extent& size) {
    check_size_2d(field, size, 4, 4096);
    if (size.height % 2 != 0) reject(field + ".height", std::to_string(size.height), "an even number in [4, 4096]");
}

void check_table_format(const std::string& field, rhi::Format format) {
    if (format != rhi::Format::rgba16_float && format != rhi::Format::rgba32_float)
        reject(field, rhi::to_string(format), "rgba16_float or rgba32_float");
}

void reject_quality(std::string_view name, std::string_view more) {
    std::string known;
    for (const std::string_view one : quality_names()) known.append(known.empty() ? "" : ", ").append(one);
    known.append(", converged");
    if (!more.empty()) known.append(", ").append(more);
    // Appended piece by piece: with -O3, g++ 12 warns about an insertion at the front of a string (GCC bug 105651).
    reject("quality", std::string("\"").append(name).append("\""), "one of " + known);
}

}  // namespace aureole::detail
