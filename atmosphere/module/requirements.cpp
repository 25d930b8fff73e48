#include "module/requirements.h"

#include "multi_scatter/extents.h"

#include <algorithm>
#include <string>

namespace aureole::detail {
namespace {

[[noreturn]] void missing(const std::string& what, const std::string& has, const std::string& needed) {
    throw Error(ErrorCode::unsupported, what, has, needed);
}

/// The longest side of the multi-scatter tables, at the most that an air may get (Model::quality_for); 0: there are none.
std::uint32_t multi_scatter_side(const QualitySettings& quality) {
    if (quality.multi_scatter_orders == 0) return 0;
    QualitySettings most = quality;
    const int least = quality.angular_order_as_needed ? quality.angular_order + 2 : 0;
    most.multi_scatter_zenith = std::max(most.multi_scatter_zenith, least);
    most.multi_scatter_azimuth = std::max(most.multi_scatter_azimuth, least);
    return std::max(
        {quality.multi_scatter.width, multi_scatter_table_extent(most).height, multi_scatter_rays_extent(most).height});
}

}  // namespace

void require_table(const rhi::Device& device, rhi::Format format, rhi::Dimension dimension, bool filtered) {
    const rhi::FormatSupport support = device.format_support(format, dimension);
    if (support.sampled && (support.linear_filter || !filtered) && support.storage) return;
    const auto word = [](bool yes, const char* text) { return std::string(yes ? "" : "no ") + text; };
    missing(std::string("device format ") + rhi::to_string(format) + " (" + rhi::to_string(dimension) + ")",
            word(support.sampled, "sampling") + ", " + word(support.linear_filter, "linear filter") + ", " +
                word(support.storage, "storage"),
            "sampling, linear filter and storage; another table format can be chosen in the model's settings");
}

void require_size(const char* what, std::uint32_t limit, std::uint32_t needed) {
    if (limit < needed) missing(what, std::to_string(limit), "at least " + std::to_string(needed) + " texels a side");
}

void require_device(const rhi::Device& device) {
    const rhi::Capabilities& capabilities = device.capabilities();
    if (!capabilities.storage_write_without_format)
        missing("device.storage_write_without_format", "false", "true: kernels write images of several formats");
    if (capabilities.max_push_constant_bytes < 16)
        missing("device.max_push_constant_bytes", std::to_string(capabilities.max_push_constant_bytes), "at least 16");
    require_table(device, rhi::Format::rgba32_float, rhi::Dimension::d2, false);
    require_size("device.max_texture_2d", capabilities.max_texture_2d, 4096U);  // a user's tables
}

void require_tables(const rhi::Device& device, const QualitySettings& quality) {
    const rhi::Capabilities& capabilities = device.capabilities();
    require_table(device, quality.table_format, rhi::Dimension::d2);
    require_table(device, rhi::Format::rgba16_float, rhi::Dimension::d2);
    require_table(device, quality.froxel_format, rhi::Dimension::d3);
    const std::uint32_t widest = std::max({quality.transmittance.width, quality.transmittance.height, quality.sky_view.width,
                                           quality.sky_view.height, multi_scatter_side(quality)});
    require_size("device.max_texture_2d", capabilities.max_texture_2d, widest);
    require_size(
        "device.max_texture_3d", capabilities.max_texture_3d,
        std::max({quality.aerial_perspective.width, quality.aerial_perspective.height, quality.aerial_perspective.depth}));
}

void require_rows(const std::string& field, std::uint32_t height, std::uint32_t suns, std::uint32_t layers_per_sun,
                  const char* limit_name, std::uint32_t limit) {
    const std::uint32_t layers = suns * layers_per_sun + 1;
    if (std::uint64_t{height} * layers <= limit) return;
    missing(field, std::to_string(height) + " with view.max_suns " + std::to_string(suns),
            "at most " + std::to_string(limit / layers) + " (" + limit_name + " " + std::to_string(limit) + ", shared by " +
                std::to_string(layers) + " layers), or fewer suns");
}

void require_view(const rhi::Device& device, std::string_view model, const ViewTableSizes& sizes, std::uint32_t suns,
                  std::uint32_t layers_per_sun) {
    const rhi::Capabilities& capabilities = device.capabilities();
    require_rows(std::string(model).append(".sky_view.height"), sizes.sky_view_height, suns, layers_per_sun,
                 "device.max_texture_2d", capabilities.max_texture_2d);
    require_rows(std::string(model).append(".aerial_perspective.height"), sizes.froxels_height, suns, layers_per_sun,
                 "device.max_texture_3d", capabilities.max_texture_3d);
}

void require_target(const rhi::Device& device, const CompositeSettings& settings) {
    const rhi::FormatSupport support = device.format_support(settings.target_format, rhi::Dimension::d2);
    const std::string what = std::string("device format ") + rhi::to_string(settings.target_format);
    if (settings.raster && !device.capabilities().raster)
        missing("device.raster", "false", "true, or CompositeSettings::raster = false");
    if (settings.raster && !support.color_attachment) missing(what, "no colour attachment", "colour attachment");
    if (!settings.raster && !support.storage) missing(what, "no storage", "storage, or CompositeSettings::raster = true");
}

}  // namespace aureole::detail
