#include <aureole/rhi/error.h>
#include <aureole/rhi/plain_glsl.h>

#include <algorithm>
#include <bit>

namespace aureole::rhi {
namespace {

constexpr std::uint32_t first_version = 430;  // the first with compute shaders
constexpr std::uint32_t first_free_binding = 32;

void check(const PlainGlslOptions& options) {
    if (options.version < first_version)
        throw Error(ErrorCode::invalid_argument, "version", std::to_string(options.version),
                    "at least " + std::to_string(first_version) + ", which has compute shaders");
    if (options.push_binding < first_free_binding)
        throw Error(ErrorCode::invalid_argument, "push_binding", std::to_string(options.push_binding),
                    "at least " + std::to_string(first_free_binding) + ", beyond all slots");
}

std::uint32_t bits_of(const ConstantDesc& constant, std::span<const Specialization> given) {
    const auto found = std::find_if(given.begin(), given.end(), [&](const Specialization& s) { return s.id == constant.id; });
    return found == given.end() ? constant.default_bits : found->bits;
}

/// An expression for the value: floats by their bits, so that none is lost in print.
std::string value_of(ConstantKind kind, std::uint32_t bits) {
    if (kind == ConstantKind::boolean) return bits != 0 ? "true" : "false";
    if (kind == ConstantKind::real) return "uintBitsToFloat(" + std::to_string(bits) + "u)";
    return "int(" + std::to_string(bits) + "u)";
}

std::string line(const std::string& name, const std::string& value) { return "#define AUREOLE_" + name + " " + value + "\n"; }

}  // namespace

std::uint32_t plain_glsl_image_unit(const Shader& shader, std::uint32_t slot) noexcept {
    const auto before = [&](const SlotDesc& s) { return s.kind == SlotKind::storage_texture && s.slot < slot; };
    return static_cast<std::uint32_t>(std::count_if(shader.slots.begin(), shader.slots.end(), before));
}

std::string plain_glsl(const Shader& shader, std::span<const Specialization> specialization, const PlainGlslOptions& options) {
    check(options);
    std::string text = "#version " + std::to_string(options.version) + "\n#define AUREOLE_PLAIN_GLSL\n";
    text += line("PUSH_BINDING", std::to_string(options.push_binding));
    for (const ConstantDesc& constant : shader.constants)
        text += line("SPEC_" + std::to_string(constant.id), value_of(constant.kind, bits_of(constant, specialization)));
    for (const SlotDesc& slot : shader.slots)
        if (slot.kind == SlotKind::storage_texture)
            text += line("IMAGE_UNIT_" + std::to_string(slot.slot), std::to_string(plain_glsl_image_unit(shader, slot.slot)));
    const std::size_t first_line = shader.glsl.find('\n');  // the version, of GLSL with sets and constants
    return text.append(shader.glsl.substr(std::min(first_line, shader.glsl.size())));
}

}  // namespace aureole::rhi
