#include "rhi/report.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace aureole::conformance {
namespace {

constexpr std::size_t most_failures = 12;

struct Current {
    Result* result = nullptr;
    std::size_t unsaid = 0;  // failures beyond the most that are kept
    std::vector<std::string> context;
};
thread_local Current current;

}  // namespace

Reporting::Reporting(Result& result) { current = {&result, 0, {}}; }

Reporting::~Reporting() {
    if (current.unsaid > 0) current.result->failures.push_back("and " + std::to_string(current.unsaid) + " more");
    current = {};
}

Context::Context(std::string text) { current.context.push_back(std::move(text)); }
Context::~Context() { current.context.pop_back(); }

void fail(const std::string& message) {
    if (!current.result) return;
    current.result->outcome = Outcome::failed;
    if (current.result->failures.size() >= most_failures) {
        ++current.unsaid;
        return;
    }
    std::string text;
    for (const std::string& context : current.context) text += context + ": ";
    current.result->failures.push_back(text + message);
}

void note(const std::string& message) {
    if (current.result) current.result->notes.push_back(message);
}

std::string print(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string print(const Texel& texel) {
    return "(" + print(texel[0]) + ", " + print(texel[1]) + ", " + print(texel[2]) + ", " + print(texel[3]) + ")";
}

void expect_equal(std::string_view what, double got, double wanted) {
    if (got != wanted) fail(std::string(what) + " is " + print(got) + "; wanted: " + print(wanted));
}

void expect_equal(std::string_view what, const Texel& got, const Texel& wanted) {
    if (got != wanted) fail(std::string(what) + " is " + print(got) + "; wanted: " + print(wanted));
}

void expect_equal(std::string_view what, const std::vector<Texel>& got, const std::vector<Texel>& wanted) {
    if (got.size() != wanted.size())
        return expect_equal(std::string(what) + ": number of texels", double(got.size()), double(wanted.size()));
    std::size_t wrong = 0, first = 0;
    for (std::size_t i = got.size(); i-- > 0;)
        if (got[i] != wanted[i]) ++wrong, first = i;
    if (wrong == 0) return;
    fail(std::string(what) + ": " + std::to_string(wrong) + " of " + std::to_string(got.size()) + " texels are wrong, number " +
         std::to_string(first) + " first, which is " + print(got[first]) + "; wanted: " + print(wanted[first]));
}

void expect_near(std::string_view what, double got, double wanted, double tolerance) {
    if (std::abs(got - wanted) <= tolerance) return;
    fail(std::string(what) + " is " + print(got) + "; wanted: " + print(wanted) + " within " + print(tolerance));
}

}  // namespace aureole::conformance
