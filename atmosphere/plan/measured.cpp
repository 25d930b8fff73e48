#include "plan/measured.h"

namespace aureole::detail {

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
