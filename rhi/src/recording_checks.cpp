// The rules of recording functions that do not depend on states.
#include <aureole/rhi/checks.h>

#include <string>

namespace aureole::rhi {

std::uint64_t packed_size(const TextureDesc& desc) noexcept {
    const std::uint64_t faces = desc.dimension == Dimension::cube ? 6 : 1;
    return faces * desc.extent.width * desc.extent.height * desc.extent.depth * bytes_per_texel(desc.format);
}

namespace {

constexpr std::uint32_t max_groups = 65535;  // what every device allows along an axis
constexpr std::size_t max_update_bytes = 65536;

std::string named(const PipelineFacts& pipeline) { return field_name("pipeline", pipeline.name, ""); }

/// What dispatches and draws have in common.
std::string complain_work(const char* verb, std::span<const std::byte> push_constants, const PipelineFacts* pipeline,
                          const BindingSetFacts* bindings, bool has_bindings, Stage stage) {
    if (!pipeline) return std::string(verb) + ": unknown or destroyed pipeline";
    const Shader& shader = *pipeline->shader;
    if (shader.stage != stage)
        return std::string(verb) + ": " + named(*pipeline) + " is " +
               (shader.stage == Stage::compute ? "a compute pipeline" : "a raster pipeline");
    if (push_constants.size() != shader.push_constant_bytes)
        return std::string(verb) + ": " + named(*pipeline) + " takes " + std::to_string(shader.push_constant_bytes) +
               " bytes of push constants, not " + std::to_string(push_constants.size());
    if (!bindings) {
        if (shader.slots.empty() && !has_bindings) return {};
        return std::string(verb) + ": " + (has_bindings ? "unknown or destroyed" : "no") + " binding set for " +
               named(*pipeline);
    }
    if (bindings->shader != pipeline->shader)
        return std::string(verb) + ": " + field_name("binding set", bindings->name, "") + " was made for shader " +
               std::string(bindings->shader->name) + ", not for " + named(*pipeline);
    return {};
}

std::string complain_usage(const char* kind, const std::string& name, Usage has_usage, Usage needed) {
    if (has(has_usage, needed)) return {};
    return "copy: " + field_name(kind, name, "") + " has usage " + to_string(has_usage) + ", not " + to_string(needed);
}

/// Buffers for the CPU's bytes exist to be copied from or to.
Usage with_implied(Usage usage) {
    if (has(usage, Usage::upload)) usage = usage | Usage::copy_source;
    if (has(usage, Usage::read_back)) usage = usage | Usage::copy_destination;
    return usage;
}

std::string complain_buffer_texture(const BufferDesc* buffer, Usage buffer_usage, const TextureDesc* texture,
                                    Usage texture_usage) {
    if (!texture) return "copy: unknown or destroyed texture";
    if (!buffer) return "copy: unknown or destroyed buffer";
    if (auto text = complain_usage("texture", texture->name, texture->usage, texture_usage); !text.empty()) return text;
    if (auto text = complain_usage("buffer", buffer->name, with_implied(buffer->usage), buffer_usage); !text.empty())
        return text;
    if (buffer->size < packed_size(*texture))
        return "copy: " + field_name("buffer", buffer->name, "") + " has " + std::to_string(buffer->size) + " bytes, " +
               field_name("texture", texture->name, "") + " needs " + std::to_string(packed_size(*texture));
    return {};
}

std::string complain_textures(const TextureDesc* source, const TextureDesc* destination, bool same) {
    if (!source || !destination) return "copy: unknown or destroyed texture";
    if (same) return "copy: " + field_name("texture", source->name, "") + " is both source and destination";
    if (auto text = complain_usage("texture", source->name, source->usage, Usage::copy_source); !text.empty()) return text;
    if (auto text = complain_usage("texture", destination->name, destination->usage, Usage::copy_destination); !text.empty())
        return text;
    if (source->format != destination->format || source->extent != destination->extent ||
        source->dimension != destination->dimension)
        return "copy: " + field_name("texture", source->name, "") + " and " + field_name("texture", destination->name, "") +
               " differ in format, dimension or extent";
    return {};
}

}  // namespace

std::string complaint(const DispatchDesc& desc, const PipelineFacts* pipeline, const BindingSetFacts* bindings) {
    auto text =
        complain_work("dispatch", desc.push_constants, pipeline, bindings, static_cast<bool>(desc.bindings), Stage::compute);
    for (int axis = 0; axis < 3 && text.empty(); ++axis)
        if (desc.groups[axis] == 0 || desc.groups[axis] > max_groups)
            text = "dispatch: " + named(*pipeline) + " groups[" + std::to_string(axis) +
                   "]: " + std::to_string(desc.groups[axis]) + " is not allowed; allowed: 1 to " + std::to_string(max_groups);
    return text;
}

std::string complaint(const DrawDesc& desc, const PipelineFacts* pipeline, const BindingSetFacts* bindings,
                      const TextureDesc* target) {
    auto text = complain_work("draw_fullscreen", desc.push_constants, pipeline, bindings, static_cast<bool>(desc.bindings),
                              Stage::fragment);
    if (!text.empty()) return text;
    if (!target) return "draw_fullscreen: unknown or destroyed target of " + named(*pipeline);
    const auto name = [&] { return field_name("texture", target->name, ""); };  // made only when something is wrong
    if (target->dimension != Dimension::d2) return "draw_fullscreen: target " + name() + " is not 2d";
    if (!has(target->usage, Usage::color_attachment))
        return "draw_fullscreen: target " + name() + " has usage " + to_string(target->usage) + ", not color_attachment";
    if (target->format != pipeline->target_format)
        return "draw_fullscreen: target " + name() + " is " + to_string(target->format) + ", " + named(*pipeline) + " writes " +
               to_string(pipeline->target_format);
    return {};
}

std::string complaint(const CopyDesc& desc, const ObjectLookup& objects) {
    if (const auto* c = std::get_if<TextureToBuffer>(&desc))
        return complain_buffer_texture(objects.find(c->destination), Usage::copy_destination, objects.find(c->source),
                                       Usage::copy_source);
    if (const auto* c = std::get_if<BufferToTexture>(&desc))
        return complain_buffer_texture(objects.find(c->source), Usage::copy_source, objects.find(c->destination),
                                       Usage::copy_destination);
    const auto& c = std::get<TextureToTexture>(desc);
    return complain_textures(objects.find(c.source), objects.find(c.destination), c.source == c.destination);
}

std::string complaint(const BufferDesc* buffer, std::span<const std::byte> bytes) {
    if (!buffer) return "update_constants: unknown or destroyed buffer";
    const auto name = [&] { return field_name("buffer", buffer->name, ""); };  // made only when something is wrong
    if (!has(buffer->usage, Usage::constants))
        return "update_constants: " + name() + " has usage " + to_string(buffer->usage) + ", not constants";
    if (bytes.empty() || bytes.size() % 4 != 0 || bytes.size() > max_update_bytes)
        return "update_constants: " + name() + ": " + std::to_string(bytes.size()) +
               " bytes are not allowed; allowed: a multiple of 4 up to " + std::to_string(max_update_bytes);
    if (bytes.size() > buffer->size)
        return "update_constants: " + name() + " has " + std::to_string(buffer->size) + " bytes, not " +
               std::to_string(bytes.size());
    return {};
}

}  // namespace aureole::rhi
