// Single scattering by a table of optical depth: what it adds to single_test.cpp, which holds it to closed forms too.
#include <aureole/models/single_lut.h>

#include "common/rejects.h"
#include "passes/model_sweep.h"

#include <doctest/doctest.h>

using namespace aureole;
using models::SingleLutSettings;

TEST_CASE("single-lut: settings out of range are named") {
    const auto rejected = [](const auto& change) {
        SingleLutSettings settings;
        change(settings);
        return detail::rejected_field([&] { (void)models::single_lut(settings); });
    };
    CHECK(rejected([](SingleLutSettings& s) { s.steps = static_cast<models::Steps>(2); }) == "single_lut.steps");
    CHECK(rejected([](SingleLutSettings& s) { s.view_steps = 0; }) == "single_lut.view_steps");
    CHECK(rejected([](SingleLutSettings& s) { s.table.width = 1; }) == "single_lut.table.width");
    CHECK(rejected([](SingleLutSettings& s) { s.table.height = 5000; }) == "single_lut.table.height");
    CHECK(rejected([](SingleLutSettings& s) { s.table.depth = 2; }) == "single_lut.table.depth");
    CHECK(rejected([](SingleLutSettings& s) { s.table_nodes = 17; }) == "single_lut.table_nodes");
    CHECK(rejected([](SingleLutSettings& s) { s.table_format = rhi::Format::rgba8_unorm; }) == "single_lut.table_format");
    CHECK(rejected([](SingleLutSettings& s) { s.dome.size = {4, 4100, 1}; }) == "single_lut.dome.size.height");
    CHECK(rejected([](SingleLutSettings&) {}) == "nothing");
    CHECK(detail::rejected_field([] { (void)SingleLutSettings::by_name("ultra"); }) == "quality");
}

TEST_CASE("single-lut: a dome that the device cannot hold for so many suns is refused by its own name") {
    const auto cpu = passes::open_cpu_float();
    SingleLutSettings settings;
    settings.dome.size = {4, 4096, 1};
    passes::Setup setup;
    setup.model = models::single_lut(settings);
    passes::AirRig rig(*cpu, setup);
    rhi::Capabilities less = cpu->device().capabilities();
    less.max_texture_2d = 4096;
    cpu->device().pretend(less);
    std::string refused;
    try {
        const View view(rig.air);
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::unsupported);
        refused = error.field();
    }
    CHECK(refused == "single_lut.dome.size.height");
}

TEST_CASE("single-lut: every backend shows the same, everywhere and at every hour") {
    passes::Backends backends;
    passes::check_model(backends, models::single_lut(), "single-lut");
    passes::check_model(backends, models::single_lut(SingleLutSettings::by_name("low")), "single-lut, dome");
    SingleLutSettings midpoints;
    midpoints.steps = models::Steps::midpoints;
    midpoints.view_steps = 20;
    passes::check_model(backends, models::single_lut(midpoints), "single-lut, midpoints");
}
