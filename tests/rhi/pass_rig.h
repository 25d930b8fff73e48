// One atmosphere and one view of the default model, on the device that is checked and on the CPU backend beside it.
#pragma once

#include <aureole/atmosphere.h>
#include <aureole/cpu/cpu_device.h>
#include <aureole/presets.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rhi/compare.h"
#include "rhi/forwarding.h"
#include "rhi/place.h"
#include "rhi/report.h"

namespace aureole::conformance {

using passes::Image;
using passes::Measure;

/// Remembers textures, and lets all of them be copied. Of formats it can no more than another device can, so that a model makes
/// the same tables on both.
class TableDevice final : public ForwardingDevice {
public:
    TableDevice(rhi::Device& inner, const rhi::Device& other) : ForwardingDevice(inner), other_(other) {}
    [[nodiscard]] rhi::FormatSupport format_support(rhi::Format format, rhi::Dimension dimension) const override;
    [[nodiscard]] rhi::Texture create_texture(const rhi::TextureDesc& desc) override;
    [[nodiscard]] const rhi::TextureDesc& desc(rhi::Texture texture) const { return descs_.at(texture.value); }

private:
    const rhi::Device& other_;
    std::map<std::uint64_t, rhi::TextureDesc> descs_;
};

struct PassSetup {
    AtmosphereParameters air = presets::earth();
    QualitySettings quality = passes::small_quality();
    std::optional<ViewSettings> view{};  ///< None: tables of the air alone.
    CompositeSettings composite{};
};

class PassRig {
public:
    PassRig(rhi::Device& inner, rhi::Queue& queue, const rhi::Device& other, const PassSetup& setup);
    ~PassRig();
    PassRig(const PassRig&) = delete;
    PassRig& operator=(const PassRig&) = delete;

    void run(const std::function<void(rhi::CommandList&)>& record);
    [[nodiscard]] Image read(rhi::Texture texture, rhi::State state = rhi::State::sampled);
    void write(rhi::Texture texture, const Image& image, rhi::State state = rhi::State::sampled);
    /// With these texels, in `state`; stays as long as the rig.
    [[nodiscard]] rhi::Texture make(const std::string& name, rhi::Format format, const Image& image, rhi::State state);
    /// What the composite shows in a new target, over this colour and depth.
    [[nodiscard]] Image show(CompositeTargets targets, rhi::Format format, bool drawn);

    TableDevice device;
    Atmosphere air;
    std::unique_ptr<View> view;

private:
    rhi::Queue& queue_;
    std::vector<rhi::AnyHandle> made_;
};

/// Both of them, in step. What the checked device warns of or complains about is a failure.
class PassPair {
public:
    PassPair(const Target& target, const PassSetup& wanted);
    PassPair(const PassPair&) = delete;
    PassPair& operator=(const PassPair&) = delete;

    template <class Act>
    void each(const Act& act) {
        act(*reference);
        act(*checked);
    }
    void record_air();
    /// Gives the checked device the CPU's tables of the air: what is recorded then is compared by itself.
    void share_air() const;
    void record_view(const Camera& camera, const Sun& sun);

    /// A table of both, by how to get at it.
    struct Tables {
        Image checked, reference;
    };
    [[nodiscard]] Tables read(const std::function<rhi::Texture(const PassRig&)>& table) const;

private:
    /// Collects what the device warns of, until it goes.
    struct Listener {
        explicit Listener(rhi::Device& to);
        ~Listener();
        Listener(const Listener&) = delete;
        Listener& operator=(const Listener&) = delete;
        rhi::Device& device;
        std::string complaints;
    };
    Listener listener_;
    std::unique_ptr<cpu::CpuDevice> cpu_;

public:
    std::unique_ptr<PassRig> reference, checked;
};

/// The places and hours at which views are compared: day, sunset and dusk, in the air, at its top and in space.
struct PlaceAndHour {
    double altitude_m, elevation_deg;
    [[nodiscard]] std::string name() const;
};
inline constexpr PlaceAndHour places_and_hours[] = {{2, 45}, {5e3, 4}, {99e3, -2}, {4e5, 10}};

/// Worst difference of one quantity of a pass.
class Difference {
public:
    explicit Difference(std::string quantity) : quantity_(std::move(quantity)) {}
    /// Rows [begin, begin + count) of every slice.
    void compare(const PassPair::Tables& tables, std::uint32_t begin, std::uint32_t count, const Measure& measure,
                 const std::string& where);
    void add(double checked, double reference, double error, const std::string& where);
    /// Says how far they are apart, as a note, or as a failure where that is too far.
    void tell(double allowed) const;

private:
    std::string quantity_;
    passes::Worst worst_;
};

}  // namespace aureole::conformance
