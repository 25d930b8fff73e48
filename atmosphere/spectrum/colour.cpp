// From spectra to colours, and how far two colours are apart.
#include <aureole/spectrum.h>

#include "common/check.h"
#include "spectrum/colour.h"
#include "spectrum/tables.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace aureole::spectrum {
namespace {

void check_finite(const std::string& field, const glm::dvec3& value) {
    aureole::detail::check_xyz(field, value, -1e300, 1e300);
}

void check_bands(const Bands& bands) {
    aureole::detail::check_count("bands.edge_nm", bands.edge_nm.size(), 2, 4097);
    const std::size_t count = bands.edge_nm.size() - 1;
    aureole::detail::check_count("bands.value", bands.value.size(), count, count);
    for (std::size_t i = 0; i <= count; ++i) {
        const std::string field = aureole::detail::element("bands.edge_nm", i);
        aureole::detail::check(field, bands.edge_nm[i], 0, 1e6);
        if (i > 0 && !(bands.edge_nm[i] > bands.edge_nm[i - 1]))
            aureole::detail::reject(field, aureole::detail::print(bands.edge_nm[i]), "above the edge before it");
    }
    for (std::size_t i = 0; i < count; ++i)
        aureole::detail::check(aureole::detail::element("bands.value", i), bands.value[i], -1e100, 1e100);
}

/// XYZ of a chromaticity with y = 1.
glm::dvec3 from_chromaticity(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

/// Columns: XYZ of Rec.709's red, green and blue, scaled so that they add up to white.
glm::dmat3 primaries() {
    const glm::dmat3 unscaled(from_chromaticity(0.64, 0.33), from_chromaticity(0.30, 0.60), from_chromaticity(0.15, 0.06));
    const glm::dvec3 scale = glm::inverse(unscaled) * white_d65();
    return {unscaled[0] * scale[0], unscaled[1] * scale[1], unscaled[2] * scale[2]};
}

/// The cube root of L*a*b*, straight near 0.
double lab_root(double t) {
    constexpr double knee = 6.0 / 29.0;
    return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4.0 / 29.0;
}

double square(double x) { return x * x; }
double seventh_root_share(double chroma) {  // sqrt(C^7 / (C^7 + 25^7))
    const double c7 = std::pow(chroma, 7);
    return std::sqrt(c7 / (c7 + std::pow(25.0, 7)));
}
double degrees(double x) { return x * 180 / glm::pi<double>(); }
double cos_degrees(double x) { return std::cos(glm::radians(x)); }

/// In [0, 360); 0 where there is no hue.
double hue_degrees(double a, double b) {
    if (a == 0 && b == 0) return 0;
    const double h = degrees(std::atan2(b, a));
    return h < 0 ? h + 360 : h;
}

/// The mean of two hues along the shorter arc.
double mean_hue(double h1, double h2) {
    const double sum = h1 + h2;
    if (std::abs(h1 - h2) <= 180) return sum / 2;
    return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

/// From h1 to h2 along the shorter arc.
double hue_step(double h1, double h2) {
    const double step = h2 - h1;
    return step > 180 ? step - 360 : step < -180 ? step + 360 : step;
}

}  // namespace

glm::dvec3 white_d65() { return from_chromaticity(0.3127, 0.3290); }

glm::dvec3 xyz_from_rec709(const Rgb& rgb) {
    check_finite("rgb", rgb);
    static const glm::dmat3 matrix = primaries();
    return matrix * rgb;
}

Rgb rec709_from_xyz(const glm::dvec3& xyz) {
    check_finite("xyz", xyz);
    static const glm::dmat3 matrix = glm::inverse(primaries());
    return matrix * xyz;
}

glm::dvec3 xyz(const Bands& bands) {
    check_bands(bands);
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < bands.value.size(); ++i) {
        const double from = std::max(bands.edge_nm[i], first_nm), to = std::min(bands.edge_nm[i + 1], last_nm);
        if (from < to) sum += bands.value[i] * (to - from) * colour_matching(from, to);
    }
    return detail::max_luminous_efficacy * sum;
}

glm::dvec3 lab_from_xyz(const glm::dvec3& xyz, const glm::dvec3& white) {
    check_finite("xyz", xyz);
    aureole::detail::check_xyz("white", white, 1e-100, 1e100);
    const double x = lab_root(xyz.x / white.x), y = lab_root(xyz.y / white.y), z = lab_root(xyz.z / white.z);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// Equation numbers: Sharma, Wu & Dalal 2005, Color Res. Appl. 30, 21.
double delta_e_2000(const glm::dvec3& lab_a, const glm::dvec3& lab_b) {
    check_finite("lab_a", lab_a);
    check_finite("lab_b", lab_b);
    const double mean_chroma = (std::hypot(lab_a.y, lab_a.z) + std::hypot(lab_b.y, lab_b.z)) / 2;  // (2), (3)
    const double stretch = 1 + 0.5 * (1 - seventh_root_share(mean_chroma));                        // 1 + G, (4)
    const double a1 = stretch * lab_a.y, a2 = stretch * lab_b.y;
    const double c1 = std::hypot(a1, lab_a.z), c2 = std::hypot(a2, lab_b.z);
    const double h1 = hue_degrees(a1, lab_a.z), h2 = hue_degrees(a2, lab_b.z);

    const bool grey = c1 * c2 == 0;
    const double lightness_step = lab_b.x - lab_a.x, chroma_step = c2 - c1;                               // (8), (9)
    const double hue = grey ? 0 : 2 * std::sqrt(c1 * c2) * std::sin(glm::radians(hue_step(h1, h2) / 2));  // (10), (11)
    const double l = (lab_a.x + lab_b.x) / 2, c = (c1 + c2) / 2, h = grey ? h1 + h2 : mean_hue(h1, h2);   // (12)-(14)

    const double t = 1 - 0.17 * cos_degrees(h - 30) + 0.24 * cos_degrees(2 * h) + 0.32 * cos_degrees(3 * h + 6) -
                     0.20 * cos_degrees(4 * h - 63);                                 // (15)
    const double s_l = 1 + 0.015 * square(l - 50) / std::sqrt(20 + square(l - 50));  // (18)
    const double s_c = 1 + 0.045 * c, s_h = 1 + 0.015 * c * t;                       // (19), (20)
    const double rotation =
        -2 * seventh_root_share(c) * std::sin(glm::radians(60 * std::exp(-square((h - 275) / 25))));  // (16), (17), (21)

    const double dl = lightness_step / s_l, dc = chroma_step / s_c, dh = hue / s_h;
    return std::sqrt(std::max(0.0, dl * dl + dc * dc + dh * dh + rotation * dc * dh));  // (22)
}

}  // namespace aureole::spectrum
