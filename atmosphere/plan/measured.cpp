#include "plan/measured.h"

namespace aureole::detail {

std::array<const MeasuredError*, 2> errors_of_geometry(const MeasuredSetting& setting, double range_m) {
    if (setting.aerial_near_p95.by_scene.empty()) return {&setting.aerial_p95, nullptr};
    return {&setting.aerial_near_p95, range_m > 1000 * near_geometry_km ? &setting.aerial_far_p95 : nullptr};
}

const MeasuredSkies& measured_in_rgb() {
    static const MeasuredSkies skies
#include "plan/measured_rgb.inc"
        ;
    return skies;
}

const MeasuredSkies& measured_in_wavelengths() {
    static const MeasuredSkies skies
#include "plan/measured_wavelengths.inc"
        ;
    return skies;
}

}  // namespace aureole::detail
