#include "app/sequence.h"

#include "io/test_files.h"

#include <doctest/doctest.h>

using namespace aureole::app;

TEST_CASE("parse_sun_path") {
    const SunPath path = parse_sun_path("-6:12.5", 5);
    CHECK(path.elevation_deg(0) == -6);
    CHECK(path.elevation_deg(4) == 12.5);
    CHECK(path.elevation_deg(2) == doctest::Approx(3.25));
    CHECK(parse_sun_path("10:-10", 2).elevation_deg(1) == -10);
    for (const char* bad : {"", "5", "5:", ":5", "5:6:7", "a:b", "5:91", "-91:0", "nan:0", "0:inf", "1 : 2"}) {
        CAPTURE(bad);
        CHECK(complaint([&] { (void)parse_sun_path(bad, 2); }) ==
              "--sun-elevation: \"" + std::string(bad) + "\" is not allowed; allowed: FROM:TO in degrees, each in [-90, 90]");
    }
}

TEST_CASE("numbered") {
    CHECK(numbered("out/sky.png", 7) == "out/sky-0007.png");
    CHECK(numbered("sky.exr", 12345) == "sky-12345.exr");
    CHECK(numbered("out/sky_%04d.png", 7) == "out/sky_0007.png");
    CHECK(numbered("%02d_sky.png", 123) == "123_sky.png");
    CHECK(numbered("sky%d.png", 7) == "sky7.png");
    CHECK(numbered("out%d/sky.png", 7) == "out%d/sky-0007.png");  // the folder's name is left alone
    for (const char* bad :
         {"sky%.png", "sky%s.png", "sky%4d.png", "sky%00d.png", "sky%d%d.png", "sky%%.png", "sky%04x.png", "%"}) {
        CAPTURE(bad);
        CHECK(contains(complaint([&] { (void)numbered(bad, 1); }), "allowed: at most one %d or %04d"));
    }
}
