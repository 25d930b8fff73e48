// Models in N wavelengths that compute light for each pixel: pixels are added up.
#include <doctest/doctest.h>

#include "models/spectral/pictures_test.h"

using namespace aureole;
using namespace aureole::passes;

TEST_CASE("spectral: a picture by pixels is the sum of those at each triplet, with what is behind the air") {
    const auto cpu = open_cpu_double();
    std::vector<ModelPtr> inner = models_by_pixels();
    inner.push_back(models::reference(few_paths(true)));
    inner.push_back(models::reference(few_paths(false)));
    inner.erase(inner.begin() + 1);  // fog of one colour, which is RGB
    for (const Wavelengths& set : {spectrum::fitted(4), spectrum::equal_bins(9)}) {
        const std::vector<spectrum::Triplet> triplets = spectrum::triplets(set);
        const Rgb sun = models::solar_rec709(set);
        for (const ModelPtr& model : inner) {
            // What is behind the air is grey: it is RGB, in which triplets know no red.
            Image grey{picture, {}};
            for (std::uint32_t i = 0; i < picture.width * picture.height; ++i)
                grey.texels.emplace_back(glm::dvec3(0.1 + 0.05 * (i % 7)), 1);
            const rhi::Texture behind = cpu->make("grey", rhi::Format::rgba32_float, grey);
            Shown all(*cpu, models::spectral(model, {set, of_earth}));
            all.targets.scene_color = behind;
            std::vector<std::unique_ptr<Shown>> parts;
            for (const spectrum::Triplet& triplet : triplets) {
                parts.push_back(std::make_unique<Shown>(*cpu, model, spectrum::earth(triplet.nm)));
                parts.back()->targets.scene_color = behind;
            }
            Worst worst;
            for (const double elevation : {60.0, -1.0}) {
                Sun wide = sun_at(elevation);
                wide.angular_radius_rad = 0.4;  // seen by some pixels
                wide.limb_darkening = LimbDarkening::none;
                const std::vector<Image> shown = all.show(wide);
                std::vector<std::vector<Image>> by_triplet;  // each once: films go on adding up
                by_triplet.reserve(parts.size());
                for (const std::unique_ptr<Shown>& part : parts) by_triplet.push_back(part->show(wide));
                for (std::size_t i = 0; i < shown.size(); ++i) {
                    Image sum{shown[i].extent, std::vector<glm::dvec4>(shown[i].texels.size())};
                    for (std::size_t k = 0; k < parts.size(); ++k) {
                        const Image& part = by_triplet[k][i];
                        for (std::size_t t = 0; t < sum.texels.size(); ++t)
                            sum.texels[t] += glm::dvec4(triplets[k].to_rec709 * glm::dvec3(part.texels[t]) / sun, 0);
                    }
                    for (glm::dvec4& texel : sum.texels)
                        texel = glm::dvec4(i == 2 ? glm::dvec3(texel) : glm::max(glm::dvec3(texel), 0.0), 1);
                    worst.compare(shown[i], sum, {Measure::Kind::relative, 0, 1e-3}, "picture " + std::to_string(i));
                }
            }
            INFO(model->name() << ", " << set.nm.size() << ": " << worst.text());
            CHECK(worst.compared());
            CHECK(worst.error() < 1e-6);  // sums and weights are floats
        }
    }
}

TEST_CASE("spectral: fog of one colour has that colour, whatever the wavelengths") {
    const auto cpu = open_cpu_double();
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(0);
    models::FogSettings grey;
    grey.mode = models::FogSettings::Mode::one_colour;
    grey.colour = Rgb(0.3, 0.1, 0.2);
    Shown plain(*cpu, models::fog(grey), air), wrapped(*cpu, models::spectral(models::fog(grey), {spectrum::fitted(4)}), air);
    const std::vector<Image> a = plain.show(30), b = wrapped.show(30);
    Worst worst;
    for (std::size_t i = 0; i < a.size(); ++i) {
        // The sun's light through the air, in the light's last column, is of the air.
        const Measure measure{.kind = Measure::Kind::relative, .least = 0, .least_of_largest = 1e-3};
        if (i < 2)
            worst.compare(a[i], b[i], measure);
        else
            for (std::uint32_t x = 0; x < 9; ++x) CHECK(glm::length(a[i].at(x, 0) - b[i].at(x, 0)) < 1e-6);
    }
    CHECK_MESSAGE(worst.error() < 1e-6, worst.text());
}

TEST_CASE("spectral: suns of two colours are the sum of each, and a full-screen draw shows what a compute pass does") {
    const auto cpu = open_cpu_double();
    for (const ModelPtr& inner : models_by_pixels()) {
        Setup setup = setup_of(models::spectral(inner, {spectrum::fitted(4)}));
        setup.view.max_suns = 2;
        setup.composite.sun_disk = false;
        Rig rig(*cpu, setup);
        setup.composite.raster = true;
        Rig drawn(*cpu, setup);
        rig.record_air();
        drawn.record_air();
        Camera camera = camera_at(setup.air.planet, 200);
        camera.kind = Projection::panorama;
        Sun red = sun_at(20), blue = sun_at(5);
        red.irradiance = Rgb(2, 0.5, 0.25);
        blue.irradiance = Rgb(0.1, 0.2, 1);
        const auto show = [&](Rig& of, std::vector<Sun> suns) {
            of.record_view(camera, suns);
            return of.show(panorama);
        };
        const Image both = show(rig, {red, blue});
        CHECK(show(drawn, {red, blue}) == both);
        Image sum = show(rig, {red});
        const Image other = show(rig, {blue});
        for (std::size_t i = 0; i < sum.texels.size(); ++i) sum.texels[i] += other.texels[i] * glm::dvec4(1, 1, 1, 0);
        Worst worst;
        worst.compare(both, sum, {Measure::Kind::relative, 0, 1e-3});
        CHECK_MESSAGE(worst.error() < 1e-6, inner->name() << worst.text());
    }
}
