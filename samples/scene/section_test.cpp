#include "scene/section.h"

#include "io/test_files.h"

#include <doctest/doctest.h>

using namespace aureole::app;

namespace {

Section root(const std::string& text) { return TomlDocument(text, "t.toml").root(); }

}  // namespace

TEST_CASE("Section: values of each kind") {
    Section s = root(
        "a = 1\nb = 2.5\nc = [1, 2.0]\nd = 0.5\ne = [1, 2, 3]\nf = true\ng = \"x\"\nh = \"two\"\n[i]\nj = 1\n[[k]]\n[[k]]\n");
    CHECK(s.number("a", {0, 1}) == 1);
    CHECK(s.number("b", {0, 3}) == 2.5);
    CHECK_FALSE(s.number("missing", {0, 1}));
    CHECK(s.numbers("c", {0, 3}) == std::vector<double>{1, 2});
    CHECK(s.rgb("d", {0, 1}) == aureole::Rgb(0.5));
    CHECK(s.rgb("e", {0, 3}) == aureole::Rgb(1, 2, 3));
    CHECK(s.boolean("f") == true);
    CHECK(s.text("g") == "x");
    CHECK(s.is_text("g"));
    CHECK_FALSE(s.is_text("a"));
    CHECK(s.choice("h", {"one", "two"}) == std::size_t{1});
    CHECK(s.section("i")->number("j", {0, 1}) == 1);
    CHECK(s.sections("k").size() == 2);
    CHECK(s.sections("missing").empty());
    CHECK_NOTHROW(s.finish());
}

TEST_CASE("TomlDocument: a key of any length is no way to the end of the stack") {
    const auto key = [](std::size_t parts) {
        std::string text = "\na";
        for (std::size_t i = 1; i < parts; ++i) text += i % 2 == 0 ? ".a" : " . \"b\"";
        return text;
    };
    CHECK_NOTHROW((void)root(key(100) + " = 1"));
    CHECK(
        contains(complaint([&] { (void)root(key(3000000) + " = 1"); }), "t.toml:2: not TOML of ours: a key of more than 100"));
    CHECK(contains(complaint([&] { (void)root("[" + key(200).substr(1) + "]"); }), "a key of more than"));
    CHECK_NOTHROW((void)root("# " + std::string(300, '.')));
    std::string numbers = "a = [0.5";
    for (int i = 0; i < 300; ++i) numbers += ", 0.5";
    CHECK(root(numbers + "]").numbers("a", {0, 1})->size() == 301);
}

TEST_CASE("Section: messages say file, line, key, value and what is allowed") {
    const auto rejected = [](const std::string& text, auto&& read) {
        Section s = root(text);
        return complaint([&] { read(s); });
    };
    CHECK(rejected("\n\na = 2", [](Section& s) {
              (void)s.number("a", {0, 1});
          }) == "t.toml:3: a: 2 is not allowed; allowed: a number in [0, 1]");
    CHECK(rejected("a = nan", [](Section& s) {
              (void)s.number("a", {0, 1});
          }) == "t.toml:1: a: nan is not allowed; allowed: a number in [0, 1]");
    CHECK(rejected("a = \"1\"", [](Section& s) {
              (void)s.number("a", {0, 1});
          }) == "t.toml:1: a: \"1\" is not allowed; allowed: a number in [0, 1]");
    CHECK(rejected("a = [1, 5]", [](Section& s) {
              (void)s.numbers("a", {0, 1});
          }) == "t.toml:1: a: 5 as element 1 is not allowed; allowed: numbers in [0, 1]");
    CHECK(rejected("a = 1", [](Section& s) {
              (void)s.numbers("a", {0, 1});
          }) == "t.toml:1: a: 1 is not allowed; allowed: an array of numbers in [0, 1]");
    CHECK(rejected("a = [1, 1]", [](Section& s) {
              (void)s.rgb("a", {0, 1});
          }) == "t.toml:1: a: [1, 1] is not allowed; allowed: a number, or [red, green, blue], each in [0, 1]");
    CHECK(contains(rejected("a = inf", [](Section& s) { (void)s.rgb("a", {0, 1}); }), "a: inf is not allowed"));
    CHECK(rejected("a = 1", [](Section& s) { (void)s.boolean("a"); }) ==
          "t.toml:1: a: 1 is not allowed; allowed: true or false");
    CHECK(rejected("a = 1", [](Section& s) { (void)s.text("a"); }) ==
          "t.toml:1: a: 1 is not allowed; allowed: a text in quotes");
    CHECK(rejected("a = \"z\"", [](Section& s) {
              (void)s.choice("a", {"x", "y"});
          }) == "t.toml:1: a: \"z\" is not allowed; allowed: \"x\", \"y\"");
    CHECK(rejected("a = 1", [](Section& s) { (void)s.section("a"); }) == "t.toml:1: a: 1 is not allowed; allowed: a table");
    CHECK(rejected("a = [1]", [](Section& s) { (void)s.sections("a"); }) ==
          "t.toml:1: a: [1] is not allowed; allowed: an array of tables");
    CHECK(rejected("a = [1, 2, 3, 4, 5, 6, 7, 8, 9]", [](Section& s) { (void)s.text("a"); }) ==
          "t.toml:1: a: an array of 9 is not allowed; allowed: a text in quotes");
    CHECK(rejected("a = 1979-05-27", [](Section& s) { (void)s.text("a"); }) ==
          "t.toml:1: a: a date or time is not allowed; allowed: a text in quotes");
    CHECK(rejected("[[k]]\na = 1\n[[k]]\n[k.s]\nb = 7\n", [](Section& s) {
              (void)s.sections("k")[1].section("s")->number("b", {0, 1});
          }) == "t.toml:5: k[1].s.b: 7 is not allowed; allowed: a number in [0, 1]");
}

TEST_CASE("Section: unknown keys") {
    Section s = root("a = 1\nb = 1\n");
    (void)s.number("a", {0, 1});
    (void)s.number("c", {0, 1});
    CHECK(complaint([&] { s.finish(); }) == "t.toml:2: b: this key is not allowed; allowed: a, c");
}

TEST_CASE("TomlDocument: what is no TOML") {
    CHECK(contains(complaint([] { (void)root("a = 1\nb = = 2\n"); }), "t.toml:2: not TOML: "));
    CHECK(contains(complaint([] { (void)root("a = 1\na = 2\n"); }), "t.toml:2: not TOML: "));
    CHECK(contains(complaint([] { (void)root(std::string("\xff\xfe\x00", 3)); }), "t.toml:1: not TOML: "));
    CHECK(complaint([] { TomlDocument(std::filesystem::path("no.toml")); }) == "no.toml: there is no such file");
    CHECK(complaint([] { TomlDocument(std::filesystem::path(".")); }) == ".: not a regular file");
}
