#include "io/npz.h"

#include "io/test_files.h"

#include <doctest/doctest.h>
#include <zip.h>
#include <cstring>

using namespace aureole::app;

namespace {

/// A .npy text of version 1 with this header and these bytes behind it.
std::string npy(std::string header, const std::string& data, int version = 1) {
    header += '\n';
    std::string text = "\x93NUMPY";
    text += static_cast<char>(version);
    text += '\0';
    text += static_cast<char>(header.size() & 255);
    text += static_cast<char>(header.size() >> 8);
    if (version > 1) text += std::string(2, '\0');
    return text + header + data;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

NpyArray parse(const std::string& text) { return parse_npy(std::as_bytes(std::span(text)), "x"); }
std::string rejected(const std::string& text) {
    return complaint([&] { (void)parse(text); });
}

void put_npz(const std::string& name, const std::vector<std::pair<std::string, std::string>>& entries,
             zip_int32_t method = ZIP_CM_DEFLATE) {
    std::filesystem::remove(name);
    zip_t* archive = zip_open(name.c_str(), ZIP_CREATE, nullptr);
    REQUIRE(archive);
    for (const auto& [entry, text] : entries) {
        const zip_int64_t index =
            zip_file_add(archive, entry.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0), 0);
        REQUIRE(index >= 0);
        REQUIRE(zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), method, 0) == 0);
    }
    REQUIRE(zip_close(archive) == 0);
}

const std::string two_by_three = "{'descr': '<i2', 'fortran_order': False, 'shape': (2, 3), }";

}  // namespace

TEST_CASE("parse_npy: types, byte orders, versions, orders of indices") {
    const NpyArray array = parse(npy(two_by_three, bytes_of<std::int16_t>({1, -2, 3, 4, 5, 6})));
    CHECK(array.shape == std::vector<std::size_t>{2, 3});
    CHECK(array.values == std::vector<double>{1, -2, 3, 4, 5, 6});
    // Fortran order: the first index runs fastest.
    CHECK(parse(npy("{'descr': '<i2', 'fortran_order': True, 'shape': (2, 3), }", bytes_of<std::int16_t>({1, 4, 2, 5, 3, 6})))
              .values == std::vector<double>{1, 2, 3, 4, 5, 6});
    CHECK(parse(npy("{'descr': '>u2', 'fortran_order': False, 'shape': (1,), }", {"\x01\x02", 2})).values ==
          std::vector<double>{258});
    CHECK(parse(npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2,), }", bytes_of<float>({0.5f, -3}))).values ==
          std::vector<double>{0.5, -3});
    const NpyArray number = parse(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (), }", bytes_of<double>({0.25})));
    CHECK(number.shape.empty());
    CHECK(number.values == std::vector<double>{0.25});
    CHECK(parse(npy("{'shape':(2,),'fortran_order':False,'descr':'|u1'}", {"\x07\xff", 2}, 2)).values ==
          std::vector<double>{7, 255});
    CHECK(parse(npy("{'descr': '<i4', 'fortran_order': False, 'shape': (0, 5), }", "")).values.empty());
}

TEST_CASE("parse_npy: broken files") {
    const std::string good = npy(two_by_three, bytes_of<std::int16_t>({1, 2, 3, 4, 5, 6}));
    CHECK_NOTHROW((void)parse(good));
    for (std::size_t length = 0; length < good.size(); ++length) {
        CAPTURE(length);
        CHECK(contains(rejected(good.substr(0, length)), "x: not a readable NumPy array"));
    }
    CHECK(contains(rejected(good + "!"), "holds 13 bytes where its shape needs 12"));
    CHECK(contains(rejected("PK" + good.substr(2)), "does not start as one"));
    CHECK(contains(rejected(npy(two_by_three, bytes_of<std::int16_t>({1, 2, 3, 4, 5, 6}), 9)), "version"));
    const auto header = [](const std::string& text) { return rejected(npy(text, std::string(12, '\0'))); };
    CHECK(contains(header("{}"), "no descr"));
    CHECK(contains(header("{'descr'"), "no value of descr"));
    CHECK(contains(header("{'descr': "), "no value of descr"));
    CHECK(contains(header("{'descr': '<i2"), "element type"));
    CHECK(contains(header("{'descr': [('a', '<i2')], 'fortran_order': False, 'shape': (6,)}"), "element type"));
    CHECK(contains(header("{'descr': '|O', 'fortran_order': False, 'shape': (6,)}"), "element type O"));
    CHECK(contains(header("{'descr': 'i2', 'fortran_order': False, 'shape': (6,)}"), "byte order"));
    CHECK(contains(header("{'descr': '<i2', 'fortran_order': 0, 'shape': (6,)}"), "fortran_order"));
    CHECK(contains(header("{'descr': '<i2', 'fortran_order': False}"), "no shape"));
    CHECK(contains(header("{'descr': '<i2', 'fortran_order': False, 'shape': 6}"), "no tuple"));
    CHECK(contains(header("{'descr': '<i2', 'fortran_order': False, 'shape': (6"), "no tuple"));
    CHECK(contains(header("{'descr': '<i2', 'fortran_order': False, 'shape': (-6,)}"), "no number"));
    CHECK(contains(header("{'descr': '<i2', 'fortran_order': False, 'shape': (2 3)}"), "no number"));
    CHECK(contains(header("{'descr': '<i2', 'fortran_order': False, 'shape': (4294967296, 4294967296)}"), "too large"));
    CHECK(contains(header("{'descr': '<i2', 'fortran_order': False, 'shape': (99999, 99999, 99999)}"), "too large"));
    std::string flat = "{'descr': '<i2', 'fortran_order': True, 'shape': (6";
    for (int i = 0; i < 31; ++i) flat += ", 1";
    CHECK(header(flat + ")}") == "nothing");
    CHECK(contains(header(flat + ", 1)}"), "more than 32 dimensions"));
}

TEST_CASE("NpzFile") {
    put_npz("two.npz", {{"a.npy", npy(two_by_three, bytes_of<std::int16_t>({1, 2, 3, 4, 5, 6}))},
                        {"readme.txt", "no array"},
                        {"b.npy", "broken"}});
    const NpzFile file("two.npz");
    CHECK(file.names() == std::vector<std::string>{"a", "b"});
    CHECK(file.has("a"));
    CHECK_FALSE(file.has("c"));
    CHECK(file.read("a").values.back() == 6);
    CHECK(contains(complaint([&] { (void)file.read("b"); }), "two.npz: b.npy: not a readable NumPy array"));
    CHECK(complaint([&] { (void)file.read("c"); }) == "two.npz: c.npy: there is no such array");

    put_npz("none.npz", {{"readme.txt", "no array"}});
    CHECK(complaint([] { NpzFile("none.npz"); }) == "none.npz: holds no NumPy array");
    CHECK(complaint([] { NpzFile("missing.npz"); }) == "missing.npz: there is no such file");
    CHECK(contains(complaint([] { NpzFile(put("text.npz", "hello")); }), "text.npz: not a readable .npz archive"));

    const std::string whole = get("two.npz");
    CHECK(contains(complaint([&] { NpzFile(put("cut.npz", whole.substr(0, whole.size() / 2))); }),
                   "not a readable .npz archive"));
}

TEST_CASE("NpzFile: damaged contents") {
    // Stored, not deflated, so that a changed byte is a changed value, which only the check sum gives away.
    const std::string array = npy("{'descr': '|u1', 'fortran_order': False, 'shape': (4,), }", "abcd");
    put_npz("sum.npz", {{"a.npy", array}}, ZIP_CM_STORE);
    std::string bytes = get("sum.npz");
    const std::size_t at = bytes.find("abcd");
    REQUIRE(at != std::string::npos);
    bytes[at] = 'z';
    const NpzFile file(put("sum.npz", bytes));
    CHECK(contains(complaint([&] { (void)file.read("a"); }), "cannot be unpacked"));
}
