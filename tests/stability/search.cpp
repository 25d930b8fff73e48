#include "stability/search.h"

#include "envelope/tell.h"

#include <aureole/envelope.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <sstream>

namespace aureole::stability {
namespace {

double logarithmic(double low, double high, double u) { return low * std::pow(high / low, u); }

constexpr KeptScene kept[] = {
#include "stability/worst_scenes.inc"
};

}  // namespace

Scene scene_at(const ScenePoint& u, Subject subject) {
    const double radius_m = logarithmic(1e4, 1e9, u[1]);
    Scene scene;
    scene.air = bases()[u[0] < 0.5 ? 0 : 1].air;
    sweep("radius").set(scene, radius_m);
    sweep("shell").set(scene, std::min(scene.shell_m(), 1.4 * radius_m));
    sweep("extinction of haze").set(scene, u[2] < 0.1 ? 0 : logarithmic(1e-9, 100, (u[2] - 0.1) / 0.9));
    sweep("g of haze").set(scene, 0.95 * (2 * u[3] - 1));
    // From as far as the Earth is small from 10^6 km: half a degree. A pixel of a smaller planet is lit or not by a rounding.
    // Geometry from 1000 km at most: its pixels have the digits of a direction in float, which moves it by a metre there.
    scene.altitude_m = logarithmic(1e-2, std::min(subject == Subject::sky ? 1e9 : 1e6, 160 * radius_m), u[4]);
    scene.sun_elevation_deg = 90 - 108 * u[5];
    scene.air.planet.ground_albedo = Rgb(u[6]);
    return scene;
}

std::string text_of(const Scene& s) {
    std::ostringstream text;
    text.precision(4);
    text << "radius " << s.air.planet.bottom_radius_m << " m, shell " << s.shell_m() << " m, altitude " << s.altitude_m
         << " m, sun at " << s.sun_elevation_deg << " degrees, haze "
         << 1e3 * (s.air.terms[1].scattering_per_m.g + s.air.terms[1].absorption_per_m.g) << " per km";
    if (const auto* phase = std::get_if<CornetteShanksPhase>(&s.air.terms[1].phase)) text << " of g " << phase->g;
    return text.str();
}

ModelError::ModelError(const Rung& rung)
    : model_(rung.model), seen_(physics::cpu_float(), rung.model), exact_(physics::cpu_double(), rung.model) {}

double ModelError::operator()(const Scene& scene, Subject subject) {
    const Planet& planet = scene.air.planet;
    const Camera camera{.position_m = {0, 0, planet.bottom_radius_m + scene.altitude_m}};
    const KeptInTables kept = detail::kept_in_tables(*model_, scene.air);
    if (!outside_envelope(scene.air).empty() || !outside_envelope(planet, camera, scene.all_suns(), kept).empty()) return 0;
    const Exact exact = exact_look(exact_, scene, subject, false);
    return std::ranges::max(relative_errors(seen_.look(scene, subject), exact));
}

WorstScene search(ModelError& error, Subject subject, std::uint64_t seed, std::uint64_t starts) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> even(0, 1);
    constexpr std::size_t climbers = 4;
    std::vector<WorstScene> best;
    for (std::uint64_t i = 0; i < starts; ++i) {
        WorstScene found;
        for (double& u : found.at) u = even(random);
        found.error = error(scene_at(found.at, subject), subject);
        best.push_back(found);
        std::ranges::sort(best, std::ranges::greater(), &WorstScene::error);
        if (best.size() > climbers) best.pop_back();
    }
    for (WorstScene& climber : best)
        for (std::uint64_t i = 0; i < starts / climbers; ++i) {
            const double step = std::pow(10.0, -4 * even(random));
            WorstScene next = climber;
            for (double& u : next.at)
                if (even(random) < 0.4) u = std::clamp(u + step * (2 * even(random) - 1), 0.0, 1.0);
            next.error = error(scene_at(next.at, subject), subject);
            if (next.error > climber.error) climber = next;
        }
    return *std::ranges::max_element(best, {}, &WorstScene::error);
}

std::span<const KeptScene> kept_scenes() { return kept; }

std::vector<Rung> searched_rungs() {
    std::vector<Rung> rungs = bare_rungs();
    std::ranges::copy(stored_rungs(rhi::Format::rgba32_float), std::back_inserter(rungs));
    std::erase_if(rungs, [](const Rung& rung) {
        return rung.random || rung.model->name() == "aureole" || rung.model->name() == "bruneton";
    });
    std::ranges::copy(finely_gathered_rungs(), std::back_inserter(rungs));
    return rungs;
}

}  // namespace aureole::stability
