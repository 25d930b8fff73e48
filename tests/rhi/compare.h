// How far two tables are apart: the worst difference and where it is.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "rhi/image.h"

namespace aureole::passes {

/// How two numbers are compared.
struct Measure {
    enum class Kind {
        relative,    ///< |a - b| / max(|a|, |b|, least).
        absolute,    ///< |a - b|.
        logarithm,   ///< Stored are logarithms: relative difference of what they stand for.
        half_steps,  ///< |a - b| in steps of half floats of that size, or of `least`.
    };
    Kind kind = Kind::relative;
    double least = 0;
    /// Adds to `least` this share of the largest number of the rows, in the same channel of either image.
    double least_of_largest = 0;
    /// The same with the largest number of each row alone.
    double least_of_row = 0;
};
[[nodiscard]] double difference(double a, double b, const Measure& measure);

/// The largest difference so far.
class Worst {
public:
    /// Red, green and blue of rows [begin, begin + count) of every slice.
    void compare(const Image& a, const Image& b, std::uint32_t begin, std::uint32_t count, const Measure& measure,
                 std::string_view where = {});
    void compare(const Image& a, const Image& b, const Measure& measure, std::string_view where = {}) {
        compare(a, b, 0, a.extent.height, measure, where);
    }
    void add(double error, double a, double b, std::string_view where);
    [[nodiscard]] double error() const noexcept { return error_; }
    /// False: there was nothing to compare.
    [[nodiscard]] bool compared() const noexcept { return compared_; }
    /// "1.2e-05: 0.5 and 0.500006 at ...".
    [[nodiscard]] std::string text() const;

private:
    double error_ = 0, a_ = 0, b_ = 0;
    bool compared_ = false;
    std::string where_;
};

/// With two digits.
[[nodiscard]] std::string print(double value);

/// What is wrong with a table: the first number that is not finite, or negative where that is not `signed_too`. Empty: nothing.
[[nodiscard]] std::string unsound(const Image& image, bool signed_too = false);

}  // namespace aureole::passes
