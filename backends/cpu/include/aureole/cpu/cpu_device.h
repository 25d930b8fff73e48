// The CPU backend: runs the kernels of rhi::Shader objects on the cores of this machine.
#pragma once

#include <aureole/rhi/device.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace aureole::cpu {

/// What kernels compute in.
enum class Precision : std::uint8_t {
    float32,  ///< Mirrors a GPU: float arithmetic, and every texel really rounded to its format.
    float64,  ///< The reference: double arithmetic, and textures keep every bit. Buffers hold the formats' packed bytes.
};

/// How a CPU device works.
struct CpuDeviceDesc {
    Precision precision = Precision::float32;  ///< Of all arithmetic.
    unsigned threads = 0;     ///< 1 to 1024, but no more than the process may use; 0: all. Results do not depend on it.
    bool count_work = false;  ///< Fill CpuDevice::work(). Costs a few percent.
};

/// What all dispatches or draws of the pipelines of one name did since the last reset.
struct PipelineWork {
    std::string pipeline;           ///< ComputePipelineDesc::name or RasterPipelineDesc::name.
    std::uint64_t dispatches = 0;   ///< Or draws.
    std::uint64_t invocations = 0;  ///< Kernel calls, those outside the image (up to whole groups) included.
    double seconds = 0;             ///< Wall time.
    rhi::CpuCounts counts;          ///< Evaluations, look-ups, stores and bytes of all invocations together.
};

/// A device with its queue. The queue works in the calling thread: `submit` returns when the work is done, and throws
/// Error(internal) or Error(out_of_memory) when a kernel failed; textures of the host are then left as they were.
///
/// Threading: one thread at a time. Lifetime: must outlive whoever uses device() and queue().
/// Fresh textures of float formats are filled with NaN, so that reading what was never written shows; so are those that a
/// barrier moves out of State::undefined, which throws their contents away (a host's texture keeps its own).
class CpuDevice {
public:
    virtual ~CpuDevice() = default;

    [[nodiscard]] virtual rhi::Device& device() noexcept = 0;        ///< For Atmosphere and textures.
    [[nodiscard]] virtual rhi::Queue& queue() noexcept = 0;          ///< Records and runs command lists.
    [[nodiscard]] virtual Precision precision() const noexcept = 0;  ///< As it was made with.
    [[nodiscard]] virtual unsigned threads() const noexcept = 0;     ///< That run kernels.

    /// All texels as RGBA (linear, missing channels 0, alpha 1), row by row, slice by slice, face by face. With
    /// Precision::float64 nothing is rounded. Throws Error(invalid_argument) for an unknown texture.
    [[nodiscard]] virtual std::vector<double> read_texels_double(rhi::Texture texture) const = 0;

    /// Per pipeline name, in alphabetical order; empty unless count_work was asked for.
    [[nodiscard]] virtual std::vector<PipelineWork> work() const = 0;
    virtual void reset_work() = 0;  ///< Counts begin at 0 again.
};

/// Throws Error(invalid_argument) for more than 1024 threads, Error(out_of_memory).
[[nodiscard]] std::unique_ptr<CpuDevice> create_cpu_device(const CpuDeviceDesc& desc = {});

}  // namespace aureole::cpu
