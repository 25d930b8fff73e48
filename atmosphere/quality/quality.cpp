#include <aureole/quality.h>

#include "common/check.h"

#include <array>

namespace aureole {
namespace {

struct Named {
    std::string_view name;
    QualitySettings (*make)();
};
constexpr std::array<Named, 4> named{{{"low", &QualitySettings::low},
                                      {"default", &QualitySettings::standard},
                                      {"high", &QualitySettings::high},
                                      {"published-2020", &QualitySettings::published_2020}}};

void check_size(const std::string& field, const rhi::Extent& size, double low, double high) {
    detail::check(field + ".width", size.width, low, high);
    detail::check(field + ".height", size.height, low, high);
}
void check_size_2d(const std::string& field, const rhi::Extent& size, double low, double high) {
    check_size(field, size, low, high);
    detail::check(field + ".depth", size.depth, 1, 1);
}

void check_format(const char* field, rhi::Format format) {
    if (format != rhi::Format::rgba16_float && format != rhi::Format::rgba32_float)
        detail::reject(field, rhi::to_string(format), "rgba16_float or rgba32_float");
}

/// Gauss nodes by number, or uniform steps where the published sampling is asked for.
void check_samples(const char* field, int count, Sampling sampling) {
    if (sampling == Sampling::gauss)
        detail::check(field, count, 2, 16);
    else
        detail::check(field, count, 1, 256);
}

void check_angular_order(const QualitySettings& s) {
    const bool mean_only = s.sampling == Sampling::published_2020;
    const int order = s.angular_order;
    if (order == 0 || (!mean_only && (order == 2 || order == 4 || order == 8))) return;
    detail::reject("angular_order", std::to_string(order), mean_only ? "0 with published_2020 sampling" : "0, 2, 4 or 8");
}

}  // namespace

void validate(const QualitySettings& s) {
    detail::check_enum("sampling", s.sampling, Sampling::published_2020, "gauss or published_2020");
    check_size_2d("transmittance", s.transmittance, 2, 4096);
    check_samples("transmittance_nodes", s.transmittance_nodes, s.sampling);
    check_size_2d("multi_scatter", s.multi_scatter, 2, 256);
    check_angular_order(s);
    detail::check("multi_scatter_zenith", s.multi_scatter_zenith, 2, 16);
    detail::check("multi_scatter_azimuth", s.multi_scatter_azimuth, 2, 32);
    check_samples("multi_scatter_nodes", s.multi_scatter_nodes, s.sampling);
    // The rest is extrapolated from the last two; the published sampling goes on from the first by itself.
    detail::check("multi_scatter_orders", s.multi_scatter_orders, s.sampling == Sampling::gauss ? 2 : 1, 64);
    check_size_2d("sky_view", s.sky_view, 4, 4096);
    if (s.sky_view.height % 2 != 0)
        detail::reject("sky_view.height", std::to_string(s.sky_view.height), "an even number in [4, 4096]");
    check_samples("sky_view_nodes", s.sky_view_nodes, s.sampling);
    check_size("aerial_perspective", s.aerial_perspective, 2, 256);
    detail::check("aerial_perspective.depth", s.aerial_perspective.depth, 2, 256);
    detail::check("aerial_perspective_nodes", s.aerial_perspective_nodes, 1, 8);
    check_format("table_format", s.table_format);
    check_format("froxel_format", s.froxel_format);
}

QualitySettings QualitySettings::standard() { return {}; }

QualitySettings QualitySettings::low() {
    QualitySettings s;
    s.name = "low";
    s.transmittance = {64, 16, 1};
    s.transmittance_nodes = 6;
    s.multi_scatter = {16, 8, 1};
    s.multi_scatter_azimuth = 3;
    s.angular_order = 0;
    s.multi_scatter_zenith = 3;
    s.multi_scatter_nodes = 6;
    s.sky_view = {24, 64, 1};
    s.sky_view_nodes = 7;
    s.aerial_perspective = {16, 16, 16};
    return s;
}

QualitySettings QualitySettings::high() {
    QualitySettings s;
    s.name = "high";
    s.transmittance = {256, 64, 1};
    s.multi_scatter = {40, 16, 1};
    s.angular_order = 8;
    s.angular_order_as_needed = true;
    s.multi_scatter_zenith = 8;
    s.multi_scatter_azimuth = 5;
    s.multi_scatter_nodes = 12;
    s.multi_scatter_orders = 4;
    s.sky_view = {64, 256, 1};
    s.sky_view_nodes = 12;
    s.aerial_perspective = {32, 32, 64};
    s.aerial_perspective_nodes = 2;
    s.froxel_format = rhi::Format::rgba32_float;
    return s;
}

QualitySettings QualitySettings::published_2020() {
    QualitySettings s;
    s.name = "published-2020";
    s.sampling = Sampling::published_2020;
    s.transmittance = {256, 64, 1};
    s.transmittance_nodes = 40;
    s.multi_scatter = {32, 32, 1};
    s.angular_order = 0;
    s.multi_scatter_zenith = 8;  // 8 x 8 = 64 directions over the whole sphere
    s.multi_scatter_azimuth = 8;
    s.multi_scatter_nodes = 20;
    s.multi_scatter_orders = 1;
    s.sky_view = {200, 100, 1};
    s.sky_view_nodes = 30;
    s.aerial_perspective = {32, 32, 32};
    s.aerial_perspective_nodes = 1;
    s.table_format = rhi::Format::rgba16_float;
    return s;
}

QualitySettings QualitySettings::by_name(std::string_view name) {
    for (const Named& setting : named)
        if (setting.name == name) return setting.make();
    // Appended piece by piece: with -O3, g++ 12 warns about an insertion at the front of a string (GCC bug 105651).
    detail::reject("quality", std::string("\"").append(name).append("\""), "low, default, high or published-2020");
}

}  // namespace aureole
