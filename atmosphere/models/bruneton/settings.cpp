#include "common/check.h"
#include "common/check_table.h"

#include <aureole/models/bruneton.h>

#include <string>

namespace aureole::models {
namespace {

using detail::check;

}  // namespace

void validate(const BrunetonSettings& s) {
    detail::check_size_2d("bruneton.transmittance", s.transmittance, 2, 4096);
    detail::check_size_2d("bruneton.irradiance", s.irradiance, 2, 1024);
    check("bruneton.altitude_nodes", s.altitude_nodes, 2, 256);
    check("bruneton.view_nodes", s.view_nodes, 4, 512);
    if (s.view_nodes % 2 != 0)
        detail::reject("bruneton.view_nodes", std::to_string(s.view_nodes), "an even number in [4, 512]");
    check("bruneton.sun_nodes", s.sun_nodes, 2, 256);
    check("bruneton.nu_nodes", s.nu_nodes, 2, 64);
    if (s.nu_nodes * s.sun_nodes > 2048)
        detail::reject("bruneton.nu_nodes", std::to_string(s.nu_nodes),
                       "at most 2048 / sun_nodes (" + std::to_string(s.sun_nodes) + ")");
    check("bruneton.orders", s.orders, 1, 64);
    detail::check_table_format("bruneton.format", s.format);
    detail::check_enum("bruneton.sampling", s.sampling, BrunetonSampling::published, "gauss or published");
    check("bruneton.transmittance_nodes", s.transmittance_nodes, 2, 16);
    check("bruneton.ray_nodes", s.ray_nodes, 2, 16);
    check("bruneton.zenith_nodes", s.zenith_nodes, 2, 16);
    check("bruneton.azimuth_nodes", s.azimuth_nodes, 2, 16);
    check("bruneton.lowest_sun_deg", s.lowest_sun_deg, 91, 120);
    check("bruneton.slices_per_frame", s.slices_per_frame, 0, 1000000);
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

BrunetonSettings BrunetonSettings::converged() {
    BrunetonSettings s = high();
    s.irradiance = {128, 32, 1};
    s.nu_nodes = 12;
    s.ray_nodes = s.transmittance_nodes = 12;
    s.format = rhi::Format::rgba32_float;
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
    if (name == "converged") return converged();
    if (name == "published") return published();
    detail::reject_quality(name, "published");
}

}  // namespace aureole::models
