#include "io/csv.h"

#include "io/test_files.h"

#include <doctest/doctest.h>
#include <array>

using namespace aureole::app;

namespace {

constexpr std::array<std::string_view, 2> names{"b", "a"};

CsvTable parse(const std::string& text) { return parse_csv(text, "t.csv", names); }
std::string rejected(const std::string& text) {
    return complaint([&] { (void)parse(text); });
}

}  // namespace

TEST_CASE("parse_csv: columns by name, comments, blanks, any line end") {
    const CsvTable table = parse("\xEF\xBB\xBF# first\r\na, extra ,b\r\n\r\n# second\n1,x,2\n -1e-3 ,,\t0.5\n");
    CHECK(table.comments == std::vector<std::string>{"first", "second"});
    REQUIRE(table.rows() == 2);
    CHECK(table.columns[0] == std::vector<double>{2, 0.5});
    CHECK(table.columns[1] == std::vector<double>{1, -1e-3});
    CHECK(table.lines == std::vector<int>{5, 6});
    CHECK(parse("a,b\n1,2").columns[0] == std::vector<double>{2});  // no line end at the end of the file
}

TEST_CASE("parse_csv: what is rejected, and where") {
    CHECK(rejected("") == "t.csv: holds no row of numbers");
    CHECK(rejected("# only\n# comments\n") == "t.csv: holds no row of numbers");
    CHECK(rejected("a,b\n") == "t.csv: holds no row of numbers");
    CHECK(rejected("a,c\n1,2\n") == "t.csv:1: column b is missing; there are: a,c");
    CHECK(rejected("#\na,b,a\n1,2,3\n") == "t.csv:2: column a appears twice");
    CHECK(rejected("a,b\n1,2\n3\n") == "t.csv:3: 1 cells is not allowed; allowed: 2, as many as there are columns");
    CHECK(rejected("a,b\n1,2,3\n") == "t.csv:2: 3 cells is not allowed; allowed: 2, as many as there are columns");
    for (const char* bad : {"", "x", "1x", "1 2", "nan", "inf", "-inf", "1e999", "\"1\"", "0x10"}) {
        CAPTURE(bad);
        CHECK(rejected("a,b\n1," + std::string(bad) + "\n") ==
              "t.csv:2: b: \"" + std::string(bad) + "\" is not allowed; allowed: a finite number");
    }
    CHECK(complaint([] { (void)read_csv("no.csv", names); }) == "no.csv: there is no such file");
}

TEST_CASE("print_number: reads back as the same number") {
    CHECK(print_number(0.1) == "0.1");
    CHECK(print_number(0.1f) == "0.1");
    CHECK(print_number(1.0 / 3) == "0.3333333333333333");
    CHECK(print_number(0.0) == "0");
}
