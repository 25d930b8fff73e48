#include "module/air.h"
#include "module/requirements.h"
#include "module/told.h"

#include "aerial_perspective/aerial_perspective.h"
#include "camera/pack_view.h"
#include "common/check.h"
#include "composite/composite.h"
#include "envelope/tell.h"
#include "light/light.h"
#include "shadows/shadows.h"

#include <aureole/rhi/log.h>

#include <spdlog/logger.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

namespace aureole {
namespace detail {
namespace {

/// All device objects of a view that depend on the air.
struct ViewTables {
    ViewTables(AirTables& air, const ViewSettings& settings, const CompositeSettings& composite_settings,
               rhi::Texture shadow_map)
        : objects(air.objects.sibling()),
          block_buffer(objects->constants("view", sizeof(ViewBlock))),
          shared{*objects, air.shared, block_buffer, settings.max_suns, settings.projection},
          model(air.model->make_view(shared, settings)),
          light(shared, model->kernels(), settings.light),
          shadows(shared, model->kernels(), settings.shadows, air.model->transmittance_table()),
          composite(shared, model->kernels(), shadows, composite_settings) {
        if (shadow_map) shadows.use_map(shadow_map);
    }

    void invalidate() noexcept {
        forget(block_buffer);
        model->invalidate();
        light.invalidate();
        shadows.invalidate();
        composite.invalidate();
    }

    std::unique_ptr<Objects> objects;
    TrackedBuffer block_buffer;
    ViewResources shared;
    std::unique_ptr<ModelView> model;
    LightPass light;
    ShadowPass shadows;
    CompositePass composite;
};

void check_view(const ViewSettings& settings) {
    check_enum("view.projection", settings.projection, Projection::fisheye, "matrix, panorama or fisheye");
    check("view.max_suns", settings.max_suns, 1, max_suns);
    check("view.aerial_perspective_distance_m", settings.aerial_perspective_distance_m, 1e-3, 1e13);
    validate(settings.shadows);
}

void check_shadows(const Atmosphere::Impl& air, const ViewSettings& settings) {
    if (settings.shadows.cascades > 0 && !air.model->has_shadows())
        throw Error(ErrorCode::unsupported, "view.shadows.cascades", std::to_string(settings.shadows.cascades),
                    "0 with the model " + std::string(air.model->name()) +
                        ", whose light is not made of single scattering and the rest");
}

// Blocks are floats without gaps; what is to be known is whether the device has the same bits.
// NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
bool same_block(const ViewBlock& a, const ViewBlock& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// The block without what the light does not depend on: where the camera looks, and how the picture is shown.
ViewBlock for_light(ViewBlock block) {
    block.composite = block.ray_origin = block.ray_x = block.ray_y = block.depth = glm::vec4(0);
    return block;
}

constexpr const char* projection_names[] = {"matrix", "panorama", "fisheye"};

}  // namespace
}  // namespace detail

struct View::Impl final : detail::AirUser {
    Impl(Atmosphere::Impl& air_in, const ViewSettings& settings_in, const CompositeSettings& composite_in)
        : air(air_in), settings(settings_in), composite(composite_in) {
        detail::check_view(settings);
        detail::check_shadows(air, settings);
        detail::validate(composite);
        detail::require_target(air.device, composite);
        tables = std::make_unique<detail::ViewTables>(*air.tables, settings, composite, shadow_map.texture);
        for (const std::string_view name : tables->model->passes()) reports.emplace_back().name = name;
        if (tables->shadows.enabled()) reports.emplace_back().name = "shadows";
        reports.emplace_back().name = "light";
        reports.emplace_back().name = "composite";
        suns.reserve(settings.max_suns);
        air.users.push_back(this);
    }
    ~Impl() override { std::erase(air.users, this); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void prepare(detail::AirTables& new_air) override {
        pending = std::make_unique<detail::ViewTables>(new_air, settings, composite, shadow_map.texture);
        pending->composite.prepare_as(tables->composite);
    }
    void commit() noexcept override {
        tables = std::move(pending);
        stale();
    }
    void abandon() noexcept override { pending.reset(); }
    void stale() noexcept {
        tables->model->restart();
        light_stale = block_stale = shadows_stale = true;
    }
    [[nodiscard]] std::size_t shadow_pass() const noexcept { return reports.size() - 3; }  // if there is one
    [[nodiscard]] std::size_t light_pass() const noexcept { return reports.size() - 2; }
    [[nodiscard]] std::size_t composite_pass() const noexcept { return reports.size() - 1; }

    void invalidate() noexcept override {
        tables->invalidate();
        stale();
    }
    void refresh() override {
        if (updated) use(pack(camera, suns), camera);
    }
    [[nodiscard]] detail::ViewBlock pack(const Camera& by, std::span<const Sun> lit) const {
        detail::ViewInputs inputs;
        inputs.aerial_perspective_distance_m = settings.aerial_perspective_distance_m;
        inputs.exposure = composite.exposure;
        inputs.sun_lobe_g = composite.sun_lobe_g;
        inputs.shadow_distance_m = settings.shadows.distance_m;
        inputs.shadowed_sun = shadow_map.sun;
        validate(by);
        if (by.kind != settings.projection)
            detail::reject(
                "camera.kind", detail::projection_names[static_cast<int>(by.kind)],
                std::string("ViewSettings::projection, ") + detail::projection_names[static_cast<int>(settings.projection)]);
        for (const Sun& sun : lit) validate(sun);
        return detail::pack_view(by, lit, air.parameters.planet, inputs);
    }
    /// A position relative to a world's origin on the ground is not wrong in itself, but nobody means it.
    void tell_if_deep(const Camera& by) {
        const double distance = glm::length(by.position_m), radius = air.parameters.planet.bottom_radius_m;
        const bool is_deep = distance < radius / 2;
        if (is_deep && !deep)
            log()->warn(
                "camera.position_m: {} m from the planet's centre, the ground is at {} m; it is in metres, relative to that "
                "centre "
                "(kilometres? the radius not added?)",
                detail::print(distance), detail::print(radius));
        deep = is_deep;
    }
    void use(const detail::ViewBlock& fresh, const Camera& by) {
        if (tables->shadows.enabled()) {
            const detail::ShadowBlock shadows = detail::pack_shadows(shadow_map, settings.shadows.cascades, by.position_m);
            // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): as above
            shadows_stale |= std::memcmp(&shadows, &shadow_block, sizeof shadows) != 0 || !detail::same_froxels(fresh, block);
            shadow_block = shadows;
        }
        block_stale |= !detail::same_block(fresh, block);
        tables->model->update(block, fresh);
        light_stale |= !detail::same_block(detail::for_light(fresh), detail::for_light(block));
        block = fresh;
    }

    Atmosphere::Impl& air;
    ViewSettings settings;
    CompositeSettings composite;
    std::unique_ptr<detail::ViewTables> tables, pending;
    detail::ViewBlock block{};
    bool updated = false;
    bool deep = false;  // the camera is nearer to the planet's centre than to its ground
    detail::Teller teller{air.tellers};
    detail::Told before_update, before_air, before_record;
    detail::ToldTargets unprepared;
    bool light_stale = true, block_stale = true, shadows_stale = true;
    ShadowMap shadow_map;
    detail::ShadowBlock shadow_block{};
    std::uint64_t air_version = 0;
    Camera camera;
    std::vector<Sun> suns;
    std::vector<PassReport> reports;
};

View::View(Atmosphere& atmosphere, const ViewSettings& settings, const CompositeSettings& composite)
    : impl_(std::make_unique<Impl>(atmosphere.impl(), settings, composite)) {}
View::~View() = default;

void View::update(const Camera& camera, std::span<const Sun> suns) {
    Impl& impl = *impl_;
    if (suns.size() > impl.settings.max_suns)
        detail::reject("suns", std::to_string(suns.size()) + " of them",
                       "at most " + std::to_string(impl.settings.max_suns) + ", ViewSettings::max_suns");
    impl.use(impl.pack(camera, suns), camera);
    impl.tell_if_deep(camera);
    KeptInTables kept = impl.air.kept_in_tables;
    kept.half_difference &= impl.composite.scene_depth && impl.settings.aerial_perspective;
    impl.teller.tell(outside_envelope(impl.air.parameters.planet, camera, suns, kept));
    impl.camera = camera;
    impl.suns.assign(suns.begin(), suns.end());
    impl.updated = true;
}

void View::set_exposure(double exposure) {
    CompositeSettings changed = impl_->composite;
    changed.exposure = exposure;
    detail::validate(changed);
    impl_->composite = changed;
    impl_->refresh();
}

void View::set_shadow_map(const ShadowMap& map) {
    Impl& impl = *impl_;
    detail::validate(map, impl.settings.shadows, impl.settings.max_suns, impl.air.device);
    detail::ViewTables& tables = *impl.tables;
    if (map.texture != tables.shadows.map()) {
        auto composites = tables.composite.prepared_with(map.texture);
        tables.shadows.use_map(map.texture);
        tables.composite.use(std::move(composites));
    }
    impl.shadow_map = map;
    impl.shadows_stale = true;  // what it shows is another picture, as far as anyone knows
    impl.refresh();
}

void View::record(rhi::CommandList& commands, TimestampSlots timestamps) {
    Impl& impl = *impl_;
    detail::ViewTables& tables = *impl.tables;
    for (std::size_t i = 0; i <= impl.light_pass(); ++i) impl.reports[i].recorded = false;
    if (impl.before_update.begins(!impl.updated)) log()->error("View::record: called before View::update; nothing is recorded");
    if (!impl.updated) return;
    const bool early = !impl.air.tables->recorded();
    if (impl.before_air.begins(early)) log()->error("View::record: called before Atmosphere::record; nothing is recorded");
    if (early) return;
    if (impl.air.tables->version != impl.air_version) impl.stale();
    impl.air_version = impl.air.tables->version;
    if (impl.block_stale) detail::update_block(commands, tables.block_buffer, impl.block);
    tables.model->record(commands, impl.reports, timestamps);
    if (impl.shadows_stale && tables.shadows.enabled()) {
        const std::size_t shadows = impl.shadow_pass();
        tables.shadows.record(commands, impl.shadow_block, impl.reports[shadows], timestamps,
                              static_cast<std::uint32_t>(shadows));
    }
    const std::size_t light = impl.light_pass();
    if (impl.light_stale && tables.light.enabled())
        tables.light.record(commands, impl.reports[light], timestamps, static_cast<std::uint32_t>(light));
    impl.light_stale = impl.block_stale = impl.shadows_stale = false;
}

void View::invalidate() noexcept { impl_->invalidate(); }

void View::prepare_composite(const CompositeTargets& targets) {
    impl_->tables->composite.prepare(targets);
    impl_->unprepared.end(targets);
}

void View::release_composite(const CompositeTargets& targets) noexcept { impl_->tables->composite.release(targets); }

void View::record_composite(rhi::CommandList& commands, const CompositeTargets& targets, TimestampSlots timestamps) {
    Impl& impl = *impl_;
    const std::size_t pass = impl.composite_pass();
    impl.reports[pass].recorded = false;
    if (!impl.tables->composite.prepared(targets)) {
        if (impl.unprepared.begins(targets))
            log()->error("View::record_composite: these targets were not given to prepare_composite; nothing is recorded");
        return;
    }
    const bool early = impl.tables->block_buffer.state == rhi::State::undefined || !impl.tables->model->ready();
    if (impl.before_record.begins(early))
        log()->error("View::record_composite: called before View::record; nothing is recorded");
    if (early) return;
    const bool from_space = impl.block.camera.w > 0.5F;
    impl.tables->composite.record(commands, targets, from_space, impl.air.frame, impl.reports[pass], timestamps,
                                  static_cast<std::uint32_t>(pass));
}

std::span<const PassReport> View::reports() const noexcept { return impl_->reports; }
rhi::Texture View::sky_view_table() const noexcept { return impl_->tables->model->sky_view_table(); }
rhi::Texture View::aerial_perspective_table() const noexcept { return impl_->tables->model->aerial_perspective_table(); }
rhi::Texture View::film_table() const noexcept { return impl_->tables->model->film_table(); }
rhi::Texture View::light_table() const noexcept { return impl_->tables->light.table().handle; }
rhi::Buffer View::air_block() const noexcept { return impl_->tables->shared.air.block.handle; }
rhi::Buffer View::view_block() const noexcept { return impl_->tables->block_buffer.handle; }
rhi::Texture View::phase_table() const noexcept { return impl_->tables->shared.air.phase_table.handle; }
rhi::Texture View::profile_table() const noexcept { return impl_->tables->shared.air.profile_table.handle; }
std::vector<rhi::Specialization> View::shader_constants() const {
    const detail::ModelView& model = *impl_->tables->model;
    detail::Specialize constants = impl_->tables->shared.specialize();
    constants.set(7, false);  // the azimuth axis of sky_view.glsl, where the model does not say otherwise
    for (const rhi::Specialization& s : model.kernels().specialization) constants.set(s);
    constants.set(25,
                  model.kernels().aerial_perspective && model.aerial_perspective_table());  // HAS_FROXELS of host/aureole.glsl
    return {constants.values().begin(), constants.values().end()};
}
std::string View::shader_defines() const {
    std::string text;
    for (const rhi::Specialization& s : shader_constants())
        text += "#define AUREOLE_SPEC_" + std::to_string(s.id) + " " + std::to_string(static_cast<std::int32_t>(s.bits)) + "\n";
    return text;
}
std::uint64_t View::table_bytes() const noexcept { return impl_->tables->objects->texture_bytes(); }

}  // namespace aureole
