// What the tests of models in N wavelengths share: a model of each kind, small; the air at wavelengths; pictures of a sky and
// of land.
#pragma once

#include <aureole/models/bruneton.h>
#include <aureole/models/fog.h>
#include <aureole/models/hillaire.h>
#include <aureole/models/reference.h>
#include <aureole/models/single_lut.h>
#include <aureole/models/spectral.h>

#include "passes/scene.h"
#include "passes/trio.h"

namespace aureole::passes {

using spectrum::Wavelengths;

inline constexpr rhi::Extent panorama{24, 12, 1}, picture{20, 12, 1};
inline constexpr double elevations[] = {60, 5, 0, -4};

inline QualitySettings exact_quality() {
    QualitySettings quality = small_quality();
    quality.table_format = rhi::Format::rgba32_float;
    return quality;
}

inline models::BrunetonSettings small_bruneton() {
    models::BrunetonSettings s;
    s.transmittance = {40, 12, 1};
    s.irradiance = {11, 5, 1};
    s.altitude_nodes = 5;
    s.view_nodes = 14;
    s.sun_nodes = 9;
    s.nu_nodes = 4;
    s.orders = 2;
    s.format = rhi::Format::rgba32_float;
    return s;
}

inline models::HillaireSettings small_hillaire() {
    models::HillaireSettings s;
    s.table_format = s.froxel_format = rhi::Format::rgba32_float;
    s.transmittance = {40, 12, 1};
    s.multi_scatter = {9, 7, 1};
    s.sky_view = {11, 22, 1};
    s.aerial_perspective = {9, 7, 6};
    return s;
}

/// With tables in float, so that sums of pictures and pictures of sums differ by rounding alone.
inline std::vector<ModelPtr> models_by_tables() {
    return {models::aureole(exact_quality()), models::hillaire(small_hillaire()), models::bruneton(small_bruneton())};
}

/// Which compute light for each pixel; with what they keep tables of, and without.
inline std::vector<ModelPtr> models_by_pixels() {
    models::FogSettings grey;
    grey.mode = models::FogSettings::Mode::one_colour;
    models::SingleSettings dome = models::SingleSettings::by_name("low");
    models::SingleLutSettings look_up;
    dome.dome.format = look_up.table_format = rhi::Format::rgba32_float;
    models::HillaireSettings marched = small_hillaire(), marched_sky = small_hillaire();
    marched.fast_sky = marched.fast_aerial_perspective = marched_sky.fast_sky = false;
    marched.grey_transmittance = marched_sky.grey_transmittance = false;  // as in wavelengths
    marched.march_steps = marched_sky.march_steps = 8;
    return {models::fog(),
            models::fog(grey),
            models::single(),
            models::single(dome),
            models::single_lut(look_up),
            models::hillaire(marched),
            models::hillaire(marched_sky)};
}

inline models::ReferenceSettings few_paths(bool film) {
    models::ReferenceSettings s;
    s.paths_per_frame = 2;
    s.light_paths = 2;
    s.max_order = 3;
    s.nodes = 4;
    s.first_order_parts = 1;
    if (film) s.film_width = panorama.width, s.film_height = panorama.height;
    return s;
}

inline std::vector<ModelPtr> inner_models() {
    std::vector<ModelPtr> all = models_by_tables();
    for (ModelPtr& model : models_by_pixels()) all.push_back(std::move(model));
    all.push_back(models::reference(few_paths(true)));
    return all;
}

inline Setup setup_of(const ModelPtr& model, bool geometry = false) {
    Setup setup;
    setup.model = model;
    setup.view.projection = geometry ? Projection::matrix : Projection::panorama;
    setup.composite.target_format = rhi::Format::rgba32_float;
    setup.composite.scene_color = setup.composite.scene_depth = geometry;
    return setup;
}

/// The atmosphere's own parameters, whatever the wavelengths.
inline AtmosphereParameters as_it_is(const AtmosphereParameters& rgb, const std::array<double, 3>&) { return rgb; }
inline AtmosphereParameters of_earth(const AtmosphereParameters&, const std::array<double, 3>& nm) {
    return spectrum::earth(nm);
}

inline Wavelengths red_green_blue(double scale = 1) {
    return {{680, 550, 440}, {Rgb(scale, 0, 0), Rgb(0, 2 * scale, 0), Rgb(0, 0, 3 * scale)}};
}

/// A model on a backend: the sky around, and landscape through it.
struct Shown {
    Shown(Backend& backend, const ModelPtr& model, const AtmosphereParameters& air = presets::earth())
        : around(backend, with(setup_of(model), air)), land(backend, with(setup_of(model, true), air)) {
        const DepthConvention convention = perspective_conventions(1.5).front();
        const SceneTextures textures = upload(backend, picture, patches, convention);
        targets.scene_color = textures.color;
        targets.scene_depth = textures.depth;
        projection = convention.projection;
        around.record_air();
        land.record_air();
    }
    static Setup with(Setup setup, const AtmosphereParameters& air) {
        setup.air = air;
        return setup;
    }
    std::vector<Image> show(double elevation) { return show(sun_at(elevation)); }
    std::vector<Image> show(const Sun& sun) {
        Camera camera = camera_at(around.setup.air.planet, 200);
        camera.kind = Projection::panorama;
        around.record_view(camera, sun);
        camera.kind = Projection::matrix;
        camera.projection = projection;
        land.record_view(camera, sun);
        return {around.show(panorama), land.show(picture, targets), around.light()};
    }
    Rig around, land;
    CompositeTargets targets;
    glm::dmat4 projection{1};
};

inline Image sky(Rig& rig, double elevation) {
    Camera camera = camera_at(rig.setup.air.planet, 200);
    camera.kind = Projection::panorama;
    rig.record_view(camera, sun_at(elevation));
    return rig.show(panorama);
}

}  // namespace aureole::passes
