// A planned sky for tests: Earth between day and dusk, and a target to show it in.
#pragma once

#include <aureole/planned_sky.h>

#include <doctest/doctest.h>

#include "passes/rig.h"

#include <algorithm>
#include <cmath>

namespace aureole::passes {

inline constexpr rhi::Extent extent{16, 9, 1};
inline constexpr std::uint32_t fade_frames = 5;

/// Day to dusk at the ground; tables anew each frame, so that no plan takes seconds.
inline PlanRequirements day_and_dusk(double tolerance) {
    PlanRequirements needs;
    needs.air = presets::earth();
    needs.sun_elevation_deg = {-6, 70};
    needs.altitude_m = {2, 2};
    needs.rebuilds_per_frame = 1;
    needs.tolerance = tolerance;
    return needs;
}

struct TwoHours {
    double tolerance = 0, first_deg = 0, then_deg = 0;
};

/// Two elevations of the sun, at the second of which the first's setting does not do.
inline TwoHours two_hours(bool shadows = false) {
    for (const double tolerance : {0.03, 0.05, 0.1, 0.2, 0.5}) {
        PlanRequirements needs = day_and_dusk(tolerance);
        needs.shadows = shadows;
        needs.sun_elevation_deg = {50, 50};
        const Setting by_day = plan(needs).setting;
        for (const double then : {5.0, 1.0, -2.0, -4.0}) {
            needs.sun_elevation_deg = {then, then};
            const Plan found = plan(needs);
            const auto kept = std::ranges::find(found.candidates, by_day, &PlanCandidate::setting);
            if (found.tolerable && !(kept != found.candidates.end() && kept->tolerable)) return {tolerance, 50, then};
        }
    }
    FAIL("every hour has the same plan");
    return {};
}

/// A planned sky, and a target to show it in.
struct Shown {
    Shown(Backend& backend_in, double tolerance, bool raster, std::uint32_t frames = fade_frames, int passes = 0,
          rhi::Format format = rhi::Format::rgba32_float, double exposure = 10)
        : Shown(backend_in, day_and_dusk(tolerance), {.target_format = format, .raster = raster, .exposure = exposure},
                {.margin = 0.1, .fade_frames = frames, .passes_per_frame = passes}) {}
    Shown(Backend& backend_in, const PlanRequirements& needs, const CompositeSettings& composite, const FollowSettings& follow)
        : backend(backend_in),
          state(composite.raster ? rhi::State::color_attachment : rhi::State::storage_write),
          sky(backend.device(), needs, composite, follow) {
        targets.extent = extent;
        targets.target = backend.make_target(composite.target_format, extent, state);
    }
    PlanUpdate update(double sun_deg) {
        const Sun sun = sun_at(sun_deg);
        return sky.update(camera_at(presets::earth().planet, 2), {&sun, 1});
    }
    Image show() {
        backend.run([&](rhi::CommandList& commands) {
            sky.record(commands);
            sky.record_composite(commands, targets);
        });
        return backend.read(targets.target, state);
    }
    /// A fifth of the way.
    void begin_fade(const TwoHours& hours) {
        sky.prepare_composite(targets);
        for (const double hour : {hours.first_deg, hours.then_deg, hours.then_deg}) {
            (void)update(hour);
            (void)show();
        }
    }
    Backend& backend;
    rhi::State state;
    PlannedSky sky;
    CompositeTargets targets;
};

inline double greatest_step(const Image& a, const Image& b) {
    double greatest = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
        for (int c = 0; c < 4; ++c) greatest = std::max(greatest, std::abs(a.texels[i][c] - b.texels[i][c]));
    return greatest;
}

/// What the plan draws, by itself.
inline Image alone(Backend& backend, const Plan& plan, const CompositeSettings& composite, double sun_deg) {
    Setup setup;
    setup.air = plan.air;
    setup.model = plan.model;
    setup.view = plan.view;
    setup.composite = composite;
    Rig rig(backend, setup);
    rig.record_air();
    rig.record_view(camera_at(plan.air.planet, 2), sun_at(sun_deg));
    return rig.show(extent);
}

}  // namespace aureole::passes
