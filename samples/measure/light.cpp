#include "measure/light.h"

#include "app/solution.h"
#include "app/trace_eyes.h"
#include "measure/sampling.h"

#include <aureole/light.h>
#include <aureole/models/reference.h>

#include <algorithm>
#include <string>

namespace aureole::app {
namespace {

void check_place(const LightPlace& place, const std::string& name) {
    check_row({place.sun_zenith_deg, place.altitude_km, 0, 0}, name);
}

ViewSettings view_settings() {
    ViewSettings settings;
    settings.aerial_perspective = false;
    return settings;
}

void check_places(std::span<const LightPlace> places) {
    for (std::size_t i = 0; i < places.size(); ++i) check_place(places[i], "place " + std::to_string(i + 1));
}

/// Reads the light of air whose tables have been recorded.
class LightEye {
public:
    LightEye(Backend& backend, Atmosphere& air)
        : backend_(backend), textures_(backend), air_(air), view_(air_, view_settings()) {}

    [[nodiscard]] MeasuredLight see(const LightPlace& place) {
        Sun sun;
        sun.direction = probe_direction(place.sun_zenith_deg, 0);
        const double altitude_m = std::max(place.altitude_km, 0.0) * 1000;
        view_.update(look(air_.parameters().planet.bottom_radius_m, altitude_m, 0, 0, 1, 1), {&sun, 1});
        backend_.run([&](rhi::CommandList& commands) { view_.record(commands); });
        const LightTable table = textures_.read_light(view_, 1);
        return {table.sun_irradiance(), table.sky_irradiance({0, 0, 1})};  // the camera stands on the +z axis
    }

private:
    Backend& backend_;
    DeviceTextures textures_;  // none of its own: it reads the view's
    Atmosphere& air_;
    View view_;
};

}  // namespace

std::vector<MeasuredLight> light(Backend& backend, const AtmosphereParameters& parameters, const ModelPtr& model,
                                 std::span<const LightPlace> places) {
    check_places(places);
    if (places.empty()) return {};
    return light(backend, *solved(backend, parameters, model), places);
}

std::vector<MeasuredLight> light(Backend& backend, Atmosphere& air, std::span<const LightPlace> places) {
    check_places(places);
    if (places.empty()) return {};
    LightEye eye(backend, air);
    std::vector<MeasuredLight> measured;
    for (const LightPlace& place : places) measured.push_back(eye.see(place));
    backend.check();
    return measured;
}

std::optional<LightTruth> trace_light(Backend& backend, const AtmosphereParameters& parameters, const LightPlace& place,
                                      const TraceSettings& settings, const std::function<void(double)>& progress,
                                      const std::function<bool()>& stop) {
    settings.validate();
    if (settings.orders != 0)
        throw Error(ErrorCode::invalid_argument, "orders", std::to_string(settings.orders), "0 for light");
    check_place(place, "the place");
    const TraceColours colours(parameters, settings.spectral);
    LightTruth truth;
    const auto draw = [&](std::uint64_t round, std::span<const std::size_t>, std::span<Rgb> values) {
        models::ReferenceSettings reference;
        reference.light_paths = light_round_paths;
        values[0] = truth.sun_irradiance = Rgb(0);
        for (std::size_t air = 0; air < colours.airs().size(); ++air) {
            if (stop && stop()) return false;
            reference.seed = nth_seed(settings, round, air);
            const auto traced = solved(backend, colours.airs()[air], models::reference(reference));
            const MeasuredLight seen = LightEye(backend, *traced).see(place);
            values[0] += colours.part(air, seen.sky_irradiance_up);
            truth.sun_irradiance += colours.part(air, seen.sun_irradiance);
        }
        return true;
    };
    const std::uint64_t most = std::min<std::uint64_t>(settings.max_paths / light_round_paths,
                                                       colours.airs().size() > 1 ? seeds_of_air : seeds_of_one);
    const auto sampled = sample(1, settings.error, most, draw, progress);
    if (!sampled) return std::nullopt;
    backend.check();
    truth.sky_irradiance_up = sampled->values[0];
    truth.paths = sampled->rounds[0] * light_round_paths;
    truth.reached = sampled->reached;
    return truth;
}

}  // namespace aureole::app
