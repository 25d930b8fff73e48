#include <aureole/cpu/cpu_device.h>

#include "device.h"
#include "queue.h"

namespace aureole::cpu {
namespace {

class CpuDeviceWithQueue final : public CpuDevice {
public:
    explicit CpuDeviceWithQueue(const CpuDeviceDesc& desc) : device_(desc), queue_(device_) {}

    rhi::Device& device() noexcept override { return device_; }
    rhi::Queue& queue() noexcept override { return queue_; }
    Precision precision() const noexcept override { return device_.precision(); }
    unsigned threads() const noexcept override { return device_.workers().count(); }
    std::vector<PipelineWork> work() const override { return device_.work(); }
    void reset_work() override { device_.reset_work(); }

    std::vector<double> read_texels_double(rhi::Texture texture) const override {
        const auto object = device_.textures().alive(texture);
        if (!object) throw Error(ErrorCode::invalid_argument, "texture", "unknown or destroyed", "a texture of this device");
        return object->to_double();
    }

private:
    CpuRhiDevice device_;
    CpuQueue queue_;
};

}  // namespace

std::unique_ptr<CpuDevice> create_cpu_device(const CpuDeviceDesc& desc) { return std::make_unique<CpuDeviceWithQueue>(desc); }

}  // namespace aureole::cpu
