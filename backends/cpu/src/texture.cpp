#include "texture.h"

#include <aureole/rhi/checks.h>
#include <aureole/rhi/texel.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>

namespace aureole::cpu {
namespace {

constexpr std::size_t texels_per_piece = 16384;

std::uint32_t slices(const rhi::TextureDesc& desc) { return desc.dimension == rhi::Dimension::cube ? 6 : desc.extent.depth; }

/// Float formats start as NaN: a texel that is read before it was written shows up in every result.
template <class real>
real initial_value(rhi::Format format) {
    switch (format) {
        case rhi::Format::r8_unorm:
        case rhi::Format::rgba8_unorm:
        case rhi::Format::rgba8_srgb:
        case rhi::Format::bgra8_unorm:
            return 0;
        default:
            return std::numeric_limits<real>::quiet_NaN();
    }
}

template <class real>
void make_fresh(rhi::Format format, std::span<real> texels) {
    std::array<real, 4> texel;
    texel.fill(initial_value<real>(format));
    rhi::confine(format, texel.data());
    for (std::size_t i = 0; i < texels.size(); i += 4) std::copy(texel.begin(), texel.end(), texels.data() + i);
}

template <class real>
std::vector<real> fresh_texels(const rhi::TextureDesc& desc, std::uint64_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / (4 * sizeof(real))) throw std::bad_alloc();
    std::vector<real> texels(4 * static_cast<std::size_t>(count));
    make_fresh(desc.format, std::span(texels));
    return texels;
}

}  // namespace

TextureObject::TextureObject(const rhi::TextureDesc& desc, Precision precision, std::byte* host)
    : desc_(desc), texel_count_(std::uint64_t{desc.extent.width} * desc.extent.height * slices(desc)), host_(host) {
    if (precision == Precision::float32)
        texels_ = fresh_texels<float>(desc, texel_count_);
    else
        texels_ = fresh_texels<double>(desc, texel_count_);
}

rhi::CpuBinding TextureObject::binding() noexcept {
    rhi::CpuBinding b;
    b.format = desc_.format;
    b.exact = std::holds_alternative<std::vector<double>>(texels_);
    b.extent = {desc_.extent.width, desc_.extent.height, slices(desc_)};
    b.texels = std::visit([](auto& t) { return static_cast<void*>(t.data()); }, texels_);
    return b;
}

void TextureObject::decode_from(std::span<const std::byte> packed, Workers& workers) {
    const std::size_t size = rhi::bytes_per_texel(desc_.format);
    std::visit(
        [&](auto& texels) {
            workers.for_each(texel_count_, texels_per_piece, [&](std::size_t begin, std::size_t end) {
                rhi::decode_texels(desc_.format, packed.subspan(begin * size, (end - begin) * size),
                                   std::span(texels).subspan(4 * begin, 4 * (end - begin)));
            });
        },
        texels_);
}

void TextureObject::encode_to(std::span<std::byte> packed, Workers& workers) const {
    const std::size_t size = rhi::bytes_per_texel(desc_.format);
    std::visit(
        [&](const auto& texels) {
            workers.for_each(texel_count_, texels_per_piece, [&](std::size_t begin, std::size_t end) {
                rhi::encode_texels(desc_.format, std::span(texels).subspan(4 * begin, 4 * (end - begin)),
                                   packed.subspan(begin * size, (end - begin) * size));
            });
        },
        texels_);
}

void TextureObject::copy_from(const TextureObject& source) {
    std::visit(
        [&](auto& texels) {
            const auto& from = std::get<std::decay_t<decltype(texels)>>(source.texels_);
            std::copy(from.begin(), from.end(), texels.begin());
        },
        texels_);
}

void TextureObject::discard(Workers& workers) {
    std::visit(
        [&](auto& texels) {
            workers.for_each(texel_count_, texels_per_piece, [&](std::size_t begin, std::size_t end) {
                make_fresh(desc_.format, std::span(texels).subspan(4 * begin, 4 * (end - begin)));
            });
        },
        texels_);
}

std::vector<double> TextureObject::to_double() const {
    return std::visit([](const auto& t) { return std::vector<double>(t.begin(), t.end()); }, texels_);
}

void TextureObject::load_from_host(Workers& workers) {
    decode_from({host_, static_cast<std::size_t>(rhi::packed_size(desc_))}, workers);
}

void TextureObject::store_to_host(Workers& workers) const {
    encode_to({host_, static_cast<std::size_t>(rhi::packed_size(desc_))}, workers);
}

}  // namespace aureole::cpu
