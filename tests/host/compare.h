// Answers compared with a tolerance, and the worst of them in the message.
#pragma once

#include <string>
#include <vector>

#include "host/questions.h"

namespace aureole::host {

/// Collects pairs; a pair is good where |a - b| <= relative |b| + floor times the largest |b| of all.
class Worst {
public:
    Worst(std::string name, double relative, double floor) : name_(std::move(name)), relative_(relative), floor_(floor) {}
    void add(std::size_t where, const Rgb& got, const Rgb& expected);
    /// Fails for NaN, for the first pair that is not good, and where nothing was added.
    void check() const;

private:
    struct Pair {
        std::size_t where;
        double got, expected;
    };
    std::string name_;
    double relative_, floor_;
    std::vector<Pair> pairs_;
};

/// Every part of every answer: 3e-5 of its value plus 1e-6 of the part's largest (2e-5 of it at the edges of shadows, 100 km
/// away). Measured: 2.4e-5, where float rounds the place of a low ray in the sky's optical depth.
void check_same_answers(const std::vector<Answer>& got, const std::vector<Answer>& expected);

}  // namespace aureole::host
