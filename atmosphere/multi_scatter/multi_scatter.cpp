#include "multi_scatter/multi_scatter.h"

#include "multi_scatter/extents.h"
#include "multi_scatter/order_ratio.h"
#include "quadrature/gauss_legendre.h"

#include "aureole_atmosphere_shaders.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aureole::detail {
namespace {

constexpr rhi::Usage table_usage = rhi::Usage::sampled | rhi::Usage::storage;
constexpr rhi::Usage copied_usage = rhi::Usage::sampled | rhi::Usage::copy_destination;

/// Rays and sums are fetched texel by texel.
constexpr rhi::Format moment_format = rhi::Format::rgba32_float;

/// The table and the orders of scattering are filtered. Its logarithms lose up to half a percent in half floats, which serve
/// only where nothing better can be filtered (some phones).
rhi::Format table_format(const rhi::Device& device) {
    const bool filtered = device.format_support(rhi::Format::rgba32_float, rhi::Dimension::d2).linear_filter;
    return filtered ? rhi::Format::rgba32_float : rhi::Format::rgba16_float;
}

/// Highest Legendre degree of the phase function that `azimuths` directions on a half circle can tell from lower ones, when the
/// result is wanted up to degree 2 or so.
int sharpest_degree(int azimuths) { return std::clamp(2 * azimuths - 3, 2, 11); }

}  // namespace

glm::vec4 sun_mapping(const Planet& planet) {
    const double ratio = planet.bottom_radius_m / planet.top_radius_m;
    const double dip_sine = std::sqrt((1 - ratio) * (1 + ratio));
    const double centre = -0.2 * dip_sine;
    // A thin shell's dip is next to nothing, but the field by day still changes over the whole range of cosines.
    const double width = std::max(0.8 * dip_sine, 0.1);
    const auto axis = [&](double mu) { return (mu - centre) / (width + std::abs(mu - centre)); };
    return {static_cast<float>(centre), static_cast<float>(width), static_cast<float>(axis(-1)), static_cast<float>(axis(1))};
}

MultiScatterPass::MultiScatterPass(AirResources& shared, TrackedTexture& transmittance, double ratio)
    : shared_(shared), transmittance_(transmittance), ratio_(ratio) {
    table_ = shared.objects.texture({"multi_scatter", rhi::Dimension::d2, table_format(shared.objects.device()),
                                     multi_scatter_table_extent(shared.quality), table_usage});
    create();
}

int MultiScatterPass::passes_wanted() const noexcept { return passes_for(ratio_, shared_.quality.multi_scatter_orders); }
int MultiScatterPass::passes_of_slowest() const noexcept {
    return passes_for(std::max(ratio_, shared_.slowest_order_ratio), shared_.quality.multi_scatter_orders);
}

MultiScatterPass::Inputs MultiScatterPass::live() const {
    return {shared_.block.handle, shared_.profile_table.handle, transmittance_.handle};
}

void MultiScatterPass::create() {
    Objects& objects = shared_.objects;
    const QualitySettings& quality = shared_.quality;
    rays_ = objects.texture(
        {"multi_scatter rays", rhi::Dimension::d2, moment_format, multi_scatter_rays_extent(quality), table_usage});
    const rhi::Format order_format = table_format(objects.device());  // filtered too, as the source of the next order
    for (int i = 0; i < 2; ++i) {
        order_[i] = objects.texture({"multi_scatter order", rhi::Dimension::d2, order_format, table_.extent, table_usage});
        sum_[i] = objects.texture({"multi_scatter sum", rhi::Dimension::d2, moment_format, table_.extent, table_usage});
    }
    first_rule_ = quadrature_block(quality.multi_scatter_nodes);
    later_rule_ = quadrature_block(quality.multi_scatter_later_nodes);
    zenith_rule_ = quadrature_block(quality.multi_scatter_zenith);
    first_quadrature_ = objects.constants("multi_scatter ray quadrature", sizeof first_rule_);
    later_quadrature_ = objects.constants("multi_scatter later quadrature", sizeof later_rule_);
    zenith_quadrature_ = objects.constants("multi_scatter zenith quadrature", sizeof zenith_rule_);

    const auto rays_values = [&](bool first) {
        return Specialize(shared_.air)
            .set(8, first ? quality.multi_scatter_nodes : quality.multi_scatter_later_nodes)
            .set(9, quality.angular_order)
            .set(10, first)
            .set(11, !first)
            .set(43, quality.ground_light)
            .set(12, quality.multi_scatter_zenith)
            .set(13, quality.multi_scatter_azimuth)
            .set(14, sharpest_degree(quality.multi_scatter_azimuth));
    };
    first_rays_ = objects.compute(shaders::multi_scatter_rays, rays_values(true).values());
    next_rays_ = objects.compute(shaders::multi_scatter_rays, rays_values(false).values());
    moments_ = objects.compute(shaders::multi_scatter_moments, Specialize(shared_.air)
                                                                   .set(9, quality.angular_order)
                                                                   .set(12, quality.multi_scatter_zenith)
                                                                   .set(13, quality.multi_scatter_azimuth)
                                                                   .values());
    live_ = bind(objects, live());
}

MultiScatterPass::Bindings MultiScatterPass::bind(Objects& objects, const Inputs& inputs) const {
    const auto ray_set = [&](rhi::Pipeline pipeline, const TrackedBuffer& quadrature, rhi::Texture source) {
        return objects.bindings("multi_scatter rays", pipeline,
                                {{0, {}, {}, inputs.block},
                                 {1, {}, {}, quadrature.handle},
                                 {2, inputs.profiles, shared_.nearest, {}},
                                 {3, inputs.transmittance, shared_.linear, {}},
                                 {4, source, shared_.linear, {}},
                                 {5, {}, {}, zenith_quadrature_.handle},
                                 {6, rays_.handle, {}, {}}});
    };
    const auto moment_set = [&](const TrackedTexture& order, const TrackedTexture& sum, const TrackedTexture& order_out,
                                const TrackedTexture& sum_out) {
        return objects.bindings("multi_scatter moments", moments_,
                                {{0, {}, {}, inputs.block},
                                 {1, {}, {}, zenith_quadrature_.handle},
                                 {2, rays_.handle, shared_.nearest, {}},
                                 {3, order.handle, shared_.nearest, {}},
                                 {4, sum.handle, shared_.nearest, {}},
                                 {5, order_out.handle, {}, {}},
                                 {6, sum_out.handle, {}, {}}});
    };
    Bindings sets;
    // The first pass has no source; any table that is readable stands in its slots.
    sets.first_rays = ray_set(first_rays_, first_quadrature_, inputs.transmittance);
    sets.first_moments = moment_set(rays_, rays_, order_[0], sum_[0]);
    for (int i = 0; i < 2; ++i) {
        sets.next_rays[i] = ray_set(next_rays_, later_quadrature_, order_[i].handle);
        for (int last = 0; last < 2; ++last)
            sets.moments[last][i] = moment_set(order_[1 - i], sum_[1 - i], order_[i], last == 1 ? table_ : sum_[i]);
    }
    return sets;
}

void MultiScatterPass::keep_copy(bool wanted) {
    if (wanted && !copy_) {
        auto copy = std::make_unique<Copy>();
        copy->objects = shared_.objects.sibling();
        copy->block = copy->objects->constants("multi_scatter air", sizeof(AtmosphereBlock));
        Inputs inputs{copy->block.handle, shared_.profile_table.handle, {}};
        const QualitySettings& quality = shared_.quality;
        copy->transmittance = copy->objects->texture(
            {"multi_scatter transmittance", rhi::Dimension::d2, quality.table_format, quality.transmittance, copied_usage});
        inputs.transmittance = copy->transmittance.handle;
        if (shared_.has_profiles) {
            copy->profiles = copy->objects->texture({"multi_scatter profiles", rhi::Dimension::d2, rhi::Format::r32_float,
                                                     shared_.profile_table.extent, copied_usage});
            inputs.profiles = copy->profiles.handle;
        }
        copy->bindings = bind(*copy->objects, inputs);
        copy_ = std::move(copy);
    }
    if (wanted || !copy_) return;
    if (reads_ == &copy_->bindings) {
        if (next_ < passes_) stale_ = true;
        reads_ = &live_;
        passes_ = next_ = 0;
    }
    copy_.reset();
}

void MultiScatterPass::restart(double ratio, bool same_axes) noexcept {
    ratio_ = ratio;
    stale_ = true;
    table_fits_ = table_fits_ && same_axes;
}

void MultiScatterPass::invalidate() noexcept {
    for (TrackedTexture* texture : {&table_, &rays_, &order_[0], &order_[1], &sum_[0], &sum_[1]}) forget(*texture);
    forget(first_quadrature_);
    forget(later_quadrature_);
    forget(zenith_quadrature_);
    if (copy_) {
        forget(copy_->block);
        forget(copy_->profiles);
        forget(copy_->transmittance);
    }
    stale_ = true;
    table_fits_ = false;
    passes_ = next_ = 0;
}

void MultiScatterPass::fill_copy(rhi::CommandList& commands, const AtmosphereBlock& block) {
    update_block(commands, copy_->block, block);
    for (auto [from, to] :
         {std::pair(&transmittance_, &copy_->transmittance), std::pair(&shared_.profile_table, &copy_->profiles)}) {
        if (to->handle) copy_texture(commands, *from, *to);
    }
}

void MultiScatterPass::start(rhi::CommandList& commands, const AtmosphereBlock& block, bool from_copy) {
    passes_ = passes_wanted();
    greatest_ratio_ = static_cast<float>(greatest_ratio(ratio_));
    next_ = from_copy ? passes_ - passes_of_slowest() : 0;
    stale_ = false;
    reads_ = from_copy ? &copy_->bindings : &live_;
    if (from_copy) fill_copy(commands, block);
}

bool MultiScatterPass::record(rhi::CommandList& commands, const AtmosphereBlock& block, int passes, PassReport& report,
                              TimestampSlots timestamps, std::uint32_t index) {
    if (first_quadrature_.state == rhi::State::undefined) {
        update_block(commands, first_quadrature_, first_rule_);
        update_block(commands, later_quadrature_, later_rule_);
        update_block(commands, zenith_quadrature_, zenith_rule_);
    }
    const bool at_once = passes <= 0 || !copy_ || !table_fits_;
    const bool in_one_go = at_once || passes >= passes_of_slowest();
    if (stale_ && (at_once || next_ >= passes_)) start(commands, block, !in_one_go);
    PassScope scope(commands, report, timestamps, index);
    report.bytes_written = 0;
    const int end = at_once ? passes_ : std::min(passes_, next_ + passes);
    for (; next_ < end; ++next_) {
        if (next_ < 0) continue;
        record_pass(commands, scope);
        report.bytes_written += rays_.bytes + 2 * table_.bytes;
    }
    if (next_ < passes_) return false;
    table_fits_ = true;
    return true;
}

void MultiScatterPass::record_pass(rhi::CommandList& commands, PassScope& scope) {
    const bool first = next_ == 0;
    const bool last = next_ + 1 == passes_;  // never the first: a pass is made for 2 orders at least
    const int parity = next_ % 2;
    TrackedTexture& sum_out = last ? table_ : sum_[parity];

    move(commands, {{&rays_, rhi::State::storage_write}});
    scope.dispatch(shaders::multi_scatter_rays, first ? first_rays_ : next_rays_,
                   first ? reads_->first_rays : reads_->next_rays[1 - parity], rays_.extent);
    move(commands,
         {{&rays_, rhi::State::sampled}, {&order_[parity], rhi::State::storage_write}, {&sum_out, rhi::State::storage_write}});
    const glm::vec4 flags(first ? 1.0F : 0.0F, last ? 1.0F : 0.0F, greatest_ratio_, 0.0F);
    scope.dispatch(shaders::multi_scatter_moments, moments_,
                   first ? reads_->first_moments : reads_->moments[last ? 1 : 0][parity], table_.extent,
                   std::as_bytes(std::span(&flags, 1)));
    move(commands, {{&order_[parity], rhi::State::sampled}, {&sum_out, rhi::State::sampled}});
}

}  // namespace aureole::detail
