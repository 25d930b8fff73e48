// Finds the four wavelengths of fitted() anew, and measures them and the other sets. This is the program that made the
// constant.
#include "spectrum/relative.h"
#include "spectrum/sky_spectra.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <functional>

using namespace aureole;
using namespace aureole::spectrum;
using namespace aureole::spectrum::detail;

namespace {

using Nanometres = std::vector<int>;
constexpr int low_nm = 390, high_nm = 710;

/// A colour to hit, and what a small miss in XYZ costs: delta E^2 = miss^T metric miss.
struct Target {
    glm::dvec3 xyz;
    glm::dmat3 metric;
    std::vector<double> radiance;  ///< At low_nm, low_nm + 1, ..
};

/// Second derivatives of delta E^2, by differences small against what the eye can tell.
glm::dmat3 metric_at(const glm::dvec3& xyz) {
    const glm::dvec3 white = white_d65(), lab = lab_from_xyz(xyz, white);
    constexpr double h = 1e-5;
    const auto squared = [&](const glm::dvec3& step) {  // of both ways, which takes out the third order
        const double there = delta_e_2000(lab, lab_from_xyz(xyz + step, white));
        const double back = delta_e_2000(lab, lab_from_xyz(xyz - step, white));
        return 0.5 * (there * there + back * back);
    };
    glm::dmat3 metric;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            glm::dvec3 both(0), apart(0);
            both[i] += h, both[j] += h, apart[i] += h, apart[j] -= h;
            metric[i][j] = (squared(both) - squared(apart)) / (4 * h * h);
        }
    return metric;
}

std::vector<Target> make_targets() {
    const Wavelengths forty = equal_bins(40);
    std::vector<Target> targets;
    for (unsigned i = 0; i < fit_count; ++i) {
        const SkySpectrum s = sky_spectrum(i);
        const glm::dvec3 xyz = xyz_from_rec709(colour_of(s, forty));
        Target t{.xyz = 0.5 / xyz.y * xyz, .metric = metric_at(0.5 / xyz.y * xyz), .radiance = {}};
        for (int nm = low_nm; nm <= high_nm; ++nm) t.radiance.push_back(s(nm) * 0.5 / xyz.y);
        targets.push_back(std::move(t));
    }
    return targets;
}

/// The 3 x N matrix of least squares, column by column, and the root mean square of delta E that it leaves.
struct Fit {
    std::vector<double> matrix;
    double error = 1e9;
};

Fit fit(const std::vector<Target>& targets, const Nanometres& nm) {
    // Normal equations; then Cholesky.
    const std::size_t n = 3 * nm.size();
    std::vector<std::vector<double>> a(n, std::vector<double>(n));
    std::vector<double> x(n), v(nm.size());
    double unexplained = 0;
    for (const Target& t : targets) {
        const glm::dvec3 pull = t.metric * t.xyz;
        for (std::size_t k = 0; k < nm.size(); ++k) v[k] = t.radiance[static_cast<std::size_t>(nm[k] - low_nm)];
        for (std::size_t row = 0; row < n; ++row) {
            const glm::dvec3& metric = t.metric[static_cast<int>(row % 3)];
            x[row] += v[row / 3] * pull[static_cast<int>(row % 3)];
            for (std::size_t column = 0; column <= row; ++column)
                a[row][column] += v[row / 3] * v[column / 3] * metric[static_cast<int>(column % 3)];
        }
        unexplained += glm::dot(t.xyz, pull);
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            for (std::size_t k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
            if (i == j && !(a[i][i] > 0)) return {};
            a[i][j] = i == j ? std::sqrt(a[i][i]) : a[i][j] / a[j][j];
        }
        for (std::size_t k = 0; k < i; ++k) x[i] -= a[i][k] * x[k];
        x[i] /= a[i][i];
        unexplained -= x[i] * x[i];
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) x[i] -= a[k][i] * x[k];
        x[i] /= a[i][i];
    }
    return {x, std::sqrt(std::max(0.0, unexplained) / static_cast<double>(targets.size()))};
}

struct Search {
    const std::vector<Target>& targets;
    Nanometres best;
    double error = 1e9;

    bool take_if_better(const Nanometres& nm) {
        const double e = fit(targets, nm).error;
        if (!(e < error)) return false;
        error = e;
        best = nm;
        return true;
    }
    /// All increasing sets of `count` on a grid that begin with `chosen`.
    void grid(std::size_t count, int step, Nanometres chosen = {}) {
        if (chosen.size() == count) {
            take_if_better(chosen);
            return;
        }
        const int first = chosen.empty() ? 400 : chosen.back() + step;
        chosen.push_back(first);
        for (; chosen.back() <= 700; chosen.back() += step) grid(count, step, chosen);
    }
    /// Downhill, one wavelength or two at a time, until no step of 1 nm helps.
    void refine() {
        for (int step = 8; step >= 1;) {
            const Nanometres from = best;
            int moves = 1;
            for (std::size_t k = 0; k < from.size(); ++k) moves *= 3;
            bool better = false;
            for (int move = 0; move < moves; ++move) {
                Nanometres next = from;
                int code = move;
                int moved = 0;
                for (int& nm : next) {
                    nm += step * (code % 3 - 1);
                    moved += code % 3 != 1;
                    code /= 3;
                }
                if (moved > 2) continue;
                const bool increasing = std::adjacent_find(next.begin(), next.end(), std::greater_equal<>()) == next.end();
                if (increasing && next.front() >= low_nm && next.back() <= high_nm) better = take_if_better(next) || better;
            }
            if (!better) step /= 2;
        }
    }
};

Wavelengths as_wavelengths(const Nanometres& nm, const Fit& fit) {
    Wavelengths set;
    for (std::size_t k = 0; k < nm.size(); ++k) {
        set.nm.push_back(nm[k]);
        set.to_rec709.push_back(rec709_from_xyz({fit.matrix[3 * k], fit.matrix[3 * k + 1], fit.matrix[3 * k + 2]}));
    }
    return set;
}

/// What the sun outside the air looks like: linear Rec.709 in lux.
Rgb sunlight() {
    Rgb sum(0);
    for (const Rgb& colour : equal_bins(40).to_rec709) sum += colour;
    return sum;
}

/// The figures of spectrum.md, which are rounded to two digits.
void check_spread(const std::string& name, const Spread& actual, const Spread& stated) {
    INFO(name << ": median " << actual.median << ", p95 " << actual.p95 << ", worst " << actual.worst);
    CHECK(relative(actual.median, stated.median) < 0.06);
    CHECK(relative(actual.p95, stated.p95) < 0.06);
    CHECK(relative(actual.worst, stated.worst) < 0.06);
}

}  // namespace

TEST_CASE("spectrum: the fitted wavelengths are what the fit finds") {
    const std::vector<Target> targets = make_targets();
    for (const int n : {3, 4, 6}) {
        CAPTURE(n);
        Search search{targets, {}};
        search.grid(static_cast<std::size_t>(n), 20);
        search.refine();
        const Wavelengths found = as_wavelengths(search.best, fit(targets, search.best));
        const Wavelengths stated = fitted(n);
        REQUIRE(found.nm.size() == static_cast<std::size_t>(n));
        REQUIRE(stated.nm.size() == found.nm.size());
        REQUIRE(stated.to_rec709.size() == found.nm.size());
        for (std::size_t k = 0; k < found.nm.size(); ++k) {
            const Rgb& c = found.to_rec709[k];
            INFO("found " << found.nm[k] << " nm: " << c.r << ", " << c.g << ", " << c.b);
            CHECK(stated.nm[k] == found.nm[k]);
            for (int i = 0; i < 3; ++i) CHECK(std::abs(stated.to_rec709[k][i] - c[i]) < 10);  // of 1e5
        }
    }
}

TEST_CASE("spectrum: how far sets of wavelengths are from forty") {
    check_spread("3", judge_set(fitted(3)), {0.65, 2.2, 6.9});
    check_spread("4", judge_set(fitted(4)), {0.157, 0.58, 1.97});
    check_spread("6", judge_set(fitted(6)), {0.026, 0.091, 0.36});
    check_spread("3 bins", judge_set(equal_bins(3)), {3.8, 17, 28});
    check_spread("6 bins", judge_set(equal_bins(6)), {0.64, 2.2, 5.1});
    check_spread("9 bins", judge_set(equal_bins(9)), {0.48, 1.9, 5.9});
    check_spread("12 bins", judge_set(equal_bins(12)), {0.21, 1.06, 3.1});
    check_spread("15 bins", judge_set(equal_bins(15)), {0.19, 0.58, 1.1});
    check_spread("20 bins", judge_set(equal_bins(20)), {0.09, 0.33, 1});
    check_spread("30 bins", judge_set(equal_bins(30)), {0.073, 0.27, 0.76});
    // The finest there is: what forty themselves are off.
    check_spread("400 bins", judge_set(equal_bins(400)), {0.018, 0.067, 0.114});
}

TEST_CASE("spectrum: how far red, green and blue are from forty") {
    // A sun of the right colour, and each of the three attenuated as one wavelength is.
    const Rgb sun = sunlight();
    const Wavelengths rgb{.nm = {680, 550, 440}, .to_rec709 = {{sun.r, 0, 0}, {0, sun.g, 0}, {0, 0, sun.b}}};
    check_spread("rgb", judge_set(rgb), {6.3, 25, 42});

    // The same with the coefficients of presets::earth.
    const AtmosphereParameters air = presets::earth();
    const Rgb rayleigh = vertical_optical_depth(air, "rayleigh"), ozone = vertical_optical_depth(air, "ozone");
    const auto preset = [&](const SkySpectrum& s) {
        const auto channel = [&](int c) {
            const double aerosol = angstrom_optical_depth(rgb.nm[static_cast<std::size_t>(c)], s.aerosol_beta, s.aerosol_alpha);
            return sun[c] * s({.molecules = rayleigh[c], .aerosol = aerosol, .ozone = ozone[c]});
        };
        return Rgb(channel(0), channel(1), channel(2));
    };
    check_spread("preset", judge(preset), {7.1, 26, 44});
}
