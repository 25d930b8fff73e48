// Kernels make no number that is none and none beyond float's range, also where it would be thrown away later: the processor's
// own flags say so. In one thread, since each has flags of its own.
#include <aureole/models/reference.h>
#include <doctest/doctest.h>

#include <cfenv>

#include "models/bruneton/small_test.h"
#include "passes/rig.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

/// What the processor has noted meanwhile.
std::string noted(const std::function<void()>& action) {
    std::feclearexcept(FE_ALL_EXCEPT);
    action();
    const int flags = std::fetestexcept(FE_INVALID | FE_OVERFLOW | FE_DIVBYZERO);
    return std::string((flags & FE_INVALID) != 0 ? "invalid " : "") + ((flags & FE_OVERFLOW) != 0 ? "overflow " : "") +
           ((flags & FE_DIVBYZERO) != 0 ? "division by zero" : "");
}

/// What one thread finishes soon.
ModelPtr small(std::string_view model) {
    if (model == "aureole") return nullptr;
    if (model == "bruneton") return models::bruneton(bruneton_test::small());
    if (model == "reference") return models::reference({.paths_per_frame = 4, .light_paths = 1});
    return model_by_name(model, "low");
}

}  // namespace

TEST_CASE("the processor's flags: they are heard") {
    volatile float zero = 0, large = 1e30F;
    CHECK(noted([&] { zero = zero / zero; }) == "invalid ");
    CHECK(noted([&] { large = large * large; }) == "overflow ");
    zero = 0;
    CHECK(noted([&] { large = 1.0F / zero; }) == "division by zero");
    CHECK(noted([&] { large = 1.0F; }) == "");
}

TEST_CASE("the processor's flags: no model computes what is no number, or too large") {
    const auto cpu = open_cpu_float(1);
    for (const std::string_view model : model_names()) {
        for (const char* preset : preset_names()) {
            CAPTURE(model);
            CAPTURE(preset);
            Setup setup;
            setup.air = presets::by_name(preset);
            setup.model = small(model);
            setup.composite.target_format = rhi::Format::rgba32_float;
            Rig rig(*cpu, setup);
            CHECK(noted([&] { rig.record_air(); }) == "");
            for (const auto& place : {std::pair(2.0, 90.0), {0.0, 0.0}, {1e4, -4.0}, {3e5, 5.0}}) {
                const double altitude = place.first, elevation = place.second;
                CAPTURE(altitude);
                CAPTURE(elevation);
                CHECK(noted([&] { rig.record_view(camera_at(setup.air.planet, altitude), sun_at(elevation)); }) == "");
                CHECK(noted([&] { (void)rig.show({9, 6, 1}); }) == "");
            }
        }
    }
}
