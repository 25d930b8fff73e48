// Filtered look-ups: at texel centres, between them, at and beyond the edges. The textures hold linear functions of the
// texel's place, for which the right answer is known without a second filter: the function at the clamped place.
#include <algorithm>
#include <cmath>

#include "aureole_rhi_tests_shaders.h"
#include "rhi/checks.h"
#include "rhi/harness.h"
#include "rhi/report.h"

namespace aureole::conformance {

using namespace aureole::rhi;

namespace {

/// Looks `texture` up at `coordinates`, with one of the sampling kernels.
std::vector<Texel> look_up(Harness& h, const Shader& shader, Texture texture, Sampler sampler,
                           const std::vector<Texel>& coordinates) {
    const Extent extent{static_cast<std::uint32_t>(coordinates.size()), 1, 1};
    const auto places = h.filled("coordinates", extent, coordinates);
    const auto image = h.texture("looked up", Format::rgba32_float, extent, Usage::storage | Usage::copy_source);
    const auto pipeline = h.compute(shader);
    const auto set =
        h.bind(pipeline, {{0, places, h.sampler(Filter::nearest), {}}, {1, texture, sampler, {}}, {2, image, {}, {}}});
    h.use(image, State::storage_write);
    h.dispatch(pipeline, set, {(extent.width + 15) / 16, 1, 1});
    return h.read(image);
}

constexpr std::uint32_t width = 5, height = 3, depth = 4;

double ramp(double x, double y, double z) { return 2 + 0.5 * x - 0.25 * y + 4 * z; }

/// r and g hold the ramp and its opposite, b and a the texel's place.
std::vector<Texel> ramp_texels(std::uint32_t slices) {
    std::vector<Texel> texels;
    for (std::uint32_t z = 0; z < slices; ++z)
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x) texels.push_back({ramp(x, y, z), -ramp(x, y, z), double(x), double(y)});
    return texels;
}

/// Texture of the ramp in a format that can be filtered.
Texture ramp_texture(Harness& h, std::uint32_t slices, Dimension dimension) {
    const auto texture =
        h.texture("ramp", Format::rgba16_float, {width, height, slices}, Usage::sampled | Usage::copy_destination, dimension);
    h.upload(texture, pack(Format::rgba16_float, ramp_texels(slices)));
    h.use(texture, State::sampled);
    return texture;
}

/// Place in texels of a coordinate, kept on the texture by clamping.
double clamped(double u, std::uint32_t size) { return std::clamp(u * size - 0.5, 0.0, size - 1.0); }

/// Filter weights have at least 8 bits on a GPU: as much as a neighbouring texel differs, over 128.
double tolerance(const Harness& h, double step) { return h.exact ? 1e-5 : step / 128 + 1e-5; }

std::vector<Texel> places_2d() {
    std::vector<Texel> places;
    for (int j = -2; j <= 14; ++j)
        for (int i = -2; i <= 22; ++i) places.push_back({i / 20.0, j / 12.0, 0, 0});  // centres and edges among them
    return places;
}

}  // namespace

void check_nearest(const Target& target) {
    for (const Address address : {Address::clamp, Address::repeat}) {
        Harness h(target);
        const auto texture = ramp_texture(h, 1, Dimension::d2);
        std::vector<Texel> places;
        std::vector<std::pair<int, int>> wanted;
        const auto wrap = [&](int i, int size) {
            return address == Address::clamp ? std::clamp(i, 0, size - 1) : ((i % size) + size) % size;
        };
        for (int j = -4; j < 7; ++j)
            for (int i = -6; i < 11; ++i)
                for (const double within : {0.2, 0.5, 0.8}) {  // anywhere inside a texel
                    places.push_back({(i + within) / width, (j + within) / height, 0, 0});
                    wanted.emplace_back(wrap(i, width), wrap(j, height));
                }
        const auto got = look_up(h, shaders::conformance_sample_2d, texture, h.sampler(Filter::nearest, address), places);
        int wrong = 0;
        for (std::size_t k = 0; k < got.size(); ++k) wrong += got[k][2] != wanted[k].first || got[k][3] != wanted[k].second;
        expect(wrong == 0, std::string(address == Address::clamp ? "clamp" : "repeat") + ": " + std::to_string(wrong) + " of " +
                               std::to_string(got.size()) + " look-ups find another texel");
    }
}

void check_linear(const Target& target) {
    Harness h(target);
    const auto places = places_2d();
    const auto got =
        look_up(h, shaders::conformance_sample_2d, ramp_texture(h, 1, Dimension::d2), h.sampler(Filter::linear), places);
    for (std::size_t k = 0; k < got.size(); ++k) {
        const double x = clamped(places[k][0], width), y = clamped(places[k][1], height);
        const std::string where = "at " + print(places[k]) + ", ";
        expect_near(where + "red", got[k][0], ramp(x, y, 0), tolerance(h, 0.75));
        expect_near(where + "green", got[k][1], -ramp(x, y, 0), tolerance(h, 0.75));
        expect_near(where + "column", got[k][2], x, tolerance(h, 1));
        expect_near(where + "row", got[k][3], y, tolerance(h, 1));
    }
}

void check_linear_repeat(const Target& target) {
    Harness h(target);
    std::vector<Texel> places;
    for (int i = -24; i <= 48; ++i) places.push_back({i / 24.0, 0.5, 0, 0});
    const auto sampler = h.sampler(Filter::linear, Address::repeat);
    const auto got = look_up(h, shaders::conformance_sample_2d, ramp_texture(h, 1, Dimension::d2), sampler, places);
    for (std::size_t k = 0; k < got.size(); ++k) {
        // Between the last and the first texel the way leads back over one step.
        double x = std::fmod(places[k][0] * width - 0.5 + 10 * width, width);
        if (x > width - 1) x = (width - 1) * (width - x);
        expect_near("at " + print(places[k]) + ", column", got[k][2], x, tolerance(h, width - 1));
    }
}

void check_3d(const Target& target) {
    Harness h(target);
    const Dimension d3 = Dimension::d3;
    std::vector<Texel> places;
    for (int k = -1; k <= 17; ++k)
        for (const double u : {-0.1, 0.1, 0.37, 0.9, 1.0})
            for (const double v : {0.0, 1.0 / 6, 0.6, 1.2}) places.push_back({u, v, k / 16.0, 0});
    const auto got = look_up(h, shaders::conformance_sample_3d, ramp_texture(h, depth, d3), h.sampler(Filter::linear), places);
    for (std::size_t k = 0; k < got.size(); ++k) {
        const double wanted = ramp(clamped(places[k][0], width), clamped(places[k][1], height), clamped(places[k][2], depth));
        expect_near("at " + print(places[k]), got[k][0], wanted, tolerance(h, 4.75));
    }

    // Storage writes: each texel at its own place.
    const Extent extent{6, 5, 3};
    const auto image = h.texture("volume", Format::rgba16_float, extent, Usage::storage | Usage::copy_source, d3);
    const auto pipeline = h.compute(shaders::conformance_fill_3d);
    const auto set = h.bind(pipeline, {{0, image, {}, {}}});
    h.use(image, State::storage_write);
    h.dispatch(pipeline, set, {2, 3, 2});
    std::vector<Texel> wanted;
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 6; ++x) wanted.push_back({double(x), double(y), double(z), 6 + 50 + 300});
    expect_equal("texels stored to a volume", h.read(image), wanted);
}

namespace {

constexpr int cube_size = 4;

bool cubes_work(const Target& target) {
    const FormatSupport support = target.device.format_support(Format::rgba16_float, Dimension::cube);
    return support.sampled && support.storage;
}

/// Every texel holds its column, row and face.
Texture filled_cube(Harness& h) {
    const auto cube = h.texture("cube", Format::rgba16_float, {cube_size, cube_size, 1},
                                Usage::sampled | Usage::storage | Usage::copy_source, Dimension::cube);
    const auto pipeline = h.compute(shaders::conformance_fill_cube);
    const auto set = h.bind(pipeline, {{0, cube, {}, {}}});
    h.use(cube, State::storage_write);
    h.dispatch(pipeline, set, {1, 1, 6});
    h.use(cube, State::sampled);
    return cube;
}

/// The direction of a place on a face. Faces +x -x +y -y +z -z; s runs along a row, t down the rows, both from -1 to 1.
Texel cube_direction(std::size_t face, double s, double t) {
    const Texel by_face[6] = {{1, -t, -s, 0}, {-1, -t, s, 0}, {s, 1, t, 0}, {s, -1, -t, 0}, {s, -t, 1, 0}, {-s, -t, -1, 0}};
    return by_face[face];
}

double cube_centre(int i) { return (2 * i + 1.0) / cube_size - 1; }

Texel cube_texel(std::size_t face, int x, int y) { return {double(x), double(y), double(face), cube_size}; }

/// What linear filtering finds one step beyond an edge of a face: of the texels on the other faces, the one closest to that
/// place. Beyond a corner: the mean of the three texels there.
Texel cube_texel_beyond(std::size_t face, int x, int y) {
    const auto inside = [](int i) { return std::clamp(i, 0, cube_size - 1); };
    if (inside(x) == x && inside(y) == y) return cube_texel(face, x, y);
    if (inside(x) != x && inside(y) != y) {
        const Texel a = cube_texel(face, inside(x), inside(y)), b = cube_texel_beyond(face, x, inside(y)),
                    c = cube_texel_beyond(face, inside(x), y);
        Texel mean;
        for (std::size_t i = 0; i < 4; ++i) mean[i] = (a[i] + b[i] + c[i]) / 3;
        return mean;
    }
    const Texel place = cube_direction(face, cube_centre(x), cube_centre(y));
    Texel closest{};
    double least = 1e9;
    for (std::size_t other = 0; other < 6; ++other)
        for (int k = 0; k < cube_size * cube_size && other != face; ++k) {
            const int column = k % cube_size, row = k / cube_size;
            const Texel centre = cube_direction(other, cube_centre(column), cube_centre(row));
            double distance = 0;
            for (std::size_t i = 0; i < 3; ++i) distance += (centre[i] - place[i]) * (centre[i] - place[i]);
            if (distance < least) least = distance, closest = cube_texel(other, column, row);
        }
    return closest;
}

}  // namespace

void check_cube(const Target& target) {
    if (!cubes_work(target)) throw Skipped{"rgba16_float cubes cannot be sampled and stored to"};
    Harness h(target);
    const auto cube = filled_cube(h);
    // Directions of texel centres, and what stands there.
    std::vector<Texel> directions, wanted;
    for (std::size_t face = 0; face < 6; ++face)
        for (int y = 0; y < cube_size; ++y)
            for (int x = 0; x < cube_size; ++x) {
                Texel direction = cube_direction(face, cube_centre(x), cube_centre(y));
                for (double& component : direction) component *= 0.25 * (double(face) + 1);  // length does not matter
                directions.push_back(direction);
                wanted.push_back(cube_texel(face, x, y));
            }
    for (const Filter filter : {Filter::nearest, Filter::linear}) {
        const auto got = look_up(h, shaders::conformance_sample_cube, cube, h.sampler(filter), directions);
        double error = 0;
        for (std::size_t k = 0; k < got.size(); ++k)
            for (std::size_t c = 0; c < 4; ++c) error = std::max(error, std::abs(got[k][c] - wanted[k][c]));
        expect_near(
            filter == Filter::nearest ? "at texels' centres, nearest: worst error" : "at texels' centres, linear: worst error",
            error, 0, filter == Filter::nearest ? 0 : tolerance(h, 5));
    }
    expect_equal("cube copied to a buffer, face by face", h.read(cube), wanted);
}

void check_cube_edges(const Target& target) {
    if (!cubes_work(target)) throw Skipped{"rgba16_float cubes cannot be sampled and stored to"};
    Harness h(target);
    const auto cube = filled_cube(h);
    // Places all over each face, up to its edges and corners. Off the very border, where the face is a matter of rounding.
    constexpr int steps = 32;
    std::vector<Texel> directions, wanted;
    for (std::size_t face = 0; face < 6; ++face)
        for (int j = 0; j < steps; ++j)
            for (int i = 0; i < steps; ++i) {
                const double s = (2 * i + 1.0) / steps - 1, t = (2 * j + 1.0) / steps - 1;
                directions.push_back(cube_direction(face, s, t));
                const double x = (s + 1) / 2 * cube_size - 0.5, y = (t + 1) / 2 * cube_size - 0.5;
                const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
                const double right_weight = x - left, lower_weight = y - top;
                Texel mixed{};
                for (const int dy : {0, 1})
                    for (const int dx : {0, 1}) {
                        const Texel texel = cube_texel_beyond(face, left + dx, top + dy);
                        const double weight = (dx ? right_weight : 1 - right_weight) * (dy ? lower_weight : 1 - lower_weight);
                        for (std::size_t c = 0; c < 4; ++c) mixed[c] += weight * texel[c];
                    }
                wanted.push_back(mixed);
            }
    const auto got = look_up(h, shaders::conformance_sample_cube, cube, h.sampler(Filter::linear), directions);
    for (std::size_t k = 0; k < got.size(); ++k) {
        for (std::size_t c = 0; c < 4; ++c) {
            if (std::abs(got[k][c] - wanted[k][c]) <= tolerance(h, 10)) continue;
            expect_near("towards " + print(directions[k]), got[k][c], wanted[k][c], tolerance(h, 10));
        }
    }
}

}  // namespace aureole::conformance
