#include <aureole/rhi/checks.h>

#include <algorithm>
#include <string>

namespace aureole::rhi {

std::string field_name(std::string_view kind, std::string_view name, std::string_view field) {
    std::string text(kind);
    text.append(" \"").append(name.empty() ? "(unnamed)" : name).append("\"");
    if (!field.empty()) text.append(" ").append(field);
    return text;
}

std::string to_string(Usage usage) {
    constexpr struct {
        Usage flag;
        const char* name;
    } names[] = {{Usage::sampled, "sampled"},
                 {Usage::storage, "storage"},
                 {Usage::color_attachment, "color_attachment"},
                 {Usage::copy_source, "copy_source"},
                 {Usage::copy_destination, "copy_destination"},
                 {Usage::constants, "constants"},
                 {Usage::read_back, "read_back"},
                 {Usage::upload, "upload"}};
    std::string text;
    for (const auto& n : names)
        if (has(usage, n.flag)) text.append(text.empty() ? "" : "|").append(n.name);
    return text.empty() ? "none" : text;
}

namespace {

constexpr Usage texture_usages =
    Usage::sampled | Usage::storage | Usage::color_attachment | Usage::copy_source | Usage::copy_destination;
constexpr Usage buffer_usages =
    Usage::copy_source | Usage::copy_destination | Usage::constants | Usage::read_back | Usage::upload;

[[noreturn]] void refuse(const std::string& field, std::string_view value, std::string_view allowed) {
    throw Error(ErrorCode::invalid_argument, field, value, allowed);
}
[[noreturn]] void lacking(const std::string& field, std::string_view value, std::string_view allowed) {
    throw Error(ErrorCode::unsupported, field, value, allowed);
}

void check_usage(const std::string& field, Usage usage, Usage allowed) {
    constexpr std::uint32_t all = static_cast<std::uint32_t>(texture_usages | buffer_usages);
    const std::uint32_t bits = static_cast<std::uint32_t>(usage);
    if (bits == 0 || (bits & ~static_cast<std::uint32_t>(allowed)) != 0)
        refuse(field, (bits & ~all) != 0 ? std::to_string(bits) : to_string(usage), "one or more of " + to_string(allowed));
}

void check_side(const std::string& field, std::uint32_t texels, std::uint32_t limit) {
    const std::string allowed = "1 to " + std::to_string(limit);
    if (texels == 0) refuse(field, "0", allowed);
    if (texels > limit) lacking(field, std::to_string(texels), allowed);
}

void check_extent(const TextureDesc& desc, const Capabilities& capabilities) {
    const auto field = [&](const char* side) { return field_name("texture", desc.name, std::string("extent.") + side); };
    const Extent& e = desc.extent;
    const std::uint32_t limit = desc.dimension == Dimension::d2   ? capabilities.max_texture_2d
                                : desc.dimension == Dimension::d3 ? capabilities.max_texture_3d
                                                                  : capabilities.max_texture_cube;
    check_side(field("width"), e.width, limit);
    check_side(field("height"), e.height, limit);
    if (desc.dimension == Dimension::d3) {
        check_side(field("depth"), e.depth, limit);
        return;
    }
    if (e.depth != 1) refuse(field("depth"), std::to_string(e.depth), "1 for 2d and cube textures");
    if (desc.dimension == Dimension::cube && e.width != e.height)
        refuse(field("height"), std::to_string(e.height), "the width, " + std::to_string(e.width) + ", for cube textures");
}

void check_shader(const std::string& field, const Shader* shader, Stage stage, const Capabilities& capabilities) {
    const char* wanted = stage == Stage::compute ? "a compute shader" : "a fragment shader";
    if (!shader) refuse(field, "null", wanted);
    if (shader->stage != stage) refuse(field, shader->name, wanted);
    if (shader->push_constant_bytes > capabilities.max_push_constant_bytes)
        lacking(field,
                std::string(shader->name) + " with " + std::to_string(shader->push_constant_bytes) + " bytes of push constants",
                "at most " + std::to_string(capabilities.max_push_constant_bytes));
}

void check_specialization(const std::string& field, std::span<const Specialization> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (values[i].id == values[k].id) refuse(field, "id " + std::to_string(values[i].id) + " twice", "each id once");
}

/// One slot of a set: finds its binding and checks it.
class SlotCheck {
public:
    SlotCheck(const BindingSetDesc& set, const SlotDesc& slot, const ObjectLookup& objects, const Device& device)
        : slot_(slot), objects_(objects), device_(device) {
        field_ = field_name("binding set", set.name, "slot " + std::to_string(slot.slot) + " (" + std::string(slot.name) + ")");
    }

    void run(std::span<const Binding> bindings) const {
        const auto fits = [&](const Binding& b) { return b.slot == slot_.slot; };
        const auto count = std::count_if(bindings.begin(), bindings.end(), fits);
        if (count == 0) refuse(field_, "nothing", std::string("a ") + to_string(slot_.kind));
        if (count > 1) refuse(field_, std::to_string(count) + " bindings", "one");
        const Binding& binding = *std::find_if(bindings.begin(), bindings.end(), fits);
        if (slot_.kind == SlotKind::constants)
            check_buffer(binding);
        else
            check_texture(binding);
    }

private:
    void check_buffer(const Binding& binding) const {
        if (!binding.buffer || binding.texture)
            refuse(field_, binding.texture ? "a texture" : "no buffer", "a buffer with usage constants");
        const BufferDesc* buffer = objects_.find(binding.buffer);
        if (!buffer) refuse(field_, "an unknown or destroyed buffer", "a live buffer");
        if (!has(buffer->usage, Usage::constants))
            refuse(field_, field_name("buffer", buffer->name, "with usage " + to_string(buffer->usage)), "usage constants");
    }

    void check_texture(const Binding& binding) const {
        const Usage usage = slot_.kind == SlotKind::sampled_texture ? Usage::sampled : Usage::storage;
        if (!binding.texture || binding.buffer)
            refuse(field_, binding.buffer ? "a buffer" : "no texture", "a texture with usage " + to_string(usage));
        const TextureDesc* texture = objects_.find(binding.texture);
        if (!texture) refuse(field_, "an unknown or destroyed texture", "a live texture");
        if (texture->dimension != slot_.dimension)
            refuse(field_, field_name("texture", texture->name, std::string("of dimension ") + to_string(texture->dimension)),
                   std::string("dimension ") + to_string(slot_.dimension));
        if (!has(texture->usage, usage))
            refuse(field_, field_name("texture", texture->name, "with usage " + to_string(texture->usage)),
                   "usage " + to_string(usage));
        if (usage == Usage::sampled) check_sampler(binding, *texture);
    }

    void check_sampler(const Binding& binding, const TextureDesc& texture) const {
        const SamplerDesc* sampler = binding.sampler ? objects_.find(binding.sampler) : nullptr;
        if (!sampler) refuse(field_, binding.sampler ? "an unknown or destroyed sampler" : "no sampler", "a live sampler");
        if (sampler->filter == Filter::linear && !device_.format_support(texture.format, texture.dimension).linear_filter)
            lacking(field_,
                    field_name("texture", texture.name, std::string("of ") + to_string(texture.format) + " with linear filter"),
                    "nearest filter for this format");
    }

    const SlotDesc& slot_;
    const ObjectLookup& objects_;
    const Device& device_;
    std::string field_;
};

}  // namespace

void check(const TextureDesc& desc, const Capabilities& capabilities, const FormatSupport& support) {
    const std::string format = field_name("texture", desc.name, "format");
    if (bytes_per_texel(desc.format) == 0) refuse(format, to_string(desc.format), "any format but undefined");
    if (desc.dimension > Dimension::cube)
        refuse(field_name("texture", desc.name, "dimension"), std::to_string(static_cast<int>(desc.dimension)),
               "d2, d3 or cube");
    check_extent(desc, capabilities);
    check_usage(field_name("texture", desc.name, "usage"), desc.usage, texture_usages);

    const std::string what = std::string(to_string(desc.format)) + " (" + to_string(desc.dimension) + ")";
    if (has(desc.usage, Usage::sampled) && !support.sampled) lacking(format, what, "formats that can be sampled");
    if (has(desc.usage, Usage::storage) && !support.storage) lacking(format, what, "formats with storage writes");
    if (has(desc.usage, Usage::color_attachment) && !support.color_attachment)
        lacking(format, what, "formats that can be drawn to");
}

std::optional<Usage> texture_usage_for(State state) noexcept {
    switch (state) {
        case State::sampled:
        case State::depth_read:
            return Usage::sampled;
        case State::storage_write:
            return Usage::storage;
        case State::color_attachment:
            return Usage::color_attachment;
        case State::copy_source:
            return Usage::copy_source;
        case State::copy_destination:
            return Usage::copy_destination;
        case State::undefined:
        case State::general:
            return Usage::none;
        case State::constants:
            break;
    }
    return std::nullopt;
}

void check(const ExternalTexture& external, const Capabilities& capabilities, const FormatSupport& support) {
    const TextureDesc& desc = external.desc;
    check(desc, capabilities, support);
    const std::string field = field_name("texture", desc.name, "state");
    const std::optional<Usage> needed = texture_usage_for(external.state);
    if (!needed) refuse(field, to_string(external.state), "a state of textures");
    if (!has(desc.usage, *needed))
        refuse(field, to_string(external.state), "with usage " + to_string(*needed) + ", not " + to_string(desc.usage));
    if (external.state == State::depth_read && desc.format != Format::d32_float)
        refuse(field, to_string(external.state), std::string("with format d32_float, not ") + to_string(desc.format));
}

void check(const BufferDesc& desc) {
    constexpr std::uint64_t constants_limit = 65536;
    check_usage(field_name("buffer", desc.name, "usage"), desc.usage, buffer_usages);
    const std::string size = field_name("buffer", desc.name, "size");
    if (desc.size == 0) refuse(size, "0", "at least 1");
    if (has(desc.usage, Usage::constants) && desc.size > constants_limit)
        refuse(size, std::to_string(desc.size), "at most " + std::to_string(constants_limit) + " for constants");
}

void check(const SamplerDesc& desc) {
    if (desc.filter > Filter::linear)
        refuse("sampler filter", std::to_string(static_cast<int>(desc.filter)), "nearest or linear");
    for (const Address address : {desc.address_u, desc.address_v, desc.address_w})
        if (address > Address::repeat) refuse("sampler address", std::to_string(static_cast<int>(address)), "clamp or repeat");
}

void check(const ComputePipelineDesc& desc, const Capabilities& capabilities) {
    check_shader(field_name("pipeline", desc.name, "shader"), desc.shader, Stage::compute, capabilities);
    check_specialization(field_name("pipeline", desc.name, "specialization"), desc.specialization);
}

void check(const RasterPipelineDesc& desc, const Capabilities& capabilities, const FormatSupport& support) {
    check_shader(field_name("pipeline", desc.name, "shader"), desc.shader, Stage::fragment, capabilities);
    check_specialization(field_name("pipeline", desc.name, "specialization"), desc.specialization);
    const std::string field = field_name("pipeline", desc.name, "target_format");
    if (bytes_per_texel(desc.target_format) == 0) refuse(field, to_string(desc.target_format), "a format that can be drawn to");
    if (!capabilities.raster) lacking(field_name("pipeline", desc.name, ""), "raster", "compute only on this device");
    if (!support.color_attachment) lacking(field, to_string(desc.target_format), "formats that can be drawn to");
}

void check(const BindingSetDesc& desc, const Shader& shader, const ObjectLookup& objects, const Device& device) {
    for (const Binding& binding : desc.bindings) {
        const auto known = [&](const SlotDesc& slot) { return slot.slot == binding.slot; };
        if (std::none_of(shader.slots.begin(), shader.slots.end(), known))
            refuse(field_name("binding set", desc.name, "slot"), std::to_string(binding.slot),
                   "the slots of shader " + std::string(shader.name));
    }
    for (const SlotDesc& slot : shader.slots) SlotCheck(desc, slot, objects, device).run(desc.bindings);
}

}  // namespace aureole::rhi
