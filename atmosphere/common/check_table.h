// Rejecting sizes and formats of tables, for the settings of every model; and names of qualities.
#pragma once

#include <aureole/rhi/types.h>

#include <string>
#include <string_view>

namespace aureole::detail {

void check_size_2d(const std::string& field, const rhi::Extent& size, double low, double high);
/// Each side in [2, 256].
void check_froxels(const std::string& field, const rhi::Extent& size);
/// Each in [4, 4096], an even number of rows.
void check_sky_view(const std::string& field, const rhi::Extent& size);
/// rgba16_float or rgba32_float.
void check_table_format(const std::string& field, rhi::Format format);
/// Throws Error(invalid_argument): this is none of quality_names(), nor `more`, a further name of one model.
[[noreturn]] void reject_quality(std::string_view name, std::string_view more = {});

}  // namespace aureole::detail
