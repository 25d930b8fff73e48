// Every table of the model `aureole`, the light and the composite on OpenGL, against the CPU backend in float: the same bounds
// as Vulkan has (docs/precision.md).
#include <doctest/doctest.h>

#include "gl_guest.h"
#include "passes/compare.h"
#include "passes/rig.h"
#include "passes/scene.h"
#include "test_context.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr double bound = 1e-4;
constexpr rhi::Extent size{37, 23, 1};
constexpr double aspect = 37.0 / 23.0;

struct OpenGl final : OpenDevice {
    [[nodiscard]] rhi::Device& device() override { return guest->device(); }
    [[nodiscard]] rhi::Queue& queue() override { return guest->queue(); }
    std::unique_ptr<gl::Guest> guest = gl::borrow_context();
};

void check(const char* what, const Image& gl, const Image& cpu, const Measure& measure, bool signed_too = false) {
    CAPTURE(std::string(what));
    CHECK(unsound(gl, signed_too) == "");
    Worst worst;
    worst.compare(gl, cpu, measure);
    INFO(worst.text());
    CHECK(worst.compared());
    CHECK(worst.error() <= bound);
    std::printf("| %s | %.2g (%.2g) |\n", what, worst.error(), bound);
}

/// Radiance, with what is dark measured against the brightest.
constexpr Measure radiance{Measure::Kind::relative, 0, 1e-6};

Setup setup_of(bool raster) {
    Setup setup;
    setup.composite = {.target_format = rhi::Format::rgba32_float, .raster = raster, .scene_color = true, .scene_depth = true};
    return setup;
}

struct Tables {
    Image transmittance, multi_scatter, sky_view, froxels, light, picture;
};

Tables tables_of(Backend& backend, bool raster) {
    Rig rig(backend, setup_of(raster));
    rig.record_air();
    const DepthConvention convention = perspective_conventions(aspect).front();
    Camera camera = camera_at(presets::earth().planet, 1500);
    camera.projection = convention.projection;
    camera.depth_range = convention.range;
    rig.record_view(camera, sun_at(12));
    const SceneTextures scene = upload(backend, size, patches, convention);
    const Image picture = rig.show(size, {.scene_color = scene.color, .scene_depth = scene.depth});
    return {rig.transmittance(), rig.multi_scatter(), rig.sky_view(), rig.froxels(), rig.light(), picture};
}

}  // namespace

TEST_CASE("every table and picture is the CPU's, as compute and as a draw") {
    const auto context = gl::test::open_context();
    if (!context) return;
    const auto cpu = open_cpu_float();
    Backend gl("opengl", std::make_unique<OpenGl>());
    for (const bool raster : {false, true}) {
        const Tables ours = tables_of(gl, raster), wanted = tables_of(*cpu, raster);
        check(raster ? "picture, drawn" : "picture, computed", ours.picture, wanted.picture, radiance);
        if (raster) continue;
        check("transmittance", ours.transmittance, wanted.transmittance, {Measure::Kind::relative, 1e-6});
        check("multi-scatter", ours.multi_scatter, wanted.multi_scatter, {Measure::Kind::absolute}, true);
        check("sky-view", ours.sky_view, wanted.sky_view, radiance, true);
        check("froxels", ours.froxels, wanted.froxels, radiance, true);
        check("light", ours.light, wanted.light, {Measure::Kind::relative, 0, 1e-3}, true);
    }
    CHECK(context->take_messages() == "");
}
