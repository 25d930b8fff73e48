#include "io/json_file.h"

#include "io/test_files.h"

#include <doctest/doctest.h>

using namespace aureole::app;

TEST_CASE("read_json: what is none is named") {
    CHECK(read_json(put("good.json", "{\"a\": [1, 2]}")).at("a").at(1) == 2);
    CHECK(contains(complaint([] { (void)read_json("none.json"); }), "none.json: there is no such file"));
    for (const char* text : {"", "{\"a\":", "1e999", "\"\\ud800\"", "\"\xff\""}) {
        CAPTURE(text);
        CHECK(contains(complaint([&] { (void)read_json(put("bad.json", text)); }), "bad.json: is no JSON: "));
    }
}

TEST_CASE("show_json: short, however deep the value") {
    CHECK(show_json(nullptr) == "null");
    CHECK(show_json(1.5) == "1.5");
    CHECK(show_json({1, "b"}) == "[1,\"b\"]");
    CHECK(show_json(std::string(200, 'x')) == "\"" + std::string(76, 'x') + "...");
    CHECK(show_json({{"a", {1}}}) == "an object of 1 members");
    constexpr std::size_t depth = 3000000;
    const nlohmann::json deep = nlohmann::json::parse(std::string(depth, '[') + std::string(depth, ']'));
    CHECK(show_json(deep) == "an array of 1 elements");
}
