// Makes small things easy: objects that vanish with the harness, barriers by wanted state, uploads and read-backs.
#pragma once

#include <aureole/rhi/texel.h>

#include <cstring>
#include <string>
#include <vector>

#include "rhi/report.h"

namespace aureole::conformance {

class Harness {
public:
    explicit Harness(const Target& target) : device(target.device), queue(target.queue), exact(target.exact) {}
    ~Harness();
    Harness(const Harness&) = delete;
    Harness& operator=(const Harness&) = delete;

    // Creation; everything lives until the harness goes.
    rhi::Texture texture(const std::string& name, rhi::Format format, rhi::Extent extent, rhi::Usage usage,
                         rhi::Dimension dimension = rhi::Dimension::d2);
    rhi::Buffer buffer(const std::string& name, std::uint64_t size, rhi::Usage usage);
    rhi::Sampler sampler(rhi::Filter filter, rhi::Address address = rhi::Address::clamp);
    rhi::Pipeline compute(const rhi::Shader& shader, std::span<const rhi::Specialization> specialization = {});
    rhi::Pipeline raster(const rhi::Shader& shader, rhi::Format target_format);
    rhi::BindingSet bind(rhi::Pipeline pipeline, std::vector<rhi::Binding> bindings);
    /// A sampled rgba32_float texture with these texels.
    rhi::Texture filled(const std::string& name, rhi::Extent extent, const std::vector<Texel>& texels,
                        rhi::Dimension dimension = rhi::Dimension::d2);

    // Recording. `list()` begins a list when there is none.
    rhi::CommandList& list();
    void use(rhi::Texture texture, rhi::State state);
    void use(rhi::Buffer buffer, rhi::State state);
    void dispatch(rhi::Pipeline pipeline, rhi::BindingSet bindings, std::array<std::uint32_t, 3> groups,
                  std::span<const std::byte> push_constants = {});
    /// Without a barrier for the upload buffer, which no device may ask for.
    void upload(rhi::Texture texture, const std::vector<std::byte>& packed);

    /// Submits what was recorded and waits.
    void run();
    /// The frame of the latest run.
    [[nodiscard]] std::uint64_t frame() const noexcept { return frame_; }
    /// The texture's bytes after everything recorded so far.
    std::vector<std::byte> read_packed(rhi::Texture texture);
    std::vector<Texel> read(rhi::Texture texture);

    rhi::Device& device;
    rhi::Queue& queue;
    const bool exact;

private:
    struct TextureInfo {
        rhi::Texture handle;
        rhi::TextureDesc desc;
        rhi::State state = rhi::State::undefined;
    };
    struct BufferInfo {
        rhi::Buffer handle;
        rhi::State state = rhi::State::undefined;
    };
    TextureInfo& info(rhi::Texture texture);

    std::vector<TextureInfo> textures_;
    std::vector<BufferInfo> buffers_;
    std::vector<rhi::AnyHandle> objects_;
    rhi::CommandList* list_ = nullptr;
    std::uint64_t frame_ = 0;
};

/// The bytes of plain structs and arrays of floats.
template <class T>
std::span<const std::byte> bytes_of(const T& value) {
    return std::as_bytes(std::span(&value, 1));
}

/// `texels` in the bytes of `format`, each rounded to nearest.
std::vector<std::byte> pack(rhi::Format format, const std::vector<Texel>& texels);
std::vector<Texel> unpack(rhi::Format format, const std::vector<std::byte>& packed);

}  // namespace aureole::conformance
