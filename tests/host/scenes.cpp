#include "host/scenes.h"

#include <aureole/models/hillaire.h>

#include <numbers>

namespace aureole::host {
namespace {

Scene scene_of(const char* name, const char* preset, double altitude_m, std::vector<Sun> suns) {
    Scene scene{std::string(name)};
    scene.setup.air = presets::by_name(preset);
    scene.setup.view.max_suns = static_cast<std::uint32_t>(suns.size());
    scene.altitude_m = altitude_m;
    scene.suns = std::move(suns);
    scene.camera = passes::camera_at(scene.setup.air.planet, altitude_m);
    return scene;
}

Sun second_sun() {
    Sun sun;
    sun.direction = {-0.3, 0.9, 0.2};
    sun.irradiance = {0.2, 0.5, 0.1};
    return sun;
}

/// Its tables have another axis of azimuth, and no layers for sharp phase functions.
ModelPtr hillaire_in_float() {
    models::HillaireSettings settings = models::HillaireSettings::low();
    settings.table_format = settings.froxel_format = rhi::Format::rgba32_float;
    return models::hillaire(settings);
}

}  // namespace

AtmosphereParameters tabulated_haze() {
    AtmosphereParameters air = presets::hazy_earth();
    for (DensityTerm& term : air.terms) {
        if (term.name != "mie") continue;
        TabulatedPhase table;
        for (int i = 0; i <= 90; ++i) {
            table.angle_rad.push_back(i * std::numbers::pi / 90);
            table.value.push_back(evaluate(term.phase, std::cos(table.angle_rad.back())));
        }
        term.phase = table;
    }
    return air;
}

Scene noon() { return scene_of("noon", "earth", 2, {passes::sun_at(50)}); }

std::vector<Scene> scenes() {
    std::vector<Scene> all = {noon(),
                              scene_of("haze at dawn", "hazy_earth", 1000, {passes::sun_at(1)}),
                              scene_of("Mars at dusk", "mars", 1e4, {passes::sun_at(-2)}),
                              scene_of("low orbit", "earth", 4e5, {passes::sun_at(-10)}),
                              scene_of("two suns", "earth", 300, {passes::sun_at(20), second_sun()}),
                              scene_of("airless", "airless", 100, {passes::sun_at(30)}),
                              scene_of("tabulated phase, fisheye", "earth", 50, {passes::sun_at(12)}),
                              scene_of("hillaire", "earth", 2000, {passes::sun_at(5)})};
    all[6].setup.air = tabulated_haze();
    all[6].camera.kind = all[6].setup.view.projection = Projection::fisheye;
    all[7].setup.model = hillaire_in_float();
    return all;
}

Shown::Shown(std::unique_ptr<passes::Backend> open, const Scene& scene) : backend(std::move(open)), rig(*backend, scene.setup) {
    rig.record_air();
    rig.record_view(scene.camera, scene.suns);
}

void Shown::take_tables(Shown& other) {
    backend->write(rig.air.transmittance_table(), other.rig.transmittance());
    backend->write(rig.view.sky_view_table(), other.rig.sky_view());
    backend->write(rig.view.aerial_perspective_table(), other.rig.froxels());
    backend->write(rig.view.light_table(), other.rig.light());
}

}  // namespace aureole::host
