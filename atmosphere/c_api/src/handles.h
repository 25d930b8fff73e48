// What stands behind the opaque handles.
#pragma once

#include <aureole/atmosphere.h>
#include <aureole/c/device.h>
#include <aureole/c/plan.h>
#include <aureole/c/planned_sky.h>
#include <aureole/plan.h>
#include <aureole/planned_sky.h>
#include <aureole/setting.h>

#include <memory>
#include <string>
#include <vector>

namespace aureole::c_api {
/// VK_QUEUE_FAMILY_IGNORED, by its number.
inline constexpr std::uint32_t no_queue_family = ~std::uint32_t{0};
}  // namespace aureole::c_api

/// The list that is open on a device; null while none is.
struct aureole_commands {
    aureole::rhi::CommandList* list = nullptr;
};

/// A device of any kind.
struct aureole_device {
    aureole_device() = default;
    virtual ~aureole_device() = default;
    aureole_device(const aureole_device&) = delete;
    aureole_device& operator=(const aureole_device&) = delete;

    [[nodiscard]] virtual aureole::rhi::Device& rhi_device() = 0;
    [[nodiscard]] const aureole::rhi::Device& rhi_device() const { return const_cast<aureole_device*>(this)->rhi_device(); }
    [[nodiscard]] virtual aureole::rhi::CommandList& begin(void* host_list) = 0;
    /// Throws Error(invalid_argument) but of a host's Vulkan device.
    [[nodiscard]] virtual aureole::rhi::CommandList& begin_on(void* host_list, std::uint32_t queue_family);
    /// The frame's number; 0 of a host's list.
    virtual std::uint64_t end() = 0;
    /// Throws Error(unsupported) of a device whose work the host waits for.
    virtual void wait();
    /// Throws Error(unsupported) but of Vulkan devices.
    virtual void native(aureole::rhi::Texture texture, aureole_native_texture& out) const;
    [[nodiscard]] virtual std::uint64_t native(aureole::rhi::Buffer buffer) const;

    /// Where messages go. Null: nowhere.
    void listen(aureole_message_callback callback, void* user);

    aureole_commands commands;
    int atmospheres = 0;  ///< That live on it, planned skies among them.

protected:
    struct Listener {
        aureole_message_callback callback = nullptr;
        void* user = nullptr;
    };
    static void tell(void* device, aureole::rhi::Severity severity, const char* text);
    Listener listener_;
};

struct aureole_atmosphere {
    aureole_atmosphere(aureole_device& on, const aureole::Setting& chosen, const aureole::AtmosphereParameters& parameters,
                       const aureole::ModelPtr& model);
    ~aureole_atmosphere();
    aureole_atmosphere(const aureole_atmosphere&) = delete;
    aureole_atmosphere& operator=(const aureole_atmosphere&) = delete;

    aureole_device& device;
    aureole::Setting setting;
    aureole::Atmosphere air;
    int views = 0;  ///< That live of it.
};

struct aureole_view {
    aureole_view(aureole_atmosphere& of, const aureole::ViewSettings& settings, const aureole::CompositeSettings& composite);
    ~aureole_view();
    aureole_view(const aureole_view&) = delete;
    aureole_view& operator=(const aureole_view&) = delete;

    aureole_atmosphere& atmosphere;
    aureole::View view;
};

struct aureole_plan {
    aureole::Plan plan;
    std::string setting, text;
};

struct aureole_planned_sky {
    aureole_planned_sky(aureole_device& on, const aureole::PlanRequirements& needs, const aureole::CompositeSettings& composite,
                        const aureole::FollowSettings& follow);
    ~aureole_planned_sky();
    aureole_planned_sky(const aureole_planned_sky&) = delete;
    aureole_planned_sky& operator=(const aureole_planned_sky&) = delete;

    aureole_device& device;
    aureole::PlannedSky sky;
    std::vector<aureole::PlanChange> changes;  ///< Of the latest update.
};

namespace aureole::c_api {

/// Throws Error(misuse) where none is open.
[[nodiscard]] rhi::CommandList& open_list(aureole_commands* commands);
/// The same of this device; Error(invalid_argument) for another's.
[[nodiscard]] rhi::CommandList& open_list(aureole_device& device, aureole_commands* commands);

}  // namespace aureole::c_api
