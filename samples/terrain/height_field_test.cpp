#include "terrain/height_field.h"

#include <doctest/doctest.h>
#include <cmath>
#include <functional>

using namespace aureole::app;

namespace {

/// Points 100 m apart eastwards, 50 m northwards, in a map `columns` by `rows`; `f` takes metres from the middle.
HeightMap make_map(std::uint32_t columns, std::uint32_t rows, const std::function<double(double, double)>& f) {
    HeightMap map{columns, rows, {}, 100, 50};
    for (std::uint32_t r = 0; r < rows; ++r)
        for (std::uint32_t c = 0; c < columns; ++c)
            map.meters.push_back(static_cast<float>(f(100 * (c - 0.5 * (columns - 1)), 50 * (0.5 * (rows - 1) - r))));
    return map;
}

}  // namespace

TEST_CASE("HeightField: a slope keeps its heights and normals") {
    // Interpolation by cubics reproduces planes exactly away from the mirrored edges.
    const HeightField field(make_map(41, 61, [](double e, double n) { return 500 + 0.2 * e - 0.1 * n; }), 1);
    for (const glm::dvec2 place : {glm::dvec2(0, 0), glm::dvec2(333, -777), glm::dvec2(-1500, 1200)}) {
        CAPTURE(place.x);
        CHECK(field.height(place) == doctest::Approx(500 + 0.2 * place.x - 0.1 * place.y).scale(1e-300).epsilon(1e-5));
        const glm::dvec3 normal = field.normal(place);
        CHECK(normal.x / normal.z == doctest::Approx(-0.2).scale(1e-300).epsilon(1e-3));
        CHECK(normal.y / normal.z == doctest::Approx(0.1).scale(1e-300).epsilon(1e-3));
    }
    CHECK(field.lowest() < 500 - 0.2 * 1990 - 0.1 * 1490);
    CHECK(field.highest() > 500 + 0.2 * 1990 + 0.1 * 1490);
}

TEST_CASE("HeightField: mirror images continue the map without a step") {
    const HeightField field(make_map(41, 61, [](double e, double n) { return 0.2 * e + 10 * std::sin(n / 200); }), 1);
    // The map reaches 2000 m east and 1500 m north of its middle.
    for (const double beyond : {1.0, 250.0, 3900.0}) {
        CAPTURE(beyond);
        CHECK(field.height({2000 + beyond, 100}) == doctest::Approx(field.height({2000 - beyond, 100})));
        CHECK(field.height({-2000 - beyond, 100}) == doctest::Approx(field.height({-2000 + beyond, 100})));
    }
    CHECK(field.height({300, 1500 + 400}) == doctest::Approx(field.height({300, 1500 - 400})));
    CHECK(field.height({300, -1500 - 400}) == doctest::Approx(field.height({300, -1500 + 400})));
    // Two images further on everything is as at first.
    CHECK(field.height({123 + 8000, 45 - 6000}) == doctest::Approx(field.height({123, 45})));
    CHECK(field.normal({2000 + 250, 100}).x == doctest::Approx(-field.normal({2000 - 250, 100}).x));
    CHECK(field.open_sky({2000 + 250, 100}) == doctest::Approx(field.open_sky({2000 - 250, 100})));
}

TEST_CASE("HeightField: exaggeration multiplies heights") {
    const auto shape = [](double e, double n) { return 100 + 0.05 * e + 0.02 * n; };
    const HeightField once(make_map(20, 20, shape), 1), thrice(make_map(20, 20, shape), 3);
    CHECK(thrice.height({120, -80}) == doctest::Approx(3 * once.height({120, -80})));
}

TEST_CASE("HeightField: nothing is above a cell's ceiling, and ceilings are tight") {
    const HeightField field(make_map(33, 47, [](double e, double n) { return 80 * std::sin(e / 170) * std::cos(n / 130); }), 1);
    for (int level = 0; level < field.levels(); ++level) {
        const glm::dvec2 size = field.cell_size(level);
        for (std::int64_t y = -3; y < 5; ++y) {
            for (std::int64_t x = -3; x < 5; ++x) {
                double highest = -1e9;
                for (double v = 0.02; v < 1; v += 0.16)
                    for (double u = 0.02; u < 1; u += 0.16)
                        highest =
                            std::max(highest, field.height(field.origin() + size * glm::dvec2(static_cast<double>(x) + u,
                                                                                              static_cast<double>(y) + v)));
                CHECK(highest <= field.ceiling(level, x, y) + 1e-9);
                if (level == 0) CHECK(highest > field.ceiling(level, x, y) - 3);
            }
        }
    }
}

TEST_CASE("HeightField: how much sky is open") {
    const HeightField flat(make_map(20, 20, [](double, double) { return 7; }), 1);
    CHECK(flat.open_sky({0, 0}) == doctest::Approx(1));
    // At the bottom of a long trench with slopes of 45 degrees the horizon towards azimuth a from the trench's normal has
    // tangent |cos a|; the mean of 1 / (1 + cos^2 a) over a is 1 / sqrt(2).
    const HeightField trench(make_map(101, 201, [](double e, double) { return std::abs(e); }), 1);
    CHECK(trench.open_sky({0, 0}) == doctest::Approx(std::sqrt(0.5)).scale(1e-300).epsilon(0.03));
}

TEST_CASE("HeightField: the smallest map") {
    const HeightField field(make_map(2, 2, [](double e, double) { return e; }), 1);
    CHECK(field.height({0, 0}) == doctest::Approx(0).epsilon(1e-6));
    CHECK(field.highest() == doctest::Approx(50));
}
