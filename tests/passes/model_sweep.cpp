#include "passes/model_sweep.h"

#include <doctest/doctest.h>

#include <utility>

#include "passes/scene.h"

namespace aureole::passes {
namespace {

constexpr rhi::Extent size{13, 9, 1};
/// The picture against its brightest pixel, the harmonics of the light against their first and the sun.
constexpr Measure picture{Measure::Kind::relative, 1e-12, 1e-6};
constexpr Measure harmonics{Measure::Kind::relative, 1e-12, 1};

struct Rows {
    Precision shown, light;
};

void check_preset(Backends& backends, const ModelPtr& model, const char* preset, bool raster, Rows& rows) {
    const DepthConvention convention = perspective_conventions(13.0 / 9.0).front();
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.model = model;
    setup.composite = {.target_format = rhi::Format::rgba32_float, .raster = raster, .scene_color = true, .scene_depth = true};
    Trio<Rig> trio(backends, setup);
    trio.record_air();
    std::vector<std::pair<Rig*, SceneTextures>> scenes;
    trio.each([&](Rig& rig) { scenes.emplace_back(&rig, upload(rig.backend, size, patches, convention)); });
    const auto show = [&](Rig& rig) {
        for (const auto& [owner, scene] : scenes)
            if (owner == &rig) return rig.show(size, {.scene_color = scene.color, .scene_depth = scene.depth});
        return Image{};
    };
    for (const double altitude : {0.0, 2.0, 1e4, 3e5})
        for (const double elevation : {90.0, 5.0, 0.0, -4.0}) {
            const std::string where = place_name(preset, altitude, elevation);
            Camera camera = camera_at(setup.air.planet, altitude);
            camera.projection = convention.projection;
            trio.each([&](Rig& rig) { rig.record_view(camera, sun_at(elevation)); });
            Images images{show(trio.single), show(trio.exact), {}};
            if (trio.vulkan) images.vulkan = show(*trio.vulkan);
            CHECK_MESSAGE(images.unsound() == "", where);
            rows.shown.compare(images, picture, where);
            const Images light = trio.read(&Rig::light);
            CHECK_MESSAGE(light.unsound(true) == "", where);
            rows.light.compare(light, harmonics, where);
        }
}

}  // namespace

void check_model(Backends& backends, const ModelPtr& model, const std::string& name) {
    Rows rows;
    for (const char* preset : preset_names()) check_preset(backends, model, preset, false, rows);
    check_preset(backends, model, preset_names().front(), true, rows);
    rows.shown.check(name, "radiance, all places and hours", 1e-4, 1e-3);
    rows.light.check(name, "light, all places and hours", 1e-4, 1e-3);
}

}  // namespace aureole::passes
