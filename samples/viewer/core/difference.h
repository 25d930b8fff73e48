// Two pictures of one scene beside each other: how far apart, in numbers and in false colour.
#pragma once

#include "io/image.h"

#include <array>
#include <cstdint>
#include <vector>

namespace aureole::viewer {

/// For each pixel (B - A) / A in luminance (Rec.709). Where A is darker than a thousandth of its own mean, that takes its
/// place: what is hardly seen counts for little. 0 where both are black.
struct Difference {
    std::uint32_t width = 0, height = 0;
    std::vector<float> relative;
    double median = 0, p95 = 0, greatest = 0;  ///< Of absolute values.
};
/// Both of one size, else Error(invalid_argument).
[[nodiscard]] Difference difference(const app::LinearImage& a, const app::LinearImage& b);

/// Colour of a relative difference: black is none; towards B brighter red, yellow, white; towards B darker blue, cyan, white.
/// White is `range` and beyond. The brightness grows by the square root, so that small differences show.
[[nodiscard]] std::array<std::uint8_t, 3> false_colour(double relative, double range);
[[nodiscard]] app::DisplayImage false_colours(const Difference& difference, double range);

/// A to the left of the divider (a share of the width), B from there on, and a line of one pixel between. Both of one size,
/// else Error(invalid_argument).
[[nodiscard]] app::DisplayImage split(const app::DisplayImage& a, const app::DisplayImage& b, double divider);

}  // namespace aureole::viewer
