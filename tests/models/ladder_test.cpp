// What every model of the register must hold: it shows every planet at every hour, without a number that is none, the same on
// every backend; and where physics leaves it no choice, it shows what the others show.
#include <doctest/doctest.h>

#include "passes/compare.h"
#include "passes/scene.h"
#include "passes/trio.h"

#include <aureole/models/bruneton.h>
#include <aureole/models/spectral.h>

#include <algorithm>
#include <cstdio>

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr rhi::Extent panorama{24, 12, 1}, picture{20, 12, 1};
constexpr double elevations[] = {90, 5, 0, -4};
constexpr double altitudes[] = {0, 2, 1e4, 3e5};

/// A quality as it is, but for bruneton's nodes: a few of them take its way through orders, textures and samplings as well as
/// the millions whose solution takes minutes.
ModelPtr model_of(std::string_view model, std::string_view quality) {
    ModelPtr whole = model_by_name(model, quality);
    if (model != "bruneton" || quality == "low") return whole;
    models::BrunetonSettings settings = models::BrunetonSettings::by_name(quality);
    settings.altitude_nodes = 8;
    settings.view_nodes = 32;
    settings.sun_nodes = 16;
    return models::bruneton(settings);
}

ModelPtr in_four_wavelengths(const ModelPtr& model) { return models::spectral(model, {spectrum::fitted(4)}); }

Setup setup_of(const ModelPtr& model, const char* preset, bool geometry) {
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.model = model;
    setup.view.projection = geometry ? Projection::matrix : Projection::panorama;
    setup.view.light = !geometry;
    setup.composite.target_format = rhi::Format::rgba32_float;
    setup.composite.scene_color = setup.composite.scene_depth = geometry;
    return setup;
}

/// A model on one backend: all around it, and landscape through it.
struct Shown {
    Shown(Backend& backend, const ModelPtr& model, const char* preset)
        : around(backend, setup_of(model, preset, false)), land(backend, setup_of(model, preset, true)) {
        const DepthConvention convention = perspective_conventions(1.5).front();
        const SceneTextures textures = upload(backend, picture, patches, convention);
        targets.scene_color = textures.color;
        targets.scene_depth = textures.depth;
        projection = convention.projection;
        around.record_air();
        land.record_air();
    }
    std::vector<Image> show(double altitude, double elevation) {
        Camera camera = camera_at(around.setup.air.planet, altitude);
        camera.kind = Projection::panorama;
        around.record_view(camera, sun_at(elevation));
        camera.kind = Projection::matrix;
        camera.projection = projection;
        land.record_view(camera, sun_at(elevation));
        return {around.show(panorama), land.show(picture, targets), around.light()};
    }
    Rig around, land;
    CompositeTargets targets;
    glm::dmat4 projection{1};
};

/// By half floats in tables: a step of one is 2^-10. Light a thousandth of the picture's brightest is as good as dark, and so
/// is what the sun's rounded cosine gives the ground at the terminator, 1e-7.
constexpr Measure by_picture{.kind = Measure::Kind::relative, .least = 2e-5, .least_of_largest = 1e-3};
/// Harmonics of the light against the first, which bounds the others.
constexpr Measure by_first{.kind = Measure::Kind::relative, .least = 1e-6, .least_of_largest = 1};
const Measure& measure_of(std::size_t image) { return image == 2 ? by_first : by_picture; }
constexpr double most_apart = 6e-3;

/// Compares a picture of two backends. Paths draw the same numbers everywhere, but where rounding turns one of their choices
/// that pixel has another path, as good: what counts there is the middle pixel.
void compare(Worst& worst, std::string_view model, const Image& a, const Image& b, const Measure& measure,
             const std::string& where) {
    if (model != "reference") return worst.compare(a, b, measure, where);
    double largest = 0;
    for (const glm::dvec4& texel : a.texels) largest = std::max(largest, std::abs(texel.y));
    std::vector<double> apart;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
        apart.push_back(
            difference(a.texels[i].y, b.texels[i].y, {measure.kind, measure.least + measure.least_of_largest * largest}));
    std::ranges::nth_element(apart, apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2));
    worst.add(apart[apart.size() / 2], 0, 0, where + " " + std::to_string(a.extent.width) + " wide");
}

}  // namespace

TEST_CASE("models: each shows presets at every hour, on every backend alike") {
    const auto cpu = open_cpu_float(), vulkan = open_vulkan();
    for (const std::string_view model : model_names()) {
        Worst worst;
        const bool dear = model == "bruneton" || model == "reference";  // half of this program's time, with all presets
        for (const char* preset : preset_names().first(dear ? 2 : preset_names().size())) {
            Shown one(*cpu, model_of(model, "low"), preset);
            std::optional<Shown> other;
            // Vulkan takes long to compile the path tracer, for each air anew: the second one is shown on the CPU alone, and
            // reference_backends_test has more airs on Vulkan.
            if (vulkan && (model != "reference" || preset == preset_names().front()))
                other.emplace(*vulkan, model_of(model, "low"), preset);
            for (const double altitude : altitudes)
                for (const double elevation : elevations) {
                    const std::string where = std::string(model) + ", " + place_name(preset, altitude, elevation);
                    CAPTURE(where);
                    const std::vector<Image> images = one.show(altitude, elevation);
                    CHECK(unsound(images[0]) == "");
                    CHECK(unsound(images[1]) == "");
                    CHECK(unsound(images[2], true) == "");  // harmonics have signs
                    if (!other) continue;
                    const std::vector<Image> others = other->show(altitude, elevation);
                    for (std::size_t i = 0; i < images.size(); ++i)
                        compare(worst, model, others[i], images[i], measure_of(i), where);
                }
        }
        std::printf("%-10s Vulkan and CPU float: %s\n", std::string(model).c_str(), worst.text().c_str());
        CHECK_MESSAGE(worst.error() < most_apart, worst.text());
    }
}

TEST_CASE("models: each shows four wavelengths, on every backend alike") {
    const auto cpu = open_cpu_float(), vulkan = open_vulkan();
    for (const std::string_view model : model_names()) {
        if (model == "bruneton") continue;  // dear, and model_spectral_test has a small one on every backend
        Worst worst;
        Shown one(*cpu, in_four_wavelengths(model_of(model, "low")), "earth");
        std::optional<Shown> other;
        if (vulkan) other.emplace(*vulkan, in_four_wavelengths(model_of(model, "low")), "earth");
        for (const auto& [altitude, elevation] : {std::pair(2.0, 30.0), {200.0, -4.0}, {3e5, 5.0}}) {
            const std::string where = std::string(model) + ", 4 wavelengths, " + place_name("earth", altitude, elevation);
            CAPTURE(where);
            const std::vector<Image> images = one.show(altitude, elevation);
            for (std::size_t i = 0; i < images.size(); ++i) CHECK(unsound(images[i], i == 2) == "");
            if (!other) continue;
            const std::vector<Image> others = other->show(altitude, elevation);
            for (std::size_t i = 0; i < images.size(); ++i) compare(worst, model, others[i], images[i], measure_of(i), where);
        }
        std::printf("%-10s 4 wavelengths, Vulkan and CPU float: %s\n", std::string(model).c_str(), worst.text().c_str());
        CHECK_MESSAGE(worst.error() < most_apart, worst.text());
    }
}

TEST_CASE("models: each in every quality shows day, dusk and space") {
    const auto cpu = open_cpu_float(), vulkan = open_vulkan();
    for (const std::string_view model : model_names())
        for (const std::string_view quality : quality_names()) {
            if (quality == "low") continue;  // that is the case above
            Worst worst;
            Shown one(*cpu, model_of(model, quality), "earth");
            std::optional<Shown> other;
            // Qualities of reference are numbers of paths; reference_backends_test has them on Vulkan, which needs long to
            // compile.
            if (vulkan && model != "reference") other.emplace(*vulkan, model_of(model, quality), "earth");
            for (const auto& [altitude, elevation] : {std::pair(200.0, 30.0), {2.0, -4.0}, {3e5, 5.0}}) {
                const std::vector<Image> images = one.show(altitude, elevation);
                const std::string where = std::string(model) + " " + std::string(quality);
                CAPTURE(where);
                for (std::size_t i = 0; i < images.size(); ++i) CHECK(unsound(images[i], i == 2) == "");
                // There is something to see; but fog is the air that the camera stands in, lit by a sun above the horizon.
                if (model == "fog" && (altitude > 1e5 || elevation < 0)) continue;
                Worst light;
                light.compare(images[0], Image{images[0].extent, std::vector(images[0].texels.size(), glm::dvec4(0))},
                              {Measure::Kind::absolute});
                CHECK(light.error() > 1e-7);
                if (!other) continue;
                const std::vector<Image> others = other->show(altitude, elevation);
                for (std::size_t i = 0; i < images.size(); ++i)
                    compare(worst, model, others[i], images[i], measure_of(i), where);
            }
            CHECK_MESSAGE(worst.error() < most_apart, worst.text());
        }
}

namespace {

/// Molecules alone, so few that light scatters once or not at all, over black ground.
AtmosphereParameters thin_air() {
    AtmosphereParameters air = presets::earth();
    std::erase_if(air.terms, [](const DensityTerm& term) { return term.name != "rayleigh"; });
    air.terms.at(0).scattering_per_m *= 1e-3;
    air.planet.ground_albedo = Rgb(0);
    return air;
}

Setup thin_setup(std::string_view model, std::string_view quality, bool wavelengths) {
    const ModelPtr whole = model_by_name(model, quality);  // with all of its nodes
    Setup setup = setup_of(wavelengths ? in_four_wavelengths(whole) : whole, "earth", false);
    setup.air = thin_air();
    setup.composite.sun_disk = false;
    return setup;
}

/// How far models may be off, by their steps and tables: the median over the sky, and the greatest. Fog knows no height, so
/// that it has no part in this.
struct Stated {
    double median, greatest;
};
Stated stated(std::string_view model, double elevation) {
    const bool dusk = elevation < 0;
    if (model == "hillaire") return dusk ? Stated{0.07, 0.25} : Stated{0.045, 0.06};  // 30 steps, sampled 3/10 into each
    if (model == "bruneton" && dusk) return {0.045, 0.12};                            // few nodes over the sun's height
    return {0.001, 0.006};
}

}  // namespace

TEST_CASE("models: through thin air all see the same sky") {
    const auto cpu = open_cpu_float();
    for (const bool wavelengths : {false, true}) {
        const std::vector<double> heights_of_sun = wavelengths ? std::vector<double>{5} : std::vector<double>{60, 5, -4};
        const auto skies = [&](std::string_view model, std::string_view quality) {
            Rig rig(*cpu, thin_setup(model, quality, wavelengths));
            rig.record_air();
            Camera camera = camera_at(rig.setup.air.planet, 100);
            camera.kind = Projection::panorama;
            std::vector<Image> result;
            for (const double elevation : heights_of_sun) {
                rig.record_view(camera, sun_at(elevation));
                result.push_back(rig.show(panorama));
            }
            return result;
        };
        const std::vector<Image> expected = skies("aureole", "high");
        for (const std::string_view model : model_names()) {
            if (model == "fog" || (wavelengths && model == "bruneton")) continue;  // a solution for each triplet: too slow
            const std::vector<Image> shown = skies(model, "default");
            for (std::size_t i = 0; i < shown.size(); ++i) {
                std::vector<double> errors;
                for (std::uint32_t y = 0; y < panorama.height / 2 - 1; ++y)
                    for (std::uint32_t x = 0; x < panorama.width; ++x)
                        errors.push_back(difference(shown[i].at(x, y).y, expected[i].at(x, y).y, {}));
                std::sort(errors.begin(), errors.end());
                const double median = errors[errors.size() / 2];
                std::printf("%-10s thin air, sun at %2g deg%s: median %.4f, greatest %.4f\n", std::string(model).c_str(),
                            heights_of_sun[i], wavelengths ? ", 4 wavelengths" : "", median, errors.back());
                const Stated most = stated(model, heights_of_sun[i]);
                CAPTURE(model);
                CAPTURE(heights_of_sun[i]);
                CHECK(median < most.median);
                CHECK(errors.back() < most.greatest);
            }
        }
    }
}
