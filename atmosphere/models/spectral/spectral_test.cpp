// Models in N wavelengths: what is added up, and what is left as it was.
#include <doctest/doctest.h>

#include <aureole/models/bruneton.h>
#include <aureole/models/fog.h>
#include <aureole/models/hillaire.h>
#include <aureole/models/reference.h>
#include <aureole/models/single_lut.h>
#include <aureole/models/spectral.h>

#include "passes/dropped_list.h"
#include "passes/scene.h"
#include "passes/trio.h"
#include "recording/allocations.h"

#include <cstdio>

using namespace aureole;
using namespace aureole::passes;
using models::SpectralSettings;
using spectrum::Wavelengths;

namespace {

constexpr rhi::Extent panorama{24, 12, 1}, picture{20, 12, 1};
constexpr double elevations[] = {60, 5, 0, -4};

QualitySettings exact_quality() {
    QualitySettings quality = small_quality();
    quality.table_format = rhi::Format::rgba32_float;
    return quality;
}

models::BrunetonSettings small_bruneton() {
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

models::HillaireSettings small_hillaire() {
    models::HillaireSettings s;
    s.table_format = s.froxel_format = rhi::Format::rgba32_float;
    s.transmittance = {40, 12, 1};
    s.multi_scatter = {9, 7, 1};
    s.sky_view = {11, 22, 1};
    s.aerial_perspective = {9, 7, 6};
    return s;
}

/// With tables in float, so that sums of pictures and pictures of sums differ by rounding alone.
std::vector<ModelPtr> models_by_tables() {
    return {models::aureole(exact_quality()), models::hillaire(small_hillaire()), models::bruneton(small_bruneton())};
}

/// Which compute light for each pixel; with what they keep tables of, and without.
std::vector<ModelPtr> models_by_pixels() {
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

models::ReferenceSettings few_paths(bool film) {
    models::ReferenceSettings s;
    s.paths_per_frame = 2;
    s.light_paths = 2;
    s.max_order = 3;
    s.nodes = 4;
    s.first_order_parts = 1;
    if (film) s.film_width = panorama.width, s.film_height = panorama.height;
    return s;
}

std::vector<ModelPtr> inner_models() {
    std::vector<ModelPtr> all = models_by_tables();
    for (ModelPtr& model : models_by_pixels()) all.push_back(std::move(model));
    all.push_back(models::reference(few_paths(true)));
    return all;
}

Setup setup_of(const ModelPtr& model, bool geometry = false) {
    Setup setup;
    setup.model = model;
    setup.view.projection = geometry ? Projection::matrix : Projection::panorama;
    setup.composite.target_format = rhi::Format::rgba32_float;
    setup.composite.scene_color = setup.composite.scene_depth = geometry;
    return setup;
}

/// The atmosphere's own parameters, whatever the wavelengths.
AtmosphereParameters as_it_is(const AtmosphereParameters& rgb, const std::array<double, 3>&) { return rgb; }
AtmosphereParameters of_earth(const AtmosphereParameters&, const std::array<double, 3>& nm) { return spectrum::earth(nm); }

Wavelengths red_green_blue(double scale = 1) {
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

Image sky(Rig& rig, double elevation) {
    Camera camera = camera_at(rig.setup.air.planet, 200);
    camera.kind = Projection::panorama;
    rig.record_view(camera, sun_at(elevation));
    return rig.show(panorama);
}

}  // namespace

TEST_CASE("spectral: red, green and blue in place of wavelengths change no bit") {
    const auto cpu = open_cpu_float();
    for (const ModelPtr& inner : inner_models()) {
        Shown plain(*cpu, inner), wrapped(*cpu, models::spectral(inner, {red_green_blue(), as_it_is}));
        for (const double elevation : elevations) CHECK(plain.show(elevation) == wrapped.show(elevation));
    }
}

TEST_CASE("spectral: the same air at every wavelength is the same picture, through the sums") {
    // Two triplets of the same air: sums of equal tables with weights that add up to 1.
    Wavelengths set = red_green_blue(0.25);
    const Wavelengths more = red_green_blue(0.75);
    set.nm.insert(set.nm.end(), more.nm.begin(), more.nm.end());
    set.to_rec709.insert(set.to_rec709.end(), more.to_rec709.begin(), more.to_rec709.end());
    const auto cpu = open_cpu_double();
    for (const ModelPtr& inner : inner_models()) {
        Shown plain(*cpu, inner), wrapped(*cpu, models::spectral(inner, {set, as_it_is}));
        Worst worst;
        for (const double elevation : elevations) {
            const std::vector<Image> a = plain.show(elevation), b = wrapped.show(elevation);
            // Weights are floats. Channels out of three equal ones: hillaire's grey air is not grey in wavelengths.
            for (std::size_t i = 0; i < a.size(); ++i)
                if (inner->name() != "hillaire" || i != 1) worst.compare(a[i], b[i], {Measure::Kind::relative, 0, 1e-4});
        }
        INFO(inner->name() << ": " << worst.text());
        CHECK(worst.compared());
        CHECK(worst.error() < 1e-6);
    }
}

TEST_CASE("spectral: a sky is the sum of the skies at each triplet") {
    const auto cpu = open_cpu_double();
    for (const int count : {6, 9, 40}) {
        const Wavelengths set = count == 6 ? spectrum::fitted(6) : spectrum::equal_bins(count);
        const std::vector<spectrum::Triplet> triplets = spectrum::triplets(set);
        const Rgb sun = models::solar_rec709(set);
        std::vector<ModelPtr> inner = models_by_tables();
        if (count == 40) inner.resize(1);
        for (const ModelPtr& model : inner) {
            Setup setup = setup_of(model);
            setup.view.light = setup.composite.sun_disk = false;
            setup.air = spectrum::earth({680, 550, 440});
            setup.model = models::spectral(model, {set, of_earth});
            Rig all(*cpu, setup);
            all.record_air();
            std::vector<std::unique_ptr<Rig>> parts;
            for (const spectrum::Triplet& triplet : triplets) {
                setup.air = spectrum::earth(triplet.nm);
                setup.model = model;
                parts.push_back(std::make_unique<Rig>(*cpu, setup));
                parts.back()->record_air();
            }
            Worst worst;
            bool negative = false;
            for (const double elevation : elevations) {
                Image sum{panorama, std::vector<glm::dvec4>(panorama.width * panorama.height)};
                for (std::size_t k = 0; k < parts.size(); ++k) {
                    const Image part = sky(*parts[k], elevation);
                    for (std::size_t i = 0; i < sum.texels.size(); ++i)
                        sum.texels[i] += glm::dvec4(triplets[k].to_rec709 * glm::dvec3(part.texels[i]) / sun, 0);
                }
                for (glm::dvec4& texel : sum.texels) {
                    negative |= std::min({texel.x, texel.y, texel.z}) < 0;
                    texel = glm::max(texel, glm::dvec4(0));
                }
                // The ground of bruneton is a product of sums: the sky alone is linear.
                const std::uint32_t rows = model->name() == "bruneton" ? panorama.height / 2 : panorama.height;
                worst.compare(sky(all, elevation), sum, 0, rows, {Measure::Kind::relative, 0, 1e-3},
                              "sun at " + std::to_string(elevation));
            }
            INFO(model->name() << ", " << count << ": " << worst.text());
            CHECK(worst.error() < 5e-7);
            std::printf("spectral: %s, %d wavelengths: %s%s\n", std::string(model->name()).c_str(), count, worst.text().c_str(),
                        negative ? "; some of it out of gamut" : "");
        }
    }
}

TEST_CASE(
    "spectral: a picture by pixels is the sum of those at each triplet, with what the host and the suns put behind the air") {
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

TEST_CASE("spectral: optical depth is that of the sun's light, and within that of the wavelengths") {
    const auto cpu = open_cpu_double();
    const Wavelengths set = spectrum::equal_bins(12);
    const std::vector<spectrum::Triplet> triplets = spectrum::triplets(set);
    const Rgb sun = models::solar_rec709(set);
    Setup setup;
    setup.air = spectrum::earth({680, 550, 440});
    setup.quality = exact_quality();
    std::vector<Image> parts;
    for (const spectrum::Triplet& triplet : triplets) {
        Setup part = setup;
        part.air = spectrum::earth(triplet.nm);
        AirRig rig(*cpu, part);
        rig.record_air();
        parts.push_back(rig.transmittance());
    }
    setup.model = models::spectral(models::aureole(setup.quality), {set, of_earth});
    AirRig rig(*cpu, setup);
    rig.record_air();
    const Image table = rig.transmittance();
    double worst = 0;
    for (std::size_t i = 0; i < table.texels.size(); ++i) {
        glm::dvec3 light(0);
        double least = 1e9, most = 0;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            const glm::dvec3 depth(parts[k].texels[i]);
            light += triplets[k].to_rec709 * glm::exp(-depth) / sun;
            least = std::min({least, depth.x, depth.y, depth.z});
            most = std::max({most, depth.x, depth.y, depth.z});
        }
        for (int c = 0; c < 3; ++c) {
            const double expected = light[c] > 0 ? std::clamp(-std::log(light[c]), least, most) : most;
            worst = std::max(worst, std::abs(table.texels[i][c] - expected) / std::max(expected, 1e-3));
        }
    }
    INFO(worst);
    CHECK(worst < 1e-4);  // where the sum nearly cancels, weights in float are felt
}

TEST_CASE("spectral: every backend shows the same") {
    Backends backends;
    for (const ModelPtr& inner : inner_models()) {
        if (inner->name() == "reference") continue;  // the ladder's test: where rounding turns a choice its paths are others
        const Setup setup = setup_of(models::spectral(inner, {spectrum::fitted(6)}));
        Trio<Rig> trio(backends, setup);
        trio.record_air();
        Precision apart;
        for (const double elevation : elevations) {
            Images images{sky(trio.single, elevation), sky(trio.exact, elevation), {}};
            if (trio.vulkan) images.vulkan = sky(*trio.vulkan, elevation);
            CHECK(images.unsound() == "");
            apart.compare(images, {Measure::Kind::relative, 0, 1e-3}, "sun at " + std::to_string(elevation));
            Images light = trio.read(&Rig::light);
            apart.compare(light, {Measure::Kind::relative, 1e-6, 1}, "light");
        }
        apart.check("spectral " + std::string(inner->name()), "sky and light", 1e-4, 1e-4);
    }
}

TEST_CASE("spectral: geometry through the air, with no number below 0") {
    const auto cpu = open_cpu_float(), vulkan = open_vulkan();
    for (const ModelPtr& inner : inner_models()) {
        if (inner->name() == "reference") continue;
        const ModelPtr model = models::spectral(inner, {spectrum::equal_bins(12)});
        Shown one(*cpu, model);
        std::optional<Shown> other;
        if (vulkan) other.emplace(*vulkan, model);
        Worst worst;
        for (const double elevation : elevations) {
            const std::vector<Image> images = one.show(elevation);
            CHECK(unsound(images[0]) == "");
            CHECK(unsound(images[1]) == "");
            if (!other) continue;
            worst.compare(other->show(elevation)[1], images[1], {Measure::Kind::relative, 0, 1e-3});
        }
        INFO(inner->name() << worst.text());
        CHECK(worst.error() < 2e-3);
    }
}

TEST_CASE("spectral: changes and losses reach every triplet and the sums") {
    const auto cpu = open_cpu_float();
    for (const ModelPtr& inner : inner_models()) {
        const ModelPtr model = models::spectral(inner, {spectrum::fitted(4)});
        AtmosphereParameters other = presets::earth();
        other.terms[0].scattering_per_m *= 1.5;
        Rig rig(*cpu, setup_of(model));
        rig.record_air();
        (void)sky(rig, 5);
        rig.air.set_parameters(other);
        CHECK(rig.record_air().total() > 0);
        CHECK(rig.record_air().total() == 0);

        Setup setup = setup_of(model);
        setup.air = other;
        Rig fresh(*cpu, setup);
        fresh.record_air();
        CHECK(sky(rig, 5) == sky(fresh, 5));
        CHECK(rig.air.table_bytes() == fresh.air.table_bytes());
        CHECK(rig.view.table_bytes() == fresh.view.table_bytes());

        // Another structure: everything is made anew.
        other.terms.push_back(other.terms[1]);
        other.terms.back().phase = HenyeyGreensteinPhase{0.5};
        rig.air.set_parameters(other);
        rig.record_air();
        setup.air = other;
        Rig third(*cpu, setup);
        third.record_air();
        const Image expected = sky(third, 5);
        CHECK(sky(rig, 5) == expected);

        DroppedList dropped;
        rig.air.invalidate();
        rig.air.record(dropped);
        rig.view.record(dropped);
        CHECK(dropped.dispatches > 0);
        rig.air.invalidate();
        rig.record_air();
        CHECK(sky(rig, 5) == expected);
    }
}

TEST_CASE("spectral: an error on the way leaves nothing behind") {
    const auto cpu = open_cpu_float();
    const std::uint64_t before = cpu->device().live();
    for (const ModelPtr& inner : inner_models()) {
        const ModelPtr model = models::spectral(inner, {spectrum::fitted(4)});
        std::uint64_t more = 0;
        for (bool made = false; !made; more += 3) {
            cpu->device().fail_after(more);
            try {
                Rig rig(*cpu, setup_of(model));
                made = true;
            } catch (const Error&) {
            }
            CHECK(cpu->device().live() == before);
        }
        CHECK(more > 20);
        cpu->device().fail_after(std::nullopt);
    }
}

TEST_CASE("spectral: recording allocates nothing") {
    const auto cpu = cpu::create_cpu_device({});
    for (const ModelPtr& inner : inner_models()) {
        Atmosphere air(cpu->device(), presets::earth(), models::spectral(inner, {spectrum::fitted(4)}));
        View view(air, {}, {});
        const Sun sun = sun_at(20);
        AtmosphereParameters parameters = presets::earth();
        for (int frame = 0; frame < 4; ++frame) {
            parameters.planet.ground_albedo = Rgb(0.1 + 0.1 * frame);
            air.set_parameters(parameters);
            view.update(camera_at(parameters.planet, 10.0 * frame), {&sun, 1});
            rhi::CommandList& list = cpu->queue().begin();
            recording::begin_counting_allocations();
            air.record(list);
            view.record(list);
            const int allocations = recording::end_counting_allocations();
            cpu->queue().submit();
            cpu->queue().wait();
            if (frame > 1) CHECK(allocations == 0);  // the device's own list grows to its size in the first
            for (const PassReport& report : air.reports()) {
                CHECK(report.recorded);
                CHECK(report.bytes_written > 0);
            }
        }
    }
}

TEST_CASE("spectral: passes of all triplets are told as one") {
    const auto cpu = open_cpu_float();
    Rig plain(*cpu, setup_of(models::aureole(small_quality())));
    Rig six(*cpu, setup_of(models::spectral(models::aureole(small_quality()), {spectrum::fitted(6)})));
    plain.record_air();
    six.record_air();
    (void)sky(plain, 5);
    (void)sky(six, 5);
    REQUIRE(six.view.reports().size() == 4);
    CHECK(six.view.reports()[0].name == "wavelengths");
    CHECK(six.view.reports()[1].name == "sums");
    CHECK(six.view.reports()[0].invocations == 2 * (plain.view.reports()[0].invocations + plain.view.reports()[1].invocations));
    CHECK(six.air.reports()[0].bytes_written ==
          2 * (plain.air.reports()[0].bytes_written + plain.air.reports()[1].bytes_written));
    CHECK(six.view.reports().back().invocations == plain.view.reports().back().invocations);
    // Of sky view and froxels: two sets, and the sums.
    CHECK(six.view.reports()[1].bytes_written * 2 == six.view.reports()[0].bytes_written);
}
