// Models in N wavelengths: what is added up, and what is left as it was.
#include <doctest/doctest.h>

#include "models/spectral/pictures_test.h"
#include "multi_scatter/order_ratio.h"
#include "passes/dropped_list.h"
#include "recording/allocations.h"

#include <cstdio>

using namespace aureole;
using namespace aureole::passes;
using spectrum::Wavelengths;

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

TEST_CASE("spectral: solutions that are spread over frames are added up when all are ready") {
    // Thin at long wavelengths, so thick at short ones that these alone would take more passes.
    const auto dusty = [](double depth) {
        return [depth](const AtmosphereParameters& rgb, const std::array<double, 3>& nm) {
            AtmosphereParameters air = rgb;
            for (int c = 0; c < 3; ++c)
                air.terms[0].scattering_per_m[c] = depth / 8000 * std::pow(440 / nm[static_cast<std::size_t>(c)], 8);
            return air;
        };
    };
    const auto cpu = open_cpu_float();
    const Wavelengths set = spectrum::equal_bins(6);
    Setup setup = setup_of(models::spectral(models::aureole(exact_quality()), {set, dusty(6)}));
    std::vector<double> ratios;
    for (const spectrum::Triplet& triplet : spectrum::triplets(set))
        ratios.push_back(detail::order_ratio(dusty(6)(setup.air, triplet.nm)));
    REQUIRE(std::abs(detail::passes_for(ratios[0], 3) - detail::passes_for(ratios[1], 3)) > 1);

    Rig rig(*cpu, setup);
    rig.air.set_multi_scatter_passes_per_frame(1);
    rig.record_air();
    AtmosphereParameters fresh = setup.air;
    fresh.planet.ground_albedo = Rgb(0.9);
    rig.air.set_parameters(fresh);
    std::vector<Image> shown;  // without repetitions: the new ground with the old field, the new field
    for (int frame = 0; frame < 70; ++frame) {
        rig.record_air();
        Image picture = sky(rig, 60);
        if (shown.empty() || !(shown.back().texels == picture.texels)) shown.push_back(std::move(picture));
    }
    CHECK(shown.size() == 2);
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
    std::string_view last;
    for (const ModelPtr& inner : inner_models()) {
        if (inner->name() == "reference" || inner->name() == last) continue;
        last = inner->name();
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
    const CompositeTargets targets{.target = cpu->device().create_texture(
                                       {"target", rhi::Dimension::d2, rhi::Format::rgba32_float, picture, rhi::Usage::storage}),
                                   .extent = picture};
    CompositeSettings composite;
    composite.target_format = rhi::Format::rgba32_float;
    for (const ModelPtr& inner : inner_models()) {
        Atmosphere air(cpu->device(), presets::earth(), models::spectral(inner, {spectrum::equal_bins(9)}));
        ViewSettings settings;
        const bool takes_shadows = inner->name() != "fog" && inner->name() != "reference";
        if (takes_shadows) settings.shadows = {.cascades = 1, .size = {5, 4, 3}, .samples = 1};
        View view(air, settings, composite);
        view.prepare_composite(targets);
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
            view.record_composite(list, targets);
            const int allocations = recording::end_counting_allocations();
            cpu->queue().submit();
            cpu->queue().wait();
            if (frame > 1) CHECK(allocations == 0);  // the device's own list grows to its size in the first
            for (const PassReport& report : air.reports()) {
                CHECK(report.recorded);
                CHECK(report.bytes_written > 0);
            }
            CHECK(view.reports().back().recorded);
        }
    }
    cpu->device().destroy(targets.target, 0);
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
