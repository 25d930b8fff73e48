// How structs grow: a library newer than the program's header, and one older.
#include "guard.h"

#include <doctest/doctest.h>

using namespace aureole;
using namespace aureole::c_api;

namespace {

/// As the library knows it; `later` came with a second version.
struct Grown {
    std::uint32_t struct_size;
    float first;
    double later;
};
constexpr std::uint32_t first_version = offsetof(Grown, later);

}  // namespace

TEST_CASE("a struct of an older header gets the defaults of fields that it does not know, and keeps its size") {
    const Grown defaults{sizeof(Grown), 1, 2};
    Grown old{first_version, 5, 77};
    const Grown whole = read(&old, "grown", defaults, first_version);
    CHECK(whole.first == 5);
    CHECK(whole.later == 2);
    CHECK(whole.struct_size == sizeof(Grown));
    write(&old, "grown", {sizeof(Grown), 8, 9}, first_version);
    CHECK(old.first == 8);
    CHECK(old.later == 77);
    CHECK(old.struct_size == first_version);
}

TEST_CASE("sizes that the library does not know are refused, with those it does") {
    const Grown defaults{sizeof(Grown), 1, 2};
    for (const std::uint32_t size : {0u, first_version - 1, static_cast<std::uint32_t>(sizeof(Grown)) + 1}) {
        const Grown wrong{size, 0, 0};
        const aureole_result result = guarded([&] { (void)read(&wrong, "grown", defaults, first_version); });
        CHECK(result == AUREOLE_INVALID_ARGUMENT);
        CHECK(std::string(aureole_last_error_field()) == "grown.struct_size");
        CHECK(std::string(aureole_last_error_value()) == std::to_string(size));
    }
}

TEST_CASE("whatever is thrown becomes a result and a message") {
    CHECK(guarded([] {}) == AUREOLE_OK);
    CHECK(guarded([] { throw Error(ErrorCode::device_lost, "gone"); }) == AUREOLE_DEVICE_LOST);
    CHECK(std::string(aureole_last_error()) == "gone");
    CHECK(std::string(aureole_last_error_field()).empty());
    CHECK(guarded([] { throw std::bad_alloc(); }) == AUREOLE_OUT_OF_MEMORY);
    CHECK(guarded([] { throw std::runtime_error("odd"); }) == AUREOLE_INTERNAL);
    CHECK(std::string(aureole_last_error()) == "odd");
    CHECK(guarded([] { throw 1; }) == AUREOLE_INTERNAL);
    for (const ErrorCode code : {ErrorCode::invalid_argument, ErrorCode::unsupported, ErrorCode::out_of_memory,
                                 ErrorCode::device_lost, ErrorCode::io, ErrorCode::misuse, ErrorCode::internal}) {
        CHECK(code_of(result_of(code)) == code);
        CHECK(std::string(aureole_result_name(result_of(code))) == to_string(code));
    }
}
