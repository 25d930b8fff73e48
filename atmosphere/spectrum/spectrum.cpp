// Look-ups in the tables.
#include <aureole/spectrum.h>

#include "common/check.h"
#include "spectrum/tables.h"

namespace aureole::spectrum {
namespace {

using aureole::detail::check;

void check_band(double from_nm, double to_nm) {
    check("from_nm", from_nm, first_nm, last_nm);
    check("to_nm", to_nm, first_nm, last_nm);
    if (!(to_nm > from_nm))
        aureole::detail::reject("to_nm", aureole::detail::print(to_nm), "above from_nm, " + aureole::detail::print(from_nm));
}

double at(const detail::Bins& bins, double nm) {
    check("nm", nm, first_nm, last_nm);
    return detail::between_centres(bins, nm);
}

double mean(const detail::Bins& bins, double from_nm, double to_nm) {
    check_band(from_nm, to_nm);
    return detail::integrate(from_nm, to_nm, [&](double nm) { return detail::in_bin(bins, nm); }) / (to_nm - from_nm);
}

}  // namespace

namespace detail {

double in_bin(const Bins& bins, double nm) { return bins[static_cast<std::size_t>((nm - table_start_nm) / bin_nm)]; }

double between_centres(const Bins& bins, double nm) {
    const double x = std::max(0.0, (nm - table_start_nm) / bin_nm - 0.5);
    const auto i = static_cast<std::size_t>(x);
    return bins[i] + (x - static_cast<double>(i)) * (bins[i + 1] - bins[i]);
}

glm::dvec3 between_samples(const Samples& samples, double nm) {
    const double x = (nm - table_start_nm) / sample_nm;
    const auto i = std::min(static_cast<std::size_t>(x), samples.size() - 2);
    return samples[i] + (x - static_cast<double>(i)) * (samples[i + 1] - samples[i]);
}

}  // namespace detail

double solar_irradiance(double nm) { return at(detail::solar_irradiance_bins, nm); }
double solar_irradiance(double from_nm, double to_nm) { return mean(detail::solar_irradiance_bins, from_nm, to_nm); }

double ozone_cross_section(double nm) { return at(detail::ozone_cross_section_bins, nm); }
double ozone_cross_section(double from_nm, double to_nm) { return mean(detail::ozone_cross_section_bins, from_nm, to_nm); }

glm::dvec3 colour_matching(double nm) {
    check("nm", nm, first_nm, last_nm);
    return detail::between_samples(detail::colour_matching_samples, nm);
}
glm::dvec3 colour_matching(double from_nm, double to_nm) {
    check_band(from_nm, to_nm);
    const auto f = [](double nm) { return detail::between_samples(detail::colour_matching_samples, nm); };
    return detail::integrate(from_nm, to_nm, f) / (to_nm - from_nm);
}

}  // namespace aureole::spectrum
