#include "common/check.h"
#include "common/check_table.h"

#include <aureole/models/reference.h>

#include <cmath>
#include <string>

namespace aureole::models {
namespace {

using detail::check;
using detail::reject;

constexpr std::size_t layers = 3;  // of the film

}  // namespace

void ReferenceSettings::validate() const {
    const ReferenceSettings& s = *this;
    detail::check_enum("reference.show", s.show, ReferenceSettings::Show::standard_error, "radiance or standard_error");
    detail::check_enum("reference.tracking", s.tracking, ReferenceSettings::Tracking::ratio, "quadrature or ratio");
    check("reference.paths_per_frame", s.paths_per_frame, 0, 65536);
    check("reference.max_paths", s.max_paths, 1, 1 << 24);
    const bool none = s.film_width == 0 && s.film_height == 0;
    if (!none) check("reference.film_width", s.film_width, 1, 16384);
    if (!none) check("reference.film_height", s.film_height, 1, 16384);
    check("reference.max_order", s.max_order, 0, 4096);
    const int parts = s.first_order_parts;
    if (parts != 1 && parts != 2 && parts != 4 && parts != 8 && parts != 16)
        reject("reference.first_order_parts", std::to_string(parts), "1, 2, 4, 8 or 16");
    check("reference.nodes", s.nodes, 4, 16);
    check("reference.roulette_order", s.roulette_order, 1, 4096);
    check("reference.seed", s.seed, 0, (1 << 24) - 1);
    check("reference.light_paths", s.light_paths, 0, 4096);
}

ReferenceSettings ReferenceSettings::by_name(std::string_view quality) {
    ReferenceSettings settings;
    if (quality == "low")
        settings.paths_per_frame = 4;
    else if (quality == "high" || quality == "converged")
        settings.paths_per_frame = 64;
    else if (quality != "default")
        detail::reject_quality(quality);
    return settings;
}

ReferenceFilm::ReferenceFilm(std::span<const float> texels, std::uint32_t width, std::uint32_t height)
    : texels_(texels.begin(), texels.end()), width_(width), height_(height) {
    const std::size_t wanted = layers * 4 * width * height;
    if (wanted == 0 || texels.size() != wanted)
        reject("texels", std::to_string(texels.size()) + " floats", std::to_string(wanted) + ", and more than none");
}

const float* ReferenceFilm::texel(std::uint32_t x, std::uint32_t y, std::uint32_t layer) const {
    check("x", x, 0, width_ - 1);
    check("y", y, 0, height_ - 1);
    return &texels_[4 * ((std::size_t{layer} * height_ + y) * width_ + x)];
}

Rgb ReferenceFilm::radiance(std::uint32_t x, std::uint32_t y) const {
    const float *mean = texel(x, y, 0), *exact = texel(x, y, 2);
    return Rgb(mean[0], mean[1], mean[2]) + Rgb(exact[0], exact[1], exact[2]);
}

Rgb ReferenceFilm::standard_error(std::uint32_t x, std::uint32_t y) const {
    const float* spread = texel(x, y, 1);
    const double n = paths(x, y);
    Rgb error(0);
    for (int c = 0; c < 3; ++c) error[c] = n > 1 ? std::sqrt(double{spread[c]} / (n * (n - 1))) : 0;
    return error;
}

int ReferenceFilm::paths(std::uint32_t x, std::uint32_t y) const { return static_cast<int>(texel(x, y, 0)[3]); }

}  // namespace aureole::models
