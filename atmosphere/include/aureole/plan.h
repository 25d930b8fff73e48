// The planner: what a scene needs, and what error or cost is tolerable, go in; the cheapest way to draw that sky comes out,
// with the reason for each choice and its price, from what was measured of every setting (plan/plan.md, docs/trade.md).
//
//     PlanRequirements needs;
//     needs.sun_elevation_deg = {-6, 60};
//     needs.altitude_m = {2, 500};
//     needs.tolerance = 0.02;                     // 2 % of radiance, for 95 of 100 directions
//     const Plan plan = aureole::plan(needs);
//     std::puts(plan.text().c_str());
//     Atmosphere air(device, plan.air, plan.model);
//     View view(air, plan.view, composite);
#pragma once

#include <aureole/atmosphere.h>
#include <aureole/setting.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace aureole {

/// From `least` to `most`, both included; one place where they are the same. What it is of says unit and limits; `most` less
/// than `least`, or no number, is Error(invalid_argument) naming the end, as "altitude_m.most".
struct PlanRange {
    double least = 0, most = 0;  ///< Both included.
    [[nodiscard]] bool operator==(const PlanRange&) const = default;
};

/// How much slower than the machine that costs were measured on (Plan::measured_on) a device is: factors on milliseconds, each
/// in [1e-6, 1e6]. calibrated() finds them.
struct DeviceSpeed {
    double composite = 1;  ///< Of passes over pixels.
    double tables = 1;     ///< Of passes that fill tables.
    [[nodiscard]] bool operator==(const DeviceSpeed&) const = default;
};

/// What a scene needs. One of tolerance, budget_ms and budget_mib, or several; a value out of range is
/// Error(invalid_argument) from plan().
struct PlanRequirements {
    AtmosphereParameters air;  ///< Clear, hazy, another planet's: with all its terms. The planner says which can go.

    // Where and when the scene plays: the plan holds over the whole of both ranges.
    PlanRange sun_elevation_deg{0, 90};  ///< In [-90, 90], least first.
    PlanRange altitude_m{2, 2};          ///< Of the camera above the ground radius; in [-1e4, 1e12], least first.

    // What is shown.
    Projection projection = Projection::matrix;  ///< Of every camera. Costs were measured for matrix, and the others are
                                                 ///< charged the same.
    bool geometry = false;                       ///< The composite gets a host's colour and depth.
    /// How far away geometry may be: of the view's froxels. Errors of geometry are those up to there; where the air before it
    /// changes less than the tolerance, it is left out. All these errors are of geometry as bright as ground of albedo 0.19
    /// under the scene's sun: what is darker errs by more, and what is black, without the air before it, by all that is seen of
    /// it, however near. A host that shows such geometry may set `plan.view.aerial_perspective = true`, which costs what the
    /// choice "aerial perspective" says. Errors were measured at 1 to 100 km; outside of these a plan that draws the air warns.
    /// In [1e-3, 1e13].
    double geometry_range_m = 96000;
    bool shadows = false;                      ///< The host's shadow map darkens the air (ViewSettings::shadows, which
                                               ///< the host sets): of one sun, and charged at the default size. What
                                               ///< shadows err by: Plan::shadows_bound, which no tolerance judges.
    bool light = true;                         ///< Sun colour and sky irradiance for the host's own materials are needed,
                                               ///< and must be as right as what is seen (within the air:
                                               ///< above it light is the sun's alone).
    std::uint32_t suns = 1;                    ///< Tables are charged for each, and composites grow with them. In [1, 4].
    std::uint32_t views = 1;                   ///< Cameras that are drawn each frame. In [1, 64].
    std::uint32_t width = 1280, height = 720;  ///< Pixels of a view. Each in [1, 65536].
    /// Colours must be those of wavelengths, as the eye sees them, not those of a red, a green and a blue light: the truth that
    /// errors are against. Measured of Earth's air alone, clear and hazy.
    bool wavelengths = false;
    /// Share of frames in which the tables of the air are made anew, because it has changed or another plan has been taken. As
    /// it is, once a minute at 60 frames a second: what takes seconds must save something. In [0, 1].
    double rebuilds_per_frame = 1.0 / 3600;

    // What is tolerable.
    /// Relative error of radiance that 95 of 100 directions must stay below; of light, too, where it is needed. In [1e-4, 10].
    std::optional<double> tolerance;
    /// Milliseconds of a frame: camera tables, composites, and rebuilds as often as they occur. In [1e-9, 1e6].
    std::optional<double> budget_ms;
    /// MiB of tables. In [1e-9, 1e6].
    std::optional<double> budget_mib;

    DeviceSpeed speed;  ///< How much slower than the measured one.

    [[nodiscard]] bool operator==(const PlanRequirements&) const = default;
};
/// Throws Error(invalid_argument) at the first field outside its range, and if nothing says what is tolerable.
void validate(const PlanRequirements& requirements);

/// On the device that PlanRequirements::speed describes.
struct PlanCost {
    double frame_ms = 0;    ///< Of a frame that moves camera and sun: tables of the camera, composites; of all views.
    double rebuild_ms = 0;  ///< Of the tables of the air.
    double mebibytes = 0;   ///< Of the tables of the air, and of the cameras.
    double charged_ms = 0;  ///< frame_ms and rebuild_ms as often as it occurs: what budget_ms bounds, and plans compare.
};
/// Relative: of the worst situation in the requirements' ranges.
struct PlanError {
    double median = 0;  ///< Of the radiance of half of the directions; likely.
    double p95 = 0;     ///< Of 95 of 100 directions, of geometry, too, where there is any; likely.
    double light = 0;   ///< Where PlanRequirements::light: of the sky's illuminance or the sun's colour, the worse; likely.
    double bound = 0;   ///< Upper bound of p95 and of light: each holds in 95 of 100 scenes that were not measured (plan.md).
};

/// A setting that was thought of.
struct PlanCandidate {
    Setting setting;         ///< Which sky.
    PlanError error;         ///< What it is expected to be wrong by.
    PlanCost cost;           ///< What it is expected to cost.
    bool tolerable = false;  ///< Meets tolerance and budgets.
    std::string excluded;    ///< Why it cannot be taken at all: "has no shadows"; then the rest is 0. Else empty.
};
/// One decision of the plan.
struct PlanChoice {
    std::string what;    ///< "model", "ozone", "ground light", "float tables", "aerial perspective", "sky-view table" ...
    std::string chosen;  ///< "kept", "left out", "40x192 rgba32_float, 10 nodes a segment" ...
    std::string reason;  ///< In a sentence, with the figures that decided.
    /// What the other way would change, where that was measured: of the bound, and of charged_ms; else none.
    std::optional<double> error_otherwise, cost_otherwise_ms;
};

/// What to give to Atmosphere and View, and why.
struct Plan {
    Setting setting;           ///< Which sky.
    AtmosphereParameters air;  ///< With what is left out left out: to be given to Atmosphere, with `model`.
    ModelPtr model;            ///< The same as `setting` names, made.
    ViewSettings view;  ///< Aerial perspective where it is needed (a host may set it to true where it is not, for geometry
                        ///< that is darker than what was measured), its range, light and suns; shadows as the host sets them.

    bool tolerable = false;  ///< False: nothing meets the requirements; this is the most accurate within budgets, or what
                             ///< breaks them least.
    PlanError error;         ///< What it is expected to be wrong by.
    /// Where PlanRequirements::shadows: upper bound of what shadows in the air err by in 95 of 100 directions, away from the
    /// edges of shadows, as a share of the light that is there without them; in [0, 1]. As PlanError::bound it holds in 95 of
    /// 100 scenes that were not measured. No part of `error`. Most of it is light that was scattered more than once, which is
    /// not shadowed (shadows.md). None where that was not measured.
    std::optional<double> shadows_bound;
    PlanCost cost;                          ///< What it is expected to cost.
    std::vector<PlanChoice> choices;        ///< Every choice with its reason.
    std::vector<PlanCandidate> candidates;  ///< All, from the cheapest on; those excluded last.
    std::vector<std::string> nearest;       ///< Ids of the measured scenes that the prediction goes by most.
    /// How far the worst of the situations is from what was measured: 0 at a measured scene; 1 as far as one of ten measured
    /// scenes is from all others, or in air that is unlike any that was measured. Above 1 the bound need not hold.
    double distance = 0;
    std::string measured_on;  ///< Device of the costs, before PlanRequirements::speed.
    DeviceSpeed speed;        ///< That they are for: PlanRequirements::speed.
    /// What the figures do not cover, each in a sentence: an air or a place that is FAR from what was measured, geometry nearer
    /// or farther than was measured, a budget in milliseconds that is judged by another device's speed.
    std::vector<std::string> warnings;

    /// For people: every choice with its reason, the candidates on either side of the chosen one.
    [[nodiscard]] std::string text() const;
};

/// Deterministic; touches no device; from any thread. 2 ms for one place, some 30 for the widest ranges (plan.md). Throws as
/// validate does, of the air too; and Error(unsupported) naming "wavelengths" or "air" where no setting that was measured can
/// be taken, with the reasons of all.
[[nodiscard]] Plan plan(const PlanRequirements& requirements);

/// What to measure for a device's speed: aureole default in Earth's air, 1280x720 pixels, sky alone. Medians of about a second.
struct SpeedSample {
    double composite_ms = 0;  ///< View::record_composite, without a host's colour and depth. In [1e-9, 1e9].
    /// Atmosphere::record after a change of the air, and View::record after one of camera and sun, with ViewSettings as they
    /// are by default: froxels and light, too. In [1e-9, 1e9].
    double tables_ms = 0;
};
/// Setting to be measured for it, of presets::earth().
[[nodiscard]] Setting speed_setting();
/// Throws Error(invalid_argument) for a time outside its range, and Error(unsupported) naming "speed" where the library's table
/// does not have that setting's cost in Earth's air.
[[nodiscard]] DeviceSpeed calibrated(const SpeedSample& sample);

}  // namespace aureole
