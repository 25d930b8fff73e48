#include "measure/pictures.h"

#include <doctest/doctest.h>
#include <png.h>
#include <cmath>

using namespace aureole;
using namespace aureole::app;

namespace {

std::string base64_of(const std::string& text) { return base64(std::as_bytes(std::span(text))); }

/// Red of the picture's pixel.
float red(const LinearImage& image, std::uint32_t x, std::uint32_t y) { return image.rgb[3 * (y * image.width + x)]; }

}  // namespace

TEST_CASE("pictures: base64 as RFC 4648 has it") {
    CHECK(base64_of("").empty());
    CHECK(base64_of("f") == "Zg==");
    CHECK(base64_of("fo") == "Zm8=");
    CHECK(base64_of("foo") == "Zm9v");
    CHECK(base64_of("foobar") == "Zm9vYmFy");
    CHECK(base64_of("\xff\xfe\xfd") == "//79");
}

TEST_CASE("pictures: a PNG holds linear values as sRGB") {
    const std::vector<std::byte> bytes = encode_png({2, 1, {0, 0.5F, 1, 0.0031308F, -1, 7}});
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) != 0);
    CHECK(image.width == 2);
    CHECK(image.height == 1);
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> pixels(6);
    REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
    CHECK(pixels == std::vector<std::uint8_t>{0, 188, 255, 10, 0, 255});  // IEC 61966-2-1; 12.92 x 0.0031308 x 255 = 10.3
}

TEST_CASE("pictures: one side of the sun, mirrored") {
    const SuiteScene scene{.scene_class = "Day", .air = 0, .sun_elevation_deg = 30, .altitude_m = 2};
    const std::vector<ProbeRow> rows = picture_rows(scene);
    REQUIRE(rows.size() == picture_width / 2 * picture_height);
    CHECK(rows.front().view_zenith_deg < 3);
    CHECK(rows.front().azimuth_deg < 3);
    CHECK(rows.back().view_zenith_deg > 177);
    CHECK(rows.back().azimuth_deg > 177);
    CHECK(rows[1].azimuth_deg > rows[0].azimuth_deg);
    CHECK(rows[1].view_zenith_deg == rows[0].view_zenith_deg);

    std::vector<Rgb> radiance(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) radiance[i] = Rgb(rows[i].azimuth_deg + 1000 * rows[i].view_zenith_deg);
    const LinearImage image = picture_of(radiance, 2);
    REQUIRE(image.rgb.size() == 3 * picture_width * picture_height);
    const std::uint32_t middle = picture_width / 2;
    CHECK(red(image, middle, 0) == doctest::Approx(2 * radiance[0].r).epsilon(1e-6).scale(1e-300));
    for (std::uint32_t y = 0; y < picture_height; ++y)
        for (std::uint32_t x = 0; x < middle; ++x) CHECK(red(image, middle + x, y) == red(image, middle - 1 - x, y));
    CHECK(red(image, picture_width - 1, 3) > red(image, middle, 3));
    CHECK(red(image, middle, 4) > red(image, middle, 3));
}

TEST_CASE("pictures: differences from black to white") {
    const std::size_t count = picture_width / 2 * picture_height;
    const std::vector<Rgb> truth(count, Rgb(0.2));
    std::vector<Rgb> seen = truth;
    seen[0] = Rgb(1);  // far beyond the end of the scale
    seen[1] = Rgb(0.21);
    const LinearImage image = difference_of(seen, truth, 1);
    const std::uint32_t middle = picture_width / 2;
    CHECK(red(image, middle, 0) == 1);
    CHECK(red(image, middle + 1, 0) > 0);
    CHECK(red(image, middle + 1, 0) < 0.1F);  // about one unit: on the way to violet
    CHECK(red(image, middle + 2, 0) == 0);
}
