#include "models/bruneton/bruneton.h"

#include "models/bruneton/extents.h"
#include "module/requirements.h"
#include "sky_view/sky_view.h"

#include "aureole_atmosphere_shaders.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace aureole {
namespace detail {
namespace {

using models::BrunetonSettings;

constexpr std::array<std::string_view, 2> air_passes{"transmittance", "precomputation"};
constexpr rhi::Usage copied_to = rhi::Usage::copy_destination | rhi::Usage::copy_source;

/// What the transmittance pass goes by; the rest is of no effect.
QualitySettings quality_of(const BrunetonSettings& settings) {
    QualitySettings quality;
    quality.name = "bruneton";
    quality.transmittance = settings.transmittance;
    quality.transmittance_nodes = settings.transmittance_nodes;
    return quality;
}

bool is_molecules(const DensityTerm& term) { return std::holds_alternative<RayleighPhase>(term.phase); }

/// The red, green and blue that air scatters, against what its molecules alone do, per vertical optical depth: the same ratio
/// for all three within a tenth. Most of layer 0 is light scattered once by molecules, or more than once by anything; where the
/// latter has another colour, green and blue of the aerosol's light are guessed from a wrong one.
bool scatters_as_molecules(const AtmosphereParameters& parameters) {
    AtmosphereParameters all = parameters;
    for (DensityTerm& term : all.terms) term.absorption_per_m = Rgb(0);
    AtmosphereParameters molecules = all;
    std::erase_if(molecules.terms, [](const DensityTerm& term) { return !is_molecules(term); });
    const Rgb whole = vertical_optical_depth(all), part = vertical_optical_depth(molecules);
    const auto alike = [&](int c) {
        const double here = whole[c] * part.r, red = whole.r * part[c];
        return here > 0 && red > 0 && here <= 1.1 * red && red <= 1.1 * here;
    };
    return alike(1) && alike(2);
}

/// Air of molecules and one other phase function, which leaves the colours nearly as they are.
bool combines(const BrunetonSettings& settings, const AirResources& shared, const AtmosphereParameters& parameters) {
    return settings.combined && !shared.summed && shared.air.phase_count == 2 && std::popcount(shared.air.sharp_phases) == 1 &&
           scatters_as_molecules(parameters);
}

class BrunetonModel final : public Model {
public:
    explicit BrunetonModel(const BrunetonSettings& settings) : settings_(settings), quality_(quality_of(settings)) {
        BrunetonModel::validate();
    }
    [[nodiscard]] std::string_view name() const noexcept override { return "bruneton"; }
    [[nodiscard]] const QualitySettings& quality() const noexcept override { return quality_; }
    [[nodiscard]] std::vector<ModelTable> tables_for(const AtmosphereParameters&) const override;
    void validate() const override { models::validate(settings_); }
    [[nodiscard]] bool by_tables() const noexcept override { return true; }
    void require(const rhi::Device& device) const override {
        const BrunetonSettings& s = settings_;
        require_table(device, quality_.table_format, rhi::Dimension::d2);
        require_table(device, s.format, rhi::Dimension::d3);
        require_table(device, rhi::Format::rgba32_float, rhi::Dimension::d3, false);
        const rhi::Capabilities& limits = device.capabilities();
        require_size("device.max_texture_2d", limits.max_texture_2d, std::max(s.transmittance.width, s.transmittance.height));
        // One layer of altitudes; make_air knows how many there are.
        const rhi::Extent table = bruneton_scattering_extent(s), field = bruneton_field_extent(s);
        require_size("device.max_texture_3d", limits.max_texture_3d,
                     std::max({table.width, table.height, table.depth, field.width, field.height}));
    }
    [[nodiscard]] std::unique_ptr<ModelAir> make_air(AirResources& shared,
                                                     const AtmosphereParameters& parameters) const override {
        const std::uint32_t layers = combines(settings_, shared, parameters) ? 1 : layers_with_sharp_phases(shared.air);
        require_size("device.max_texture_3d", shared.objects.device().capabilities().max_texture_3d,
                     static_cast<std::uint32_t>(settings_.altitude_nodes) * layers);
        return std::make_unique<BrunetonAir>(shared, parameters, settings_);
    }

private:
    BrunetonSettings settings_;
    QualitySettings quality_;
};

std::vector<ModelTable> BrunetonModel::tables_for(const AtmosphereParameters&) const {
    const BrunetonSettings& s = settings_;
    const auto count = [](int value) { return std::to_string(value); };
    const bool gauss = s.sampling == models::BrunetonSampling::gauss;
    return {{"transmittance table", s.transmittance, quality_.table_format, count(s.transmittance_nodes) + " nodes a ray"},
            {"irradiance table", s.irradiance, rhi::Format::rgba32_float, "of the sky, all orders"},
            {"scattering table", bruneton_scattering_extent(s), s.format,
             count(s.orders) + " orders, " + (gauss ? count(s.ray_nodes) + " nodes a piece of ray, " : "50 steps a ray, ") +
                 count(bruneton_directions(s).count()) + " directions"}};
}

/// `A` of the sun's axis (bruneton.glsl): how long the ray from the ground towards the lowest sun is.
double longest_sun_ray(const Planet& planet, double lowest_sun_deg) {
    const double bottom = planet.bottom_radius_m, shell = planet.top_radius_m - bottom;
    const double horizon = std::sqrt(shell * (2 * bottom + shell));
    // The top of the air sees the sun until it stands by the horizon's dip below the horizontal; two degrees more for twilight.
    const double dip = std::atan2(horizon, bottom);
    const double zenith = std::max(lowest_sun_deg * std::numbers::pi / 180,
                                   std::min(std::numbers::pi / 2 + dip + 2 * std::numbers::pi / 180, std::numbers::pi));
    const double b = bottom * std::cos(zenith);
    return (std::sqrt(b * b + horizon * horizon) - b - shell) / (horizon - shell);
}

/// Green and blue against red of what the aerosol scatters, over the same of the molecules.
glm::dvec2 colour_ratio(const AtmosphereParameters& parameters) {
    Rgb molecules(0), aerosol(0);
    for (const DensityTerm& term : parameters.terms)
        (is_molecules(term) ? molecules : aerosol) += term.scattering_per_m * term.scattering_scale;
    const auto over = [](double a, double b) { return b > 0 ? a / b : 0.0; };
    return {over(aerosol.g * molecules.r, aerosol.r * molecules.g), over(aerosol.b * molecules.r, aerosol.r * molecules.b)};
}

}  // namespace

BrunetonAir::BrunetonAir(AirResources& shared, const AtmosphereParameters& parameters, const BrunetonSettings& settings)
    : shared_(shared),
      settings_(settings),
      combined_(combines(settings, shared, parameters)),
      transmittance_(shared, transmittance_kernel(shared.quality), copied_to),
      solution_(shared, settings, combined_),
      front_(solution_.make_tables(shared.objects, transmittance_.table(), copied_to)),
      front_bindings_(solution_.bind(shared, front_)) {
    if (settings.slices_per_frame > 0) back_ = make_back();
}

std::span<const std::string_view> BrunetonAir::passes() const noexcept { return air_passes; }

void BrunetonAir::complete(const AtmosphereParameters& parameters, AtmosphereBlock& block) const noexcept {
    const glm::dvec2 ratio = colour_ratio(parameters);
    block.sun_mapping = {static_cast<float>(longest_sun_ray(parameters.planet, settings_.lowest_sun_deg)), 0,
                         static_cast<float>(ratio.x), static_cast<float>(ratio.y)};
}

bool BrunetonAir::fits(const AtmosphereParameters& parameters) const {
    return combines(settings_, shared_, parameters) == combined_;
}

void BrunetonAir::restart(const AtmosphereParameters&, const AtmosphereBlock& before, const AtmosphereBlock& fresh) {
    const bool same_planet = fresh.radii == before.radii;
    fits_ = fits_ && same_planet;
    working_ = working_ && same_planet;
    stale_ = true;
}

void BrunetonAir::invalidate() noexcept {
    transmittance_.invalidate();
    solution_.invalidate();
    forget(front_.scattering);
    forget(front_.irradiance);
    if (back_) {
        back_->transmittance->invalidate();
        forget(back_->block);
        forget(back_->profiles);
        forget(back_->phases);
        forget(back_->tables.scattering);
        forget(back_->tables.irradiance);
    }
    stale_ = true;
    working_ = shown_ = fits_ = false;
}

std::unique_ptr<BrunetonAir::Back> BrunetonAir::make_back() const {
    auto back = std::make_unique<Back>();
    back->objects = shared_.objects.sibling();
    back->block = back->objects->constants("bruneton air", sizeof(AtmosphereBlock));
    const auto table = [&](const char* name, const TrackedTexture& like) {
        return back->objects->texture({name, like.dimension, like.format, like.extent, rhi::Usage::sampled | copied_to});
    };
    back->profiles = table("bruneton profiles", shared_.profile_table);
    back->phases = table("bruneton phases", shared_.phase_table);
    back->shared.emplace(AirResources{*back->objects, shared_.air, shared_.quality, back->block, back->profiles, back->phases,
                                      shared_.has_profiles, shared_.linear, shared_.nearest, shared_.summed});
    back->transmittance.emplace(*back->shared, transmittance_kernel(shared_.quality));
    back->tables = solution_.make_tables(*back->objects, back->transmittance->table(), rhi::Usage::copy_source);
    back->bindings = solution_.bind(*back->shared, back->tables);
    return back;
}

void BrunetonAir::spread(int passes_per_frame, bool first_too) {
    const bool wanted = passes_per_frame > 0 || settings_.slices_per_frame > 0;
    if (wanted && !back_) back_ = make_back();
    if (!wanted && back_) {
        stale_ |= working_;
        working_ = false;
        back_.reset();
    }
    passes_per_frame_ = passes_per_frame;
    first_too_ = first_too;
}

int BrunetonAir::budget() const noexcept {
    return passes_per_frame_ > 0 ? passes_per_frame_ * settings_.altitude_nodes : settings_.slices_per_frame;
}

double BrunetonAir::progress() const noexcept {
    if (working_ && !stale_) return static_cast<double>(solution_.done()) / solution_.units();
    return stale_ ? 0 : 1;
}

std::uint64_t BrunetonAir::more_texture_bytes() const noexcept { return back_ ? back_->objects->texture_bytes() : 0; }

bool BrunetonAir::in_parts() const noexcept {
    const bool first_in_parts = !shown_ && (settings_.slices_per_frame > 0 || first_too_);
    return budget() > 0 && back_ && (fits_ || first_in_parts);
}

NewAir BrunetonAir::new_air() const noexcept {
    if (!in_parts()) return NewAir::shown;
    return working_ ? NewAir::later : NewAir::apart;
}

bool BrunetonAir::record(rhi::CommandList& commands, const AtmosphereBlock&, std::span<PassReport> reports,
                         TimestampSlots timestamps) {
    if (!stale_ && !working_) return false;
    if (in_parts()) return solve_a_part(commands, reports, timestamps);
    solve_at_once(commands, reports, timestamps);
    return true;
}

void BrunetonAir::solve_at_once(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) {
    transmittance_.record(commands, reports[0], timestamps, 0);
    PassScope scope(commands, reports[1], timestamps, 1);
    reports[1].bytes_written = 0;
    solution_.start();
    solution_.advance(commands, scope, reports[1], front_, front_bindings_, solution_.units());
    stale_ = working_ = false;
    shown_ = fits_ = true;
}

bool BrunetonAir::solve_a_part(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) {
    if (!working_) {
        back_->transmittance->record(commands, reports[0], timestamps, 0);
        solution_.start();
        working_ = true;
        stale_ = false;
    }
    {
        PassScope scope(commands, reports[1], timestamps, 1);
        reports[1].bytes_written = 0;
        solution_.advance(commands, scope, reports[1], back_->tables, back_->bindings, budget());
    }
    if (!solution_.finished()) return false;
    show(commands);
    return true;
}

void BrunetonAir::show(rhi::CommandList& commands) {
    copy_texture(commands, back_->transmittance->table(), transmittance_.table());
    copy_texture(commands, back_->tables.scattering, front_.scattering);
    copy_texture(commands, back_->tables.irradiance, front_.irradiance);
    working_ = false;
    shown_ = fits_ = true;
}

std::unique_ptr<ModelView> BrunetonAir::make_view(ViewResources& shared, const ViewSettings& settings) {
    return std::make_unique<BrunetonView>(shared, settings, settings_, front_, solution_.look_up());
}

}  // namespace detail

namespace models {

ModelPtr bruneton(const BrunetonSettings& settings) { return std::make_shared<detail::BrunetonModel>(settings); }

}  // namespace models
}  // namespace aureole
