#include "models/reference/reference.h"

#include "common/check.h"
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

constexpr std::array<std::string_view, 1> film_pass{"film"};
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
    [[nodiscard]] std::unique_ptr<ModelAir> make_air(AirResources&, const AtmosphereParameters&) const override {
        return std::make_unique<ReferenceAir>(settings_);
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

Specialize specialization(const ReferenceSettings& s) {
    Specialize values;
    values.set(8, s.nodes).set(10, true).set(11, false);
    values.set(26, s.paths_per_frame).set(27, s.max_order).set(28, s.sampled_first_order).set(29, s.first_order_parts);
    values.set(30, s.roulette_order).set(31, s.seed).set(32, s.film_width > 0);
    values.set(33, s.show == ReferenceSettings::Show::standard_error).set(34, s.light_paths);
    return values;
}

}  // namespace

std::unique_ptr<ModelView> ReferenceAir::make_view(ViewResources& shared, const ViewSettings& settings) {
    return std::make_unique<ReferenceView>(shared, settings, settings_);
}

ReferenceView::ReferenceView(ViewResources& shared, const ViewSettings& view, const ReferenceSettings& settings)
    : settings_(settings),
      rule_(quadrature_block(settings.nodes)),
      quadrature_(shared.objects.constants("reference quadrature", sizeof rule_)) {
    if (has_film()) make_film(shared);
    const Specialize constants = specialization(settings);
    const auto values = constants.values();
    kernels_ = {.composite = &shaders::reference_composite,
                .composite_raster = &shaders::reference_composite_raster,
                .light = &shaders::reference_light,
                .tables = {{2, has_film() ? film_.handle : shared.air.profile_table.handle, shared.air.nearest, {}},
                           {11, {}, {}, quadrature_.handle}},
                .specialization = {values.begin(), values.end()},
                .aerial_perspective = view.aerial_perspective,
                .shadows = false};
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
                     rhi::Binding{7, shared.air.phase_table.handle, shared.air.nearest, {}},
                     rhi::Binding{10, shared.air.profile_table.handle, shared.air.nearest, {}},
                     rhi::Binding{11, {}, {}, quadrature_.handle}};
    start_ = shared.objects.bindings("film, new", pipeline_, slots);
    slots[2].texture = film_.handle;
    go_on_ = shared.objects.bindings("film", pipeline_, slots);
}

std::span<const std::string_view> ReferenceView::passes() const noexcept {
    return has_film() ? std::span<const std::string_view>(film_pass) : std::span<const std::string_view>();
}

void ReferenceView::update(const ViewBlock& before, const ViewBlock& fresh) noexcept {
    const ViewBlock one = for_paths(before), other = for_paths(fresh);
    if (std::memcmp(&one, &other, sizeof one) != 0) restart();
}

void ReferenceView::restart() noexcept {
    paths_ = 0;
    started_ = false;
}

void ReferenceView::invalidate() noexcept {
    forget(quadrature_);
    forget(film_);
    forget(next_);
    restart();
}

void ReferenceView::record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) {
    if (quadrature_.state == rhi::State::undefined) update_block(commands, quadrature_, rule_);
    const int more = std::min(settings_.paths_per_frame, settings_.max_paths - paths_);
    if (!has_film() || (more == 0 && started_)) return;
    PassScope scope(commands, reports[0], timestamps, 0);
    move(commands, {{&next_, rhi::State::storage_write}});
    const glm::vec4 push(static_cast<float>(paths_), static_cast<float>(more), 0.0F, 0.0F);
    scope.dispatch(shaders::reference_film, pipeline_, started_ ? go_on_ : start_,
                   {settings_.film_width, settings_.film_height, 1}, std::as_bytes(std::span(&push, 1)));
    move(commands, {{&film_, rhi::State::copy_destination}, {&next_, rhi::State::copy_source}});
    commands.copy(rhi::TextureToTexture{next_.handle, film_.handle});
    move(commands, {{&film_, rhi::State::sampled}});
    reports[0].bytes_written = next_.bytes + film_.bytes;
    paths_ += more;
    started_ = true;
}

bool ReferenceView::ready() const noexcept {
    return quadrature_.state != rhi::State::undefined && (!has_film() || film_.state != rhi::State::undefined);
}

}  // namespace detail

namespace models {

ModelPtr reference(const ReferenceSettings& settings) { return std::make_shared<detail::ReferenceModel>(settings); }

}  // namespace models
}  // namespace aureole
