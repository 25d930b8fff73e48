// Shadows with models in N wavelengths: what they take of the light is the sum of what they take at each triplet.
#include <doctest/doctest.h>

#include "models/spectral/pictures_test.h"

#include <cmath>
#include <cstdio>

using namespace aureole;
using namespace aureole::passes;

namespace {

/// From 2 km, looking down a little: sky, bare ground and, on the left, black land 5 km away.
struct Shadowed {
    Shadowed(Backend& backend, const ModelPtr& model, const AtmosphereParameters& air, bool stripes)
        : rig(backend, setup_with(model, air)) {
        const DepthConvention convention = perspective_conventions(1.5).front();
        const Image black{picture,
                          std::vector<glm::dvec4>(std::size_t{picture.width} * picture.height, glm::dvec4(0, 0, 0, 1))};
        targets.scene_color = backend.make("black", rhi::Format::rgba32_float, black);
        targets.scene_depth = upload(
                                  backend, picture, [](auto x, auto) { return x < 7 ? 5e3 : INFINITY; }, convention)
                                  .depth;
        camera = look(air.planet.bottom_radius_m, 2000, 0, -0.15, 0.9, 1.5);
        camera.projection = convention.projection;
        rig.record_air();
        if (stripes) rig.view.set_shadow_map(striped(backend, air.planet.bottom_radius_m));
    }
    static Setup setup_with(const ModelPtr& model, const AtmosphereParameters& air) {
        Setup setup = setup_of(model, true);
        setup.air = air;
        setup.view.light = setup.composite.sun_disk = false;
        setup.view.shadows = {.cascades = 1, .distance_m = 20e3, .size = {8, 6, 12}, .samples = 3};
        return setup;
    }
    /// From above, over 64 km: dark and lit in turn, all the way up to 20 km.
    static ShadowMap striped(Backend& backend, double ground) {
        Image depth{{16, 1, 1}, {}};
        for (int x = 0; x < 16; ++x) depth.texels.emplace_back(x % 2 == 0 ? 0 : 1, 0, 0, 0);
        ShadowMap map;
        map.texture = backend.make("shadow map", rhi::Format::r32_float, depth);
        glm::dmat4& m = map.world_to_map[0] = glm::dmat4(0);
        m[0][0] = 1 / 64e3;
        m[1][0] = m[1][1] = 0.37 / 64e3;  // aslant, so that no sample lies at an edge
        m[3][0] = m[3][1] = 0.5 + 0.0123;
        m[2][2] = -1 / 40e3;
        m[3][2] = (ground + 20e3) / 40e3;
        m[3][3] = 1;
        return map;
    }
    Image show(const Sun& sun) {
        rig.record_view(camera, sun);
        return rig.show(picture, targets);
    }
    Rig rig;
    CompositeTargets targets;
    Camera camera;
};

std::vector<ModelPtr> of_both_kinds() {
    models::SingleLutSettings look_up;
    look_up.table_format = rhi::Format::rgba32_float;
    return {models::aureole(exact_quality()), models::single_lut(look_up)};
}

/// Pixels of land (x < 7), ground or sky that shadows darken.
int darker(const Image& lit, const Image& left, std::uint32_t begin, std::uint32_t end, std::uint32_t first,
           std::uint32_t last) {
    int count = 0;
    for (std::uint32_t y = first; y < last; ++y)
        for (std::uint32_t x = begin; x < end; ++x) count += left.at(x, y).y < 0.97 * lit.at(x, y).y ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("spectral shadows: a picture is the sum of the pictures at each triplet, each with its own shadows") {
    const auto cpu = open_cpu_float();
    for (const Wavelengths& set : {spectrum::fitted(4), spectrum::equal_bins(9)}) {
        const std::vector<spectrum::Triplet> triplets = spectrum::triplets(set);
        const Rgb white = models::solar_rec709(set), colour(2, 0.5, 0.25);
        for (const ModelPtr& model : of_both_kinds()) {
            const AtmosphereParameters rgb = spectrum::earth({680, 550, 440});
            Shadowed all(*cpu, models::spectral(model, {set, of_earth}), rgb, true),
                lit(*cpu, models::spectral(model, {set, of_earth}), rgb, false);
            std::vector<std::unique_ptr<Shadowed>> parts;
            parts.reserve(triplets.size());
            for (const spectrum::Triplet& triplet : triplets)
                parts.push_back(std::make_unique<Shadowed>(*cpu, model, spectrum::earth(triplet.nm), true));
            Worst worst;
            for (const double elevation : {50.0, 4.0}) {
                Image sum{picture, std::vector<glm::dvec4>(std::size_t{picture.width} * picture.height)};
                for (std::size_t k = 0; k < parts.size(); ++k) {
                    const Image part = parts[k]->show(sun_at(elevation));
                    for (std::size_t i = 0; i < sum.texels.size(); ++i)
                        sum.texels[i] += glm::dvec4(triplets[k].to_rec709 * glm::dvec3(part.texels[i]) / white * colour, 0);
                }
                for (glm::dvec4& texel : sum.texels) texel = glm::dvec4(glm::max(glm::dvec3(texel), 0.0), 1);
                Sun sun = sun_at(elevation);
                sun.irradiance = colour;
                const Image shown = all.show(sun), before = lit.show(sun);
                worst.compare(shown, sum, {Measure::Kind::relative, 0, 1e-2}, "sun at " + std::to_string(elevation));
                CHECK(darker(before, shown, 0, 7, 0, picture.height) > 5);
                CHECK(darker(before, shown, 7, picture.width, 0, 4) > 5);
                CHECK(darker(before, shown, 7, picture.width, 8, picture.height) > 5);
            }
            INFO(model->name() << ", " << set.nm.size() << ": " << worst.text());
            std::printf("spectral shadows: %s, %zu wavelengths: %s\n", std::string(model->name()).c_str(), set.nm.size(),
                        worst.text().c_str());
            CHECK(worst.compared());
            // Of single scattering in full shadow rounding is left, which each part shows where it is above 0.
            CHECK(worst.error() < (model->name() == "aureole" ? 2e-5 : 4e-4));
        }
    }
}

TEST_CASE("spectral shadows: one triplet that is red, green and blue has the shadows of its own air") {
    const auto cpu = open_cpu_float();
    for (const ModelPtr& model : of_both_kinds()) {
        Shadowed plain(*cpu, model, spectrum::earth({650, 540, 450}), true),
            wrapped(*cpu, models::spectral(model, {{{650, 540, 450}, red_green_blue().to_rec709}, of_earth}),
                    spectrum::earth({680, 550, 440}), true);
        CHECK(plain.show(sun_at(20)) == wrapped.show(sun_at(20)));
    }
}

TEST_CASE("spectral shadows: the same on every backend") {
    Backends backends;
    if (!backends.vulkan) return;
    for (const ModelPtr& model : of_both_kinds()) {
        const ModelPtr four = models::spectral(model, {spectrum::fitted(4), of_earth});
        const AtmosphereParameters air = spectrum::earth({680, 550, 440});
        Shadowed single(*backends.single, four, air, true), vulkan(*backends.vulkan, four, air, true);
        Worst worst;
        for (const double elevation : {50.0, 4.0})
            worst.compare(single.show(sun_at(elevation)), vulkan.show(sun_at(elevation)), {Measure::Kind::relative, 0, 1e-2});
        INFO(model->name() << ": " << worst.text());
        std::printf("spectral shadows: %s on Vulkan: %s\n", std::string(model->name()).c_str(), worst.text().c_str());
        CHECK(worst.error() < 5e-3);
        CHECK(backends.vulkan->take_messages() == "");
    }
}
