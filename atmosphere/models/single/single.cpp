#include "models/single/single.h"

#include "common/check.h"
#include "common/check_table.h"
#include "module/requirements.h"
#include "quadrature/gauss_legendre.h"
#include "sky_view/sky_view.h"

#include "aureole_atmosphere_shaders.h"

#include <algorithm>
#include <array>

namespace aureole {
namespace detail {
namespace {

using models::SingleSettings;
using models::Steps;

constexpr std::array<std::string_view, 1> air_passes{"transmittance"};
constexpr std::array<std::string_view, 1> view_passes{"dome"};

/// Nodes of a rule for these steps; where midpoints need none, the smallest rule there is.
int rule_size(Steps steps, int count) { return steps == Steps::gauss ? count : 1; }

std::vector<rhi::Specialization> specialization(const SingleSettings& settings) {
    const auto number = [](std::uint32_t id, int value) { return rhi::Specialization{id, static_cast<std::uint32_t>(value)}; };
    const bool gauss = settings.steps == Steps::gauss;
    std::vector<rhi::Specialization> values{
        number(8, rule_size(settings.steps, settings.view_steps)), number(30, rule_size(settings.steps, settings.light_steps)),
        number(31, gauss ? 0 : settings.view_steps), number(32, gauss ? 0 : settings.light_steps),
        number(33, settings.dome.used() ? 1 : 0)};
    if (settings.dome.phase == models::Dome::Phase::in_table) values.push_back(number(5, 0));
    return values;
}

class SingleView final : public ModelView {
public:
    SingleView(ViewResources& shared, const SingleSetup& setup, std::vector<rhi::Binding> bindings, bool aerial_perspective) {
        kernels_.composite = setup.kernels.composite;
        kernels_.composite_raster = setup.kernels.composite_raster;
        kernels_.light = setup.kernels.light;
        kernels_.specialization = specialization(setup.settings);
        kernels_.aerial_perspective = aerial_perspective;
        if (setup.settings.dome.used())
            dome_.emplace(shared, std::string(setup.prefix).append(".dome"), setup.settings.dome, *setup.kernels.dome, bindings,
                          kernels_.specialization);
        // Without a dome its slot still needs a readable texture.
        const rhi::Texture table = dome_ ? dome_->table().handle : shared.air.profile_table.handle;
        bindings.push_back({2, table, dome_ ? shared.air.linear : shared.air.nearest, {}});
        kernels_.tables = std::move(bindings);
    }

    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override {
        return dome_ ? std::span(view_passes) : std::span<const std::string_view>();
    }
    [[nodiscard]] const ModelKernels& kernels() const noexcept override { return kernels_; }
    void update(const ViewBlock& before, const ViewBlock& fresh) noexcept override {
        stale_ |= !(SkyViewKey::of(fresh) == SkyViewKey::of(before));
    }
    void restart() noexcept override { stale_ = true; }
    void invalidate() noexcept override {
        if (dome_) dome_->invalidate();
        stale_ = true;
    }
    void record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) override {
        if (dome_ && stale_) dome_->record(commands, reports[0], timestamps, 0);
        stale_ = false;
    }
    [[nodiscard]] bool due() const noexcept override { return dome_ && stale_; }
    [[nodiscard]] bool ready() const noexcept override { return !dome_ || dome_->table().state != rhi::State::undefined; }

private:
    std::optional<DomePass> dome_;
    ModelKernels kernels_;
    bool stale_ = true;
};

class SingleModel final : public Model {
public:
    explicit SingleModel(const SingleSettings& settings) : settings_(settings) { SingleModel::validate(); }
    [[nodiscard]] std::string_view name() const noexcept override { return "single"; }
    [[nodiscard]] const QualitySettings& quality() const noexcept override { return no_tables_; }
    [[nodiscard]] std::vector<ModelTable> tables_for(const AtmosphereParameters&) const override {
        if (!settings_.dome.used()) return {};
        return {dome_table(settings_.dome, settings_.view_steps)};
    }
    void validate() const override { models::validate(settings_); }
    void require(const rhi::Device& device) const override { require_dome(device, settings_.dome); }
    [[nodiscard]] std::unique_ptr<ModelAir> make_air(AirResources& shared, const AtmosphereParameters&) const override {
        return std::make_unique<SingleAir>(shared, SingleSetup{settings_,
                                                               {&shaders::single_composite, &shaders::single_composite_raster,
                                                                &shaders::single_light, &shaders::single_dome},
                                                               false,
                                                               "single"});
    }

private:
    SingleSettings settings_;
    QualitySettings no_tables_;
};

}  // namespace

SingleAir::SingleAir(AirResources& shared, const SingleSetup& setup)
    : shared_(shared),
      setup_(setup),
      view_rule_(quadrature_block(rule_size(setup.settings.steps, setup.settings.view_steps))),
      light_rule_(quadrature_block(rule_size(setup.settings.steps, setup.settings.light_steps))),
      view_nodes_(shared.objects.constants("view nodes", sizeof view_rule_)) {
    if (setup.table)
        table_.emplace(shared, transmittance_kernel(shared.quality));
    else
        light_nodes_ = shared.objects.constants("light nodes", sizeof light_rule_);
}

std::span<const std::string_view> SingleAir::passes() const noexcept {
    return table_ ? std::span(air_passes) : std::span<const std::string_view>();
}

void SingleAir::restart(const AtmosphereParameters&, const AtmosphereBlock&, const AtmosphereBlock&) { table_stale_ = true; }

void SingleAir::invalidate() noexcept {
    forget(view_nodes_);
    forget(light_nodes_);
    if (table_) table_->invalidate();
    table_stale_ = true;
}

bool SingleAir::record(rhi::CommandList& commands, const AtmosphereBlock&, std::span<PassReport> reports,
                       TimestampSlots timestamps) {
    bool changed = !ready();
    if (changed) {
        update_block(commands, view_nodes_, view_rule_);
        if (!table_) update_block(commands, light_nodes_, light_rule_);
    }
    if (table_ && table_stale_) {
        table_->record(commands, reports[0], timestamps, 0);
        changed = true;
    }
    table_stale_ = false;
    return changed;
}

std::unique_ptr<ModelView> SingleAir::make_view(ViewResources& shared, const ViewSettings& settings) {
    const rhi::Binding nodes{3, {}, {}, view_nodes_.handle};
    const rhi::Binding light =
        table_ ? rhi::Binding{4, table_->table().handle, shared_.linear, {}} : rhi::Binding{4, {}, {}, light_nodes_.handle};
    return std::make_unique<SingleView>(shared, setup_, std::vector{nodes, light}, settings.aerial_perspective);
}

std::vector<LightTexture> SingleAir::light_textures() {
    return table_ ? std::vector{LightTexture{&table_->table(), 1, 0}} : std::vector<LightTexture>{};
}

rhi::Texture SingleAir::transmittance_table() const noexcept { return table_ ? table_->table().handle : rhi::Texture{}; }

void check_steps(const std::string& field, Steps steps, int count) {
    if (steps == Steps::gauss)
        check(field, count, 2, max_nodes);
    else
        check(field, count, 1, 256);
}

void check_steps_kind(const std::string& field, Steps steps) {
    check_enum(field, steps, Steps::midpoints, "gauss or midpoints");
}

void check_dome(const std::string& field, const models::Dome& dome) {
    check_enum(field + ".phase", dome.phase, models::Dome::Phase::in_table, "at_look_up or in_table");
    check_table_format(field + ".format", dome.format);
    check(field + ".size.depth", dome.size.depth, 1, 1);
    if (!dome.used()) return;
    check(field + ".size.width", dome.size.width, 4, 4096);
    check(field + ".size.height", dome.size.height, 4, 4096);
    if (dome.size.height % 2 != 0)
        reject(field + ".size.height", std::to_string(dome.size.height), "an even number in [4, 4096]");
}

void require_dome(const rhi::Device& device, const models::Dome& dome) {
    if (!dome.used()) return;
    require_table(device, dome.format, rhi::Dimension::d2);
    require_size("device.max_texture_2d", device.capabilities().max_texture_2d, std::max(dome.size.width, dome.size.height));
}

}  // namespace detail

namespace models {

void validate(const SingleSettings& settings) {
    detail::check_steps_kind("single.steps", settings.steps);
    detail::check_steps("single.view_steps", settings.steps, settings.view_steps);
    detail::check_steps("single.light_steps", settings.steps, settings.light_steps);
    detail::check_dome("single.dome", settings.dome);
}

SingleSettings SingleSettings::by_name(std::string_view quality) {
    SingleSettings settings;
    if (quality == "default") return settings;
    if (quality == "low") {
        settings.view_steps = 6;
        settings.light_steps = 5;
        settings.dome.size = {24, 64, 1};
    } else if (quality == "high") {
        settings.view_steps = 12;
        settings.light_steps = 10;
    } else if (quality == "converged") {
        settings.view_steps = settings.light_steps = 16;
    } else {
        detail::reject_quality(quality);
    }
    return settings;
}

ModelPtr single(const SingleSettings& settings) { return std::make_shared<detail::SingleModel>(settings); }

}  // namespace models
}  // namespace aureole
