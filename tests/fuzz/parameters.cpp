// Air, suns and camera from bytes. What the library accepts must pack into finite numbers that make sense.
#include "bytes.h"
#include "fuzz.h"

#include <aureole/camera.h>
#include <aureole/models/spectral.h>
#include <aureole/parameters.h>
#include <aureole/presets.h>

#include "camera/pack_view.h"
#include "common/pack_atmosphere.h"
#include "multi_scatter/angular_order.h"
#include "multi_scatter/order_ratio.h"

#include <numbers>

using namespace aureole;

namespace {

constexpr double pi = std::numbers::pi;

Rgb colour(fuzz::Bytes& bytes, double low, double high) {
    const double r = bytes.number(low, high);
    if (bytes.flag()) return Rgb(r);
    const double g = bytes.number(low, high);
    return {r, g, bytes.number(low, high)};
}

/// Numbers from low to high, as a rule in order.
std::vector<double> axis(fuzz::Bytes& bytes, std::size_t count, double low, double high) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(bytes.number(low, high));
    if (bytes.raw<std::uint8_t>() >= 16) std::ranges::sort(values);
    return values;
}
std::vector<double> numbers(fuzz::Bytes& bytes, std::size_t count, double low, double high) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(bytes.number(low, high));
    return values;
}

Profile profile(fuzz::Bytes& bytes) {
    const double reach = bytes.flag() ? 1e12 : 1e5;
    switch (bytes.below(3)) {
        case 0:
            return ExponentialProfile{bytes.number(0.01, reach)};
        case 1: {
            const double center = bytes.number(-reach, reach);
            return TentProfile{center, bytes.number(0.01, reach)};
        }
        default: {
            const std::size_t count = bytes.below(8);
            return TabulatedProfile{axis(bytes, count, -reach, reach), numbers(bytes, count, 0, bytes.flag() ? 1e6 : 1)};
        }
    }
}

PhaseFunction phase(fuzz::Bytes& bytes) {
    switch (bytes.below(5)) {
        case 0:
            return RayleighPhase{};
        case 1:
            return HenyeyGreensteinPhase{bytes.number(-0.999, 0.999)};
        case 2:
            return CornetteShanksPhase{bytes.number(-0.999, 0.999)};
        case 3: {
            HenyeyGreensteinDrainePhase p;
            p.g_hg = bytes.number(-0.999, 0.999);
            p.g_draine = bytes.number(-0.999, 0.999);
            p.alpha = bytes.number(0, 1e4);
            p.weight = bytes.number(0, 1);
            return p;
        }
        default: {
            const std::size_t count = bytes.below(8);
            std::vector<double> angles = axis(bytes, count, 0, pi);
            if (count > 1 && bytes.below(8) != 0) {
                angles.front() = 0;
                angles.back() = pi;
            }
            return TabulatedPhase{std::move(angles), numbers(bytes, count, 0, bytes.flag() ? 1e100 : 1)};
        }
    }
}

AtmosphereParameters air_of(fuzz::Bytes& bytes) {
    AtmosphereParameters air;
    const std::size_t preset = bytes.below(presets::names().size() + 1);
    if (preset < presets::names().size()) air = presets::by_name(presets::names()[preset]);
    if (bytes.flag()) {
        air.planet.bottom_radius_m = bytes.number(1e3, 1e12);
        air.planet.top_radius_m = bytes.number(air.planet.bottom_radius_m + 1, 11 * air.planet.bottom_radius_m);
        air.planet.ground_albedo = colour(bytes, 0, 1);
    }
    for (std::size_t count = bytes.below(4) == 0 ? bytes.below(24) : bytes.below(5); count > 0; --count) {
        DensityTerm& term = air.terms.emplace_back();
        term.name = std::string(1, static_cast<char>('a' + bytes.below(26)));
        term.profile = profile(bytes);
        term.phase = phase(bytes);
        const double most = bytes.flag() ? 1e6 : 1e-4;
        term.scattering_per_m = colour(bytes, 0, most);
        term.absorption_per_m = colour(bytes, 0, most);
        if (!bytes.flag()) continue;
        term.scattering_scale = bytes.number(0, bytes.flag() ? 1e6 : 2);
        term.absorption_scale = bytes.number(0, bytes.flag() ? 1e6 : 2);
    }
    return air;
}

Sun sun_of(fuzz::Bytes& bytes) {
    Sun sun;
    const double length = bytes.flag() ? 1 : 1e100;
    sun.direction = {bytes.number(-length, length), bytes.number(-length, length), bytes.number(-length, length)};
    sun.irradiance = colour(bytes, 0, 1e20);
    sun.angular_radius_rad = bytes.number(0, pi / 4);
    sun.limb_darkening = bytes.choice<LimbDarkening>(2);
    return sun;
}

/// By look(), with some numbers of it replaced.
Camera camera_of(fuzz::Bytes& bytes, const Planet& planet) {
    Camera camera;
    const double radius = planet.bottom_radius_m;
    (void)fuzz::accepts_value([&] {
        const double altitude = bytes.number(-radius / 2, bytes.flag() ? 1e13 - radius : 1e5);
        const double azimuth = bytes.number(-1e6, 1e6), elevation = bytes.number(-pi / 2, pi / 2);
        const double fov = bytes.number(1e-6, 3.14), aspect = bytes.number(1e-3, 1e3);
        camera = look(radius, altitude, azimuth, elevation, fov, aspect, bytes.number(1e-6, 1e9));
    });
    camera.kind = bytes.choice<Projection>(3);
    camera.depth_range = bytes.choice<DepthRange>(2);
    camera.row_order = bytes.choice<RowOrder>(2);
    for (std::size_t changes = bytes.below(4); changes > 0; --changes) {
        const auto column = static_cast<glm::length_t>(bytes.below(4)), row = static_cast<glm::length_t>(bytes.below(4));
        switch (bytes.below(3)) {
            case 0:
                camera.projection[column][row] = bytes.number(-1, 1);
                break;
            case 1:
                camera.view[column][row] = bytes.number(-1, 1);
                break;
            default:
                camera.position_m[column % 3] = bytes.number(-1e13, 1e13);
        }
    }
    return camera;
}

bool not_negative(const Rgb& rgb) {
    return std::isfinite(rgb.r) && std::isfinite(rgb.g) && std::isfinite(rgb.b) && rgb.r >= 0 && rgb.g >= 0 && rgb.b >= 0;
}

template <class Block>
void require_numbers(const Block& block, const char* what, bool infinity_allowed = false) {
    float numbers[sizeof(Block) / sizeof(float)];
    std::memcpy(numbers, &block, sizeof numbers);
    for (std::size_t i = 0; i < std::size(numbers); ++i)
        fuzz::require(infinity_allowed ? !std::isnan(numbers[i]) : std::isfinite(numbers[i]),
                      std::string(what) + " holds a number at " + std::to_string(i));
}

void check_phase_function(const DensityTerm& term) {
    for (const double cosine : {-1.0, 1.0}) {
        const double value = evaluate(term.phase, cosine);
        fuzz::require(std::isfinite(value) && value >= 0, "a phase function is positive: " + std::to_string(value));
    }
    const std::vector<double> moments = legendre_moments(term.phase, 16);
    fuzz::require(std::abs(moments.front() - 1) < 1e-6, "a phase function integrates to 1: " + std::to_string(moments.front()));
    for (const double moment : moments)
        fuzz::require(std::abs(moment) < 1 + 1e-6, "a moment is at most 1: " + std::to_string(moment));
}

void check_air(const AtmosphereParameters& air, bool phases_too) {
    fuzz::require(not_negative(vertical_optical_depth(air)), "an optical depth is finite");
    const double thickness = air.planet.top_radius_m - air.planet.bottom_radius_m;
    for (const double altitude : {0.0, thickness / 2, thickness}) {
        const MediumSample sample = sample_medium(air, altitude);
        fuzz::require(not_negative(sample.scattering_per_m) && not_negative(sample.extinction_per_m), "air is finite");
    }
    for (const DensityTerm& term : std::span(air.terms).first(std::min<std::size_t>(air.terms.size(), 6))) {
        fuzz::require(not_negative(vertical_optical_depth(air, term.name)), "an optical depth of a term is finite");
        if (phases_too) check_phase_function(term);
    }
    const detail::PackedAtmosphere packed = detail::pack_atmosphere(air);
    require_numbers(packed.block, "the block of the air");
    for (const float value : packed.profile_table) fuzz::require(std::isfinite(value), "a profile's table is finite");
    for (const float value : packed.phase_table) fuzz::require(std::isfinite(value), "a phase function's table is finite");
    for (const double moment : detail::scattered_moments(air)) fuzz::require(std::isfinite(moment), "a moment is finite");
    const double ratio = detail::order_ratio(air);
    fuzz::require(ratio >= 0 && ratio <= 1, "a ratio of orders is in [0, 1]: " + std::to_string(ratio));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const AtmosphereParameters air = air_of(bytes);
    if (!fuzz::accepts_value([&] { validate(air); })) return 0;
    check_air(air, bytes.below(4) == 0);  // moments of phase functions take most of the time
    if (bytes.flag()) {
        const std::array<double, 3> nm{bytes.number(360, 830), bytes.number(360, 830), bytes.number(360, 830)};
        (void)fuzz::accepts_value([&] { validate(models::at_wavelengths(air, nm)); });
    }

    std::vector<Sun> suns;
    for (std::size_t count = bytes.below(6); count > 0; --count) suns.push_back(sun_of(bytes));
    const Camera camera = camera_of(bytes, air.planet);
    const bool valid = fuzz::accepts_value([&] {
        validate(camera);
        for (const Sun& sun : suns) validate(sun);
    });
    detail::ViewInputs inputs;
    inputs.exposure = bytes.number(1e-30, 1e30);
    inputs.aerial_perspective_distance_m = bytes.number(1e-3, 1e13);
    const bool packed = fuzz::accepts_value(
        [&] { require_numbers(detail::pack_view(camera, suns, air.planet, inputs), "the block of the view", true); });
    fuzz::require(valid || !packed, "what is packed is valid");
    return 0;
}
