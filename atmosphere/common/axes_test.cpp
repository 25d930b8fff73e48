// Axes of the tables: the two ways between what a texel stands for and where it lies undo each other, in float and in double.
#include "camera/pack_view.h"
#include "common/pack_atmosphere.h"
#include "multi_scatter/multi_scatter.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#define AUREOLE_SKY_VIEW_TABLE
#define AUREOLE_AERIAL_PERSPECTIVE_TABLE
namespace aureole::kernels {
AUREOLE_DEFINE_CPU_KERNEL(TableAxes)
#include "common/blocks.glsl"
#include "common/specialization.glsl"
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, ViewBlock, view)
SAMPLER_2D(2, sky_view_table)
SAMPLER_3D(3, aerial_perspective_table)
#include "aerial_perspective/aerial_perspective.glsl"
#include "common/geometry.glsl"
#include "multi_scatter/multi_scatter.glsl"
#include "sky_view/sky_view.glsl"
#include "transmittance/transmittance.glsl"
};
}  // namespace aureole::kernels
#undef AUREOLE_SKY_VIEW_TABLE
#undef AUREOLE_AERIAL_PERSPECTIVE_TABLE

using namespace aureole;

namespace {

struct World {
    std::string name;
    Planet planet;
};

/// The presets' planets, and the smallest and a very large one with thin and thick air.
std::vector<World> worlds() {
    std::vector<World> all;
    for (const char* preset : {"earth", "hazy_earth", "mars", "airless"})
        all.push_back({preset, presets::by_name(preset).planet});
    const auto add = [&](const char* name, double bottom, double shell) {
        Planet planet;
        planet.bottom_radius_m = bottom;
        planet.top_radius_m = bottom + shell;
        all.push_back({name, planet});
    };
    add("1 km", 1e3, 20);
    add("1 km, as much air", 1e3, 1e3);
    add("1e6 km", 1e9, 100e3);
    add("1e6 km, thick air", 1e9, 1e8);
    return all;
}

/// No two alike, few square.
const std::vector<rhi::Extent> sizes{{128, 32, 1}, {24, 12, 1}, {7, 50, 1}, {16, 16, 1}, {2, 2, 1}, {3, 200, 1}};

constexpr std::uint32_t suns = 2;
constexpr std::uint32_t layers = 2 * suns + 1;  // one sharp phase function each, and the optical depth

template <class real>
class Axes {
public:
    explicit Axes(const Planet& planet, rhi::Extent sky_view = {2, 4, 1}, bool half_angle = false)
        : planet_(planet),
          bindings_{{{}, {}, {.extent = {sky_view.width, sky_view.height * layers, 1}}, {}}},
          constants_{{{5, 2}, {6, suns}, {7, half_angle ? 1U : 0U}, {3, 2}}} {
        AtmosphereParameters air = presets::airless();
        air.planet = planet;
        const auto exact = detail::pack_exact(air).block;
        if constexpr (std::is_same_v<real, double>) {
            set(kernel.atm, exact);
        } else {
            set(kernel.atm, detail::round_block<detail::AtmosphereBlock>(exact));
        }
        kernel.atm.tables.z = 3;  // low air stretches the axis of altitude
        kernel.atm.sun_mapping = glm::vec<4, real>(detail::sun_mapping(planet));
    }

    void stand(double altitude_m) {
        Camera camera;
        camera.position_m = {0, 0, planet_.bottom_radius_m + altitude_m};
        camera.view = glm::dmat4(1);
        camera.projection = glm::dmat4(1);
        camera.kind = Projection::panorama;
        const detail::ViewBlock packed = detail::pack_view(camera, {}, planet_);
        const auto wide = [](const glm::vec4& v) { return glm::vec<4, real>(v); };
        kernel.view.camera = wide(packed.camera);
        kernel.view.horizon = wide(packed.horizon);
        if constexpr (std::is_same_v<real, double>) {  // of unit length to double's precision, as it is to float's
            const double length = std::hypot(kernel.view.horizon.x, kernel.view.horizon.y);
            kernel.view.horizon.x /= length;
            kernel.view.horizon.y /= length;
        }
    }

private:
    template <class To, class From>
    static void set(To& to, const From& from) {
        static_assert(sizeof to == sizeof from);
        std::memcpy(static_cast<void*>(&to), &from, sizeof to);
    }

    Planet planet_;
    std::array<rhi::CpuBinding, 4> bindings_;
    std::array<rhi::Specialization, 4> constants_;  // two phase functions, the second one sharp
    rhi::CpuArguments arguments_{.specialization = constants_, .bindings = bindings_, .push_constants = {}};

public:
    kernels::TableAxes<real> kernel{arguments_};
};

/// The largest error and where.
struct Largest {
    double error = 0;
    std::string where;
    void add(double value, const std::string& place) {
        if (value <= error) return;
        error = std::isnan(value) ? HUGE_VAL : value;
        where = place;
    }
};

/// What a round trip may lose: `steps` of numbers next to 1.
template <class real>
double rounding(double steps) {
    return steps * std::numeric_limits<real>::epsilon();
}
#define CHECK_LARGEST(largest, bound)      \
    do {                                   \
        INFO("at ", (largest).where);      \
        CHECK((largest).error <= (bound)); \
    } while (false)

std::string at(const World& world, double x, double y = 0) {
    return world.name + " " + std::to_string(x) + ", " + std::to_string(y);
}

}  // namespace

TEST_CASE_TEMPLATE("axes: a position in [0, 1] and a texture coordinate: both ends on texel centres, texels on theirs", real,
                   float, double) {
    Axes<real> axes(presets::earth().planet);
    for (const int size : {2, 3, 16, 24, 33, 192, 4096}) {
        CAPTURE(size);
        for (int i = 0; i < size; i += std::max(size / 37, 1)) {
            CAPTURE(i);
            const real position = axes.kernel.texel_to_unit(i, size);
            CHECK(static_cast<double>(axes.kernel.unit_to_texture(position, size)) * size - 0.5 ==
                  doctest::Approx(i).scale(1).epsilon(2e-7));
        }
        CHECK(axes.kernel.texel_to_unit(0, size) == 0);
        CHECK(axes.kernel.texel_to_unit(size - 1, size) == 1);
    }
}

TEST_CASE_TEMPLATE("axes: transmittance position and its inverse undo each other; ground, top, zenith and horizon are ends",
                   real, float, double) {
    Largest error, end;
    for (const World& world : worlds()) {
        Axes<real> axes(world.planet);
        auto& kernel = axes.kernel;
        for (const rhi::Extent& size : sizes) {
            kernel.atm.tables.z = static_cast<real>(size.width % 3);  // stretched and not
            for (std::uint32_t y = 0; y < size.height; ++y)
                for (std::uint32_t x = 0; x < size.width; ++x) {
                    const glm::vec<2, real> position(kernel.texel_to_unit(static_cast<int>(x), static_cast<int>(size.width)),
                                                     kernel.texel_to_unit(static_cast<int>(y), static_cast<int>(size.height)));
                    const auto place = kernel.transmittance_altitude_mu(position);
                    const auto back = kernel.transmittance_position(place.x, place.y);
                    error.add(std::abs(static_cast<double>(back.x - position.x)), at(world, position.x, position.y) + " mu");
                    error.add(std::abs(static_cast<double>(back.y - position.y)),
                              at(world, position.x, position.y) + " altitude");
                }
        }
        const real shell = kernel.shell_thickness();
        for (const real share : {real(0), real(1e-7), real(1e-3), real(0.5), real(0.999)}) {
            const real altitude = shell * share;
            end.add(static_cast<double>(kernel.transmittance_position(altitude, real(1)).x), at(world, share) + " zenith");
            end.add(std::abs(1 - static_cast<double>(kernel.transmittance_position(altitude, kernel.horizon_mu(altitude)).x)),
                    at(world, share) + " horizon");
        }
        end.add(std::abs(static_cast<double>(kernel.transmittance_position(real(0), real(0.3)).y)), at(world, 0) + " ground");
        end.add(std::abs(1 - static_cast<double>(kernel.transmittance_position(shell, real(0.3)).y)), at(world, 1) + " top");
    }
    CHECK_LARGEST(error, rounding<real>(4));
    CHECK_LARGEST(end, rounding<real>(2));
}

TEST_CASE_TEMPLATE("axes: sun cosine and altitude of the multi-scatter table and their inverses", real, float, double) {
    // The ends of the sun's axis go to the device in float, for every kernel alike.
    constexpr double ends_rounding = 1e-7;
    Largest sun, altitude, mu, end;
    for (const World& world : worlds())
        for (const real stretch : {real(0), real(3)}) {
            Axes<real> axes(world.planet);
            auto& kernel = axes.kernel;
            kernel.atm.tables.z = stretch;
            for (const int size : {2, 7, 24, 33, 256})
                for (int i = 0; i < size; ++i) {
                    const real position = kernel.texel_to_unit(i, size);
                    sun.add(std::abs(static_cast<double>(kernel.sun_position(kernel.sun_mu_at(position)) - position)),
                            at(world, position));
                    altitude.add(
                        std::abs(static_cast<double>(kernel.altitude_position(kernel.altitude_at(position)) - position)),
                        at(world, position));
                }
            for (const double cosine : {-1.0, -0.3, -0.1, -1e-3, 0.0, 1e-3, 0.2, 0.9, 1.0}) {
                const real mu_s = static_cast<real>(cosine);
                mu.add(std::abs(static_cast<double>(kernel.sun_mu_at(kernel.sun_position(mu_s)) - mu_s)), at(world, cosine));
            }
            end.add(std::abs(static_cast<double>(kernel.sun_position(real(-1)))), at(world, -1));
            end.add(std::abs(static_cast<double>(kernel.sun_position(real(1)) - 1)), at(world, 1));
            CHECK(kernel.altitude_at(real(0)) == 0);
            CHECK(kernel.altitude_position(real(0)) == 0);
            end.add(std::abs(static_cast<double>(kernel.altitude_position(kernel.shell_thickness()) - 1)),
                    at(world, 1) + " top");
            // A man's height is told from the ground.
            const double low = 1e-6 * static_cast<double>(kernel.shell_thickness());
            const real found = kernel.altitude_at(kernel.altitude_position(static_cast<real>(low)));
            altitude.add(std::abs(static_cast<double>(found) / low - 1), at(world, low) + " low");
        }
    CHECK_LARGEST(sun, rounding<real>(4) + ends_rounding);
    CHECK_LARGEST(altitude, rounding<real>(4));
    CHECK_LARGEST(mu, rounding<real>(16));
    CHECK_LARGEST(end, rounding<real>(2) + ends_rounding);
}

TEST_CASE_TEMPLATE("axes: every texel of the sky-view table is where its direction is looked up", real, float, double) {
    Largest across, along;
    for (const World& world : worlds())
        for (const bool half_angle : {false, true})
            for (const rhi::Extent& size : {rhi::Extent{32, 192, 1}, {7, 50, 1}, {16, 16, 1}, {100, 4, 1}}) {
                Axes<real> axes(world.planet, size, half_angle);
                auto& kernel = axes.kernel;
                const double shell = world.planet.top_radius_m - world.planet.bottom_radius_m;
                for (const double altitude : {0.0, 0.01, 2.0, 0.5 * shell, shell - 0.1, shell + 0.1, 2 * shell, 1e6}) {
                    axes.stand(altitude);
                    const int half_rows = static_cast<int>(size.height) / 2;
                    const double dip =
                        std::atan2(static_cast<double>(kernel.view.horizon.y), static_cast<double>(kernel.view.horizon.x));
                    for (const bool below : {false, true})
                        for (int i = 1; i < half_rows; ++i) {
                            const real position = kernel.texel_to_unit(i, half_rows);
                            const double angle = 2 * std::asin(static_cast<double>(kernel.sky_view_half_sine(position, below)));
                            const double elevation = (below ? -angle : angle) - dip;
                            const int column = i % static_cast<int>(size.width);
                            const real azimuth =
                                kernel.sky_view_azimuth_cosine(kernel.texel_to_unit(column, static_cast<int>(size.width)));
                            const auto seen = kernel.sky_view_coordinates(1, static_cast<real>(std::sin(elevation)),
                                                                          static_cast<real>(std::cos(elevation)), azimuth);
                            const std::string where = at(world, altitude, position) + (below ? " below" : " above");
                            across.add(std::abs(static_cast<double>(seen.x) * size.width - 0.5 - column), where);
                            const double row = static_cast<double>(seen.y) * size.height * layers - 0.5 - 2 * size.height -
                                               (below ? 0 : half_rows);
                            const double found = row / (half_rows - 1);
                            const double margin = 1 / 256.0 / (half_rows - 1);
                            const double wanted = std::min(static_cast<double>(position), 1 - margin);
                            const double widest = below ? kernel.view.horizon.w : kernel.view.horizon.z;
                            along.add(std::abs(found * found - wanted * wanted) / std::max(widest, 1.0), where);  // in chords
                        }
                }
            }
    CHECK_LARGEST(across, rounding<real>(1e3));  // of a texel among a hundred
    CHECK_LARGEST(along, rounding<real>(16));
}

TEST_CASE_TEMPLATE("axes: every froxel's slice is where its distance is looked up, and between slices distance is linear", real,
                   float, double) {
    Axes<real> axes(presets::earth().planet);
    Largest error;
    for (const int slices : {2, 3, 16, 32, 64, 256})
        for (int i = 0; i < slices; ++i)
            for (const double between : {0.0, 0.25, 0.5, 0.99}) {
                if (i + 1 == slices && between > 0) continue;
                const real here = axes.kernel.texel_to_unit(i, slices);
                const real next = axes.kernel.texel_to_unit(std::min(i + 1, slices - 1), slices);
                const real share = here * here + static_cast<real>(between) * (next * next - here * here);
                const double slice = static_cast<double>(axes.kernel.slice_position(share, slices)) * (slices - 1);
                error.add(std::abs(slice - i - between), std::to_string(slices) + " slices, " + std::to_string(i + between));
            }
    CHECK_LARGEST(error, rounding<real>(256));  // of a slice among as many
}
