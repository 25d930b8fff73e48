// Transmittance tables: deeper towards the horizon and towards the ground, between their texels too.
#include "stability/depth.h"
#include "stability/worst.h"

#include <algorithm>
#include <cmath>
#include <vector>

// The kernel that fills the table, which here can look it up as well.
#define AUREOLE_TRANSMITTANCE_TABLE
namespace aureole::kernels {
AUREOLE_DEFINE_CPU_KERNEL(TransmittanceFormulas)
SAMPLER_2D(4, transmittance_table)
#include "transmittance/transmittance.comp.glsl"
};
}  // namespace aureole::kernels
#undef AUREOLE_TRANSMITTANCE_TABLE
#undef AUREOLE_PROFILE_TABLE
#undef AUREOLE_COLUMN_QUADRATURE
#undef AUREOLE_COLUMN_NODES

using namespace aureole;
using namespace aureole::stability;

namespace {

template <class real>
using Table = Fed<kernels::TransmittanceFormulas, real>;

constexpr int width = 16, height = 6;

/// Fills the table in the format, and makes it the one that is looked up.
template <class real>
std::vector<real> fill(kernels::TransmittanceFormulas<real>& k, rhi::Format format) {
    std::vector<real> texels(4 * width * height);
    k.transmittance_out.texels = texels.data();
    k.transmittance_out.width = width, k.transmittance_out.height = height;
    k.transmittance_out.format = format;
    k.transmittance_out.exact = sizeof(real) == 8;  // only what the format could not hold at all is rounded
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) k.kernel_main({x, y, 0});
    return texels;
}
template <class real>
void show(kernels::TransmittanceFormulas<real>& k, const std::vector<real>& texels) {
    k.transmittance_table.texels = texels.data();
    k.transmittance_table.width = width, k.transmittance_table.height = height;
    k.transmittance_table.linear = true;
}

/// What rounding may do to each texel.
template <class real>
std::vector<glm::dvec3> rounding_of(kernels::TransmittanceFormulas<real>& k, const Inputs& in) {
    std::vector<glm::dvec3> all;
    const double cell = largest_cell(in);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto at = k.transmittance_altitude_mu({k.texel_to_unit(x, width), k.texel_to_unit(y, height)});
            all.push_back(conditioning(k, cell, at.x, at.y, k.distance_to_top(at.x, at.y)));
        }
    return all;
}

/// Of each texel: what is left open by its nodes, or by its storage.
template <class real>
struct Filled {
    std::vector<real> texels, finer;
    std::vector<glm::dvec3> rounding;
    [[nodiscard]] glm::dvec3 value(int x, int y) const { return at(texels, x, y); }
    [[nodiscard]] glm::dvec3 slack(int x, int y) const {
        return 2.0 * glm::abs(value(x, y) - at(finer, x, y)) +
               rounding[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
    }
    static glm::dvec3 at(const std::vector<real>& all, int x, int y) {
        const std::size_t i = 4 * static_cast<std::size_t>(y * width + x);
        return {all[i], all[i + 1], all[i + 2]};
    }
};

double share_of_fall(const glm::dvec3& deeper, const glm::dvec3& thinner, const glm::dvec3& slack) {
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        if (thinner[i] > deeper[i]) worst = std::max(worst, (thinner[i] - deeper[i]) / std::max(slack[i], 1e-30));
    return worst;
}

bool thins_with_altitude(const Case& c) {
    return std::ranges::all_of(c.air().terms,
                               [](const DensityTerm& t) { return std::holds_alternative<ExponentialProfile>(t.profile); });
}

template <class real>
void check_texels(Ledger& ledger, const Case& c, const Filled<real>& table) {
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 here = table.value(x, y);
            ledger.check("a texel is finite and not negative", c,
                         here.x >= 0 && here.y >= 0 && here.z >= 0 && here.x + here.y + here.z < 2e5);
            if (y + 1 < height && x == 0)
                ledger.add("straight up: the lower, the deeper", c,
                           share_of_fall(here, table.value(x, y + 1), table.slack(x, y) + table.slack(x, y + 1)));
            if (x + 1 < width && thins_with_altitude(c))
                ledger.add("air that thins out: the nearer to the horizon, the deeper", c,
                           share_of_fall(table.value(x + 1, y), here, table.slack(x, y) + table.slack(x + 1, y)));
        }
}

/// Between texels: look-ups are linear between them, so they are monotone where the texels are.
template <class real>
void check_between(Ledger& ledger, const Case& c, kernels::TransmittanceFormulas<real>& k, const Filled<real>& table) {
    glm::dvec3 slack(0), deepest(0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            slack = glm::max(slack, table.slack(x, y));
            deepest = glm::max(deepest, table.value(x, y));
        }
    // A position of the axis is off by some steps, and the table as steep as all of it is deep.
    slack = 2.0 * slack + 64 * width * step<real> * deepest;
    const real h = static_cast<real>(c.altitude_in_air_m() * km);
    const double horizon = k.horizon_mu(std::min(h, k.shell_thickness()));
    glm::dvec3 before(0), above(0);
    constexpr int count = 40;
    for (int i = 0; i < count; ++i) {
        const double share = (i + c.random(640)) / count;
        const real mu = static_cast<real>(1 - share * (1 - horizon));
        const real altitude = k.shell_thickness() * static_cast<real>((1 - share) * (1 - share));
        const glm::dvec3 now(k.optical_depth_to_top(std::min(h, k.shell_thickness()), mu)),
            straight(k.optical_depth_to_top(altitude, real(1)));
        if (thins_with_altitude(c))
            ledger.add("looked up: the nearer to the horizon, the deeper", c, share_of_fall(now, before, slack));
        ledger.add("looked up straight up: the lower, the deeper", c, share_of_fall(straight, above, slack));
        before = now;
        above = straight;
    }
}

template <class real>
void check_tables(rhi::Format format) {
    Ledger ledger(std::string("transmittance tables in ") + (format == rhi::Format::rgba16_float ? "half" : "float") +
                  (sizeof(real) == 4 ? ", by float" : ", by double"));
    const Range range = cases(500);
    Table<real> few(10), many(16);
    for (std::uint64_t i = range.begin; i < range.end; ++i) {
        const Case c(i);
        const Inputs in(c.air());
        auto& k = few.set(in);
        const Filled<real> table{fill(k, format), fill(many.set(in), rhi::Format::rgba32_float), rounding_of(k, in)};
        show(k, table.texels);
        check_texels(ledger, c, table);
        check_between(ledger, c, k, table);
    }
    ledger.verify();
}

}  // namespace

TEST_CASE_TEMPLATE("stability, tables: transmittance is monotone where it must be", real, float, double) {
    check_tables<real>(rhi::Format::rgba32_float);
    if constexpr (sizeof(real) == 4) check_tables<real>(rhi::Format::rgba16_float);
}
