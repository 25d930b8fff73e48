// The state behind Atmosphere: the tables of one air, and the views that read them.
#pragma once

#include "envelope/tell.h"
#include "models/model.h"

#include <aureole/envelope.h>

#include <memory>
#include <vector>

namespace aureole::detail {

/// All device objects that depend on the structure of the air. Made anew when that changes.
class AirTables {
public:
    AirTables(rhi::Device& device, const std::uint64_t& frame, const AtmosphereParameters& parameters,
              const PackedAtmosphere& packed, const ModelPtr& chosen, bool summed = false);

    /// New numbers for the same structure. May throw where the air has tables, and then nothing has changed.
    void set_numbers(const AtmosphereParameters& parameters, const PackedAtmosphere& packed);
    /// Whether these parameters fit the objects at hand.
    [[nodiscard]] bool fits(const PackedAtmosphere& packed) const;
    /// The same, and set_numbers needs nothing of the device.
    [[nodiscard]] bool fits_in_place(const PackedAtmosphere& packed) const {
        return fits(packed) && packed.profile_table == profile_upload_.texels && packed.phase_table == phase_upload_.texels;
    }
    /// Everything on the device is lost: recorded anew by the next record().
    void invalidate() noexcept;
    [[nodiscard]] std::uint64_t texture_bytes() const noexcept { return objects.texture_bytes() + model->more_texture_bytes(); }

    void record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps);
    [[nodiscard]] bool due() const noexcept { return block_changed_ || model->due(); }
    /// There is something for a view to read.
    [[nodiscard]] bool recorded() const noexcept { return block_buffer.state != rhi::State::undefined && model->ready(); }

    Objects objects;
    AirStructure structure;
    QualitySettings quality;
    AtmosphereBlock block;
    TrackedBuffer block_buffer;
    TrackedTexture profile_table, phase_table;
    AirResources shared;
    std::unique_ptr<ModelAir> model;
    std::uint64_t version = 1;  ///< Grows whenever a table's contents change.

private:
    /// A table of the user's on its way to the device. Another one has another buffer: the old one may still be read from.
    struct Upload {
        std::vector<float> texels;
        std::unique_ptr<Objects> objects;
        TrackedBuffer buffer;
        bool in_use = false;  ///< Its texels are in the table that views read.
    };
    [[nodiscard]] Upload make_upload(const char* name, const std::vector<float>& texels) const;
    static void record_upload(rhi::CommandList& commands, Upload& upload, TrackedTexture& texture);
    void record_tables(rhi::CommandList& commands);
    void record_shown(rhi::CommandList& commands);
    void record_apart(rhi::CommandList& commands);
    /// What was recorded apart is what views read from here on.
    void show_apart(rhi::CommandList& commands);

    Upload profile_upload_, phase_upload_;
    bool block_changed_ = true;  // and not yet recorded anywhere
    AtmosphereBlock apart_block_{};
    bool apart_pending_ = false;  // that one has been recorded apart, and is not shown yet
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
    /// Everything on the device is lost.
    virtual void invalidate() noexcept = 0;
};

}  // namespace aureole::detail

namespace aureole {

struct Atmosphere::Impl {
    Impl(rhi::Device& device, const AtmosphereParameters& parameters, const ModelPtr& model);

    rhi::Device& device;
    std::uint64_t frame = 0;
    AtmosphereParameters parameters;
    ModelPtr model;
    int passes_per_frame = 0;
    bool first_too = false;
    std::unique_ptr<detail::AirTables> tables;
    std::vector<detail::AirUser*> users;
    std::vector<PassReport> reports;
    KeptInTables kept_in_tables{};                 // as the function of this name says
    std::vector<const detail::Teller*> tellers{};  // of this air and of its views
    detail::Teller teller{tellers};

    void tell();
};

}  // namespace aureole
