#include "io/height_map.h"

#include "io/image.h"
#include "io/test_files.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <doctest/doctest.h>
#include <zip.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace aureole::app;

namespace {

std::string npy(const std::string& shape, const std::vector<double>& values) {
    const std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }\n";
    std::string text = "\x93NUMPY\x01";
    text += std::string(1, '\0') + static_cast<char>(header.size()) + '\0' + header;
    return text + std::string(reinterpret_cast<const char*>(values.data()), values.size() * 8);
}

std::filesystem::path npz(const std::string& name, const std::vector<std::pair<std::string, std::string>>& arrays) {
    std::filesystem::remove(name);
    zip_t* archive = zip_open(name.c_str(), ZIP_CREATE, nullptr);
    REQUIRE(archive);
    for (const auto& [entry, text] : arrays)
        REQUIRE(zip_file_add(archive, (entry + ".npy").c_str(), zip_source_buffer(archive, text.data(), text.size(), 0), 0) >=
                0);
    REQUIRE(zip_close(archive) == 0);
    return name;
}

std::filesystem::path exr(const std::string& name, const std::vector<float>& values) {
    Imf::Header header(2, static_cast<int>(values.size() / 2));
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(values.data())), 4, 8));
    Imf::OutputFile file(name.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(static_cast<int>(values.size() / 2));
    return name;
}

const HeightMapOptions ten_meters{10, 1, 0};
std::string rejected(const std::filesystem::path& path, const HeightMapOptions& options = ten_meters) {
    return complaint([&] { (void)read_height_map(path, options); });
}

}  // namespace

TEST_CASE("read_height_map: an archive that says where it is") {
    const auto file = npz("sized.npz", {{"elevation", npy("(2, 3)", {1, 2, 3, 4, 5, 6})},
                                        {"dx", npy("()", {0.001})},
                                        {"dy", npy("()", {0.002})},
                                        {"ymin", npy("()", {60})},
                                        {"ymax", npy("()", {60})}});
    const HeightMap map = read_height_map(file, {});
    CHECK(map.width == 3);
    CHECK(map.height == 2);
    CHECK(map.meters == std::vector<float>{1, 2, 3, 4, 5, 6});
    // A degree of latitude is pi / 180 of Earth's mean radius, 6371.0088 km: 111.195 km; of longitude half that at 60 degrees.
    CHECK(map.spacing_north_m == doctest::Approx(222.390).scale(1e-300).epsilon(1e-5));
    CHECK(map.spacing_east_m == doctest::Approx(55.5975).scale(1e-300).epsilon(1e-5));
    CHECK(read_height_map(file, ten_meters).spacing_east_m == 10);  // what the caller says goes first

    CHECK(contains(rejected(npz("pole.npz", {{"elevation", npy("(2, 2)", {1, 2, 3, 4})},
                                             {"dx", npy("()", {0.001})},
                                             {"dy", npy("()", {-0.002})},
                                             {"ymin", npy("()", {60})},
                                             {"ymax", npy("()", {60})}})),
                   "arrays dx, dy, ymin, ymax"));
}

TEST_CASE("read_height_map: units and offset; other files") {
    const HeightMap map = read_height_map(npz("bare.npz", {{"z", npy("(2, 2)", {1, 2, 3, 4})}}), {30, 0.5, 100});
    CHECK(map.meters == std::vector<float>{100.5f, 101, 101.5f, 102});
    CHECK(map.spacing_east_m == 30);
    CHECK(map.spacing_north_m == 30);
    CHECK(read_height_map(exr("map.exr", {1, 2, 3, 4}), ten_meters).meters == std::vector<float>{1, 2, 3, 4});
}

TEST_CASE("read_height_map: what is rejected") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(contains(rejected(npz("none.npz", {{"z", npy("(2, 2)", {1, 2, 3, 4})}}), {}), "spacing_m: no value is not allowed"));
    CHECK(contains(rejected(npz("names.npz", {{"a", npy("(2, 2)", {1, 2, 3, 4})}, {"b", npy("()", {1})}})),
                   "a, b is not allowed; allowed: one called elevation, or only one"));
    CHECK(contains(rejected(npz("flat.npz", {{"z", npy("(4,)", {1, 2, 3, 4})}})), "1 dimensions is not allowed; allowed: 2"));
    CHECK(contains(rejected(npz("thin.npz", {{"z", npy("(4, 1)", {1, 2, 3, 4})}})), "1x4 is not allowed; allowed: 2 to 32768"));
    CHECK(contains(rejected(npz("nan.npz", {{"z", npy("(2, 2)", {1, 2, nan, 4})}})), "height at row 1, column 0: nan m"));
    CHECK(contains(rejected(npz("deep.npz", {{"z", npy("(2, 2)", {1, -2e5, 3, 4})}})), "height at row 0, column 1: -2e+05 m"));
    CHECK(contains(rejected(exr("nan.exr", {1, 2, NAN, 4})), "height at row 1, column 0"));
    CHECK(contains(rejected("map.tif"), "heightmap: map.tif is not allowed; allowed: jacksboro, or a file that ends in"));
    CHECK(contains(rejected("missing.npz"), "there is no such file"));
    CHECK(contains(rejected("map.exr", {0, 1, 0}), "spacing_m: 0 is not allowed"));
    CHECK(contains(rejected("map.exr", {nan, 1, 0}), "spacing_m: nan is not allowed"));
    CHECK(contains(rejected("map.exr", {10, 0, 0}), "meters_per_unit: 0 is not allowed"));
    CHECK(contains(rejected("map.exr", {10, 1, 1e9}), "offset_m: 1e+09 is not allowed"));
}

TEST_CASE("read_height_map: Matplotlib's sample grid, where it is installed") {
    if (!std::filesystem::exists("/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz")) {
        CHECK(contains(rejected("jacksboro", {}), "install python-matplotlib-data"));
        return;
    }
    const HeightMap map = read_height_map("jacksboro", {});
    CHECK(map.width == 403);
    CHECK(map.height == 344);
    // 3 arc seconds at 36.6 degrees north; the heights' range is the published one of the sample.
    CHECK(map.spacing_north_m == doctest::Approx(92.66).scale(1e-300).epsilon(1e-3));
    CHECK(map.spacing_east_m == doctest::Approx(92.66 * std::cos(36.59 * std::numbers::pi / 180)).scale(1e-300).epsilon(1e-3));
    const auto [low, high] = std::ranges::minmax(map.meters);
    CHECK(low == 236);
    CHECK(high == 1076);
}
