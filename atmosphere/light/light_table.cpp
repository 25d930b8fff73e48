#include "common/check.h"

#include <aureole/light.h>
#include <aureole/rhi/kernel/cpu_kernel.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace aureole {
namespace {

/// The shaders' formulas.
template <class real>
struct Harmonics {
    AUREOLE_KERNEL_TYPES
#include "light/harmonics.glsl"
};
static_assert(LightTable::coefficient_count == Harmonics<double>::HARMONIC_COUNT);

constexpr std::size_t row_floats = LightTable::floats_per_sun;
constexpr std::size_t max_rows = 4;  // ViewSettings::max_suns

glm::dvec3 unit(const glm::dvec3& normal) {
    const double length = std::hypot(normal.x, normal.y, normal.z);
    detail::check("normal length", length, 1e-100, 1e100);
    return normal / length;
}

Rgb signed_irradiance(std::span<const Rgb, 9> coefficients, const glm::dvec3& unit_normal) {
    Harmonics<double> harmonics;
    Rgb sum(0);
    for (int i = 0; i < LightTable::coefficient_count; ++i)
        sum += coefficients[static_cast<std::size_t>(i)] * harmonics.harmonic_irradiance(i, unit_normal);
    return sum;
}

}  // namespace

Rgb sky_irradiance(std::span<const Rgb, 9> coefficients, const glm::dvec3& normal) {
    return glm::max(signed_irradiance(coefficients, unit(normal)), Rgb(0));
}

LightTable::LightTable(std::span<const float> texels) {
    const std::size_t size = texels.size();
    if (size == 0 || size % row_floats != 0 || size > max_rows * row_floats)
        detail::reject("texels", std::to_string(size) + " floats", "40 floats for each of 1 to 4 suns");
    const auto bad = std::find_if(texels.begin(), texels.end(), [](float value) { return !std::isfinite(value); });
    if (bad != texels.end())
        detail::reject(detail::element("texels", static_cast<std::size_t>(bad - texels.begin())), detail::print(*bad),
                       "finite");
    texels_.assign(texels.begin(), texels.end());
}

int LightTable::sun_count() const noexcept { return static_cast<int>(texels_.size() / row_floats); }

Rgb LightTable::sun_irradiance(int sun) const { return texel(coefficient_count, sun); }

Rgb LightTable::sky_coefficient(int i, int sun) const {
    detail::check("coefficient", i, 0, coefficient_count - 1);
    return texel(i, sun);
}

Rgb LightTable::sky_irradiance(const glm::dvec3& normal) const {
    const glm::dvec3 direction = unit(normal);
    Rgb sum(0);
    for (int sun = 0; sun < sun_count(); ++sun) sum += aureole::signed_irradiance(coefficients(sun), direction);
    return glm::max(sum, Rgb(0));
}

Rgb LightTable::sky_irradiance(const glm::dvec3& normal, int sun) const {
    return aureole::sky_irradiance(coefficients(sun), normal);
}

std::array<Rgb, 9> LightTable::coefficients(int sun) const {
    std::array<Rgb, 9> all{};
    for (int i = 0; i < coefficient_count; ++i) all[static_cast<std::size_t>(i)] = texel(i, sun);
    return all;
}

Rgb LightTable::texel(int column, int sun) const {
    detail::check("sun", sun, 0, sun_count() - 1);
    const float* rgb = texels_.data() + static_cast<std::size_t>(sun) * row_floats + static_cast<std::size_t>(4 * column);
    return {rgb[0], rgb[1], rgb[2]};
}

}  // namespace aureole
