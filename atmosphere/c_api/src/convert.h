// C structs to C++ values and back; nothing is decided here.
#pragma once

#include <aureole.h>
#include <aureole/atmosphere.h>
#include <aureole/envelope.h>
#include <aureole/plan.h>
#include <aureole/planned_sky.h>
#include <aureole/setting.h>

#include <memory>
#include <vector>

#include "guard.h"

namespace aureole::c_api {

// Device.
[[nodiscard]] rhi::TextureDesc to_cpp(const aureole_texture_desc& c, std::string_view name);
[[nodiscard]] rhi::ExternalTexture to_cpp(const aureole_external_texture& c);
[[nodiscard]] aureole_texture_desc to_c(const rhi::TextureDesc& desc);
[[nodiscard]] aureole_external_texture to_c(const rhi::ExternalTexture& external, const aureole_texture_desc* desc);
[[nodiscard]] rhi::State state_of(aureole_state state, std::string_view name);
[[nodiscard]] rhi::Usage usage_of(aureole_usage usage, std::string_view name);

// The air. Reads versioned structs itself.
[[nodiscard]] AtmosphereParameters read_parameters(const aureole_parameters* parameters, std::string_view name);
[[nodiscard]] aureole_term default_term();
/// An air as C has it: its pointers lead into this object, and into `air`.
class AirInC {
public:
    explicit AirInC(AtmosphereParameters air);
    AirInC(const AirInC&) = delete;
    AirInC& operator=(const AirInC&) = delete;
    [[nodiscard]] const aureole_parameters& parameters() const noexcept { return parameters_; }

private:
    AtmosphereParameters air_;
    std::vector<aureole_term> terms_;
    aureole_parameters parameters_{};
};
/// What is outside of the envelope, kept for this thread until the next call.
void write_outside(std::vector<OutsideEnvelope> outside, aureole_outside* out, std::uint32_t capacity,
                   std::uint32_t* out_count);

// Atmosphere.
[[nodiscard]] aureole_setting default_setting();
[[nodiscard]] Setting read_setting(const aureole_setting* setting);
/// The model that has the setting's numbers; null where it has none.
[[nodiscard]] ModelPtr read_model(const aureole_setting* setting, const Setting& chosen);
/// `first` -1: none.
[[nodiscard]] TimestampSlots timestamps(std::int32_t first);
void write_reports(std::span<const PassReport> reports, aureole_pass_report* out, std::uint32_t capacity,
                   std::uint32_t* out_count);

// View.
[[nodiscard]] aureole_view_settings to_c(const ViewSettings& settings);
[[nodiscard]] ViewSettings to_cpp(const aureole_view_settings& c);
[[nodiscard]] aureole_composite_settings to_c(const CompositeSettings& settings);
[[nodiscard]] CompositeSettings to_cpp(const aureole_composite_settings& c);
[[nodiscard]] aureole_camera to_c(const Camera& camera);
[[nodiscard]] Camera to_cpp(const aureole_camera& c);
[[nodiscard]] aureole_sun to_c(const Sun& sun);
[[nodiscard]] std::vector<Sun> read_suns(const aureole_sun* suns, std::uint32_t count);
[[nodiscard]] aureole_shadow_map to_c(const ShadowMap& map);
[[nodiscard]] ShadowMap to_cpp(const aureole_shadow_map& c);
[[nodiscard]] aureole_composite_targets to_c(const CompositeTargets& targets);
[[nodiscard]] CompositeTargets to_cpp(const aureole_composite_targets& c);
[[nodiscard]] CompositeTargets read_targets(const aureole_composite_targets* targets);

// Plan.
[[nodiscard]] aureole_requirements to_c(const PlanRequirements& needs);
[[nodiscard]] PlanRequirements to_cpp(const aureole_requirements& c);
[[nodiscard]] aureole_follow_settings to_c(const FollowSettings& settings);
[[nodiscard]] FollowSettings to_cpp(const aureole_follow_settings& c);

[[nodiscard]] Rgb rgb(const double from[3]);
void copy(const Rgb& from, double to[3]);

}  // namespace aureole::c_api
