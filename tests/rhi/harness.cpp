#include "rhi/harness.h"

#include <aureole/rhi/checks.h>

#include <algorithm>
#include <stdexcept>

namespace aureole::conformance {

using namespace aureole::rhi;

Harness::~Harness() {
    try {
        if (list_) run();
        std::for_each(objects_.rbegin(), objects_.rend(), [&](const auto& object) { device.destroy(object, frame_); });
        queue.wait();
    } catch (...) {
        // A failure here follows one that has been reported.
    }
}

Texture Harness::texture(const std::string& name, Format format, Extent extent, Usage usage, Dimension dimension) {
    const TextureDesc desc{name, dimension, format, extent, usage};
    const Texture texture = device.create_texture(desc);
    objects_.push_back(texture);
    textures_.push_back({texture, desc});
    return texture;
}

Buffer Harness::buffer(const std::string& name, std::uint64_t size, Usage usage) {
    const Buffer buffer = device.create_buffer({name, size, usage});
    objects_.push_back(buffer);
    buffers_.push_back({buffer});
    return buffer;
}

Sampler Harness::sampler(Filter filter, Address address) {
    const Sampler sampler = device.create_sampler({filter, address, address, address});
    objects_.push_back(sampler);
    return sampler;
}

Pipeline Harness::compute(const Shader& shader, std::span<const Specialization> specialization) {
    const Pipeline pipeline = device.create_compute_pipeline({std::string(shader.name), &shader, specialization});
    objects_.push_back(pipeline);
    return pipeline;
}

Pipeline Harness::raster(const Shader& shader, Format target_format) {
    const Pipeline pipeline = device.create_raster_pipeline({std::string(shader.name), &shader, {}, target_format});
    objects_.push_back(pipeline);
    return pipeline;
}

BindingSet Harness::bind(Pipeline pipeline, std::vector<Binding> bindings) {
    const BindingSet set = device.create_binding_set({"conformance set", pipeline, bindings});
    objects_.push_back(set);
    return set;
}

Texture Harness::filled(const std::string& name, Extent extent, const std::vector<Texel>& texels, Dimension dimension) {
    const Texture made = texture(name, Format::rgba32_float, extent, Usage::sampled | Usage::copy_destination, dimension);
    upload(made, pack(Format::rgba32_float, texels));
    use(made, State::sampled);
    return made;
}

CommandList& Harness::list() {
    if (!list_) list_ = &queue.begin();
    return *list_;
}

Harness::TextureInfo& Harness::info(Texture texture) {
    const auto found = std::find_if(textures_.begin(), textures_.end(), [&](const auto& t) { return t.handle == texture; });
    if (found == textures_.end()) throw std::logic_error("not a texture of this harness");
    return *found;
}

void Harness::use(Texture texture, State state) {
    TextureInfo& t = info(texture);
    const TextureBarrier barrier{texture, t.state, state};
    t.state = state;
    list().barrier({&barrier, 1}, {});
}

void Harness::use(Buffer buffer, State state) {
    const auto found = std::find_if(buffers_.begin(), buffers_.end(), [&](const auto& b) { return b.handle == buffer; });
    if (found == buffers_.end()) throw std::logic_error("not a buffer of this harness");
    const BufferBarrier barrier{buffer, found->state, state};
    found->state = state;
    list().barrier({}, {&barrier, 1});
}

void Harness::dispatch(Pipeline pipeline, BindingSet bindings, std::array<std::uint32_t, 3> groups,
                       std::span<const std::byte> push_constants) {
    list().dispatch({pipeline, bindings, push_constants, {groups[0], groups[1], groups[2]}});
}

void Harness::upload(Texture texture, const std::vector<std::byte>& packed) {
    const Buffer staging = buffer("upload for " + info(texture).desc.name, packed.size(), Usage::upload);
    device.write_buffer(staging, packed);
    use(texture, State::copy_destination);
    list().copy(BufferToTexture{staging, texture});
}

void Harness::run() {
    list();
    list_ = nullptr;
    frame_ = queue.submit();
    queue.wait();
}

std::vector<std::byte> Harness::read_packed(Texture texture) {
    const TextureDesc desc = info(texture).desc;
    std::vector<std::byte> packed(static_cast<std::size_t>(packed_size(desc)));
    const Buffer staging = buffer("read-back of " + desc.name, packed.size(), Usage::read_back);
    use(staging, State::copy_destination);
    use(texture, State::copy_source);
    list().copy(TextureToBuffer{texture, staging});
    run();
    device.read_buffer(staging, packed);
    return packed;
}

std::vector<Texel> Harness::read(Texture texture) { return unpack(info(texture).desc.format, read_packed(texture)); }

std::vector<std::byte> pack(Format format, const std::vector<Texel>& texels) {
    const std::size_t size = bytes_per_texel(format);
    std::vector<std::byte> packed(size * texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i) encode_texel(format, texels[i].data(), packed.data() + i * size);
    return packed;
}

std::vector<Texel> unpack(Format format, const std::vector<std::byte>& packed) {
    const std::size_t size = bytes_per_texel(format);
    std::vector<Texel> texels(packed.size() / size);
    for (std::size_t i = 0; i < texels.size(); ++i) decode_texel(format, packed.data() + i * size, texels[i].data());
    return texels;
}

}  // namespace aureole::conformance
