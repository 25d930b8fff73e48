#include "common/rejects.h"
#include "spectrum/relative.h"

#include <aureole/spectrum.h>

#include <doctest/doctest.h>

using namespace aureole;
using namespace aureole::spectrum;
using aureole::detail::rejected_field;
using aureole::spectrum::detail::relative;

namespace {

/// Bands of `width` nm around values at first, first + width, ..
Bands bands_around(double first, double width, std::vector<double> value) {
    Bands bands{.edge_nm = {first - width / 2}, .value = std::move(value)};
    while (bands.edge_nm.size() <= bands.value.size()) bands.edge_nm.push_back(bands.edge_nm.back() + width);
    return bands;
}

struct Pair {
    glm::dvec3 a, b;
    double difference;
};
/// Table 1 of Sharma, Wu & Dalal 2005: all 34.
const std::vector<Pair> published{{{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
                                  {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
                                  {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
                                  {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
                                  {{50, -1.1848, -84.8006}, {50, 0, -82.7485}, 1.0000},
                                  {{50, -0.9009, -85.5211}, {50, 0, -82.7485}, 1.0000},
                                  {{50, 0, 0}, {50, -1, 2}, 2.3669},
                                  {{50, -1, 2}, {50, 0, 0}, 2.3669},
                                  {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
                                  {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0010}, 7.1792},
                                  {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0011}, 7.2195},
                                  {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0012}, 7.2195},
                                  {{50, -0.0010, 2.4900}, {50, 0.0009, -2.4900}, 4.8045},
                                  {{50, -0.0010, 2.4900}, {50, 0.0010, -2.4900}, 4.8045},
                                  {{50, -0.0010, 2.4900}, {50, 0.0011, -2.4900}, 4.7461},
                                  {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
                                  {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
                                  {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
                                  {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
                                  {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
                                  {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1.0000},
                                  {{50, 2.5, 0}, {50, 3.2972, 0}, 1.0000},
                                  {{50, 2.5, 0}, {50, 1.8634, 0.5757}, 1.0000},
                                  {{50, 2.5, 0}, {50, 3.2592, 0.3350}, 1.0000},
                                  {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
                                  {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
                                  {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
                                  {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
                                  {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
                                  {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
                                  {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
                                  {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
                                  {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
                                  {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};

}  // namespace

TEST_CASE("spectrum: CIEDE2000 gives the published differences, both ways") {
    CHECK(published.size() == 34);
    for (const Pair& pair : published) {
        CAPTURE(pair.a.y);
        CAPTURE(pair.b.y);
        CHECK(std::abs(delta_e_2000(pair.a, pair.b) - pair.difference) < 5.1e-5);
        CHECK(std::abs(delta_e_2000(pair.b, pair.a) - pair.difference) < 5.1e-5);
        CHECK(delta_e_2000(pair.a, pair.a) == 0);
    }
}

TEST_CASE("spectrum: equal energy is E") {
    const glm::dvec3 e = xyz({.edge_nm = {360, 830}, .value = {1}});
    CHECK(relative(e.x / e.y, 1) < 3e-4);
    CHECK(relative(e.z / e.y, 1) < 4e-4);
    // 683 lm/W x the area under the luminosity function, 106.857 nm.
    CHECK(relative(e.y, 683 * 106.857) < 1e-5);
    // Narrower bands, and bands that reach beyond what is visible, say the same.
    const glm::dvec3 split = xyz({.edge_nm = {0, 401, 402.5, 555, 700, 2000}, .value = {1, 1, 1, 1, 1}});
    CHECK(glm::length(split - e) < 1e-9 * e.y);
}

TEST_CASE("spectrum: D65 is Rec.709's white") {
    // CIE D65, 380-780 nm every 10 nm.
    const Bands d65 = bands_around(
        380, 10, {49.9755, 54.6482, 82.7549, 91.486,  93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861, 115.923,
                  108.811, 109.354, 107.802, 104.79,  107.689, 104.405, 104.046, 100,     96.3342, 95.788,  88.6856,
                  90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091,
                  74.349,  61.604,  69.8856, 75.087,  63.5927, 46.4182, 66.8054, 63.3828});
    const glm::dvec3 sum = xyz(d65);
    CHECK(relative(sum.x / (sum.x + sum.y + sum.z), 0.3127) < 1e-3);
    CHECK(relative(sum.y / (sum.x + sum.y + sum.z), 0.3290) < 1e-3);
    const Rgb rgb = rec709_from_xyz(sum) / sum.y;
    for (int c = 0; c < 3; ++c) CHECK(relative(rgb[c], 1) < 5e-3);
}

TEST_CASE("spectrum: Rec.709") {
    const glm::dvec3 white = xyz_from_rec709(Rgb(1));
    CHECK(glm::length(white - white_d65()) < 1e-14);
    CHECK(glm::length(lab_from_xyz(white, white_d65()) - glm::dvec3(100, 0, 0)) < 1e-10);
    // The luminances of the primaries, as ITU-R BT.709 rounds them.
    CHECK(relative(xyz_from_rec709({1, 0, 0}).y, 0.2126) < 3e-4);
    CHECK(relative(xyz_from_rec709({0, 1, 0}).y, 0.7152) < 3e-4);
    CHECK(relative(xyz_from_rec709({0, 0, 1}).y, 0.0722) < 1e-3);
    const Rgb colour(0.2, -0.1, 3);
    CHECK(glm::length(rec709_from_xyz(xyz_from_rec709(colour)) - colour) < 1e-14);
    // A grey of 18 % is L* 49.5.
    CHECK(relative(lab_from_xyz(0.18 * white, white).x, 49.4961) < 1e-5);
    CHECK(relative(lab_from_xyz(0.001 * white, white).x, 0.9033) < 1e-3);
}

TEST_CASE("spectrum: bad bands and colours are rejected") {
    CHECK(rejected_field([] { (void)xyz({.edge_nm = {400}, .value = {}}); }) == "bands.edge_nm");
    CHECK(rejected_field([] { (void)xyz({.edge_nm = {400, 500}, .value = {1, 2}}); }) == "bands.value");
    CHECK(rejected_field([] { (void)xyz({.edge_nm = {400, 400}, .value = {1}}); }) == "bands.edge_nm[1]");
    CHECK(rejected_field([] { (void)xyz({.edge_nm = {-1, 400}, .value = {1}}); }) == "bands.edge_nm[0]");
    CHECK(rejected_field([] { (void)xyz({.edge_nm = {400, 500}, .value = {NAN}}); }) == "bands.value[0]");
    CHECK(rejected_field([] { (void)lab_from_xyz({1, 1, 1}, {1, 0, 1}); }) == "white.y");
    CHECK(rejected_field([] { (void)lab_from_xyz({1, INFINITY, 1}, {1, 1, 1}); }) == "xyz.y");
    CHECK(rejected_field([] { (void)delta_e_2000({NAN, 0, 0}, {0, 0, 0}); }) == "lab_a.x");
    CHECK(rejected_field([] { (void)rec709_from_xyz({0, 0, NAN}); }) == "xyz.z");
}
