#include "common/rejects.h"

#include <aureole/parameters.h>
#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

using namespace aureole;
using detail::rejected_field;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

// Earth with one term of every kind, so that every field can be spoilt.
AtmosphereParameters everything() {
    AtmosphereParameters p = presets::earth();
    p.terms.push_back({.name = "dust",
                       .profile = TabulatedProfile{{0, 1000, 2000}, {1, 0.5, 0}},
                       .scattering_per_m = Rgb(1e-6),
                       .absorption_per_m = Rgb(0),
                       .phase = TabulatedPhase{{0, 1, pi}, {3, 2, 1}}});
    p.terms.push_back({.name = "fog",
                       .profile = ExponentialProfile{100},
                       .scattering_per_m = Rgb(1e-6),
                       .absorption_per_m = Rgb(0),
                       .phase = HenyeyGreensteinDrainePhase{}});
    p.terms.push_back({.name = "smoke",
                       .profile = ExponentialProfile{500},
                       .scattering_per_m = Rgb(0),
                       .absorption_per_m = Rgb(1e-6),
                       .phase = HenyeyGreensteinPhase{}});
    return p;
}

std::string rejected(const std::function<void(AtmosphereParameters&)>& spoil) {
    AtmosphereParameters p = everything();
    spoil(p);
    return rejected_field([&] { validate(p); });
}

/// A field, how to set it, values that must be rejected, and the ends of its range that must pass.
struct Scalar {
    std::string field;
    std::function<void(AtmosphereParameters&, double)> set;
    std::vector<double> bad, good;
};

template <class T>
T& profile(AtmosphereParameters& p, std::size_t i) {
    return std::get<T>(p.terms[i].profile);
}
template <class T>
T& phase(AtmosphereParameters& p, std::size_t i) {
    return std::get<T>(p.terms[i].phase);
}

void check_all(const std::vector<Scalar>& fields) {
    for (const Scalar& f : fields) {
        CAPTURE(f.field);
        std::vector<double> bad = f.bad;
        bad.insert(bad.end(), {not_a_number, inf, -inf});
        for (const double value : bad) {
            CAPTURE(value);
            CHECK(rejected([&](AtmosphereParameters& p) { f.set(p, value); }) == f.field);
        }
        for (const double value : f.good) {
            CAPTURE(value);
            CHECK(rejected([&](AtmosphereParameters& p) { f.set(p, value); }) == "nothing");
        }
    }
}

}  // namespace

TEST_CASE("validate: presets and one term of every kind pass") {
    for (const char* name : {"earth", "hazy_earth", "mars", "airless"}) CHECK_NOTHROW(validate(presets::by_name(name)));
    CHECK_NOTHROW(validate(everything()));
    CHECK_NOTHROW(validate(AtmosphereParameters{}));
}

TEST_CASE("validate: every field of the planet") {
    check_all({
        {"planet.bottom_radius_m", [](auto& p, double v) { p.planet.bottom_radius_m = v; }, {0, -6.36e6, 999, 1.1e12}, {6e6}},
        {"planet.top_radius_m",
         [](auto& p, double v) { p.planet.top_radius_m = v; },
         {0, -1, 6.36e6, 6.36e6 + 0.5, 11.1 * 6.36e6},
         {6.36e6 + 1, 11 * 6.36e6}},
        {"planet.ground_albedo.r", [](auto& p, double v) { p.planet.ground_albedo.r = v; }, {-1e-9, 1.0001}, {0, 1}},
        {"planet.ground_albedo.g", [](auto& p, double v) { p.planet.ground_albedo.g = v; }, {-1e-9, 1.0001}, {0, 1}},
        {"planet.ground_albedo.b", [](auto& p, double v) { p.planet.ground_albedo.b = v; }, {-1e-9, 1.0001}, {0, 1}},
    });
}

TEST_CASE("validate: every field of every profile") {
    check_all({
        {"terms[0].profile.scale_height_m",
         [](auto& p, double v) { profile<ExponentialProfile>(p, 0).scale_height_m = v; },
         {0, -8000, 0.009, 1.1e12},
         {0.01, 1e12}},
        {"terms[2].profile.center_m",
         [](auto& p, double v) { profile<TentProfile>(p, 2).center_m = v; },
         {-1.1e12, 1.1e12},
         {0, -1e12, 1e12}},
        {"terms[2].profile.half_width_m",
         [](auto& p, double v) { profile<TentProfile>(p, 2).half_width_m = v; },
         {0, -15e3, 0.009, 1.1e12},
         {0.01, 1e12}},
        {"terms[3].profile.altitude_m[1]",
         [](auto& p, double v) { profile<TabulatedProfile>(p, 3).altitude_m[1] = v; },
         {0, -1, -1.1e12, 1.1e12},
         {1, 1999}},
        {"terms[3].profile.density[2]",
         [](auto& p, double v) { profile<TabulatedProfile>(p, 3).density[2] = v; },
         {-1e-9, 1.1e6},
         {0, 1e6}},
    });
    const auto table = [](std::vector<double> altitude, std::vector<double> density) {
        return rejected([&](AtmosphereParameters& p) { p.terms[3].profile = TabulatedProfile{altitude, density}; });
    };
    CHECK(table({}, {}) == "terms[3].profile.altitude_m");
    CHECK(table({0}, {1}) == "terms[3].profile.altitude_m");
    CHECK(table(std::vector<double>(4097, 0), std::vector<double>(4097, 0)) == "terms[3].profile.altitude_m");
    CHECK(table({0, 1}, {1}) == "terms[3].profile.density");
    CHECK(table({0, 1}, {1, 1, 1}) == "terms[3].profile.density");
    CHECK(table({0, 2, 2}, {1, 1, 1}) == "terms[3].profile.altitude_m[2]");
    CHECK(table({-3, 2}, {0, 0}) == "nothing");
}

TEST_CASE("validate: every coefficient") {
    std::vector<Scalar> fields;
    for (int c = 0; c < 3; ++c) {
        const std::string suffix = std::string(".") + "rgb"[c];
        fields.push_back({"terms[1].scattering_per_m" + suffix,
                          [c](auto& p, double v) { p.terms[1].scattering_per_m[c] = v; },
                          {-1e-12, 1.1e6},
                          {0, 1e6}});
        fields.push_back({"terms[2].absorption_per_m" + suffix,
                          [c](auto& p, double v) { p.terms[2].absorption_per_m[c] = v; },
                          {-1e-12, 1.1e6},
                          {0, 1e6}});
    }
    fields.push_back({"terms[1].scattering_scale",
                      [](auto& p, double v) { p.terms[1].scattering_scale = v; },
                      {-1e-12, 1.1e6},
                      {0, 1, 1e6}});
    fields.push_back({"terms[2].absorption_scale",
                      [](auto& p, double v) { p.terms[2].absorption_scale = v; },
                      {-1e-12, 1.1e6},
                      {0, 1, 1e6}});
    check_all(fields);
    // The product must fit as well.
    const auto scaled = [](double coefficient, double scale) {
        return rejected(
            [&](auto& p) { p.terms[1].scattering_per_m = Rgb(0, coefficient, 0), p.terms[1].scattering_scale = scale; });
    };
    CHECK(scaled(0.6e6, 2) == "terms[1].scattering_scale");
    CHECK(scaled(0.5e6, 2) == "nothing");
}

TEST_CASE("validate: every field of every phase function, also where nothing scatters") {
    check_all({
        {"terms[1].phase.g",
         [](auto& p, double v) { phase<CornetteShanksPhase>(p, 1).g = v; },
         {1, -1, 0.9991},
         {0, 0.999, -0.999}},
        {"terms[5].phase.g",
         [](auto& p, double v) { phase<HenyeyGreensteinPhase>(p, 5).g = v; },
         {1, -1, -0.9991},
         {0, 0.999, -0.999}},
        {"terms[4].phase.g_hg",
         [](auto& p, double v) { phase<HenyeyGreensteinDrainePhase>(p, 4).g_hg = v; },
         {1, -1},
         {0.999, -0.999}},
        {"terms[4].phase.g_draine",
         [](auto& p, double v) { phase<HenyeyGreensteinDrainePhase>(p, 4).g_draine = v; },
         {1, -1},
         {0.999, -0.999}},
        {"terms[4].phase.alpha",
         [](auto& p, double v) { phase<HenyeyGreensteinDrainePhase>(p, 4).alpha = v; },
         {-0.1, 1.1e4},
         {0, 1e4}},
        {"terms[4].phase.weight",
         [](auto& p, double v) { phase<HenyeyGreensteinDrainePhase>(p, 4).weight = v; },
         {-0.01, 1.01},
         {0, 1}},
        {"terms[3].phase.angle_rad[1]",
         [](auto& p, double v) { phase<TabulatedPhase>(p, 3).angle_rad[1] = v; },
         {0, -1, 3.2},
         {0.1, 3}},
        {"terms[3].phase.angle_rad[0]",
         [](auto& p, double v) { phase<TabulatedPhase>(p, 3).angle_rad[0] = v; },
         {0.1, -0.1},
         {0}},
        {"terms[3].phase.angle_rad[2]",
         [](auto& p, double v) { phase<TabulatedPhase>(p, 3).angle_rad[2] = v; },
         {3.1, 3.2},
         {pi}},
        {"terms[3].phase.value[1]",
         [](auto& p, double v) { phase<TabulatedPhase>(p, 3).value[1] = v; },
         {-1e-9, 1.1e100},
         {0, 1e100}},
    });
    const auto table = [](std::vector<double> angle, std::vector<double> value) {
        return rejected([&](AtmosphereParameters& p) { p.terms[3].phase = TabulatedPhase{angle, value}; });
    };
    CHECK(table({}, {}) == "terms[3].phase.angle_rad");
    CHECK(table({0}, {1}) == "terms[3].phase.angle_rad");
    CHECK(table(std::vector<double>(4097, 0), std::vector<double>(4097, 0)) == "terms[3].phase.angle_rad");
    CHECK(table({0, pi}, {1}) == "terms[3].phase.value");
    CHECK(table({0, pi}, {0, 0}) == "terms[3].phase.value");
    CHECK(table({0, 3.14159265}, {0, 1e-300}) == "nothing");
}

TEST_CASE("validate: any number of terms, but not of phase functions") {
    AtmosphereParameters p;
    for (int i = 0; i < 100; ++i)
        p.terms.push_back({.name = "haze",
                           .profile = ExponentialProfile{},
                           .scattering_per_m = Rgb(1e-6),
                           .absorption_per_m = Rgb(0),
                           .phase = HenyeyGreensteinPhase{0.1 * (i % 4)}});
    CHECK_NOTHROW(validate(p));
    p.terms[99].phase = RayleighPhase{};
    CHECK(rejected_field([&] { validate(p); }) == "terms");
    p.terms[99].scattering_per_m = Rgb(0);  // its phase function does not matter any more
    CHECK_NOTHROW(validate(p));
}

TEST_CASE("validate: every field of a sun") {
    struct Field {
        std::string field;
        std::function<void(Sun&, double)> set;
        std::vector<double> bad, good;
    };
    const std::vector<Field> fields{
        {"sun.direction.x", [](Sun& s, double v) { s.direction.x = v; }, {1.1e100}, {0, -1e100}},
        {"sun.direction.y", [](Sun& s, double v) { s.direction.y = v; }, {-1.1e100}, {0, 1e100}},
        {"sun.direction.z", [](Sun& s, double v) { s.direction.z = v; }, {1.1e100}, {-1, 1e-100}},
        {"sun.irradiance.r", [](Sun& s, double v) { s.irradiance.r = v; }, {-1e-9, 1.1e20}, {0, 1e20}},
        {"sun.irradiance.g", [](Sun& s, double v) { s.irradiance.g = v; }, {-1e-9, 1.1e20}, {0, 1e20}},
        {"sun.irradiance.b", [](Sun& s, double v) { s.irradiance.b = v; }, {-1e-9, 1.1e20}, {0, 1e20}},
        {"sun.angular_radius_rad", [](Sun& s, double v) { s.angular_radius_rad = v; }, {-1e-9, 0.79}, {0, pi / 4}},
        {"sun.direction",
         [](Sun& s, double v) {
             s.direction = {0, 0, std::isfinite(v) ? v : 0};
         },
         {0, 1e-101},
         {1}},
    };
    for (const Field& f : fields) {
        CAPTURE(f.field);
        std::vector<double> bad = f.bad;
        bad.insert(bad.end(), {not_a_number, inf, -inf});
        for (const double value : bad) {
            CAPTURE(value);
            Sun sun;
            f.set(sun, value);
            CHECK(rejected_field([&] { validate(sun); }) == f.field);
        }
        for (const double value : f.good) {
            Sun sun;
            f.set(sun, value);
            CHECK_NOTHROW(validate(sun));
        }
    }
    Sun sun;
    sun.limb_darkening = static_cast<LimbDarkening>(7);
    CHECK(rejected_field([&] { validate(sun); }) == "sun.limb_darkening");
}

TEST_CASE("validate: the message says what was given and what is allowed") {
    AtmosphereParameters p = presets::earth();
    std::get<ExponentialProfile>(p.terms[1].profile).scale_height_m = -5;
    try {
        validate(p);
        FAIL("not rejected");
    } catch (const Error& error) {
        CHECK(error.field() == "terms[1].profile.scale_height_m");
        CHECK(error.value() == "-5");
        CHECK(error.allowed() == "in [0.01, 1e+12]");
    }
}
