#include "plan/work.h"

#include "common/pack_atmosphere.h"
#include "multi_scatter/extents.h"
#include "multi_scatter/order_ratio.h"
#include "sky_view/sky_view.h"

#include <algorithm>

namespace aureole::detail {
namespace {

// What a node along a ray takes besides its moments, in moments: measured on llvmpipe, where qualities whose moments go from 1
// to 45 then take the same time a unit, within 15 % (plan.md).
constexpr double node_of_air = 4, node_of_view = 9.5;
constexpr double tabulated_profile = 0.5;  // more, for each: 12 % in `low`, 10 % in `default`
// A node of a column through an exponential term, in the same unit, measured likewise: where all terms are exponential, and the
// kernel needs no cuts (column.glsl); else of each part so many times more.
constexpr double node_of_column = 0.7, cut_column = 2.6;
constexpr double parts_of_tent = 2, parts_of_table = 5.8;  // a table's eight have no exponential to work out

double texels(const rhi::Extent& e) { return double(e.width) * e.height * e.depth; }

/// What a column through all terms takes, beside one through a single exponential one.
double column_work(const AirStructure& air) {
    constexpr int exponential = 0, tent = 1;  // medium.glsl
    double parts = 0;
    for (int term = 0; term < air.term_count; ++term) {
        const int kind = air.term_kinds >> 2 * term & 3;
        parts += kind == exponential ? 1 : kind == tent ? parts_of_tent : parts_of_table;
    }
    return std::max(parts, 1.0) * (parts > air.term_count ? cut_column : 1);
}

/// Of `aureole`, pass by pass as MultiScatterPass records them.
class MultiScatterWork {
public:
    MultiScatterWork(const QualitySettings& quality, const AtmosphereParameters& air, double node)
        : q_(quality),
          node_(node),
          moments_(quality.multi_scatter_orders > 0 ? moment_count(quality.angular_order) : 0),
          passes_(passes_for(order_ratio(air, quality.ground_light), quality.multi_scatter_orders)),
          directions_(multi_scatter_directions(quality)),
          rays_(texels(multi_scatter_rays_extent(quality))),
          table_(texels(multi_scatter_table_extent(quality))) {}

    [[nodiscard]] double moments() const { return moments_; }
    [[nodiscard]] double reads() const {
        if (q_.multi_scatter_orders == 0) return 0;
        const double first = rays_ * q_.multi_scatter_nodes * node_;
        const double later = rays_ * q_.multi_scatter_later_nodes * (node_ + moments_);
        return first + (passes_ - 1) * later + passes_ * table_ * directions_;
    }
    /// The table, two orders and two sums at work, and the rays: in texels.
    [[nodiscard]] double memory() const { return q_.multi_scatter_orders == 0 ? 0 : 5 * table_ + rays_; }

private:
    const QualitySettings& q_;
    double node_, moments_, passes_, directions_, rays_, table_;
};

}  // namespace

TableWork table_work(const Model& model, const AtmosphereParameters& air) {
    TableWork work;
    const ExactAtmosphere packed = pack_exact(air);
    const double layers = layers_with_sharp_phases(packed.structure);
    work.view_memory = layers;
    work.aerial_perspective_memory = layers + 1;  // and transmittance
    const double column = column_work(packed.structure);
    if (model.name() == "fog") work.composite = work.light = column;
    if (model.name() == "single") {
        work.light = column;
        (model.tables_for(air).empty() ? work.composite : work.view) = column;  // the table of `low` is its dome
    }
    if (model.name() == "single-lut") work.rebuild = column;
    if (model.name() != "aureole") return work;
    const QualitySettings quality = model.quality_for(air);
    const auto profile_texels = static_cast<double>(packed.profile_table.size());
    const double node = node_of_air + tabulated_profile * profile_texels / table_width;
    const MultiScatterWork multi_scatter(quality, air, node);
    const double transmittance = texels(quality.transmittance);
    const double share = quality.table_format == rhi::Format::rgba16_float ? 0.5 : 1;  // of rgba32_float's bytes
    work.rebuild = transmittance * quality.transmittance_nodes * node_of_column * column + multi_scatter.reads();
    work.view = node_of_view + multi_scatter.moments();
    work.air_memory = share * transmittance + multi_scatter.memory() + profile_texels / 4;
    return work;
}

}  // namespace aureole::detail
