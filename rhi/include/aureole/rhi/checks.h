// For those who implement Device: the rules that every descriptor must meet, in one place. Backends and the validation
// wrapper call these first, so that all of them refuse the same input in the same words. Each function throws
// Error(invalid_argument) for a value that is never allowed and Error(unsupported) for one that this device lacks, naming
// the object (`texture "sky_view" extent.width`); it returns if all is well and changes nothing.
#pragma once

#include <aureole/rhi/device.h>

#include <optional>

namespace aureole::rhi {

/// `support` is the device's answer for the texture's format and dimension.
void check(const TextureDesc& desc, const Capabilities& capabilities, const FormatSupport& support);
/// A texture that a host lends: its descriptor, and the state it is lent in (see ExternalTexture::state). What stands for the
/// host's object (`native`, `cpu_texels`) is the backend's to check.
void check(const ExternalTexture& external, const Capabilities& capabilities, const FormatSupport& support);
void check(const BufferDesc& desc);                                             ///< Size and usage.
void check(const SamplerDesc& desc);                                            ///< Values that the enumerations have.
void check(const ComputePipelineDesc& desc, const Capabilities& capabilities);  ///< Its shader and constants.
/// `support` is the device's answer for the 2D target format.
void check(const RasterPipelineDesc& desc, const Capabilities& capabilities, const FormatSupport& support);

/// Answers what the handles of a binding set stand for; null for handles that are unknown or destroyed.
class ObjectLookup {
public:
    virtual ~ObjectLookup() = default;
    [[nodiscard]] virtual const TextureDesc* find(Texture texture) const = 0;  ///< Of a texture, lent ones included.
    [[nodiscard]] virtual const BufferDesc* find(Buffer buffer) const = 0;     ///< Of a buffer.
    [[nodiscard]] virtual const SamplerDesc* find(Sampler sampler) const = 0;  ///< Of a sampler.
};

/// Every slot of the shader filled once with a live object of the right kind, dimension and usage, and nothing else given.
/// `shader` is the shader of desc.pipeline.
void check(const BindingSetDesc& desc, const Shader& shader, const ObjectLookup& objects, const Device& device);

// Recording functions never throw, so their rules answer with a complaint (empty: all is well), which also names the objects.
// Rules about states are the validation wrapper's (validation.h).

/// What a device remembers of a pipeline for the checks below.
struct PipelineFacts {
    std::string_view name;                     ///< For messages.
    const Shader* shader = nullptr;            ///< That it was made from.
    Format target_format = Format::undefined;  ///< Of raster pipelines.
};
/// What it remembers of a binding set.
struct BindingSetFacts {
    std::string_view name;           ///< For messages.
    const Shader* shader = nullptr;  ///< Of the pipeline that the set was made for.
};

/// Null `pipeline` or `bindings`: unknown or destroyed. A shader without slots needs no binding set.
[[nodiscard]] std::string complaint(const DispatchDesc& desc, const PipelineFacts* pipeline, const BindingSetFacts* bindings);
/// Null `target`: unknown or destroyed.
[[nodiscard]] std::string complaint(const DrawDesc& desc, const PipelineFacts* pipeline, const BindingSetFacts* bindings,
                                    const TextureDesc* target);
[[nodiscard]] std::string complaint(const CopyDesc& desc, const ObjectLookup& objects);  ///< For copy.
/// For update_constants.
[[nodiscard]] std::string complaint(const BufferDesc* buffer, std::span<const std::byte> bytes);

/// The usage that a texture needs to be in a state; Usage::none if it needs none; nothing if no texture is ever in that state.
[[nodiscard]] std::optional<Usage> texture_usage_for(State state) noexcept;

/// Bytes of all texels, tightly packed, all faces of a cube included.
[[nodiscard]] std::uint64_t packed_size(const TextureDesc& desc) noexcept;

/// `kind "name" field`, as used in messages: texture "sky_view" extent.width. Unnamed objects read `texture "(unnamed)"`.
[[nodiscard]] std::string field_name(std::string_view kind, std::string_view name, std::string_view field);
/// The flags of a usage by name, joined by '|'; "none" for none.
[[nodiscard]] std::string to_string(Usage usage);

}  // namespace aureole::rhi
