#include "io/image.h"

#include "io/test_files.h"

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <doctest/doctest.h>
#include <png.h>
#include <zlib.h>
#include <cstring>

using namespace aureole::app;

namespace {

/// A greyscale PNG of 3 x 2 pixels, written by libpng itself.
template <class T>
void put_grey(const char* name, const std::vector<T>& pixels, png_uint_32 format) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = 3;
    image.height = 2;
    image.format = format;
    REQUIRE(png_image_write_to_file(&image, name, 0, pixels.data(), 0, nullptr));
}

void put_exr(const char* name, std::initializer_list<const char*> channels, const std::vector<float>& values) {
    Imf::Header header(3, 2);
    Imf::FrameBuffer buffer;
    for (const char* channel : channels) {
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
        buffer.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(values.data())), 4, 12));
    }
    Imf::OutputFile file(name, header);
    file.setFrameBuffer(buffer);
    file.writePixels(2);
}

}  // namespace

TEST_CASE("write_png: pixels come back") {
    const DisplayImage image{2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 1, 2, 3}};
    write_png("rgb.png", image);
    png_image read{};
    read.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&read, "rgb.png"));
    read.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> pixels(12);
    REQUIRE(png_image_finish_read(&read, nullptr, pixels.data(), 0, nullptr));
    CHECK(read.width == 2);
    CHECK(pixels == image.rgb);
    CHECK(contains(complaint([&] { write_png("no_folder/rgb.png", image); }), "there is no folder no_folder"));
}

TEST_CASE("write_exr: floats come back to the bit") {
    const LinearImage image{2, 1, {1e-9f, 2, 3e9f, 4, 5, 0.1f}};
    write_exr("rgb.exr", image);
    Imf::InputFile file("rgb.exr");
    std::vector<float> green(2);
    Imf::FrameBuffer buffer;
    buffer.insert("G", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(green.data()), 4, 8));
    file.setFrameBuffer(buffer);
    file.readPixels(0);
    CHECK(green == std::vector<float>{2, 5});
    CHECK(contains(complaint([&] { write_exr("no_folder/rgb.exr", image); }), "there is no folder no_folder"));
}

TEST_CASE("read_png_grey: 8 and 16 bits") {
    put_grey<std::uint16_t>("grey16.png", {0, 1, 2, 3, 256, 65535}, PNG_FORMAT_LINEAR_Y);
    const GreyImage image = read_png_grey("grey16.png");
    CHECK(image.width == 3);
    CHECK(image.height == 2);
    CHECK(image.values == std::vector<float>{0, 1, 2, 3, 256, 65535});
    put_grey<std::uint8_t>("grey8.png", {0, 1, 2, 3, 4, 255}, PNG_FORMAT_GRAY);
    CHECK(read_png_grey("grey8.png").values == std::vector<float>{0, 1, 2, 3, 4, 255});
}

TEST_CASE("read_png_grey: what it rejects") {
    write_png("colour.png", {1, 1, {1, 2, 3}});
    CHECK(contains(complaint([] { (void)read_png_grey("colour.png"); }), "allowed: greyscale with 8 or 16 bits"));
    CHECK(contains(complaint([] { (void)read_png_grey("missing.png"); }), "there is no such file"));
    CHECK(contains(complaint([] { (void)read_png_grey(put("text.png", "hello, this is no picture")); }), "not a readable PNG"));
    put_grey<std::uint16_t>("whole.png", {0, 1, 2, 3, 256, 65535}, PNG_FORMAT_LINEAR_Y);
    const std::string whole = get("whole.png");
    for (std::size_t length = 0; length < whole.size(); ++length) {
        CAPTURE(length);
        CHECK(contains(complaint([&] { (void)read_png_grey(put("cut.png", whole.substr(0, length))); }), "not a readable PNG"));
    }
}

TEST_CASE("read_png_grey: a header is not believed") {
    put_grey<std::uint16_t>("whole.png", {0, 1, 2, 3, 256, 65535}, PNG_FORMAT_LINEAR_Y);
    const auto with_size = [](png_uint_32 width, png_uint_32 height) {
        std::string bytes = get("whole.png");  // signature, length, IHDR, width, height, 5 bytes, check sum
        png_save_uint_32(reinterpret_cast<png_bytep>(bytes.data() + 16), width);
        png_save_uint_32(reinterpret_cast<png_bytep>(bytes.data() + 20), height);
        const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + 12), 17);
        png_save_uint_32(reinterpret_cast<png_bytep>(bytes.data() + 29), static_cast<png_uint_32>(sum));
        return complaint([&] { (void)read_png_grey(put("header.png", bytes)); });
    };
    CHECK(with_size(60000, 60000) ==
          "header.png: size: 60000x60000 is not allowed; allowed: 2 to 32768 points a side, at most 268435456 in all");
    CHECK(contains(with_size(32768, 32768), "size: 32768x32768 is not allowed"));
    CHECK(contains(with_size(3, 1), "size: 3x1 is not allowed"));
    std::string large = get("whole.png");  // a text of two gigabytes after the header, of 33 bytes with the signature
    large.insert(33, "\x7f\xff\xff\xf0tEXt");
    CHECK(contains(complaint([&] { (void)read_png_grey(put("large.png", large)); }),
                   "not a readable PNG: the file ends too early"));
    CHECK(contains(with_size(16384, 16384), "not a readable PNG: the file ends too early"));  // before half a gigabyte is taken
}

TEST_CASE("read_exr_grey: what an attribute promises is not believed") {
    put_exr("y.exr", {"Y"}, {0, 1, 2, 3, -4, 1e6f});
    const std::string whole = get("y.exr");
    const auto number = [](std::uint32_t value) {
        std::string bytes(4, ' ');
        for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> (8 * i));
        return bytes;
    };
    const auto said = [&](const std::string& type, std::uint32_t length, const std::string& value) {
        const std::string own = "own" + std::string(1, '\0') + type + std::string(1, '\0') + number(length) + value;
        return complaint([&] { (void)read_exr_grey(put("own.exr", whole.substr(0, 8) + own + whole.substr(8))); });
    };
    const auto two_gigabytes = std::uint32_t{0x7FFFFFFF};
    const std::string of_length = " is not of the length that it says, ";
    for (const char* type : {"string", "stringvector", "floatvector", "opaque", "chlist", "preview"})
        CHECK(contains(said(type, two_gigabytes, ""),
                       std::string("attribute \"own\" of type \"") + type + "\" promises 2147483647 bytes"));
    CHECK(contains(said("stringvector", 8, number(two_gigabytes) + "text"), of_length + "8 bytes"));
    CHECK(contains(said("preview", 12, number(0x8000) + number(0x10000) + "rgba"), of_length + "12 bytes"));
    CHECK(contains(said("preview", 12, number(0xFFFFFFFF) + number(0xFFFFFFFF) + "rgba"), of_length + "12 bytes"));
    CHECK(contains(said("chlist", 4, "Y   "), of_length + "4 bytes"));  // goes on in what follows
    CHECK(contains(said("box2i", 4, "four"), of_length + "4 bytes"));   // so would this
    CHECK(contains(said("floatvector", 6, "sixsix"), of_length + "6 bytes"));
    CHECK(contains(said("tiledesc", 9, number(20000) + number(20000) + " "), "a tile of 20000x20000 points is not allowed"));
    CHECK(contains(said("tiledesc", 9, number(0xFFFFFFFF) + number(0xFFFFFFFF) + " "), "points is not allowed"));
    // These are let through; the place of the lines has shifted.
    for (const auto& [type, value] :
         std::initializer_list<std::pair<const char*, std::string>>{{"opaque", "four"},
                                                                    {"stringvector", number(4) + "text"},
                                                                    {"preview", number(1) + number(1) + "rgba"},
                                                                    {"floatvector", "eight by"}})
        CHECK(contains(said(type, static_cast<std::uint32_t>(value.size()), value), "Unexpected data block"));
}

TEST_CASE("read_exr_grey") {
    const std::vector<float> values{0, 1, 2, 3, -4, 1e6f};
    put_exr("y.exr", {"Y"}, values);
    CHECK(read_exr_grey("y.exr").values == values);
    CHECK(read_exr_grey("y.exr").width == 3);
    put_exr("height.exr", {"height"}, values);
    CHECK(read_exr_grey("height.exr").values == values);
    put_exr("two.exr", {"a", "b"}, values);
    CHECK(
        contains(complaint([] { (void)read_exr_grey("two.exr"); }), "a, b is not allowed; allowed: Y, R, or a single channel"));
    CHECK(contains(complaint([] { (void)read_exr_grey("missing.exr"); }), "there is no such file"));
    CHECK(contains(complaint([] { (void)read_exr_grey(put("text.exr", "hello")); }), "not a readable EXR"));
    const std::string whole = get("y.exr");
    std::string wide = whole;  // dataWindow: box2i, 16 bytes, xMin yMin xMax yMax
    const std::size_t window = wide.find("dataWindow") + sizeof("dataWindow") + sizeof("box2i") + 4;
    const std::int32_t far = 59999;
    for (const std::size_t corner : {8u, 12u}) std::memcpy(wide.data() + window + corner, &far, sizeof far);
    CHECK(complaint([&] { (void)read_exr_grey(put("wide.exr", wide)); }) ==
          "wide.exr: size: 60000x60000 is not allowed; allowed: 2 to 32768 points a side, at most 268435456 in all");
    using namespace std::string_literals;
    for (const std::string& size : {"\xff\xff\xff\x7f"s, "\xff\xff\xff\xff"s, std::string("\0\x40\0\0", 4)}) {
        const std::string large = whole.substr(0, 8) + "own\0unknown\0"s + size + whole.substr(8);
        CHECK(contains(complaint([&] { (void)read_exr_grey(put("large.exr", large)); }),
                       "large.exr: not a readable EXR: attribute \"own\" of type \"unknown\" promises "));
    }
    for (const std::size_t length : {whole.size() / 4, whole.size() / 2, whole.size() - 1}) {
        CAPTURE(length);
        CHECK(contains(complaint([&] { (void)read_exr_grey(put("cut.exr", whole.substr(0, length))); }), "not a readable EXR"));
    }
}
