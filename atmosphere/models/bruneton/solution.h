// The recorder of a solution: which pass computes which slices of the tables, at once or in parts.
#pragma once

#include "common/pass.h"

#include <aureole/models/bruneton.h>

namespace aureole::detail {

/// What a solution makes, and views read.
struct BrunetonTables {
    TrackedTexture* transmittance;
    TrackedTexture scattering, irradiance;
};

/// Small tables are kept in float wherever that can be filtered.
[[nodiscard]] rhi::Format small_table_format(const rhi::Device& device);

/// Order by order: the field that arrives at every point (from what has been scattered so far), what the air scatters of it,
/// and the sum of that along every ray. Tables of the field and of its source are shared by all sets of tables that are solved
/// for.
class BrunetonSolution {
public:
    BrunetonSolution(AirResources& shared, const models::BrunetonSettings& settings, bool combined);

    /// Binding sets for one set of tables.
    struct Bindings {
        rhi::BindingSet first_scattering, next_scattering, irradiance, arriving, density;
    };
    [[nodiscard]] Bindings bind(const AirResources& from, const BrunetonTables& tables) const;

    /// Tables of this model, apart from transmittance.
    [[nodiscard]] BrunetonTables make_tables(Objects& objects, TrackedTexture& transmittance, rhi::Usage more) const;

    void start() noexcept { done_ = 0; }
    void invalidate() noexcept;
    /// Records up to `units` units of work: slices of a 4D table, and one for each small table.
    void advance(rhi::CommandList& commands, PassScope& scope, PassReport& report, BrunetonTables& tables, const Bindings& sets,
                 int units);
    /// Of a solution.
    [[nodiscard]] int units() const noexcept { return slices_ + (settings_.orders - 1) * (2 * slices_ + 1); }
    [[nodiscard]] int done() const noexcept { return done_; }
    [[nodiscard]] bool finished() const noexcept { return done_ >= units(); }

    /// What the air scatters of the field, by the latest density pass.
    [[nodiscard]] TrackedTexture& source() noexcept { return source_; }

    /// What views' kernels are specialized by.
    [[nodiscard]] std::vector<rhi::Specialization> look_up() const;

private:
    /// The part of a solution to which a unit belongs.
    enum class Stage { field, density, scattering };
    struct Position {
        Stage stage;
        int order, slice, left;  ///< `left`: units of the stage from this one on.
    };
    [[nodiscard]] Position position() const noexcept;
    [[nodiscard]] Specialize specialize() const;
    /// `share`: 1, or 0 for no irradiance at all.
    void record_irradiance(rhi::CommandList& commands, PassScope& scope, BrunetonTables& tables, const Bindings& sets,
                           float share);
    void record_field(rhi::CommandList& commands, PassScope& scope, BrunetonTables& tables, const Bindings& sets, int order);

    AirResources& shared_;
    models::BrunetonSettings settings_;
    bool combined_;
    int layers_, slices_;
    int zenith_nodes_, azimuth_nodes_;
    TrackedTexture arriving_, source_;
    TrackedBuffer ray_quadrature_, zenith_quadrature_;
    QuadratureBlock ray_rule_, zenith_rule_;
    rhi::Pipeline first_scattering_, next_scattering_, irradiance_, arriving_pipeline_, density_;
    int done_ = 0;
};

}  // namespace aureole::detail
