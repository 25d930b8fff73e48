// Luminance of linear Rec.709, in one place for all that meters or compares pictures.
#pragma once

#include <aureole/spectrum.h>

#include <glm/geometric.hpp>

namespace aureole::app {

/// White (1, 1, 1) has 1. Takes any numbers, and none, too.
inline double luminance(const Rgb& rgb) {
    static const Rgb weights(spectrum::xyz_from_rec709({1, 0, 0}).y, spectrum::xyz_from_rec709({0, 1, 0}).y,
                             spectrum::xyz_from_rec709({0, 0, 1}).y);
    return glm::dot(weights, rgb);
}

}  // namespace aureole::app
