// What every pass's recorder is made of: device objects that die together, resources that remember their state, pipelines
// specialized to the air.
#pragma once

#include "common/host_blocks.h"
#include "common/pack_atmosphere.h"

#include <aureole/atmosphere.h>

#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace aureole::detail {

struct TrackedTexture {
    rhi::Texture handle;
    rhi::State state = rhi::State::undefined;
    rhi::Extent extent;
    std::uint64_t bytes = 0;
    rhi::Format format = rhi::Format::undefined;
    rhi::Dimension dimension = rhi::Dimension::d2;
};
struct TrackedBuffer {
    rhi::Buffer handle;
    rhi::State state = rhi::State::undefined;
};

/// Device objects that are created one by one and destroyed together, when the owner goes or a constructor fails half-way.
class Objects {
public:
    Objects(rhi::Device& device, const std::uint64_t& frame) : device_(&device), frame_(&frame) {}
    ~Objects();
    Objects(const Objects&) = delete;
    Objects& operator=(const Objects&) = delete;

    [[nodiscard]] rhi::Device& device() const noexcept { return *device_; }
    /// Number of the frame in which objects are destroyed.
    [[nodiscard]] const std::uint64_t& frame() const noexcept { return *frame_; }
    [[nodiscard]] TrackedTexture texture(const rhi::TextureDesc& desc);
    [[nodiscard]] TrackedBuffer constants(std::string_view name, std::size_t size);
    /// A buffer that holds these bytes for one copy to a texture.
    [[nodiscard]] TrackedBuffer upload(std::string_view name, std::span<const std::byte> bytes);
    [[nodiscard]] rhi::Sampler sampler(rhi::Filter filter);
    /// Of equal shaders and values the same pipeline, as for the triplets of N wavelengths.
    [[nodiscard]] rhi::Pipeline compute(const rhi::Shader& shader, std::span<const rhi::Specialization> values);
    [[nodiscard]] rhi::Pipeline raster(const rhi::Shader& shader, std::span<const rhi::Specialization> values,
                                       rhi::Format target);
    [[nodiscard]] rhi::BindingSet bindings(std::string_view name, rhi::Pipeline pipeline,
                                           std::initializer_list<rhi::Binding> slots) {
        return bindings(name, pipeline, std::span(slots.begin(), slots.size()));
    }
    [[nodiscard]] rhi::BindingSet bindings(std::string_view name, rhi::Pipeline pipeline, std::span<const rhi::Binding> slots);
    /// An empty bag for the same device.
    [[nodiscard]] std::unique_ptr<Objects> sibling() const { return std::make_unique<Objects>(*device_, *frame_); }
    /// Device memory of the textures made here, bytes.
    [[nodiscard]] std::uint64_t texture_bytes() const noexcept { return texture_bytes_; }

private:
    struct MadePipeline {
        const rhi::Shader* shader;
        std::vector<rhi::Specialization> values;
        rhi::Format target;  ///< undefined: none, it computes.
        rhi::Pipeline handle;
    };
    template <class Create>
    rhi::Pipeline pipeline(const rhi::Shader& shader, std::span<const rhi::Specialization> values, rhi::Format target,
                           const Create& create);

    rhi::Device* device_;
    const std::uint64_t* frame_;
    std::vector<rhi::AnyHandle> handles_;
    std::vector<MadePipeline> pipelines_;
    std::uint64_t texture_bytes_ = 0;
};

/// Values of specialization constants; ids as in the kernels.
class Specialize {
public:
    Specialize() = default;
    /// Constants 0 to 5: the structure of the air (common/specialization.glsl, sky_view.glsl).
    explicit Specialize(const AirStructure& air);
    /// Sets or replaces a constant.
    Specialize& set(std::uint32_t id, int value);
    Specialize& set(const rhi::Specialization& value);
    /// Constant 54 (common/storage.glsl): what is written to a texture of this format stays finite.
    Specialize& storing(rhi::Format format);
    [[nodiscard]] std::span<const rhi::Specialization> values() const noexcept { return values_; }

private:
    std::vector<rhi::Specialization> values_;
};

/// What a list that never ran was to do to it has not been done: the next use starts from nothing.
inline void forget(TrackedTexture& texture) noexcept { texture.state = rhi::State::undefined; }
inline void forget(TrackedBuffer& buffer) noexcept { buffer.state = rhi::State::undefined; }

/// One move of a barrier.
struct Move {
    TrackedTexture* texture;
    rhi::State after;
};
/// One barrier for all moves that change something or follow a write.
void move(rhi::CommandList& commands, std::initializer_list<Move> moves);

/// Copies the whole of a texture to one of its size; both are left in State::sampled.
void copy_texture(rhi::CommandList& commands, TrackedTexture& from, TrackedTexture& to);

/// Replaces a block's contents, leaving the buffer readable by kernels.
void update(rhi::CommandList& commands, TrackedBuffer& buffer, std::span<const std::byte> bytes);
template <class Block>
void update_block(rhi::CommandList& commands, TrackedBuffer& buffer, const Block& block) {
    update(commands, buffer, std::as_bytes(std::span(&block, 1)));
}

/// Records a marker, a timestamp before and after, and the invocations into a report.
class PassScope {
public:
    PassScope(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index);
    ~PassScope();
    PassScope(const PassScope&) = delete;
    PassScope& operator=(const PassScope&) = delete;

    /// Dispatches enough groups for `width` x `height` x `depth` invocations.
    void dispatch(const rhi::Shader& shader, rhi::Pipeline pipeline, rhi::BindingSet bindings, rhi::Extent invocations,
                  std::span<const std::byte> push_constants = {});

private:
    rhi::CommandList& commands_;
    PassReport& report_;
    TimestampSlots timestamps_;
    std::uint32_t index_;
};

/// A kernel that fills one table.
struct TableKernel {
    const rhi::Shader* shader;
    rhi::Extent size;    ///< Of one layer.
    rhi::Format format;  ///< Of the table.
    int nodes;           ///< Constant 8: of its quadrature block if it has one (slot 1), else of whatever it counts.

    /// It wants a quadrature_block of `nodes` in slot 1.
    [[nodiscard]] bool has_quadrature() const;
};

/// What the passes of one atmosphere share.
struct AirResources {
    Objects& objects;
    const AirStructure& air;
    const QualitySettings& quality;
    TrackedBuffer& block;  ///< AtmosphereBlock
    TrackedTexture& profile_table;
    TrackedTexture& phase_table;
    bool has_profiles;  ///< False: one texel stands in for the profile table.
    rhi::Sampler linear, nearest;
    bool summed = false;  ///< Tables are added to those of other wavelengths: colours in them must not depend on each other.
    /// Greatest order_ratio among airs whose tables are added up: solutions that are spread over frames are ready together.
    double slowest_order_ratio = 0;
};

}  // namespace aureole::detail
