// A texture on the CPU: RGBA numbers in the device's precision, decoded from and encoded to the format's bytes by copies.
#pragma once

#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi/shader.h>

#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include "workers.h"

namespace aureole::cpu {

class TextureObject {
public:
    /// `host` is the host's packed memory for a wrapped texture, null for one of the device's own.
    TextureObject(const rhi::TextureDesc& desc, Precision precision, std::byte* host);

    [[nodiscard]] const rhi::TextureDesc& desc() const noexcept { return desc_; }
    [[nodiscard]] std::uint64_t texel_count() const noexcept { return texel_count_; }
    /// As the kernels see it; the caller adds kind and sampler. Stays valid as long as the texture lives.
    [[nodiscard]] rhi::CpuBinding binding() noexcept;

    /// `packed` has at least packed_size(desc()) bytes.
    void decode_from(std::span<const std::byte> packed, Workers& workers);
    void encode_to(std::span<std::byte> packed, Workers& workers) const;
    /// Same format and extent. Nothing is rounded.
    void copy_from(const TextureObject& source);
    /// Fresh contents.
    void discard(Workers& workers);
    [[nodiscard]] std::vector<double> to_double() const;

    [[nodiscard]] bool of_host() const noexcept { return host_ != nullptr; }
    void load_from_host(Workers& workers);
    void store_to_host(Workers& workers) const;

    // The submission that last loaded this host texture, and whether it has been written since (see Executor).
    std::uint64_t loaded_by = 0;
    bool written = false;

private:
    rhi::TextureDesc desc_;
    std::uint64_t texel_count_ = 0;
    std::byte* host_ = nullptr;
    std::variant<std::vector<float>, std::vector<double>> texels_;
};

}  // namespace aureole::cpu
