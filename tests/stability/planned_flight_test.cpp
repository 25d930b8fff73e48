// The same flights and sunsets by a sky that follows its plan: where one plan gives way to another, nothing is seen to jump
// but what jumps in both by themselves, and the share of their difference that a frame fades in.
//
// CI looks at the frames around the switches; AUREOLE_STABILITY_CASES=2000 takes all.
#include "stability/flight.h"

#include <aureole/planned_sky.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <set>
#include <string>
#include <vector>

using namespace aureole;
using namespace aureole::stability;

namespace {

constexpr std::uint32_t fade_frames = 12;
constexpr int around = 4;  // frames before and after a fade
const rhi::Extent extent{24, 1, 1};
constexpr rhi::Usage given = rhi::Usage::sampled | rhi::Usage::copy_destination;
constexpr rhi::Usage target_usage = rhi::Usage::storage | rhi::Usage::copy_source;

CompositeSettings composite() { return {.target_format = rhi::Format::rgba32_float, .sun_disk = false}; }

Camera camera_of(const Frame& f) {
    const Planet planet = presets::earth().planet;
    Camera camera = look(planet.bottom_radius_m, 0, 0, 0, 1, 1);  // its rays are not used
    camera.position_m = {0, 0, planet.bottom_radius_m + f.altitude_m};
    return camera;
}
Sun sun_of(const Frame& f) { return physics::sun_at((90 - f.sun_elevation_deg) * physics::degree, 0.00465); }

/// Textures that a sky shows the directions of a frame in.
class Screen {
public:
    Screen() {
        physics::Machine& machine = physics::cpu_float();
        targets_.extent = extent;
        targets_.target = machine.texture("planned", rhi::Format::rgba32_float, extent, target_usage);
        machine.move(targets_.target, rhi::State::undefined, rhi::State::storage_write);
        targets_.directions = machine.texture("directions", rhi::Format::rgba32_float, extent, given);
    }
    ~Screen() {
        for (const rhi::Texture texture : {targets_.target, targets_.directions}) physics::cpu_float().destroy(texture);
    }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    [[nodiscard]] const CompositeTargets& targets() const { return targets_; }
    template <class Sky>
    std::vector<Rgb> show(Sky&& record, const Frame& f) {
        physics::Machine& machine = physics::cpu_float();
        std::vector<float> texels;
        for (const glm::dvec3& d : directions(presets::earth().planet, f.altitude_m))
            texels.insert(texels.end(), {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z), 0.0F});
        machine.upload(targets_.directions, texels, state_, rhi::State::sampled);
        state_ = rhi::State::sampled;
        machine.run(record);
        std::vector<Rgb> seen;
        for (const glm::dvec4& texel : machine.read(targets_.target, extent.width, rhi::State::storage_write))
            seen.emplace_back(texel);
        return seen;
    }

private:
    CompositeTargets targets_;
    rhi::State state_ = rhi::State::undefined;
};

PlanRequirements needs(double tolerance) {
    PlanRequirements needs;
    needs.air = presets::earth();
    needs.sun_elevation_deg = {-18, 90};
    needs.altitude_m = {0.01, 1e9};
    needs.rebuilds_per_frame = 1;         // no plan takes seconds
    needs.width = 64, needs.height = 36;  // small, as what is drawn here: models without tables are worth a thought
    needs.light = false;
    needs.tolerance = tolerance;
    return needs;
}

class Planned {
public:
    explicit Planned(double tolerance)
        : sky_(physics::cpu_float().device(), needs(tolerance), composite(), {.fade_frames = fade_frames}) {
        sky_.prepare_composite(screen_.targets());
    }
    PlanUpdate update(const Frame& f) {
        const Sun sun = sun_of(f);
        return sky_.update(camera_of(f), {&sun, 1});
    }
    std::vector<Rgb> show(const Frame& f) {
        return screen_.show(
            [&](rhi::CommandList& commands) {
                sky_.record(commands);
                sky_.record_composite(commands, screen_.targets());
            },
            f);
    }
    [[nodiscard]] const Plan& plan() const { return sky_.plan(); }

private:
    Screen screen_;
    PlannedSky sky_;
};

/// What a plan draws by itself.
class Alone {
public:
    explicit Alone(const Plan& plan)
        : air_(physics::cpu_float().device(), plan.air, plan.model), view_(air_, plan.view, composite()) {
        view_.prepare_composite(screen_.targets());
    }
    std::vector<Rgb> show(const Frame& f) {
        const Sun sun = sun_of(f);
        view_.update(camera_of(f), {&sun, 1});
        return screen_.show(
            [&](rhi::CommandList& commands) {
                air_.record(commands);
                view_.record(commands);
                view_.record_composite(commands, screen_.targets());
            },
            f);
    }

private:
    Screen screen_;
    Atmosphere air_;
    View view_;
};

Frame frame_of(const Flight& flight, int i) { return flight.at(i / (frames - 1.0)); }

/// What a flight's plans do.
struct Course {
    std::set<int> around_switches;  ///< Frames.
    std::set<std::string> models;
};

/// Only frames of a fade have to be shown for the sky to go on.
Course course_of(const Flight& flight, double tolerance) {
    Course course;
    Planned sky(tolerance);
    for (int i = 0; i < frames; ++i) {
        const Frame f = frame_of(flight, i);
        const PlanUpdate update = sky.update(f);
        course.models.insert(sky.plan().setting.model);
        if (update.share >= 1) continue;
        (void)sky.show(f);
        for (int k = -around; k <= around + 1; ++k) course.around_switches.insert(std::clamp(i + k, 0, frames - 1));
    }
    return course;
}

/// A frame of the planned sky, of the old plan and of the new one alone, and the share of the new one.
struct Moment {
    int frame;
    std::vector<Rgb> shown, before, after;
    double share;
};

/// In percent of the light, or of 1e-4 of the frame's brightest.
struct Found {
    int switches = 0, models = 0;
    double mixed = 0;   ///< How far a frame is from the mean of both plans, weighted with their shares.
    double apart = 0;   ///< The largest difference of two plans.
    double excess = 0;  ///< Of a frame's jump, over those of both plans alone, by their shares, and the fade's own.
    double fade = 0;    ///< The largest jump of a fade's own, where a frame is of more of the new plan than the one before.
    double jump = 0;    ///< More than the scene's, as in flight_test.cpp.
};

double least_of(const Moment& m) { return 1e-4 * brightest(m.shown) + 1e-10; }

/// With d = after - before and s the share, which grows by e- and then by e+, the second difference of before + s d is that of
/// `before` and of `after` in the shares of the middle, and (e- d- - e+ d+) / 2, e being 1 / fade_frames at most.
void compare(Found& found, const Moment& a, const Moment& m, const Moment& b) {
    const double least = least_of(m);
    const auto grown = [](const Moment& from, const Moment& to) {
        return std::clamp(to.share - from.share, 0.0, 1.0 / fade_frames);
    };
    for (std::size_t i = 0; i < m.shown.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const auto bend = [&](const auto& of) { return std::abs(of(m) - (of(a) + of(b)) / 2); };
            const double shown = bend([&](const Moment& x) { return x.shown[i][c]; });
            const double old_plan = bend([&](const Moment& x) { return x.before[i][c]; });
            const double new_plan = bend([&](const Moment& x) { return x.after[i][c]; });
            const auto apart = [&](const Moment& x) { return x.after[i][c] - x.before[i][c]; };
            const double fade = std::abs(grown(a, m) * apart(a) - grown(m, b) * apart(b)) / 2;
            const double light = std::max({m.shown[i][c], a.shown[i][c], b.shown[i][c], least});
            found.fade = std::max(found.fade, fade / light);
            found.excess = std::max(found.excess, (shown - (1 - m.share) * old_plan - m.share * new_plan - fade) / light);
        }
}

void check_mix(Found& found, const Moment& m) {
    const double least = least_of(m);
    for (std::size_t i = 0; i < m.shown.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double before = m.before[i][c], after = m.after[i][c], light = std::max({before, after, least});
            found.mixed = std::max(found.mixed, std::abs(m.shown[i][c] - (1 - m.share) * before - m.share * after) / light);
            found.apart = std::max(found.apart, std::abs(after - before) / light);
        }
}

Found fly(const Flight& flight, double tolerance, const std::set<int>& wanted) {
    Found found;
    const bool all = wanted.empty();
    Planned sky(tolerance);
    Show scene(physics::cpu_double(), {"single", "converged", "rgb", {}});
    std::unique_ptr<Alone> before, after;
    Setting now;
    std::set<std::string> models;
    std::deque<Moment> moments;
    Jumps jumps;
    bool was_outside = false;
    for (int i = 0; i < frames; ++i) {
        const Frame f = frame_of(flight, i);
        const PlanUpdate update = sky.update(f);
        if (!(sky.plan().setting == now)) {
            if (i > 0) ++found.switches;
            now = sky.plan().setting;
            models.insert(now.model);
            before = after ? std::move(after) : std::make_unique<Alone>(sky.plan());
            after = std::make_unique<Alone>(sky.plan());
            // A fade that has just ended, or ends as this one begins, is of other plans.
            if (std::ranges::any_of(moments, [](const Moment& m) { return m.share < 1; })) moments.clear();
            for (Moment& m : moments)  // what was new is old
                m.before = m.after, m.after = after->show(frame_of(flight, m.frame)), m.share = 0;
        }
        if (!all && !wanted.contains(i)) continue;
        if (!moments.empty() && moments.back().frame != i - 1) moments.clear(), jumps.cut();
        const bool is_outside = f.altitude_m > 100e3;  // other directions are looked in from beyond the air
        if (is_outside != was_outside) moments.clear(), jumps.cut();
        was_outside = is_outside;
        moments.push_back({i, sky.show(f), before->show(f), after->show(f), update.share});
        check_mix(found, moments.back());
        jumps.next(moments.back().shown, scene.frame(f), sun_sets(f));
        if (moments.size() < 3) continue;
        compare(found, moments[0], moments[1], moments[2]);
        moments.pop_front();
    }
    found.models = static_cast<int>(models.size());
    found.jump = jumps.worst();
    return found;
}

Found fly(const Flight& flight, double tolerance, const Course& course) {
    const Found found = fly(flight, tolerance, frames_wanted() >= frames ? std::set<int>() : course.around_switches);
    if (std::getenv("AUREOLE_STABILITY_PRINT") != nullptr)
        std::printf(
            "| %s, within %g %% | %d switches, %d models | apart %.2f %% | mixed %.2g %% | excess %.2g %% | "
            "fade %.2f %% | jump %.2f %% |\n",
            flight.name, 100 * tolerance, found.switches, found.models, 100 * found.apart, 100 * found.mixed,
            100 * found.excess, 100 * found.fade, 100 * found.jump);
    return found;
}

/// Whatever the plans are: frames are what they mix, to rounding, and so jump no more than both plans and the fade's own share.
void check_fades(const Found& found) {
    CHECK(found.switches >= 1);
    CHECK(found.mixed <= 1e-5);
    CHECK(found.excess <= 1e-5);
}

}  // namespace

TEST_CASE("stability, frame by frame: a sky that follows its plan changes plans underway, and jumps no more than they do" *
          doctest::test_suite("long")) {
    // Two of the flights in CI. How often they switch is the planner's table's to say: between them three times at least.
    constexpr double tolerance = 0.1;
    int switches = 0;
    for (const Flight& flight : flights) {
        const bool quick = flight.at == climb_at_dusk || flight.at == set;
        if (!quick && frames_wanted() < frames) continue;
        INFO(std::string(flight.name));
        const Found found = fly(flight, tolerance, course_of(flight, tolerance));
        switches += found.switches;
        check_fades(found);
    }
    CHECK(switches >= 3);
}

TEST_CASE("stability, frame by frame: one model gives way to another underway, and jumps no more than both do" *
          doctest::test_suite("long")) {
    // Within so little that simpler models do for a part of a flight. Which, and where, is the planner's table's to say.
    for (const double tolerance : {0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0})
        for (const Flight& flight : flights) {
            const Course course = course_of(flight, tolerance);
            if (course.models.size() < 2) continue;
            INFO(std::string(flight.name), ", within ", tolerance);
            const Found found = fly(flight, tolerance, course);
            CHECK(found.models >= 2);
            check_fades(found);
            return;
        }
    FAIL("no flight's plans are of two models");
}
