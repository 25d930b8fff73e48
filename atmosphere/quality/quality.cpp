#include <aureole/quality.h>

#include "common/check.h"
#include "common/check_table.h"

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
                                      {"converged", &QualitySettings::converged}}};

void check_nodes(const char* field, int count) { detail::check(field, count, 2, 16); }

void check_angular_order(const QualitySettings& s) {
    const int order = s.angular_order;
    if (order == 0 || order == 2 || order == 4 || order == 6 || order == 8) return;
    detail::reject("aureole.angular_order", std::to_string(order), "0, 2, 4, 6 or 8");
}

/// The rest is extrapolated from the last two: one is too few.
void check_orders(const QualitySettings& s) {
    const int orders = s.multi_scatter_orders;
    if (orders == 0 || (orders >= 2 && orders <= 64)) return;
    detail::reject("aureole.multi_scatter_orders", std::to_string(orders), "0, or in [2, 64]");
}

}  // namespace

void validate(const QualitySettings& s) {
    detail::check_size_2d("aureole.transmittance", s.transmittance, 2, 4096);
    check_nodes("aureole.transmittance_nodes", s.transmittance_nodes);
    detail::check_size_2d("aureole.multi_scatter", s.multi_scatter, 2, 256);
    check_angular_order(s);
    detail::check("aureole.multi_scatter_zenith", s.multi_scatter_zenith, 2, 16);
    detail::check("aureole.multi_scatter_azimuth", s.multi_scatter_azimuth, 2, 32);
    check_nodes("aureole.multi_scatter_nodes", s.multi_scatter_nodes);
    check_nodes("aureole.multi_scatter_later_nodes", s.multi_scatter_later_nodes);
    check_orders(s);
    detail::check_sky_view("aureole.sky_view", s.sky_view);
    check_nodes("aureole.sky_view_nodes", s.sky_view_nodes);
    detail::check_froxels("aureole.aerial_perspective", s.aerial_perspective);
    detail::check("aureole.aerial_perspective_nodes", s.aerial_perspective_nodes, 1, 8);
    detail::check_table_format("aureole.table_format", s.table_format);
    detail::check_table_format("aureole.froxel_format", s.froxel_format);
}

std::span<const std::string_view> quality_names() {
    static constexpr std::array<std::string_view, 3> names{"low", "default", "high"};
    return names;
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
    s.angular_order_as_needed = false;
    s.multi_scatter_zenith = 4;
    s.multi_scatter_nodes = 6;
    s.multi_scatter_later_nodes = 4;
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
    s.multi_scatter_zenith = 10;
    s.multi_scatter_azimuth = 5;
    s.multi_scatter_nodes = 12;
    s.multi_scatter_later_nodes = 6;
    s.multi_scatter_orders = 4;
    s.sky_view = {64, 256, 1};
    s.sky_view_nodes = 12;
    s.aerial_perspective = {32, 32, 64};
    s.aerial_perspective_nodes = 2;
    s.froxel_format = rhi::Format::rgba32_float;
    return s;
}

QualitySettings QualitySettings::converged() {
    QualitySettings s;
    s.name = "converged";
    s.transmittance = {512, 128, 1};
    s.transmittance_nodes = 16;
    s.multi_scatter = {56, 24, 1};
    s.angular_order = 8;
    s.angular_order_as_needed = false;
    s.multi_scatter_zenith = s.multi_scatter_azimuth = 10;
    s.multi_scatter_nodes = 16;
    s.multi_scatter_later_nodes = 12;
    s.multi_scatter_orders = 6;
    s.sky_view = {80, 320, 1};
    s.sky_view_nodes = 16;
    s.aerial_perspective = {32, 32, 96};
    s.aerial_perspective_nodes = 2;
    s.froxel_format = rhi::Format::rgba32_float;
    return s;
}

QualitySettings QualitySettings::by_name(std::string_view name) {
    for (const Named& setting : named)
        if (setting.name == name) return setting.make();
    detail::reject_quality(name);
}

}  // namespace aureole
