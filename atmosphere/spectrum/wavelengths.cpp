// Which wavelengths to render, and how they add up to a colour.
#include <aureole/spectrum.h>

#include "common/check.h"
#include "spectrum/colour.h"
#include "spectrum/tables.h"

namespace aureole::spectrum {
namespace {

constexpr double from_nm = 380, to_nm = 780;

/// Linear Rec.709 in lux of the sun's light in a band.
Rgb sunlight(double from, double to) {
    const auto density = [](double nm) {
        return detail::in_bin(detail::solar_irradiance_bins, nm) * detail::between_samples(detail::colour_matching_samples, nm);
    };
    return rec709_from_xyz(detail::max_luminous_efficacy * detail::integrate(from, to, density));
}

}  // namespace

Wavelengths equal_bins(int n) {
    aureole::detail::check("n", n, 1, 400);
    Wavelengths set;
    const double width = (to_nm - from_nm) / n;
    for (int i = 0; i < n; ++i) {
        const double from = from_nm + width * i, to = i + 1 == n ? to_nm : from + width;
        set.nm.push_back(0.5 * (from + to));
        set.to_rec709.push_back(sunlight(from, to));
    }
    return set;
}

std::vector<Triplet> triplets(const Wavelengths& wavelengths) {
    aureole::detail::check_count("wavelengths.nm", wavelengths.nm.size(), 1, 4096);
    aureole::detail::check_count("wavelengths.to_rec709", wavelengths.to_rec709.size(), wavelengths.nm.size(),
                                 wavelengths.nm.size());
    std::vector<Triplet> result;
    for (std::size_t first = 0; first < wavelengths.nm.size(); first += 3) {
        Triplet triplet{.nm = {}, .to_rec709 = glm::dmat3(0)};
        for (std::size_t k = 0; k < 3; ++k) {
            const bool used = first + k < wavelengths.nm.size();
            triplet.nm[k] = used ? wavelengths.nm[first + k] : wavelengths.nm.back();
            if (used) triplet.to_rec709[static_cast<int>(k)] = wavelengths.to_rec709[first + k];
        }
        result.push_back(triplet);
    }
    return result;
}

}  // namespace aureole::spectrum
