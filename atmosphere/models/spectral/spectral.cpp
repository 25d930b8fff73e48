#include "models/spectral/spectral.h"

#include "common/check.h"
#include "multi_scatter/order_ratio.h"

#include <algorithm>
#include <optional>

namespace aureole {
namespace detail {
namespace {

// One pass stands for all that the model records for its triplets: their number does not change how many passes there are.
constexpr std::array<std::string_view, 2> air_passes{"air_wavelengths", "air_sums"}, view_passes{"wavelengths", "sums"};

SpectralWeights weights_of(std::span<const spectrum::Triplet> triplets, const Rgb& sun) {
    SpectralWeights weights;
    weights.triplets = triplets.size();
    for (std::size_t k = 0; k < triplets.size(); ++k)
        for (int c = 0; c < 3; ++c)
            weights.to_rgb[3 * k + static_cast<std::size_t>(c)] = glm::dvec4(triplets[k].to_rec709[c] / sun, 0);
    weights.to_rgb[0].w = weights.to_rgb[3 * triplets.size() - 2].w = 1;  // TripletBlock: the first, the last
    return weights;
}

bool is_diagonal(const glm::dmat3& m) { return m == glm::dmat3({m[0][0], 0, 0}, {0, m[1][1], 0}, {0, 0, m[2][2]}); }

bool same_phases(const PackedAtmosphere& a, const PackedAtmosphere& b) {
    return a.phase_count == b.phase_count && a.phase_kinds == b.phase_kinds && a.sharp_phases == b.sharp_phases &&
           a.phase_table == b.phase_table &&
           std::equal(std::begin(a.block.phase_parameters), std::end(a.block.phase_parameters),
                      std::begin(b.block.phase_parameters));
}

std::string print(const std::array<double, 3>& nm) {
    return detail::print(nm[0]) + ", " + detail::print(nm[1]) + " and " + detail::print(nm[2]) + " nm";
}

/// The sums of what `of` lists of each of `owners`.
template <class Owner>
std::vector<SpectralSum> make_sums(Objects& objects, rhi::Sampler nearest, const TrackedBuffer& weights,
                                   std::span<Owner* const> owners) {
    std::vector<std::vector<LightTexture>> lists;
    for (Owner* owner : owners) lists.push_back(owner->light_textures());
    std::vector<SpectralSum> sums;
    for (std::size_t i = 0; i < lists.front().size(); ++i) {
        std::vector<rhi::Texture> tables;
        tables.reserve(lists.size());
        for (const std::vector<LightTexture>& list : lists) tables.push_back(list[i].table->handle);
        sums.emplace_back(objects, nearest, weights, lists.front()[i], tables);
    }
    return sums;
}

rhi::Texture sum_of(std::span<const SpectralSum> sums, rhi::Texture table) noexcept {
    for (const SpectralSum& sum : sums)
        if (sum.first_table() == table) return sum.table();
    return {};
}

void record_sums(rhi::CommandList& commands, std::span<SpectralSum> sums, PassReport& report, TimestampSlots timestamps) {
    PassScope scope(commands, report, timestamps, 1);
    report.bytes_written = 0;
    for (SpectralSum& sum : sums) sum.record(commands, scope, report);
}

bool all_ready(std::span<const SpectralSum> sums) noexcept {
    return std::ranges::all_of(sums, [](const SpectralSum& sum) { return sum.ready(); });
}

class SpectralModel final : public Model {
public:
    SpectralModel(ModelPtr inner, models::SpectralSettings settings)
        : inner_(std::move(inner)), settings_(std::move(settings)) {
        SpectralModel::validate();
    }
    [[nodiscard]] std::string_view name() const noexcept override { return inner_->name(); }
    [[nodiscard]] const QualitySettings& quality() const noexcept override { return inner_->quality(); }
    [[nodiscard]] QualitySettings quality_for(const AtmosphereParameters& parameters) const override {
        return inner_->quality_for(parameters);
    }
    [[nodiscard]] std::vector<ModelTable> tables_for(const AtmosphereParameters& parameters) const override {
        std::vector<ModelTable> tables = inner_->tables_for(parameters);
        const std::size_t triplets = spectrum::triplets(settings_.wavelengths).size();
        for (ModelTable& table : tables) table.samples += ", " + std::to_string(triplets) + " times: three wavelengths each";
        return tables;
    }
    void validate() const override {
        if (!inner_) reject("spectral.inner", "null", "a model");
        if (dynamic_cast<const SpectralModel*>(inner_.get()) != nullptr)
            reject("spectral.inner", "a model in wavelengths", "a model in red, green and blue");
        inner_->validate();
        models::validate(settings_);
    }
    void require(const rhi::Device& device) const override { inner_->require(device); }
    [[nodiscard]] bool has_shadows() const noexcept override { return inner_->has_shadows(); }
    [[nodiscard]] std::unique_ptr<ModelAir> make_air(AirResources& shared,
                                                     const AtmosphereParameters& parameters) const override {
        return std::make_unique<SpectralAir>(shared, parameters, inner_, settings_);
    }

private:
    ModelPtr inner_;
    models::SpectralSettings settings_;
};

}  // namespace

void InnerReports::make(std::span<const std::string_view> names, std::size_t models) {
    each = names.size();
    for (std::size_t k = 0; k < models; ++k)
        for (const std::string_view name : names) reports.emplace_back().name = name;
}

void InnerReports::add_to(PassReport& report) const noexcept {
    report.invocations = report.bytes_written = 0;
    for (const PassReport& inner : reports) {
        if (!inner.recorded) continue;
        report.invocations += inner.invocations;
        report.bytes_written += inner.bytes_written;
    }
}

SpectralAir::SpectralAir(AirResources& shared, const AtmosphereParameters& parameters, const ModelPtr& inner,
                         const models::SpectralSettings& settings)
    : inner_(inner),
      settings_(settings),
      triplets_(spectrum::triplets(settings.wavelengths)),
      weights_(weights_of(triplets_, models::solar_rec709(settings.wavelengths))),
      weights_buffer_(shared.objects.constants("spectral weights", sizeof weights_.to_rgb)),
      sums_needed_(triplets_.size() > 1 || !is_diagonal(triplets_.front().to_rec709)) {
    if (!settings_.air) settings_.air = models::at_wavelengths;
    std::vector<ModelAir*> models;
    const std::vector<Triplet> triplets = at_triplets(parameters);
    for (const Triplet& air : triplets) {
        airs_.push_back(std::make_unique<AirTables>(shared.objects.device(), shared.objects.frame(), air.parameters, air.packed,
                                                    inner, sums_needed_));
        models.push_back(airs_.back()->model.get());
    }
    finish_together(triplets);
    inner_reports_.make(models.front()->passes(), models.size());
    if (!sums_needed_) return;
    sums_ = make_sums<ModelAir>(shared.objects, shared.nearest, weights_buffer_, models);
    while (triplet_buffers_.size() < triplets_.size())
        triplet_buffers_.push_back(shared.objects.constants("triplet", sizeof(TripletBlock)));
}

std::vector<SpectralAir::Triplet> SpectralAir::at_triplets(const AtmosphereParameters& rgb) const {
    const PackedAtmosphere own = pack_atmosphere(rgb);
    std::vector<Triplet> result;
    for (const spectrum::Triplet& t : triplets_) {
        Triplet& air = result.emplace_back(Triplet{settings_.air(rgb, t.nm), {}});
        air.packed = pack_atmosphere(air.parameters);
        if (air.packed.block.radii != own.block.radii)
            reject("spectral.air", "other radii at " + print(t.nm), "those of the atmosphere");
        if (!same_phases(air.packed, own))
            reject("spectral.air", "other phase functions at " + print(t.nm), "those of the atmosphere, in their order");
        air.packed.block.tables.z = own.block.tables.z;  // what is added up has the same axes
    }
    return result;
}

void SpectralAir::finish_together(std::span<const Triplet> fresh) {
    double slowest = 0;
    const bool ground_light = inner_->quality().ground_light;
    for (const Triplet& air : fresh) slowest = std::max(slowest, order_ratio(air.parameters, ground_light));
    for (const auto& air : airs_) air->shared.slowest_order_ratio = slowest;
}

std::span<const std::string_view> SpectralAir::passes() const noexcept {
    return inner_reports_.named(air_passes, !sums_.empty());
}

void SpectralAir::complete(const AtmosphereParameters& parameters, AtmosphereBlock& block) const noexcept {
    airs_.front()->model->complete(parameters, block);
}

bool SpectralAir::fits(const AtmosphereParameters& parameters) const {
    const std::vector<Triplet> fresh = at_triplets(parameters);
    for (std::size_t k = 0; k < airs_.size(); ++k) {
        const Triplet& air = fresh[k];
        if (!airs_[k]->fits_in_place(air.packed) || !airs_[k]->model->fits(air.parameters) ||
            airs_[k]->quality != inner_->quality_for(air.parameters))
            return false;
    }
    return true;
}

void SpectralAir::restart(const AtmosphereParameters& parameters, const AtmosphereBlock&, const AtmosphereBlock&) {
    const std::vector<Triplet> fresh = at_triplets(parameters);
    finish_together(fresh);
    for (std::size_t k = 0; k < airs_.size(); ++k) airs_[k]->set_numbers(fresh[k].parameters, fresh[k].packed);
}

void SpectralAir::invalidate() noexcept {
    for (const auto& air : airs_) air->invalidate();
    for (SpectralSum& sum : sums_) sum.invalidate();
    forget(weights_buffer_);
    for (TrackedBuffer& buffer : triplet_buffers_) forget(buffer);
}

bool SpectralAir::due() const noexcept {
    return std::ranges::any_of(airs_, [](const auto& air) { return air->due(); });
}

bool SpectralAir::record(rhi::CommandList& commands, const AtmosphereBlock&, std::span<PassReport> reports,
                         TimestampSlots timestamps) {
    if (!due()) return false;
    bool changed = false;
    {
        std::optional<PassScope> scope;
        if (inner_reports_.each > 0) scope.emplace(commands, reports[0], timestamps, 0);
        for (std::size_t k = 0; k < airs_.size(); ++k) {
            const std::uint64_t version = airs_[k]->version;
            airs_[k]->record(commands, inner_reports_.of(k), {});
            changed |= airs_[k]->version != version;
        }
        if (scope) inner_reports_.add_to(reports[0]);
    }
    const bool all = std::ranges::all_of(airs_, [](const auto& air) { return air->recorded(); });
    if (!changed || !all) return changed;
    record_weights(commands);
    if (!sums_.empty()) record_sums(commands, sums_, reports[1], timestamps);
    return true;
}

void SpectralAir::record_weights(rhi::CommandList& commands) {
    if (weights_buffer_.state != rhi::State::undefined) return;
    const std::span all = std::span(weights_.to_rgb);
    update(commands, weights_buffer_, std::as_bytes(all));
    for (std::size_t k = 0; k < triplet_buffers_.size(); ++k)
        update(commands, triplet_buffers_[k], std::as_bytes(all.subspan(3 * k, 3)));
}

bool SpectralAir::ready() const noexcept {
    return all_ready(sums_) && std::ranges::all_of(airs_, [](const auto& air) { return air->recorded(); });
}

double SpectralAir::progress() const noexcept {
    double sum = 0;
    for (const auto& air : airs_) sum += air->model->progress();
    return sum / static_cast<double>(airs_.size());
}

void SpectralAir::spread(int passes_per_frame, bool first_too) {
    std::size_t done = 0;
    try {
        for (; done < airs_.size(); ++done) airs_[done]->model->spread(passes_per_frame, first_too);
    } catch (...) {
        // To what it was: objects that this needs are still there, or were not there before.
        while (done > 0) airs_[--done]->model->spread(passes_per_frame_, first_too_);
        throw;
    }
    passes_per_frame_ = passes_per_frame;
    first_too_ = first_too;
}

std::uint64_t SpectralAir::more_texture_bytes() const noexcept {
    std::uint64_t bytes = 0;
    for (const auto& air : airs_) bytes += air->texture_bytes();
    return bytes;
}

rhi::Texture SpectralAir::shown(rhi::Texture table) const noexcept {
    const rhi::Texture sum = sum_of(sums_, table);
    return sum ? sum : table;
}

rhi::Texture SpectralAir::transmittance_table() const noexcept { return shown(airs_.front()->model->transmittance_table()); }

std::unique_ptr<ModelView> SpectralAir::make_view(ViewResources& shared, const ViewSettings& settings) {
    return std::make_unique<SpectralView>(shared, settings, *this);
}

SpectralView::SpectralView(ViewResources& shared, const ViewSettings& settings, SpectralAir& air) : air_(air) {
    std::vector<ModelView*> views;
    for (std::size_t k = 0; k < air.airs().size(); ++k) {
        const std::unique_ptr<AirTables>& tables = air.airs()[k];
        ViewResources own{shared.objects, tables->shared, shared.block, shared.suns, shared.projection, air.triplet(k)};
        const ViewResources shadowed = own;
        if (air.by_tables()) own.triplet = {};
        inner_.push_back(std::make_unique<Inner>(Inner{own, shadowed, {}}));
        inner_.back()->view = tables->model->make_view(inner_.back()->shared, settings);
        views.push_back(inner_.back()->view.get());
    }
    inner_reports_.make(views.front()->passes(), views.size());
    kernels_ = views.front()->kernels();
    if (air.sums()) sums_ = make_sums<ModelView>(shared.objects, shared.air.nearest, air.weights(), views);
    for (std::size_t k = 0; k < inner_.size(); ++k) {
        const ModelKernels& kernels = inner_[k]->view->kernels();
        const rhi::Texture transmittance = air.airs()[k]->model->transmittance_table();
        if (!air.by_tables() || !air.sums()) kernels_.triplets.push_back({&inner_[k]->shared, &kernels});
        kernels_.shadow_triplets.push_back({&inner_[k]->shadowed, &kernels, transmittance});
    }
    if (!kernels_.triplets.empty()) return;
    for (rhi::Binding& binding : kernels_.tables) binding.texture = shown(binding.texture);
    kernels_.specialization.push_back({50, 1});  // NO_NEGATIVE of composite/inputs.glsl
}

std::span<const std::string_view> SpectralView::passes() const noexcept {
    return inner_reports_.named(view_passes, !sums_.empty());
}

rhi::Texture SpectralView::shown(rhi::Texture table) const noexcept {
    const rhi::Texture sum = sum_of(sums_, table);
    return sum ? sum : air_.shown(table);
}

void SpectralView::update(const ViewBlock& before, const ViewBlock& fresh) noexcept {
    for (const auto& inner : inner_) inner->view->update(before, fresh);
}

void SpectralView::restart() noexcept {
    for (const auto& inner : inner_) inner->view->restart();
}

void SpectralView::invalidate() noexcept {
    for (const auto& inner : inner_) inner->view->invalidate();
    for (SpectralSum& sum : sums_) sum.invalidate();
}

bool SpectralView::due() const noexcept {
    return std::ranges::any_of(inner_, [](const auto& inner) { return inner->view->due(); });
}

void SpectralView::record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) {
    if (!due()) return;
    {
        std::optional<PassScope> scope;
        if (inner_reports_.each > 0) scope.emplace(commands, reports[0], timestamps, 0);
        for (PassReport& report : inner_reports_.reports) report.recorded = false;
        for (std::size_t k = 0; k < inner_.size(); ++k) inner_[k]->view->record(commands, inner_reports_.of(k), {});
        if (scope) inner_reports_.add_to(reports[0]);
    }
    if (!sums_.empty()) record_sums(commands, sums_, reports[1], timestamps);
}

bool SpectralView::ready() const noexcept {
    return all_ready(sums_) && std::ranges::all_of(inner_, [](const auto& inner) { return inner->view->ready(); });
}

rhi::Texture SpectralView::sky_view_table() const noexcept { return shown(inner_.front()->view->sky_view_table()); }
rhi::Texture SpectralView::aerial_perspective_table() const noexcept {
    return shown(inner_.front()->view->aerial_perspective_table());
}

}  // namespace detail

namespace models {

ModelPtr spectral(const ModelPtr& inner, const SpectralSettings& settings) {
    return std::make_shared<detail::SpectralModel>(inner, settings);
}

}  // namespace models
}  // namespace aureole
