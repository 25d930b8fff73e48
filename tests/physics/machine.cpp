#include "physics/machine.h"

#include <stdexcept>

namespace aureole::physics {
namespace {

class CpuMachine final : public Machine {
public:
    explicit CpuMachine(cpu::Precision precision) : device_(cpu::create_cpu_device({precision, 0, false})) { listen(); }
    rhi::Device& device() override { return device_->device(); }
    rhi::Queue& queue() override { return device_->queue(); }
    const cpu::CpuDevice* cpu() const override { return device_.get(); }

private:
    std::unique_ptr<cpu::CpuDevice> device_;
};

}  // namespace

void Machine::listen() {
    device().set_message_callback(
        [](void* user, rhi::Severity severity, const char* text) {
            if (severity == rhi::Severity::error) static_cast<Machine*>(user)->error_ = text;
        },
        this);
}

void Machine::run(const std::function<void(rhi::CommandList&)>& record) {
    record(queue().begin());
    frame_ = queue().submit();
    queue().wait();
    if (!error_.empty()) throw std::runtime_error("the device reported: " + error_);
}

rhi::Texture Machine::texture(const char* name, rhi::Format format, rhi::Extent extent, rhi::Usage usage) {
    return device().create_texture({name, rhi::Dimension::d2, format, extent, usage});
}

void Machine::move(rhi::Texture texture, rhi::State before, rhi::State after) {
    run([&](rhi::CommandList& commands) {
        const rhi::TextureBarrier barrier{texture, before, after};
        commands.barrier({&barrier, 1}, {});
    });
}

void Machine::upload(rhi::Texture texture, std::span<const float> texels, rhi::State before, rhi::State after) {
    const rhi::Buffer buffer =
        device().create_buffer({"upload", texels.size_bytes(), rhi::Usage::upload | rhi::Usage::copy_source});
    device().write_buffer(buffer, std::as_bytes(texels));
    run([&](rhi::CommandList& commands) {
        const rhi::TextureBarrier writable{texture, before, rhi::State::copy_destination};
        const rhi::BufferBarrier readable{buffer, rhi::State::undefined, rhi::State::copy_source};
        commands.barrier({&writable, 1}, {&readable, 1});
        commands.copy(rhi::BufferToTexture{buffer, texture});
        const rhi::TextureBarrier done{texture, rhi::State::copy_destination, after};
        commands.barrier({&done, 1}, {});
    });
    destroy(buffer);
}

std::vector<glm::dvec4> Machine::read(rhi::Texture texture, std::size_t texels, rhi::State state) {
    std::vector<glm::dvec4> result(texels);
    if (cpu()) {
        const std::vector<double> values = cpu()->read_texels_double(texture);
        for (std::size_t i = 0; i < texels; ++i)
            result[i] = {values.at(4 * i), values.at(4 * i + 1), values.at(4 * i + 2), values.at(4 * i + 3)};
        return result;
    }
    std::vector<glm::vec4> values(texels);
    const std::span<std::byte> bytes = std::as_writable_bytes(std::span(values));
    const rhi::Buffer buffer =
        device().create_buffer({"read back", bytes.size(), rhi::Usage::read_back | rhi::Usage::copy_destination});
    run([&](rhi::CommandList& commands) {
        const rhi::TextureBarrier readable{texture, state, rhi::State::copy_source};
        const rhi::BufferBarrier writable{buffer, rhi::State::undefined, rhi::State::copy_destination};
        commands.barrier({&readable, 1}, {&writable, 1});
        commands.copy(rhi::TextureToBuffer{texture, buffer});
        const rhi::TextureBarrier done{texture, rhi::State::copy_source, state};
        commands.barrier({&done, 1}, {});
    });
    device().read_buffer(buffer, bytes);
    destroy(buffer);
    for (std::size_t i = 0; i < texels; ++i) result[i] = values[i];
    return result;
}

Machine& cpu_float() {
    static CpuMachine machine(cpu::Precision::float32);
    return machine;
}
Machine& cpu_double() {
    static CpuMachine machine(cpu::Precision::float64);
    return machine;
}

}  // namespace aureole::physics
