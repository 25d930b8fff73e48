#include "host/compare.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace aureole::host {

void Worst::add(std::size_t where, const Rgb& got, const Rgb& expected) {
    for (int c = 0; c < 3; ++c) pairs_.push_back({where, got[c], expected[c]});
}

void Worst::check() const {
    INFO(name_);
    REQUIRE(!pairs_.empty());
    double largest = 0;
    for (const Pair& p : pairs_) largest = std::max(largest, std::abs(p.expected));
    double worst = -1;
    Pair at = pairs_.front();
    for (const Pair& p : pairs_) {
        const double allowed = relative_ * std::abs(p.expected) + floor_ * largest;
        const double error = std::abs(p.got - p.expected);
        const double excess = allowed > 0 ? error / allowed : (error == 0 ? 0.0 : INFINITY);
        if (std::isnan(excess) || excess > worst) worst = excess, at = p;
        if (std::isnan(excess)) break;
    }
    CAPTURE(at.where);
    CAPTURE(at.got);
    CAPTURE(at.expected);
    CAPTURE(largest);
    CHECK_MESSAGE(worst <= 1, "error over tolerance: " << worst);
}

void check_same_answers(const std::vector<Answer>& got, const std::vector<Answer>& expected) {
    REQUIRE(got.size() == expected.size());
    for (const AnswerPart& part : answer_parts()) {
        Worst worst(part.name, 3e-5, part.floor);
        for (std::size_t i = 0; i < got.size(); ++i) worst.add(i, got[i].*part.value, expected[i].*part.value);
        worst.check();
    }
}

}  // namespace aureole::host
