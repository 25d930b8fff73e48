// What a check says while it runs. One check at a time runs in a thread: its words go to the Result that was opened for it.
#pragma once

#include <aureole/rhi_tests/conformance.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::conformance {

using Texel = std::array<double, 4>;

/// While it lives, what this thread says goes to `result`.
class Reporting {
public:
    explicit Reporting(Result& result);
    ~Reporting();
    Reporting(const Reporting&) = delete;
    Reporting& operator=(const Reporting&) = delete;
};

/// Stands before every message while it lives: the format, the dimension, the texel that is being tried.
class Context {
public:
    explicit Context(std::string text);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

/// Thrown by a check that cannot go on, once it has said why; and by one that has nothing to try.
struct Stopped {};
struct Skipped {
    std::string reason;
};

/// Nobody listens where no Reporting lives: then these do nothing.
void fail(const std::string& message);
void note(const std::string& message);

/// A condition, in the words of a rule: "the queue counts frames one by one".
inline void expect(bool holds, std::string_view rule) {
    if (!holds) fail(std::string(rule));
}
/// The same where nothing after it makes sense without.
inline void require(bool holds, std::string_view rule) {
    expect(holds, rule);
    if (!holds) throw Stopped{};
}

[[nodiscard]] std::string print(double value);
[[nodiscard]] std::string print(const Texel& texel);

/// Numbers and texels that must come out as they are.
void expect_equal(std::string_view what, double got, double wanted);
void expect_equal(std::string_view what, const Texel& got, const Texel& wanted);
/// Texels of a texture, row by row: tells the first that is wrong, and how many are.
void expect_equal(std::string_view what, const std::vector<Texel>& got, const std::vector<Texel>& wanted);
/// |got - wanted| at most `tolerance`; no number is never near.
void expect_near(std::string_view what, double got, double wanted, double tolerance);

}  // namespace aureole::conformance
