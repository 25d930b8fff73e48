// Automatic exposure: how bright a picture is, whatever its projection.
#pragma once

#include <aureole/camera.h>

#include <cstdint>
#include <span>
#include <vector>

namespace aureole::app {

/// Solid angle of each pixel in sr, row by row; 0 where a fisheye shows nothing. The camera is one of aureole::look's with any
/// kind of projection.
[[nodiscard]] std::vector<double> solid_angles(const Camera& camera, std::uint32_t width, std::uint32_t height);

/// Every `step`-th pixel of every `step`-th row of a picture, its first among them: enough for the meter.
struct Thinned {
    std::uint32_t width = 0, height = 0;
    std::vector<float> rgba;
};
[[nodiscard]] Thinned thinned(std::span<const float> rgba, std::uint32_t width, std::uint32_t height, std::uint32_t step);

/// Exposure that makes the brightest part of a picture bright: the log-average luminance of the brightest 0.3 sr (a disk of 35
/// degrees; at most half of the picture) becomes 0.8. Measured over a solid angle, not over a share of the pixels, a panorama
/// gets the exposure of a picture of its bright side. Black pixels are left out; 1 for a black picture.
[[nodiscard]] double automatic_exposure(std::span<const float> rgba, std::span<const double> solid_angles);

}  // namespace aureole::app
