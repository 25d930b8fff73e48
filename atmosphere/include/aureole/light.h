// Sun and sky light for the host's own lights, on the CPU: what a View's light table holds, once the host has read it back.
//
//     ViewSettings::light is on, and air.record, view.record have been recorded; then, in the same list or a later one:
//         barrier: view.light_table() from State::sampled to State::copy_source
//         commands.copy(rhi::TextureToBuffer{view.light_table(), read_back_buffer});   // 160 bytes a sun
//         barrier: view.light_table() back to State::sampled
//     when that has finished:
//         device.read_buffer(read_back_buffer, std::as_writable_bytes(std::span(texels)));
//         LightTable light(texels);
//
// Shaders get the same from aureole_sun_irradiance and aureole_sky_irradiance (<aureole/glsl/aureole.glsl>): both call the
// formulas of atmosphere/light/harmonics.glsl. Irradiance comes in the unit of Sun::irradiance, radiance in that unit per
// steradian.
#pragma once

#include <aureole/parameters.h>

#include <array>
#include <span>
#include <vector>

namespace aureole {

/// Irradiance of a surface with this normal (world axes, of any length in [1e-100, 1e100], else Error(invalid_argument)) from
/// coefficients of the sky's radiance as LightTable::sky_coefficient gives them: for a host that keeps them, mixes those of two
/// places, say, or adds suns up. Never negative.
[[nodiscard]] Rgb sky_irradiance(std::span<const Rgb, 9> coefficients, const glm::dvec3& normal);

/// The light table's texels, read on the CPU by the formulas of the shaders.
class LightTable {
public:
    /// Columns of the table: nine coefficients of the sky's radiance, then the sun's irradiance.
    static constexpr int coefficient_count = 9;
    static constexpr int floats_per_sun = 4 * (coefficient_count + 1);  ///< Texels are RGBA.

    /// The table's texels, RGBA, a row for each of ViewSettings::max_suns. Copied. Error(invalid_argument) unless there are 40
    /// floats for each of 1 to 4 suns, all finite.
    explicit LightTable(std::span<const float> texels);

    /// Rows: ViewSettings::max_suns. Suns that View::update was not given are dark.
    [[nodiscard]] int sun_count() const noexcept;

    /// Irradiance of a surface at the camera that faces the sun: after the air, less what the horizon hides of the disk.
    /// `sun` in [0, sun_count()), else Error(invalid_argument).
    [[nodiscard]] Rgb sun_irradiance(int sun = 0) const;

    /// Irradiance that the sky, lit by all suns, gives a surface at the camera with this normal (world axes of Camera; of any
    /// length in [1e-100, 1e100], else Error(invalid_argument)). Light that the ground reflects from below the horizon is part
    /// of it. Never negative. Spherical harmonics of degree 2 are within 6 percent of the largest irradiance that any normal
    /// gets (host.md).
    [[nodiscard]] Rgb sky_irradiance(const glm::dvec3& normal) const;
    /// The share of one sun's light in it.
    [[nodiscard]] Rgb sky_irradiance(const glm::dvec3& normal, int sun) const;

    /// For engines that take spherical harmonics as they are: coefficient i of the sky's radiance in the orthonormal real
    /// basis, order 00, 1-1, 10, 11, 2-2, 2-1, 20, 21, 22 (y, z, x; xy, yz, 3 z^2 - 1, xz, x^2 - y^2), world axes. `i` in [0,
    /// 9), `sun` in [0, sun_count()), else Error(invalid_argument).
    [[nodiscard]] Rgb sky_coefficient(int i, int sun = 0) const;

private:
    [[nodiscard]] Rgb texel(int column, int sun) const;
    [[nodiscard]] std::array<Rgb, 9> coefficients(int sun) const;

    std::vector<float> texels_;
};

}  // namespace aureole
