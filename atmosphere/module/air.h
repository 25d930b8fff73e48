// The state behind Atmosphere: the tables of one air, and the views that read them.
#pragma once

#include "common/pass.h"
#include "multi_scatter/multi_scatter.h"
#include "transmittance/transmittance.h"

#include <optional>

namespace aureole::detail {

/// All device objects that depend on the structure of the air. Made anew when that changes.
class AirTables {
public:
    AirTables(rhi::Device& device, const std::uint64_t& frame, const AtmosphereParameters& parameters,
              const PackedAtmosphere& packed, const QualitySettings& quality);

    /// New numbers for the same structure.
    void set_block(const AtmosphereParameters& parameters, const PackedAtmosphere& packed);
    /// Whether these parameters fit the objects at hand.
    [[nodiscard]] bool fits(const PackedAtmosphere& packed) const;

    void record(rhi::CommandList& commands, int passes_per_frame, std::span<PassReport> reports, TimestampSlots timestamps);

    Objects objects;
    AirStructure structure;
    QualitySettings quality;
    AtmosphereBlock block;
    TrackedBuffer block_buffer;
    TrackedTexture profile_table, phase_table;
    TrackedBuffer profile_upload, phase_upload;
    AirResources shared;
    TransmittancePass transmittance;
    MultiScatterPass multi_scatter;
    std::uint64_t version = 1;  ///< Grows whenever a table's contents change.

private:
    void record_uploads(rhi::CommandList& commands);
    bool block_changed_ = true;
    bool transmittance_stale_ = true;
};

/// What Atmosphere tells its views.
class AirUser {
public:
    virtual ~AirUser() = default;
    /// Makes what the view needs for these tables, without using it yet. May throw.
    virtual void prepare(AirTables& tables) = 0;
    /// Uses what was prepared.
    virtual void commit() noexcept = 0;
    virtual void abandon() noexcept = 0;
    /// The planet may have changed; what follows from it and the camera is computed anew.
    virtual void refresh() = 0;
};

}  // namespace aureole::detail

namespace aureole {

struct Atmosphere::Impl {
    Impl(rhi::Device& device, const AtmosphereParameters& parameters, const QualitySettings& quality);

    rhi::Device& device;
    std::uint64_t frame = 0;
    AtmosphereParameters parameters;
    QualitySettings quality;
    int passes_per_frame = 0;
    std::unique_ptr<detail::AirTables> tables;
    std::vector<detail::AirUser*> users;
    std::array<PassReport, 2> reports;
};

}  // namespace aureole
