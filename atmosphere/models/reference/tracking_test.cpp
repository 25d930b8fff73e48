// Ratio tracking by itself: its bounds hold, its factors stay in [0, 1], its mean is the transmittance.
#include "common/pack_atmosphere.h"
#include "models/reference/small_planet.h"

#include <aureole/presets.h>
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/traced.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>

#define AUREOLE_PROFILE_TABLE 1
namespace aureole::kernels {
AUREOLE_DEFINE_CPU_KERNEL(BendsKernel)
#include "models/reference/reference_bends.comp.glsl"
};
#undef AUREOLE_BENDS_GLSL
#undef AUREOLE_CONSTANTS_GLSL
AUREOLE_DEFINE_CPU_KERNEL(TrackingFormulas)
#include "common/blocks.glsl"
#include "common/specialization.glsl"
UNIFORMS(0, AtmosphereBlock, atm)
#include "common/geometry.glsl"
#include "models/reference/tracking.glsl"
}
;
}  // namespace aureole::kernels
#undef AUREOLE_PROFILE_TABLE

using namespace aureole;
using namespace aureole::physics;

namespace {

/// The kernel's functions in one precision, for one air.
template <class real>
class Tracking {
public:
    explicit Tracking(const AtmosphereParameters& parameters) {
        validate(parameters);
        const detail::ExactAtmosphere air = detail::pack_exact(parameters);
        const auto block = detail::round_block<detail::AtmosphereBlock>(air.block);
        const auto* floats = reinterpret_cast<const float*>(&block);
        std::array<real, sizeof block / sizeof(float)> wide;
        for (std::size_t i = 0; i < wide.size(); ++i) wide[i] = static_cast<real>(floats[i]);
        static_assert(sizeof kernel.atm == sizeof wide);
        std::memcpy(static_cast<void*>(&kernel.atm), wide.data(), sizeof wide);
        kernel.TERM_COUNT = air.structure.term_count;
        kernel.TERM_KINDS = air.structure.term_kinds;
        if (!air.profile_table.empty()) find_bends(air.profile_table);
    }
    Tracking(const Tracking&) = delete;
    Tracking& operator=(const Tracking&) = delete;

private:
    void find_bends(const std::vector<double>& table) {
        const int rows = static_cast<int>(table.size()) / detail::table_width;
        profiles_.assign(4 * table.size(), real(0));
        for (std::size_t i = 0; i < table.size(); ++i) profiles_[4 * i] = static_cast<real>(static_cast<float>(table[i]));
        kernels::BendsKernel<real> bends(arguments_);
        const int blocks = detail::table_width / bends.BEND_BLOCK;
        bends_.assign(std::size_t{4} * static_cast<std::size_t>(blocks * rows), real(0));
        const auto show = [](auto& texture, std::vector<real>& texels, int width, int height) {
            texture.texels = texels.data();
            texture.width = width;
            texture.height = height;
        };
        for (auto* table_of : {&bends.profile_table, &kernel.profile_table})
            show(*table_of, profiles_, detail::table_width, rows);
        show(bends.bends_out, bends_, blocks, rows);
        bends.bends_out.exact = true;
        bends.bends_out.format = rhi::Format::rgba32_float;
        show(kernel.profile_bends, bends_, blocks, rows);
        for (int row = 0; row < rows; ++row)
            for (int block = 0; block < blocks; ++block) bends.kernel_main({block, row, 0});
    }

    std::array<rhi::CpuBinding, 5> bindings_{};
    rhi::CpuArguments arguments_{.specialization = {}, .bindings = bindings_, .push_constants = {}};
    std::vector<real> profiles_, bends_;

public:
    kernels::TrackingFormulas<real> kernel{arguments_};
};

/// Everything at once: gas, haze and fog that lies low, a tent, a table with corners and a thin sheet of cloud.
AtmosphereParameters all_kinds() {
    AtmosphereParameters air = presets::hazy_earth();
    air.terms.push_back({"fog", ExponentialProfile{40}, Rgb(1e-4), Rgb(0), RayleighPhase{}});
    air.terms.push_back({"sheet",
                         TabulatedProfile{{0, 2e3, 6e3, 6.1e3, 6.2e3, 20e3, 60e3}, {0.3, 0.05, 0.05, 1, 0.02, 0.01, 0}},
                         Rgb(2e-4, 3e-4, 4e-4), Rgb(1e-5), RayleighPhase{}});
    return air;
}
struct NamedAir {
    std::string name;
    AtmosphereParameters air;
};
std::vector<NamedAir> airs() {
    return {{"earth", presets::earth()},
            {"hazy earth", presets::hazy_earth()},
            {"mars", presets::mars()},
            {"all kinds of terms", all_kinds()},
            {"small planet", small_planet()}};
}

/// A ray from somewhere in the air, in km; every other one nearly level.
struct RandomRay {
    double altitude, mu;
};
template <class Generator>
RandomRay random_ray(Generator& random, double thickness_km) {
    std::uniform_real_distribution<double> unit(0, 1);
    const double share = unit(random), altitude = thickness_km * share * share * share;
    const double mu = unit(random) < 0.5 ? 2 * unit(random) - 1 : 0.2 * (unit(random) - 0.5);
    return {altitude, mu};
}
template <class Kernel>
double length_of(Kernel& kernel, const RandomRay& ray) {
    using real = decltype(kernel.bottom_radius());
    const auto h = static_cast<real>(ray.altitude), mu = static_cast<real>(ray.mu);
    return static_cast<double>(kernel.hits_ground(h, mu) ? kernel.distance_to_ground(h, mu) : kernel.distance_to_top(h, mu));
}

/// Extinction minus control over the excess on random pieces of random rays: the least and the greatest.
template <class real>
std::pair<double, double> residual_range(const NamedAir& named) {
    Tracking<real> tracking(named.air);
    auto& kernel = tracking.kernel;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    double least = 0.5, most = 0.5;
    for (int i = 0; i < 3000; ++i) {
        const RandomRay ray = random_ray(random, static_cast<double>(kernel.shell_thickness()));
        const double end = length_of(kernel, ray);
        const auto h = static_cast<real>(ray.altitude), mu = static_cast<real>(ray.mu);
        const double lowest = std::clamp(-(static_cast<double>(kernel.bottom_radius()) + ray.altitude) * ray.mu, 0.0, end);
        // A piece of one of the parts, short or long, from its lower end on.
        const bool falls = unit(random) < lowest / end;
        const double span = falls ? lowest : end - lowest, length = span * std::exp2(-10 * unit(random));
        const double from = (span - length) * unit(random);
        const auto at = [&](double s) {
            return kernel.altitude_after(h, mu, static_cast<real>(falls ? lowest - s : lowest + s));
        };
        const real r = kernel.bottom_radius() + h;
        const auto piece =
            kernel.make_piece(static_cast<real>(length), at(from), at(from + length), r * r * (1 - mu) * (1 + mu));
        const auto bounds = kernel.enclose_extinction(piece, real(0));
        for (int k = 0; k <= 16; ++k) {
            const double x = k / 16.0;
            const auto residual = kernel.residual_extinction(piece, static_cast<real>(x), at(from + x * length));
            for (int c = 0; c < 3; ++c) {
                if (!(bounds.excess[c] > 0)) continue;
                least = std::min(least, static_cast<double>(residual[c] / bounds.excess[c]));
                most = std::max(most, static_cast<double>(residual[c] / bounds.excess[c]));
            }
        }
    }
    return {least, most};
}

/// By adaptive quadrature of the same densities.
Rgb true_transmittance(kernels::TrackingFormulas<double>& kernel, const RandomRay& ray, double end) {
    const Shell shell{kernel.atm.radii.x, kernel.atm.radii.y, {}};
    const double lowest = std::clamp(-(kernel.bottom_radius() + ray.altitude) * ray.mu, 0.0, end);
    Rgb depth(0);
    for (int i = 0; i < kernel.TERM_COUNT; ++i) {
        const auto density = [&](Real t) {
            return static_cast<Real>(
                kernel.term_density(i, static_cast<double>(shell.altitude_after(ray.altitude, ray.mu, t))));
        };
        const Real column = (lowest > 0 ? integrate(density, 0, lowest, 1e-6L) : 0) +
                            (lowest < end ? integrate(density, lowest, end, 1e-6L) : 0);
        depth += static_cast<double>(column) * Rgb(kernel.atm.term_extinction[i]);
    }
    return glm::exp(-depth);
}

struct TrackedMean {
    Rgb mean{0}, error{0};
    double least = 1, most = 0;
};
template <class real>
TrackedMean tracked_mean(kernels::TrackingFormulas<real>& kernel, const RandomRay& ray, double end, int count, unsigned which) {
    typename kernels::TrackingFormulas<real>::Draws draws{which, 1, 2, 3};
    Rgb sum(0), squares(0);
    TrackedMean result;
    for (int i = 0; i < count; ++i) {
        const auto t = kernel.tracked_transmittance(static_cast<real>(ray.altitude), static_cast<real>(ray.mu),
                                                    static_cast<real>(end), draws);
        const Rgb value(t);
        sum += value;
        squares += value * value;
        for (int c = 0; c < 3; ++c) {
            result.least = std::min(result.least, value[c]);
            result.most = std::max(result.most, value[c]);
        }
    }
    result.mean = sum / static_cast<double>(count);
    result.error =
        glm::sqrt(glm::max(squares / static_cast<double>(count) - result.mean * result.mean, Rgb(0)) / (count - 1.0));
    return result;
}

/// Of rays in every air that are not all dark.
template <class real>
void check_means(const char* what, double rounding) {
    constexpr int draws = 16000;
    Scores scores;
    double signed_sum = 0, spread = 0;
    int values = 0;
    unsigned which = 0;
    for (const NamedAir& named : airs()) {
        Tracking<real> tracking(named.air);
        Tracking<double> exact(named.air);
        std::mt19937 random(11);
        for (int i = 0; i < 12; ++i) {
            const RandomRay ray = random_ray(random, exact.kernel.shell_thickness());
            const double end = length_of(exact.kernel, ray);
            const Rgb truth = true_transmittance(exact.kernel, ray, end);
            const TrackedMean tracked = tracked_mean(tracking.kernel, ray, end, draws, ++which);
            CHECK(tracked.least >= -1e-6);
            CHECK(tracked.most <= 1 + 1e-6);
            for (int c = 0; c < 3; ++c) {
                if (truth[c] < 1e-3) continue;  // whose mean a few thousand draws do not tell
                // Where a draw in ten thousand meets a place at all their scatter says nothing.
                const double error = std::hypot(tracked.error[c], (rounding + 1.0 / draws) * truth[c]);
                scores.add(tracked.mean[c] - truth[c], error, named.name, i, c, ray.altitude, ray.mu, tracked.mean[c],
                           truth[c]);
                signed_sum += (tracked.mean[c] - truth[c]) / error;
                spread += tracked.error[c] / truth[c] * std::sqrt(draws);
                ++values;
            }
        }
    }
    scores.check(what, 100);
    std::printf("    a draw scatters by %.3f of the transmittance on average; mean score %.2f of 3 allowed\n", spread / values,
                std::abs(signed_sum) / std::sqrt(values));
    // Channels share their places: at worst all three go one way.
    CHECK(std::abs(signed_sum) / std::sqrt(3.0 * values) < 3);
}

}  // namespace

TEST_CASE("reference tracking: the bounds of extinction hold on pieces of every length, in float and double") {
    for (const NamedAir& named : airs()) {
        CAPTURE(named.name);
        const auto [least, most] = residual_range<double>(named);
        CHECK(least >= -1e-6);
        CHECK(most <= 1);
        CHECK(most > 0.5);  // and they are not far above
        // The excess holds a margin for rounding, which is all there is of it where a piece is short: rounding goes either way.
        const auto [float_least, float_most] = residual_range<float>(named);
        CHECK(float_least >= -1.2);
        CHECK(float_most <= 1);
    }
}

TEST_CASE("reference tracking: the mean of draws is the transmittance, in float and double") {
    check_means<double>("tracked transmittance, double", 1e-6);
    check_means<float>("tracked transmittance, float", 3e-5);
}

TEST_CASE("reference tracking: air that is even, and rays straight up, need no draws") {
    AtmosphereParameters even;
    even.terms = {even_term(Rgb(1e-5, 2e-5, 3e-5), Rgb(0), RayleighPhase{})};
    AtmosphereParameters gas = presets::earth();
    gas.terms.resize(1);
    Tracking<double> flat(even), round(gas);
    const RandomRay level{2, 0}, up{0, 1};
    const double end = length_of(flat.kernel, level), top = length_of(round.kernel, up);
    const TrackedMean a = tracked_mean(flat.kernel, level, end, 100, 1), b = tracked_mean(round.kernel, up, top, 100, 1);
    for (int c = 0; c < 3; ++c) {
        CHECK(a.mean[c] == doctest::Approx(std::exp(-0.01 * (c + 1) * end)).scale(1e-300).epsilon(1e-5));
        CHECK(b.error[c] < 1e-5 * b.mean[c]);
        CHECK(b.mean[c] < 0.97);
    }
}
