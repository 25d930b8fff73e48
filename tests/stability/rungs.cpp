#include "stability/rungs.h"

#include <aureole/models/aureole.h>
#include <aureole/models/bruneton.h>
#include <aureole/models/fog.h>
#include <aureole/models/hillaire.h>
#include <aureole/models/reference.h>
#include <aureole/models/single.h>
#include <aureole/models/single_lut.h>

#include <vector>

namespace aureole::stability {
namespace {

constexpr rhi::Format half = rhi::Format::rgba16_float, full = rhi::Format::rgba32_float;

QualitySettings small_aureole(rhi::Format format) {
    QualitySettings s;
    s.name = "small";
    s.transmittance = {16, 6, 1};
    s.transmittance_nodes = 6;
    s.multi_scatter = {6, 4, 1};
    s.angular_order = 2;
    s.angular_order_as_needed = false;
    s.multi_scatter_zenith = 2;
    s.multi_scatter_azimuth = 2;
    s.multi_scatter_nodes = 4;
    s.multi_scatter_later_nodes = 3;
    s.sky_view = {8, 16, 1};
    s.sky_view_nodes = 5;
    s.aerial_perspective = {4, 4, 4};
    s.table_format = s.froxel_format = format;
    return s;
}

models::HillaireSettings small_hillaire(bool fast, rhi::Format format) {
    models::HillaireSettings s;
    s.transmittance = {16, 6, 1};
    s.transmittance_steps = 12;
    s.multi_scatter = {6, 4, 1};
    s.multi_scatter_steps = 6;
    s.fast_sky = s.fast_aerial_perspective = fast;
    s.sky_view = {8, 16, 1};
    s.sky_view_steps = 8;
    s.aerial_perspective = {4, 4, 4};
    s.march_steps = 8;
    s.grey_transmittance = fast;
    s.table_format = s.froxel_format = format;
    return s;
}

models::BrunetonSettings small_bruneton(bool combined, rhi::Format format) {
    models::BrunetonSettings s;
    s.transmittance = {16, 6, 1};
    s.transmittance_nodes = 6;
    s.irradiance = {6, 3, 1};
    s.altitude_nodes = 4;
    s.view_nodes = 8;
    s.sun_nodes = 5;
    s.nu_nodes = 3;
    s.orders = 3;
    s.combined = combined;
    s.format = format;
    s.ray_nodes = 4;
    s.zenith_nodes = 2;
    s.azimuth_nodes = 3;
    return s;
}

models::SingleSettings single(models::Steps steps, bool dome) {
    models::SingleSettings s{.steps = steps, .view_steps = 5, .light_steps = 4, .dome = {}};
    if (dome) s.dome = {.size = {8, 16, 1}, .phase = models::Dome::Phase::in_table, .format = half};
    return s;
}

models::ReferenceSettings few_paths() {
    models::ReferenceSettings s;
    s.paths_per_frame = 1;
    s.light_paths = 1;
    s.max_order = 20;
    s.first_order_parts = 1;
    s.nodes = 4;
    return s;
}

std::vector<Rung> make() {
    using models::FogSettings, models::Steps;
    return {
        {"fog, one colour", models::fog({.mode = FogSettings::Mode::one_colour}), false},
        {"fog, in-scatter", models::fog({.transmittance_nodes = 4})},
        {"fog, endless", models::fog({.sky = FogSettings::Sky::infinity, .transmittance_nodes = 4}), false},
        {"single", models::single(single(Steps::gauss, false))},
        {"single, midpoints", models::single(single(Steps::midpoints, false))},
        {"single, dome", models::single(single(Steps::gauss, true))},
        {"single-lut", models::single_lut({.view_steps = 5, .table = {16, 6, 1}, .table_nodes = 5, .dome = {}})},
        {"single-lut, half",
         models::single_lut({.view_steps = 5, .table = {16, 6, 1}, .table_nodes = 5, .table_format = half, .dome = {}})},
        {"hillaire", models::hillaire(small_hillaire(true, half))},
        {"hillaire, marched", models::hillaire(small_hillaire(false, full))},
        {"aureole", models::aureole(small_aureole(full))},
        {"aureole, half", models::aureole(small_aureole(half))},
        {"bruneton", models::bruneton(small_bruneton(false, full))},
        {"bruneton, half", models::bruneton(small_bruneton(true, half))},
        {"reference", models::reference(few_paths()), true, true},
    };
}

}  // namespace

std::span<const Rung> rungs() {
    static const std::vector<Rung> all = make();
    return all;
}

}  // namespace aureole::stability
