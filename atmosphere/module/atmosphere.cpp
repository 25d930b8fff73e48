#include "module/air.h"
#include "module/requirements.h"

#include "common/check.h"
#include "envelope/tell.h"

#include <aureole/models/aureole.h>

#include <algorithm>
#include <utility>

namespace aureole {
namespace detail {
namespace {

constexpr rhi::Usage uploaded = rhi::Usage::sampled | rhi::Usage::copy_destination | rhi::Usage::copy_source;

/// A table of the host's, or one texel that stands in for it.
rhi::TextureDesc table_desc(const char* name, int rows) {
    const auto height = static_cast<std::uint32_t>(std::max(rows, 1));
    const auto width = rows > 0 ? static_cast<std::uint32_t>(table_width) : 1U;
    return {name, rhi::Dimension::d2, rhi::Format::r32_float, {width, height, 1}, uploaded};
}

std::span<const std::byte> texels_or_zero(const std::vector<float>& texels) {
    static constexpr float zero = 0;
    return texels.empty() ? std::as_bytes(std::span(&zero, 1)) : std::as_bytes(std::span(texels));
}

}  // namespace

AirTables::AirTables(rhi::Device& device, const std::uint64_t& frame, const AtmosphereParameters& parameters,
                     const PackedAtmosphere& packed, const ModelPtr& chosen, bool summed)
    : objects(device, frame),
      structure(packed),
      quality(chosen->quality_for(parameters)),
      block(packed.block),
      block_buffer(objects.constants("atmosphere", sizeof block)),
      profile_table(objects.texture(table_desc("profiles", packed.profile_rows))),
      phase_table(objects.texture(table_desc("phases", packed.phase_rows))),
      shared{objects,
             structure,
             quality,
             block_buffer,
             profile_table,
             phase_table,
             packed.profile_rows > 0,
             objects.sampler(rhi::Filter::linear),
             objects.sampler(rhi::Filter::nearest),
             summed},
      model(chosen->make_air(shared, parameters)),
      profile_upload_(make_upload("profiles upload", packed.profile_table)),
      phase_upload_(make_upload("phases upload", packed.phase_table)) {
    model->complete(parameters, block);
}

AirTables::Upload AirTables::make_upload(const char* name, const std::vector<float>& texels) const {
    Upload upload{texels, objects.sibling(), {}};
    upload.buffer = upload.objects->upload(name, texels_or_zero(texels));
    return upload;
}

bool AirTables::fits(const PackedAtmosphere& packed) const {
    return static_cast<const AirStructure&>(packed) == structure &&
           packed.profile_table.size() == profile_upload_.texels.size() &&
           packed.phase_table.size() == phase_upload_.texels.size();
}

void AirTables::set_numbers(const AtmosphereParameters& parameters, const PackedAtmosphere& packed) {
    const bool other_profiles = packed.profile_table != profile_upload_.texels;
    const bool other_phases = packed.phase_table != phase_upload_.texels;
    Upload profiles, phases;
    if (other_profiles) profiles = make_upload("profiles upload", packed.profile_table);
    if (other_phases) phases = make_upload("phases upload", packed.phase_table);
    AtmosphereBlock fresh = packed.block;
    model->complete(parameters, fresh);
    model->restart(parameters, block, fresh);
    // Nothing throws from here on.
    if (other_profiles) profile_upload_ = std::move(profiles);
    if (other_phases) phase_upload_ = std::move(phases);
    block = fresh;
    block_changed_ = true;
}

void AirTables::invalidate() noexcept {
    for (TrackedTexture* table : {&profile_table, &phase_table}) forget(*table);
    for (TrackedBuffer* buffer : {&block_buffer, &profile_upload_.buffer, &phase_upload_.buffer}) forget(*buffer);
    profile_upload_.in_use = phase_upload_.in_use = apart_pending_ = false;
    block_changed_ = true;
    model->invalidate();
}

void AirTables::record_upload(rhi::CommandList& commands, Upload& upload, TrackedTexture& texture) {
    if (upload.buffer.state != rhi::State::copy_source) {
        const rhi::BufferBarrier readable{upload.buffer.handle, upload.buffer.state, rhi::State::copy_source};
        commands.barrier({}, std::span(&readable, 1));
        upload.buffer.state = rhi::State::copy_source;
    }
    move(commands, {{&texture, rhi::State::copy_destination}});
    commands.copy(rhi::BufferToTexture{upload.buffer.handle, texture.handle});
    move(commands, {{&texture, rhi::State::sampled}});
}

void AirTables::record_tables(rhi::CommandList& commands) {
    for (auto [upload, table] : {std::pair(&profile_upload_, &profile_table), std::pair(&phase_upload_, &phase_table)}) {
        if (!upload->in_use) record_upload(commands, *upload, *table);
        upload->in_use = true;
    }
}

void AirTables::record_shown(rhi::CommandList& commands) {
    record_tables(commands);
    update_block(commands, block_buffer, block);
    apart_pending_ = false;
}

void AirTables::record_apart(rhi::CommandList& commands) {
    if (AirResources* own = model->apart()) {
        record_upload(commands, profile_upload_, own->profile_table);
        record_upload(commands, phase_upload_, own->phase_table);
        update_block(commands, own->block, block);
    }
    apart_block_ = block;
    apart_pending_ = true;
}

void AirTables::show_apart(rhi::CommandList& commands) {
    if (AirResources* own = model->apart()) {
        copy_texture(commands, own->profile_table, profile_table);
        copy_texture(commands, own->phase_table, phase_table);
    } else {
        record_tables(commands);
    }
    update_block(commands, block_buffer, apart_block_);
    apart_pending_ = false;
}

void AirTables::record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) {
    for (PassReport& report : reports) report.recorded = false;
    // Pending although it is to be recorded again: the model has given up the work on it.
    const NewAir to = block_changed_ || apart_pending_ ? model->new_air() : NewAir::later;
    if (to == NewAir::shown) record_shown(commands);
    if (to == NewAir::apart) record_apart(commands);
    if (to != NewAir::later) block_changed_ = false;
    const bool changed = model->record(commands, block, reports, timestamps);
    if (changed && apart_pending_) show_apart(commands);
    if (changed || to == NewAir::shown) ++version;
}

}  // namespace detail

namespace {

const ModelPtr& given(const ModelPtr& model) {
    if (!model) detail::reject("model", "null", "a model");
    return model;
}

}  // namespace

Atmosphere::Impl::Impl(rhi::Device& device_in, const AtmosphereParameters& parameters_in, const ModelPtr& model_in)
    : device(device_in), parameters(parameters_in), model(given(model_in)) {
    model->validate();
    const detail::PackedAtmosphere packed = detail::pack_atmosphere(parameters);
    detail::require_device(device);
    model->require(device);
    tables = std::make_unique<detail::AirTables>(device, frame, parameters, packed, model);
    for (const std::string_view name : tables->model->passes()) reports.emplace_back().name = name;
    tell();
}

void Atmosphere::Impl::tell() {
    kept_in_tables = detail::kept_in_tables(*model, parameters);
    teller.tell(outside_envelope(parameters));
}

Atmosphere::Atmosphere(rhi::Device& device, const AtmosphereParameters& parameters, const ModelPtr& model)
    : impl_(std::make_unique<Impl>(device, parameters, model)) {}
Atmosphere::Atmosphere(rhi::Device& device, const AtmosphereParameters& parameters, const QualitySettings& quality)
    : Atmosphere(device, parameters, models::aureole(quality)) {}
Atmosphere::~Atmosphere() = default;

void Atmosphere::set_parameters(const AtmosphereParameters& parameters) {
    Impl& impl = *impl_;
    if (parameters == impl.parameters) return;
    const detail::PackedAtmosphere packed = detail::pack_atmosphere(parameters);
    AtmosphereParameters copy = parameters;
    if (impl.tables->fits(packed) && impl.tables->quality == impl.model->quality_for(copy) && impl.tables->model->fits(copy)) {
        impl.tables->set_numbers(copy, packed);
        impl.parameters = std::move(copy);
        for (detail::AirUser* user : impl.users) user->refresh();
        impl.tell();
        return;
    }
    // Everything new is made before anything old is given up, so that a failure changes nothing.
    auto tables = std::make_unique<detail::AirTables>(impl.device, impl.frame, copy, packed, impl.model);
    tables->model->spread(impl.passes_per_frame, impl.first_too);
    try {
        for (detail::AirUser* user : impl.users) user->prepare(*tables);
    } catch (...) {
        for (detail::AirUser* user : impl.users) user->abandon();
        throw;
    }
    tables->version = impl.tables->version + 1;
    for (detail::AirUser* user : impl.users) user->commit();
    impl.tables = std::move(tables);
    impl.parameters = std::move(copy);
    for (detail::AirUser* user : impl.users) user->refresh();
    impl.tell();
}

const AtmosphereParameters& Atmosphere::parameters() const noexcept { return impl_->parameters; }
const Model& Atmosphere::model() const noexcept { return *impl_->model; }
const QualitySettings& Atmosphere::quality() const noexcept { return impl_->model->quality(); }

void Atmosphere::set_multi_scatter_passes_per_frame(int passes, bool first_too) {
    detail::check("multi_scatter_passes_per_frame", passes, 0, 64);
    impl_->tables->model->spread(passes, first_too);
    impl_->passes_per_frame = passes;
    impl_->first_too = first_too;
}
void Atmosphere::invalidate() noexcept {
    impl_->tables->invalidate();
    for (detail::AirUser* user : impl_->users) user->invalidate();
}
void Atmosphere::set_frame(std::uint64_t frame) noexcept { impl_->frame = frame; }

void Atmosphere::record(rhi::CommandList& commands, TimestampSlots timestamps) {
    impl_->tables->record(commands, impl_->reports, timestamps);
}

std::span<const PassReport> Atmosphere::reports() const noexcept { return impl_->reports; }
double Atmosphere::progress() const noexcept { return impl_->tables->model->progress(); }
rhi::Device& Atmosphere::device() const noexcept { return impl_->device; }
rhi::Texture Atmosphere::transmittance_table() const noexcept { return impl_->tables->model->transmittance_table(); }
rhi::Texture Atmosphere::multi_scatter_table() const noexcept { return impl_->tables->model->multi_scatter_table(); }
std::uint64_t Atmosphere::table_bytes() const noexcept { return impl_->tables->texture_bytes(); }

}  // namespace aureole
