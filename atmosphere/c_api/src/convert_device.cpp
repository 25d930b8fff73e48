#include "convert.h"

namespace aureole::c_api {
namespace {

using rhi::Format, rhi::Usage, rhi::State, rhi::Dimension;

// Numbers in C are those of C++.
static_assert(
    number(Format::r8_unorm) == AUREOLE_FORMAT_R8_UNORM && number(Format::rgba8_unorm) == AUREOLE_FORMAT_RGBA8_UNORM &&
    number(Format::rgba8_srgb) == AUREOLE_FORMAT_RGBA8_SRGB && number(Format::bgra8_unorm) == AUREOLE_FORMAT_BGRA8_UNORM &&
    number(Format::r16_float) == AUREOLE_FORMAT_R16_FLOAT && number(Format::rg16_float) == AUREOLE_FORMAT_RG16_FLOAT &&
    number(Format::rgba16_float) == AUREOLE_FORMAT_RGBA16_FLOAT && number(Format::r32_float) == AUREOLE_FORMAT_R32_FLOAT &&
    number(Format::rg32_float) == AUREOLE_FORMAT_RG32_FLOAT && number(Format::rgba32_float) == AUREOLE_FORMAT_RGBA32_FLOAT &&
    number(Format::r11g11b10_float) == AUREOLE_FORMAT_R11G11B10_FLOAT && number(Format::d32_float) == AUREOLE_FORMAT_D32_FLOAT);
static_assert(number(Usage::sampled) == AUREOLE_USAGE_SAMPLED && number(Usage::storage) == AUREOLE_USAGE_STORAGE &&
              number(Usage::color_attachment) == AUREOLE_USAGE_COLOR_ATTACHMENT &&
              number(Usage::copy_source) == AUREOLE_USAGE_COPY_SOURCE &&
              number(Usage::copy_destination) == AUREOLE_USAGE_COPY_DESTINATION &&
              number(Usage::constants) == AUREOLE_USAGE_CONSTANTS && number(Usage::read_back) == AUREOLE_USAGE_READ_BACK &&
              number(Usage::upload) == AUREOLE_USAGE_UPLOAD);
static_assert(number(State::undefined) == AUREOLE_STATE_UNDEFINED && number(State::sampled) == AUREOLE_STATE_SAMPLED &&
              number(State::depth_read) == AUREOLE_STATE_DEPTH_READ &&
              number(State::storage_write) == AUREOLE_STATE_STORAGE_WRITE &&
              number(State::color_attachment) == AUREOLE_STATE_COLOR_ATTACHMENT &&
              number(State::copy_source) == AUREOLE_STATE_COPY_SOURCE &&
              number(State::copy_destination) == AUREOLE_STATE_COPY_DESTINATION &&
              number(State::constants) == AUREOLE_STATE_CONSTANTS && number(State::general) == AUREOLE_STATE_GENERAL);
static_assert(number(Dimension::d3) == AUREOLE_3D && number(Dimension::cube) == AUREOLE_CUBE);

}  // namespace

rhi::State state_of(aureole_state state, std::string_view name) { return enumerator(state, State::general, name); }

rhi::Usage usage_of(aureole_usage usage, std::string_view name) {
    constexpr std::uint32_t all = 2 * AUREOLE_USAGE_UPLOAD - 1;
    if (usage > all) throw Error(ErrorCode::invalid_argument, name, std::to_string(usage), "flags of aureole_usage");
    return static_cast<Usage>(usage);
}

rhi::TextureDesc to_cpp(const aureole_texture_desc& c, std::string_view name) {
    const std::string prefix(name);
    return {text(c.name),
            enumerator(c.dimension, Dimension::cube, prefix + ".dimension"),
            enumerator(c.format, Format::d32_float, prefix + ".format"),
            {c.width, c.height, c.depth},
            usage_of(c.usage, prefix + ".usage")};
}

rhi::ExternalTexture to_cpp(const aureole_external_texture& c) {
    const aureole_texture_desc desc = read(c.desc, "external.desc", to_c(rhi::TextureDesc{}));
    return {to_cpp(desc, "external.desc"), c.native, c.native_view, c.cpu_texels, state_of(c.state, "external.state")};
}

aureole_texture_desc to_c(const rhi::TextureDesc& desc) {
    return {sizeof(aureole_texture_desc), number(desc.dimension), number(desc.format), desc.extent.width,
            desc.extent.height,           desc.extent.depth,      number(desc.usage),  desc.name.c_str()};
}

aureole_external_texture to_c(const rhi::ExternalTexture& external, const aureole_texture_desc* desc) {
    return {sizeof(aureole_external_texture),
            number(external.state),
            desc,
            external.native,
            external.native_view,
            external.cpu_texels};
}

}  // namespace aureole::c_api
