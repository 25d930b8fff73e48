#include "app/progress.h"

#include "io/test_files.h"

#include <doctest/doctest.h>
#include <algorithm>

using namespace aureole::app;

TEST_CASE("progress_line: bar, share, time and estimate") {
    CHECK(progress_line(0, 4, 0) == "[..............................]  0/4  0%  0 s");
    // 30 s for one of four steps: 90 s for the other three.
    CHECK(progress_line(1, 4, 30) == "[#######.......................]  1/4  25%  30 s, about 1 min 30 s left");
    // One of four had been done before; one in 30 s: 60 s for the other two.
    CHECK(contains(progress_line(2, 4, 30, 1), "2/4  50%  30 s, about 1 min 00 s left"));
    CHECK(progress_line(1, 4, 30, 1) == "[#######.......................]  1/4  25%  30 s");
    CHECK(progress_line(4, 4, 7) == "[##############################]  4/4  100%  7 s");
}

TEST_CASE("print_duration") {
    CHECK(print_duration(0.4) == "0 s");
    CHECK(print_duration(59.4) == "59 s");
    CHECK(print_duration(125) == "2 min 05 s");
    CHECK(print_duration(3725) == "1 h 02 min");
}

TEST_CASE("Progress: away from a terminal a line every tenth") {
    std::FILE* file = std::fopen("progress.txt", "w");
    REQUIRE(file);
    Progress progress(50, file, false);
    for (int i = 0; i < 50; ++i) progress.step();
    std::fclose(file);
    const std::string text = get("progress.txt");
    CHECK(std::count(text.begin(), text.end(), '\n') == 10);
    CHECK(contains(text, "50/50  100%"));
    CHECK_FALSE(contains(text, "\r"));
}

TEST_CASE("Progress: of work whose end is an estimate") {
    std::FILE* file = std::fopen("share.txt", "w");
    REQUIRE(file);
    Progress progress(100, file, false);
    progress.start_at(52);
    for (const std::size_t done : {55U, 61U, 58U, 62U, 62U, 70U, 69U, 70U, 100U}) progress.reach(done);
    std::fclose(file);
    const std::string text = get("share.txt");
    CHECK(std::count(text.begin(), text.end(), '\n') == 3);  // 61, 70, 100: each tenth once, though it came twice
    CHECK(contains(text, "61/100"));
    CHECK(contains(text, "100/100"));
}
