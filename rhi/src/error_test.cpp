#include <aureole/rhi/error.h>
#include <aureole/rhi/shader.h>
#include <aureole/rhi/types.h>
#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace aureole;

TEST_CASE("an error about a field keeps and prints its parts") {
    const Error error(ErrorCode::invalid_argument, "planet.bottom_radius_m", "-1", "finite, > 0");
    CHECK(error.code() == ErrorCode::invalid_argument);
    CHECK(error.field() == "planet.bottom_radius_m");
    CHECK(error.value() == "-1");
    CHECK(error.allowed() == "finite, > 0");
    CHECK(std::string(error.what()) == "planet.bottom_radius_m: -1 is not allowed; allowed: finite, > 0");

    const Error plain(ErrorCode::io, "no such file");
    CHECK(plain.field().empty());
    CHECK(std::string(plain.what()) == "no such file");
}

TEST_CASE("every enumerator has a name of its own") {
    std::set<std::string> names;
    for (int i = 0; i <= static_cast<int>(ErrorCode::internal); ++i) names.insert(to_string(static_cast<ErrorCode>(i)));
    CHECK(names.size() == 7);
    for (int i = 0; i <= static_cast<int>(rhi::Format::d32_float); ++i) names.insert(to_string(static_cast<rhi::Format>(i)));
    CHECK(names.size() == 7 + 13);
    CHECK(names.count("unknown") == 0);

    std::set<std::string> others;
    for (int i = 0; i <= static_cast<int>(rhi::State::general); ++i) others.insert(to_string(static_cast<rhi::State>(i)));
    for (int i = 0; i < 3; ++i) others.insert(to_string(static_cast<rhi::Dimension>(i)));
    CHECK(others.size() == 9 + 3);
    std::set<std::string> kinds;
    for (int i = 0; i < 3; ++i) kinds.insert(rhi::to_string(static_cast<rhi::SlotKind>(i)));
    CHECK(kinds.size() == 3);
    CHECK(others.count("unknown") + kinds.count("unknown") == 0);
}

TEST_CASE("texel sizes agree with the formats' names") {
    using rhi::Format;
    const struct {
        Format format;
        std::uint32_t bytes, channels;
    } expected[] = {
        {Format::undefined, 0, 0},   {Format::r8_unorm, 1, 1},   {Format::rgba8_unorm, 4, 4},   {Format::rgba8_srgb, 4, 4},
        {Format::bgra8_unorm, 4, 4}, {Format::r16_float, 2, 1},  {Format::rg16_float, 4, 2},    {Format::rgba16_float, 8, 4},
        {Format::r32_float, 4, 1},   {Format::rg32_float, 8, 2}, {Format::rgba32_float, 16, 4}, {Format::r11g11b10_float, 4, 3},
        {Format::d32_float, 4, 1},
    };
    for (const auto& e : expected) {
        CAPTURE(std::string(to_string(e.format)));
        CHECK(rhi::bytes_per_texel(e.format) == e.bytes);
        CHECK(rhi::channel_count(e.format) == e.channels);
    }
}
