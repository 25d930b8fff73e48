// The worst of many comparisons, with the place where it occurred.
#pragma once

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace aureole::physics {

class Worst {
public:
    /// `where`: anything that prints. A NaN is worse than every number.
    template <class... Where>
    void add(double error, const Where&... where) {
        ++count_;
        if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
        if (error <= value_ && count_ > 1) return;
        value_ = error;
        std::ostringstream text;
        ((text << where << ' '), ...);
        where_ = text.str();
    }
    [[nodiscard]] double value() const { return count_ > 0 ? value_ : std::numeric_limits<double>::infinity(); }
    [[nodiscard]] const std::string& where() const { return where_; }

private:
    double value_ = 0;
    std::string where_;
    int count_ = 0;
};

}  // namespace aureole::physics

/// Holds the worst error below a limit; what was measured is shown when it is not, and always with doctest's -s.
#define CHECK_WORST(worst, limit)         \
    do {                                  \
        INFO("at ", (worst).where());     \
        CHECK((worst).value() < (limit)); \
    } while (false)
