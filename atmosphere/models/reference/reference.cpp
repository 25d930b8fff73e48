#include "models/reference/reference.h"

#include "common/check.h"
#include "light/light.h"
#include "module/requirements.h"
#include "quadrature/gauss_legendre.h"

#include "aureole_atmosphere_shaders.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace aureole {
namespace detail {
namespace {

using models::ReferenceSettings;

constexpr std::array<std::string_view, 2> pass_names{"film", "light paths"};
constexpr std::array<std::string_view, 1> air_pass_names{"profile bends"};
constexpr std::uint32_t bend_block = 64;  // bends.glsl
constexpr std::uint32_t film_layers = 3;  // film.glsl

class ReferenceModel final : public Model {
public:
    explicit ReferenceModel(const ReferenceSettings& settings) : settings_(settings) { ReferenceModel::validate(); }
    [[nodiscard]] std::string_view name() const noexcept override { return "reference"; }
    [[nodiscard]] const QualitySettings& quality() const noexcept override { return quality_; }
    void validate() const override { settings_.validate(); }
    void require(const rhi::Device& device) const override {
        const std::uint32_t rows = film_layers * settings_.film_height;
        const std::uint32_t limit = device.capabilities().max_texture_2d;
        if (std::max(settings_.film_width, rows) > limit)
            throw Error(ErrorCode::unsupported, "device.max_texture_2d", std::to_string(limit),
                        "at least film_width and three times film_height of ReferenceSettings, " +
                            std::to_string(settings_.film_width) + " and " + std::to_string(rows));
    }
    [[nodiscard]] bool has_shadows() const noexcept override { return false; }
    [[nodiscard]] std::unique_ptr<ModelAir> make_air(AirResources& shared, const AtmosphereParameters&) const override {
        return std::make_unique<ReferenceAir>(shared, settings_);
    }

private:
    ReferenceSettings settings_;
    QualitySettings quality_;
};

/// The block without what paths do not depend on: how the picture is shown, how suns look, what froxels and depth are.
ViewBlock for_paths(ViewBlock block) {
    block.composite = block.depth = block.froxels = glm::vec4(0);
    block.table_exposure = block.table_exposure_inverse = glm::vec4(0);
    for (int sun = 0; sun < max_suns; ++sun) block.sun_disk[sun] = block.sun_limb[sun] = glm::vec4(0);
    return block;
}

bool is_tracked(const ReferenceSettings& s) { return s.tracking == ReferenceSettings::Tracking::ratio; }

/// Paths of one invocation: reference.md says what limits them.
int most_paths(const ReferenceSettings& s) { return is_tracked(s) ? 8 : 32; }
/// Invocations that share the paths of a direction of the light.
int light_parts(const ReferenceSettings& s) {
    const int most = most_paths(s);
    return std::max((s.light_paths + most - 1) / most, 1);
}

Specialize specialization(const ReferenceSettings& s) {
    Specialize values;
    values.set(8, s.nodes).set(10, true).set(11, false);
    values.set(26, s.paths_per_frame)
        .set(27, s.max_order)
        .set(28, s.sampled_first_order || is_tracked(s))
        .set(29, s.first_order_parts);
    values.set(30, s.roulette_order).set(31, s.seed).set(32, s.film_width > 0);
    values.set(33, s.show == ReferenceSettings::Show::standard_error);
    values.set(34, s.light_paths).set(35, light_parts(s)).set(36, is_tracked(s));
    return values;
}
/// The same without what the light's directions do not depend on: where the camera looks, and how bright suns are.
ViewBlock for_light_paths(const ViewBlock& block) {
    ViewBlock result = for_paths(block);
    result.ray_origin = result.ray_x = result.ray_y = glm::vec4(0);
    for (glm::vec4& irradiance : result.sun_irradiance) irradiance = glm::vec4(0);
    return result;
}
bool same_block(const ViewBlock& a, const ViewBlock& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

ReferenceAir::ReferenceAir(AirResources& shared, const ReferenceSettings& settings)
    : settings_(settings), has_bends_(is_tracked(settings) && shared.has_profiles) {
    if (!has_bends_) return;
    const rhi::Extent profiles = shared.profile_table.extent;
    const rhi::Extent extent{(profiles.width + bend_block - 1) / bend_block, profiles.height, 1};
    bends_ = shared.objects.texture(
        {"profile bends", rhi::Dimension::d2, rhi::Format::rgba32_float, extent, rhi::Usage::sampled | rhi::Usage::storage});
    pipeline_ = shared.objects.compute(shaders::reference_bends, {});
    const rhi::Binding slots[] = {{0, shared.profile_table.handle, shared.nearest, {}}, {1, bends_.handle, {}, {}}};
    bindings_ = shared.objects.bindings("profile bends", pipeline_, slots);
}

std::span<const std::string_view> ReferenceAir::passes() const noexcept {
    return std::span(air_pass_names).first(has_bends_ ? 1 : 0);
}

void ReferenceAir::restart(const AtmosphereParameters& /*parameters*/, const AtmosphereBlock& /*before*/,
                           const AtmosphereBlock& /*fresh*/) {
    stale_ = true;
}

bool ReferenceAir::record(rhi::CommandList& commands, const AtmosphereBlock& /*block*/, std::span<PassReport> reports,
                          TimestampSlots timestamps) {
    if (!has_bends_ || (!stale_ && ready())) return false;
    PassScope scope(commands, reports[0], timestamps, 0);
    move(commands, {{&bends_, rhi::State::storage_write}});
    scope.dispatch(shaders::reference_bends, pipeline_, bindings_, bends_.extent);
    move(commands, {{&bends_, rhi::State::sampled}});
    reports[0].bytes_written = bends_.bytes;
    stale_ = false;
    return true;
}

std::unique_ptr<ModelView> ReferenceAir::make_view(ViewResources& shared, const ViewSettings& settings) {
    return std::make_unique<ReferenceView>(shared, settings, settings_,
                                           has_bends_ ? bends_.handle : shared.air.profile_table.handle);
}

ReferenceView::ReferenceView(ViewResources& shared, const ViewSettings& view, const ReferenceSettings& settings,
                             rhi::Texture bends)
    : settings_(settings),
      bends_(bends),
      rule_(quadrature_block(settings.nodes)),
      quadrature_(shared.objects.constants("reference quadrature", sizeof rule_)),
      has_light_(view.light) {
    if (has_film()) make_film(shared);
    if (has_light_) make_light(shared);
    const Specialize constants = specialization(settings);
    const auto values = constants.values();
    kernels_ = {.composite = &shaders::reference_composite,
                .composite_raster = &shaders::reference_composite_raster,
                .light = &shaders::reference_light,
                .tables = {{2, has_film() ? film_.handle : shared.air.profile_table.handle, shared.air.nearest, {}},
                           bends_binding(shared),
                           {11, {}, {}, quadrature_.handle}},
                .specialization = {values.begin(), values.end()},
                .aerial_perspective = view.aerial_perspective};
    if (has_light_) kernels_.tables.push_back({3, light_.handle, shared.air.nearest, {}});
}

void ReferenceView::make_film(ViewResources& shared) {
    const rhi::Extent extent{settings_.film_width, film_layers * settings_.film_height, 1};
    constexpr auto copied = rhi::Usage::copy_source | rhi::Usage::copy_destination;
    film_ =
        shared.objects.texture({"film", rhi::Dimension::d2, rhi::Format::rgba32_float, extent, rhi::Usage::sampled | copied});
    next_ = shared.objects.texture(
        {"film, next", rhi::Dimension::d2, rhi::Format::rgba32_float, extent, rhi::Usage::storage | rhi::Usage::copy_source});
    Specialize values = shared.specialize();
    const Specialize constants = specialization(settings_);
    for (const rhi::Specialization& value : constants.values()) values.set(value);
    pipeline_ = shared.objects.compute(shaders::reference_film, values.values());
    std::array slots{rhi::Binding{0, {}, {}, shared.air.block.handle},
                     rhi::Binding{1, {}, {}, shared.block.handle},
                     rhi::Binding{2, shared.air.profile_table.handle, shared.air.nearest, {}},
                     rhi::Binding{3, next_.handle, {}, {}},
                     bends_binding(shared),
                     rhi::Binding{7, shared.air.phase_table.handle, shared.air.nearest, {}},
                     rhi::Binding{10, shared.air.profile_table.handle, shared.air.nearest, {}},
                     rhi::Binding{11, {}, {}, quadrature_.handle},
                     shared.triplet_binding()};
    start_ = shared.objects.bindings("film, new", pipeline_, slots);
    slots[2].texture = film_.handle;
    go_on_ = shared.objects.bindings("film", pipeline_, slots);
}

void ReferenceView::make_light(ViewResources& shared) {
    Specialize values = light_specialization(shared);
    const Specialize constants = specialization(settings_);
    for (const rhi::Specialization& value : constants.values()) values.set(value);
    zenith_rule_ = quadrature_block(light_zeniths);
    zeniths_ = shared.objects.constants("light paths quadrature", sizeof zenith_rule_);
    light_ = shared.objects.texture({"light paths",
                                     rhi::Dimension::d2,
                                     rhi::Format::rgba32_float,
                                     {light_directions, shared.suns * static_cast<std::uint32_t>(light_parts(settings_)), 1},
                                     rhi::Usage::sampled | rhi::Usage::storage});
    light_pipeline_ = shared.objects.compute(shaders::reference_light_paths, values.values());
    light_bindings_ = shared.objects.bindings("light paths", light_pipeline_,
                                              {{0, {}, {}, shared.air.block.handle},
                                               {1, {}, {}, shared.block.handle},
                                               bends_binding(shared),
                                               {7, shared.air.phase_table.handle, shared.air.nearest, {}},
                                               {8, {}, {}, zeniths_.handle},
                                               {9, light_.handle, {}, {}},
                                               {10, shared.air.profile_table.handle, shared.air.nearest, {}},
                                               {11, {}, {}, quadrature_.handle},
                                               shared.triplet_binding()});
}

std::span<const std::string_view> ReferenceView::passes() const noexcept {
    return std::span(pass_names).subspan(has_film() ? 0 : 1, std::size_t{has_film()} + std::size_t{has_light_});
}

void ReferenceView::update(const ViewBlock& before, const ViewBlock& fresh) noexcept {
    if (!same_block(for_paths(before), for_paths(fresh))) restart_film();
    if (!same_block(for_light_paths(before), for_light_paths(fresh))) light_stale_ = true;
}

void ReferenceView::restart_film() noexcept {
    paths_ = 0;
    started_ = false;
}

void ReferenceView::restart() noexcept {
    restart_film();
    light_stale_ = true;
}

void ReferenceView::invalidate() noexcept {
    forget(quadrature_);
    forget(film_);
    forget(next_);
    forget(zeniths_);
    forget(light_);
    restart();
}

void ReferenceView::record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) {
    if (quadrature_.state == rhi::State::undefined) update_block(commands, quadrature_, rule_);
    if (film_due()) record_film(commands, reports[0], timestamps);
    if (has_light_ && light_stale_) {
        const std::uint32_t pass = has_film() ? 1 : 0;
        record_light(commands, reports[pass], timestamps, pass);
    }
}

void ReferenceView::record_film(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps) {
    PassScope scope(commands, report, timestamps, 0);
    report.bytes_written = 0;
    int left = std::min(settings_.paths_per_frame, settings_.max_paths - paths_);
    do {  // once without paths: for what is known without them
        const int count = std::min(left, most_paths(settings_));
        move(commands, {{&next_, rhi::State::storage_write}});
        const glm::vec4 push(static_cast<float>(paths_), static_cast<float>(count), 0.0F, 0.0F);
        scope.dispatch(shaders::reference_film, pipeline_, started_ ? go_on_ : start_,
                       {settings_.film_width, settings_.film_height, 1}, std::as_bytes(std::span(&push, 1)));
        move(commands, {{&film_, rhi::State::copy_destination}, {&next_, rhi::State::copy_source}});
        commands.copy(rhi::TextureToTexture{next_.handle, film_.handle});
        move(commands, {{&film_, rhi::State::sampled}});
        report.bytes_written += next_.bytes + film_.bytes;
        started_ = true;
        paths_ += count;
        left -= count;
    } while (left > 0);
}

void ReferenceView::record_light(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps,
                                 std::uint32_t index) {
    if (zeniths_.state == rhi::State::undefined) update_block(commands, zeniths_, zenith_rule_);
    PassScope scope(commands, report, timestamps, index);
    move(commands, {{&light_, rhi::State::storage_write}});
    scope.dispatch(shaders::reference_light_paths, light_pipeline_, light_bindings_, light_.extent);
    move(commands, {{&light_, rhi::State::sampled}});
    report.bytes_written = light_.bytes;
    light_stale_ = false;
}

bool ReferenceView::film_due() const noexcept {
    const bool more = paths_ < settings_.max_paths && settings_.paths_per_frame > 0;
    return has_film() && (more || !started_);
}

bool ReferenceView::due() const noexcept {
    return quadrature_.state == rhi::State::undefined || film_due() || (has_light_ && light_stale_);
}

bool ReferenceView::ready() const noexcept {
    return quadrature_.state != rhi::State::undefined && (!has_film() || film_.state != rhi::State::undefined);
}

}  // namespace detail

namespace models {

ModelPtr reference(const ReferenceSettings& settings) { return std::make_shared<detail::ReferenceModel>(settings); }

}  // namespace models
}  // namespace aureole
