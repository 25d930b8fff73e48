#include "rhi/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace aureole::passes {
namespace {

/// Distance of neighbouring half floats around a number.
double half_step(double value) {
    if (!(value >= 0x1p-14)) return 0x1p-24;
    return std::exp2(std::floor(std::log2(value)) - 10);
}

double largest(const Image& image, std::uint32_t begin, std::uint32_t count, int channel) {
    double most = 0;
    for (std::uint32_t z = 0; z < image.extent.depth; ++z)
        for (std::uint32_t y = begin; y < begin + count; ++y)
            for (std::uint32_t x = 0; x < image.extent.width; ++x) most = std::max(most, std::abs(image.at(x, y, z)[channel]));
    return most;
}

std::string place(std::uint32_t x, std::uint32_t y, std::uint32_t z, int channel) {
    return " texel (" + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z) + ")." + "rgba"[channel];
}

}  // namespace

double difference(double a, double b, const Measure& measure) {
    if (a == b) return 0;
    const double apart = std::abs(a - b), size = std::max(std::abs(a), std::abs(b));
    switch (measure.kind) {
        case Measure::Kind::relative:
            return apart / std::max(size, measure.least);
        case Measure::Kind::absolute:
            return apart;
        case Measure::Kind::logarithm:
            return std::expm1(apart);
        case Measure::Kind::half_steps:
            return apart / half_step(std::max(size, measure.least));
    }
    return apart;
}

void Worst::compare(const Image& a, const Image& b, std::uint32_t begin, std::uint32_t count, const Measure& measure,
                    std::string_view where) {
    if (a.extent != b.extent) throw std::logic_error("images of different sizes are compared");
    if (begin + count > a.extent.height) throw std::logic_error("rows beyond an image are compared");
    compared_ |= count > 0;
    for (int channel = 0; channel < 3; ++channel) {
        Measure scaled = measure;
        if (measure.least_of_largest > 0)
            scaled.least +=
                measure.least_of_largest * std::max(largest(a, begin, count, channel), largest(b, begin, count, channel));
        for (std::uint32_t z = 0; z < a.extent.depth; ++z)
            for (std::uint32_t y = begin; y < begin + count; ++y) {
                Measure of_row = scaled;
                if (measure.least_of_row > 0)
                    of_row.least += measure.least_of_row * std::max(largest(a, y, 1, channel), largest(b, y, 1, channel));
                for (std::uint32_t x = 0; x < a.extent.width; ++x) {
                    const double p = a.at(x, y, z)[channel], q = b.at(x, y, z)[channel];
                    const double error = difference(p, q, of_row);
                    if (!(error <= error_)) add(error, p, q, std::string(where) + place(x, y, z, channel));
                }
            }
    }
}

void Worst::add(double error, double a, double b, std::string_view where) {
    compared_ = true;
    if (error <= error_) return;
    error_ = std::isnan(error) ? HUGE_VAL : error, a_ = a, b_ = b, where_ = where;
}

std::string Worst::text() const {
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "%.3g: %.9g and %.9g", error_, a_, b_);
    return numbers + (where_.empty() ? "" : " at " + where_);
}

std::string print(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text;
}

std::string unsound(const Image& image, bool signed_too) {
    for (std::uint32_t z = 0; z < image.extent.depth; ++z)
        for (std::uint32_t y = 0; y < image.extent.height; ++y)
            for (std::uint32_t x = 0; x < image.extent.width; ++x)
                for (int channel = 0; channel < 3; ++channel) {
                    const double value = image.at(x, y, z)[channel];
                    if (!std::isfinite(value) || (!signed_too && value < 0)) return print(value) + place(x, y, z, channel);
                }
    return {};
}

}  // namespace aureole::passes
