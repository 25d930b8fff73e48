#include "app/trace_eyes.h"

#include <aureole/models/spectral.h>

#include <algorithm>

namespace aureole::app {
namespace {

ViewSettings view_settings() {
    ViewSettings settings;
    settings.aerial_perspective = settings.light = false;
    return settings;
}
CompositeSettings composite_settings() {
    CompositeSettings settings;
    settings.target_format = rhi::Format::rgba32_float;
    settings.sun_disk = false;
    return settings;
}

}  // namespace

TraceTarget::TraceTarget(Backend& backend, std::size_t rows) : backend_(backend), textures_(backend) {
    targets_.extent = {trace_lanes, static_cast<std::uint32_t>(rows), 1};
    targets_.target =
        textures_.create("radiance", rhi::Format::rgba32_float, targets_.extent, rhi::Usage::storage | rhi::Usage::copy_source);
    textures_.make_ready(targets_.target, rhi::State::storage_write);
    targets_.directions = textures_.create("directions", rhi::Format::rgba32_float, targets_.extent,
                                           rhi::Usage::sampled | rhi::Usage::copy_destination);
    texels_.resize(std::size_t{4} * trace_lanes * rows);
}

void TraceTarget::look(std::span<const ProbeRow> rows, std::span<const std::size_t> chosen, std::size_t lanes) {
    std::ranges::fill(texels_, 0.0F);
    for (const std::size_t row : chosen) {
        const glm::dvec3 d = probe_direction(rows[row].view_zenith_deg, rows[row].azimuth_deg);
        for (std::size_t lane = 0; lane < lanes; ++lane)
            for (int c = 0; c < 3; ++c)
                texels_[4 * (row * trace_lanes + lane) + static_cast<std::size_t>(c)] = static_cast<float>(d[c]);
    }
    textures_.upload(targets_.directions, std::as_bytes(std::span(texels_)),
                     filled_ ? rhi::State::sampled : rhi::State::undefined, rhi::State::sampled);
    filled_ = true;
}

std::vector<double> TraceTarget::read() {
    return textures_.read_doubles(targets_.target, texels_.size(), rhi::State::storage_write);
}

TraceEye::TraceEye(Backend& backend, const AtmosphereParameters& air, const models::ReferenceSettings& settings,
                   const TraceTarget& target)
    : backend_(backend),
      bottom_radius_m_(air.planet.bottom_radius_m),
      air_(backend.device(), air, models::reference(settings)),
      view_(air_, view_settings(), composite_settings()) {
    view_.prepare_composite(target.targets());
}

std::vector<double> TraceEye::see(TraceTarget& target, const ProbeRow& row, std::uint64_t frame) {
    Sun sun;
    sun.direction = probe_direction(row.sun_zenith_deg, 0);
    view_.update(look(bottom_radius_m_, row.altitude_km * 1000, 0, 0, 1, 1), {&sun, 1});
    air_.set_frame(frame);
    backend_.run([&](rhi::CommandList& commands) {
        air_.record(commands);
        view_.record(commands);
        view_.record_composite(commands, target.targets());
    });
    return target.read();
}

TraceColours::TraceColours(const AtmosphereParameters& parameters, const std::string& spectral) {
    if (spectral == "rgb") {
        airs_.push_back(parameters);
        return;
    }
    glm::dvec3 sun(0);
    for (const spectrum::Triplet& triplet : spectrum::triplets(models::wavelengths_by_name(spectral))) {
        airs_.push_back(models::at_wavelengths(parameters, triplet.nm));
        matrices_.push_back(triplet.to_rec709);
        sun += triplet.to_rec709 * glm::dvec3(1);
    }
    for (glm::dmat3& matrix : matrices_)
        for (int column = 0; column < 3; ++column) matrix[column] /= sun;
}

Rgb TraceColours::part(std::size_t air, const Rgb& channels) const {
    return matrices_.empty() ? channels : matrices_[air] * channels;
}

}  // namespace aureole::app
