#include "common/check.h"

#include <aureole/models/bruneton.h>

#include <string>

namespace aureole::models {
namespace {

using detail::check;

void check_table(const std::string& field, const rhi::Extent& size, double most) {
    check(field + ".width", size.width, 2, most);
    check(field + ".height", size.height, 2, most);
    check(field + ".depth", size.depth, 1, 1);
}

}  // namespace

void validate(const BrunetonSettings& s) {
    check_table("transmittance", s.transmittance, 4096);
    check_table("irradiance", s.irradiance, 1024);
    check("altitude_nodes", s.altitude_nodes, 2, 256);
    check("view_nodes", s.view_nodes, 4, 512);
    if (s.view_nodes % 2 != 0) detail::reject("view_nodes", std::to_string(s.view_nodes), "an even number in [4, 512]");
    check("sun_nodes", s.sun_nodes, 2, 256);
    check("nu_nodes", s.nu_nodes, 2, 64);
    if (s.nu_nodes * s.sun_nodes > 2048)
        detail::reject("nu_nodes", std::to_string(s.nu_nodes),
                       "at most 2048 / sun_nodes (" + std::to_string(s.sun_nodes) + ")");
    check("orders", s.orders, 1, 64);
    if (s.format != rhi::Format::rgba16_float && s.format != rhi::Format::rgba32_float)
        detail::reject("format", rhi::to_string(s.format), "rgba16_float or rgba32_float");
    detail::check_enum("sampling", s.sampling, BrunetonSampling::published, "gauss or published");
    check("transmittance_nodes", s.transmittance_nodes, 2, 16);
    check("ray_nodes", s.ray_nodes, 2, 16);
    check("zenith_nodes", s.zenith_nodes, 2, 16);
    check("azimuth_nodes", s.azimuth_nodes, 2, 16);
    check("lowest_sun_deg", s.lowest_sun_deg, 91, 120);
    check("slices_per_frame", s.slices_per_frame, 0, 1000000);
}

BrunetonSettings BrunetonSettings::low() {
    BrunetonSettings s;
    s.transmittance = {128, 32, 1};
    s.irradiance = {32, 8, 1};
    s.altitude_nodes = 16;
    s.view_nodes = 64;
    s.sun_nodes = 24;
    s.combined = true;
    s.zenith_nodes = 4;  // nodes of a ray as many as by default: with four, twilight has the wrong colours
    s.azimuth_nodes = 6;
    return s;
}

BrunetonSettings BrunetonSettings::standard() { return {}; }

BrunetonSettings BrunetonSettings::high() {
    BrunetonSettings s;
    s.sun_nodes = 64;
    s.orders = 8;
    s.ray_nodes = 10;
    s.zenith_nodes = 8;
    s.azimuth_nodes = 10;
    return s;
}

BrunetonSettings BrunetonSettings::published() {
    BrunetonSettings s;
    s.combined = true;
    s.sampling = BrunetonSampling::published;
    return s;
}

BrunetonSettings BrunetonSettings::by_name(std::string_view name) {
    if (name == "low") return low();
    if (name == "default") return standard();
    if (name == "high") return high();
    if (name == "published") return published();
    detail::reject("quality", "\"" + std::string(name) + "\"", "low, default, high or published");
}

}  // namespace aureole::models
