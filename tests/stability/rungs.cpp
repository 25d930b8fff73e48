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

/// Twice, thrice ... as many texels along every side.
rhi::Extent texels(rhi::Extent least, std::uint32_t finer) {
    return {least.width * finer, least.height * finer, least.depth == 1 ? 1 : least.depth * finer};
}

QualitySettings small_aureole(rhi::Format format, std::uint32_t finer = 1) {
    QualitySettings s;
    s.name = "small";
    s.transmittance = texels({16, 6, 1}, finer);
    s.transmittance_nodes = 6;
    s.multi_scatter = texels({6, 4, 1}, finer);
    s.angular_order = 2;
    s.angular_order_as_needed = false;
    s.multi_scatter_zenith = 2;
    s.multi_scatter_azimuth = 2;
    s.multi_scatter_nodes = 4;
    s.multi_scatter_later_nodes = 3;
    s.sky_view = texels({8, 16, 1}, finer);
    s.sky_view_nodes = 5;
    s.aerial_perspective = texels({4, 4, 4}, finer);
    s.table_format = s.froxel_format = format;
    return s;
}

models::HillaireSettings small_hillaire(bool fast, rhi::Format format, std::uint32_t finer = 1) {
    models::HillaireSettings s;
    s.transmittance = texels({16, 6, 1}, finer);
    s.transmittance_steps = 12;
    s.multi_scatter = texels({6, 4, 1}, finer);
    s.multi_scatter_steps = 6;
    s.fast_sky = s.fast_aerial_perspective = fast;
    s.sky_view = texels({8, 16, 1}, finer);
    s.sky_view_steps = 8;
    s.aerial_perspective = texels({4, 4, 4}, finer);
    s.march_steps = 8;
    s.grey_transmittance = fast;
    s.table_format = s.froxel_format = format;
    return s;
}

models::BrunetonSettings small_bruneton(bool combined, rhi::Format format, int finer = 1) {
    models::BrunetonSettings s;
    s.transmittance = texels({16, 6, 1}, static_cast<std::uint32_t>(finer));
    s.transmittance_nodes = 6;
    s.irradiance = texels({6, 3, 1}, static_cast<std::uint32_t>(finer));
    s.altitude_nodes = 4 * finer;
    s.view_nodes = 8 * finer;
    s.sun_nodes = 5 * finer;
    s.nu_nodes = 3 * finer;
    s.orders = 3;
    s.combined = combined;
    s.format = format;
    s.ray_nodes = 4;
    s.zenith_nodes = 2;
    s.azimuth_nodes = 3;
    return s;
}

models::SingleSettings single(models::Steps steps) { return {.steps = steps, .view_steps = 5, .light_steps = 4, .dome = {}}; }

models::SingleSettings dome(rhi::Format format, std::uint32_t finer = 1) {
    models::SingleSettings s = single(models::Steps::gauss);
    s.dome = {.size = texels({8, 16, 1}, finer), .phase = models::Dome::Phase::in_table, .format = format};
    return s;
}

models::SingleLutSettings small_single_lut(rhi::Format format, std::uint32_t finer = 1) {
    return {.view_steps = 5, .table = texels({16, 6, 1}, finer), .table_nodes = 5, .table_format = format, .dome = {}};
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
        {"single", models::single(single(Steps::gauss))},
        {"single, midpoints", models::single(single(Steps::midpoints))},
        {"single, dome", models::single(dome(half))},
        {"single-lut", models::single_lut(small_single_lut(full))},
        {"single-lut, half", models::single_lut(small_single_lut(half))},
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

std::vector<Rung> stored_rungs(rhi::Format format, std::uint32_t finer) {
    return {
        {"single, dome", models::single(dome(format, finer))},
        {"single-lut", models::single_lut(small_single_lut(format, finer))},
        {"hillaire", models::hillaire(small_hillaire(true, format, finer))},
        {"hillaire, marched", models::hillaire(small_hillaire(false, format, finer))},
        {"aureole", models::aureole(small_aureole(format, finer))},
        {"bruneton", models::bruneton(small_bruneton(false, format, static_cast<int>(finer)))},
        {"bruneton, combined", models::bruneton(small_bruneton(true, format, static_cast<int>(finer)))},
    };
}

std::vector<Rung> bare_rungs() {
    using models::FogSettings, models::Steps;
    return {
        {"fog, one colour", models::fog({.mode = FogSettings::Mode::one_colour})},
        {"fog", models::fog({.transmittance_nodes = 4})},
        {"fog, endless", models::fog({.sky = FogSettings::Sky::infinity, .transmittance_nodes = 4})},
        {"single", models::single(single(Steps::gauss))},
        {"single, midpoints", models::single(single(Steps::midpoints))},
        {"reference", models::reference(few_paths()), true, true},
    };
}

std::vector<Rung> finely_gathered_rungs() {
    QualitySettings low = QualitySettings::low();
    low.table_format = low.froxel_format = full;
    std::vector<Rung> all{{"aureole", models::aureole(low)}};
    for (const bool combined : {false, true}) {
        models::BrunetonSettings s = small_bruneton(combined, full);
        s.zenith_nodes = s.azimuth_nodes = 4;
        all.push_back({combined ? "bruneton, combined" : "bruneton", models::bruneton(s)});
    }
    return all;
}

std::vector<Rung> extreme_rungs() {
    std::vector<Rung> all;
    const auto with_aureole = [&](const char* name, rhi::Extent QualitySettings::*table, rhi::Extent size) {
        QualitySettings s = small_aureole(full);
        s.*table = size;
        all.push_back({name, models::aureole(s)});
    };
    const auto with_hillaire = [&](const char* name, rhi::Extent models::HillaireSettings::*table, rhi::Extent size) {
        models::HillaireSettings s = small_hillaire(true, full);
        s.*table = size;
        all.push_back({name, models::hillaire(s)});
    };
    using Q = QualitySettings;
    with_aureole("aureole, transmittance 2 x 2", &Q::transmittance, {2, 2, 1});
    with_aureole("aureole, transmittance 4096 wide", &Q::transmittance, {4096, 2, 1});
    with_aureole("aureole, transmittance 4096 high", &Q::transmittance, {2, 4096, 1});
    with_aureole("aureole, multi-scatter 2 x 2", &Q::multi_scatter, {2, 2, 1});
    with_aureole("aureole, multi-scatter 256 wide", &Q::multi_scatter, {256, 2, 1});
    with_aureole("aureole, sky-view 4 x 4", &Q::sky_view, {4, 4, 1});
    with_aureole("aureole, sky-view 4096 wide", &Q::sky_view, {4096, 4, 1});
    with_aureole("aureole, sky-view 4096 high", &Q::sky_view, {4, 4096, 1});
    with_aureole("aureole, froxels 2 x 2 x 2", &Q::aerial_perspective, {2, 2, 2});
    with_aureole("aureole, froxels 256 deep", &Q::aerial_perspective, {2, 2, 256});
    using H = models::HillaireSettings;
    with_hillaire("hillaire, transmittance 2 x 2", &H::transmittance, {2, 2, 1});
    with_hillaire("hillaire, transmittance 4096 wide", &H::transmittance, {4096, 2, 1});
    with_hillaire("hillaire, multi-scatter 2 x 2", &H::multi_scatter, {2, 2, 1});
    with_hillaire("hillaire, sky-view 4 x 4", &H::sky_view, {4, 4, 1});
    with_hillaire("hillaire, sky-view 4096 high", &H::sky_view, {4, 4096, 1});
    with_hillaire("hillaire, froxels 2 x 2 x 2", &H::aerial_perspective, {2, 2, 2});
    models::BrunetonSettings least = small_bruneton(false, full);
    least.transmittance = least.irradiance = {2, 2, 1};
    least.altitude_nodes = least.sun_nodes = least.nu_nodes = 2;
    least.view_nodes = 4;
    all.push_back({"bruneton, the least of all", models::bruneton(least)});
    models::BrunetonSettings wide = small_bruneton(false, full);
    wide.transmittance = {4096, 2, 1};
    wide.irradiance = {1024, 2, 1};
    wide.altitude_nodes = 2;
    wide.view_nodes = 4;
    wide.sun_nodes = 256;
    all.push_back({"bruneton, as wide as may be", models::bruneton(wide)});
    models::SingleLutSettings table = small_single_lut(full);
    table.table = {2, 2, 1};
    all.push_back({"single-lut, 2 x 2", models::single_lut(table)});
    table.table = {4096, 2, 1};
    all.push_back({"single-lut, 4096 wide", models::single_lut(table)});
    models::SingleSettings domed = dome(full);
    domed.dome.size = {4, 4, 1};
    all.push_back({"single, dome 4 x 4", models::single(domed)});
    domed.dome.size = {4096, 4, 1};
    all.push_back({"single, dome 4096 wide", models::single(domed)});
    return all;
}

}  // namespace aureole::stability
