// Devices in C: the CPU's, and what all kinds share.
#include <aureole/cpu/cpu_device.h>

#include <span>

#include "convert.h"
#include "handles.h"

using namespace aureole;
using namespace aureole::c_api;

void aureole_device::listen(aureole_message_callback callback, void* user) {
    listener_ = {callback, user};
    rhi_device().set_message_callback(callback ? &aureole_device::tell : nullptr, this);
}

void aureole_device::tell(void* device, rhi::Severity severity, const char* text) {
    const Listener& listener = static_cast<aureole_device*>(device)->listener_;
    if (listener.callback) listener.callback(listener.user, number(severity), text);
}

rhi::CommandList& aureole_device::begin_on(void* host_list, std::uint32_t queue_family) {
    if (queue_family == no_queue_family) return begin(host_list);
    throw Error(ErrorCode::invalid_argument, "queue_family", std::to_string(queue_family),
                "UINT32_MAX: only a host's Vulkan device knows families");
}
void aureole_device::wait() {
    throw Error(ErrorCode::unsupported, "a host's device has no queue of Aureole's: the host waits, and calls aureole_collect");
}
void aureole_device::native(rhi::Texture, aureole_native_texture&) const {
    throw Error(ErrorCode::unsupported, "only Vulkan devices have native objects");
}
std::uint64_t aureole_device::native(rhi::Buffer) const {
    throw Error(ErrorCode::unsupported, "only Vulkan devices have native objects");
}

rhi::CommandList& c_api::open_list(aureole_commands* commands) {
    if (!given(commands, "commands").list) throw Error(ErrorCode::misuse, "no list is open: aureole_begin comes first");
    return *commands->list;
}

rhi::CommandList& c_api::open_list(aureole_device& device, aureole_commands* commands) {
    if (&given(commands, "commands") != &device.commands)
        throw Error(ErrorCode::invalid_argument, "commands", "a list of another device", "that of the object's own device");
    return open_list(commands);
}

namespace {

struct CpuDevice final : aureole_device {
    explicit CpuDevice(const cpu::CpuDeviceDesc& desc) : made(cpu::create_cpu_device(desc)) {}
    [[nodiscard]] rhi::Device& rhi_device() override { return made->device(); }
    [[nodiscard]] rhi::CommandList& begin(void* host_list) override {
        if (host_list)
            throw Error(ErrorCode::invalid_argument, "host_list", "a pointer", "NULL: this device has its own queue");
        return made->queue().begin();
    }
    std::uint64_t end() override { return made->queue().submit(); }
    void wait() override { made->queue().wait(); }

    std::unique_ptr<cpu::CpuDevice> made;
};

aureole_cpu_device_desc default_cpu() {
    const cpu::CpuDeviceDesc desc;
    return {sizeof(aureole_cpu_device_desc), number(desc.precision), desc.threads};
}
static_assert(number(cpu::Precision::float64) == AUREOLE_FLOAT64);
static_assert(number(rhi::Severity::warning) == AUREOLE_WARNING && number(rhi::Severity::error) == AUREOLE_ERROR);

rhi::Device& device_of(aureole_device* device) { return given(device, "device").rhi_device(); }

}  // namespace

aureole_result aureole_cpu_device_desc_defaults(aureole_cpu_device_desc* desc) {
    return guarded([&] { write(desc, "desc", default_cpu()); });
}

aureole_result aureole_create_cpu_device(const aureole_cpu_device_desc* desc, aureole_device** out_device) {
    return guarded([&] {
        const aureole_cpu_device_desc c = read(desc, "desc", default_cpu());
        given(out_device, "out_device");
        cpu::CpuDeviceDesc wanted;
        wanted.precision = enumerator(c.precision, cpu::Precision::float64, "desc.precision");
        wanted.threads = c.threads;
        *out_device = new CpuDevice(wanted);
    });
}

aureole_result aureole_destroy_device(aureole_device* device) {
    return guarded([&] {
        if (!device) return;
        if (device->atmospheres > 0)
            throw Error(ErrorCode::misuse, "the device has " + std::to_string(device->atmospheres) +
                                               " atmospheres or planned skies that live: they are destroyed before it");
        delete device;
    });
}

aureole_result aureole_get_capabilities(const aureole_device* device, aureole_capabilities* out_capabilities) {
    return guarded([&] {
        const rhi::Capabilities& c = given(device, "device").rhi_device().capabilities();
        write(out_capabilities, "out_capabilities",
              {sizeof(aureole_capabilities), c.backend.c_str(), c.device.c_str(), c.driver.c_str(), c.max_texture_2d,
               c.max_texture_3d, c.max_texture_cube, c.max_push_constant_bytes, c.timestamp_slots, c.raster});
    });
}

aureole_result aureole_set_message_callback(aureole_device* device, aureole_message_callback callback, void* user) {
    return guarded([&] { given(device, "device").listen(callback, user); });
}

aureole_result aureole_texture_desc_defaults(aureole_texture_desc* desc) {
    return guarded([&] {
        aureole_texture_desc c = to_c(rhi::TextureDesc{});
        c.name = nullptr;
        write(desc, "desc", c);
    });
}

aureole_result aureole_create_texture(aureole_device* device, const aureole_texture_desc* desc, aureole_texture* out_texture) {
    return guarded([&] {
        rhi::Device& on = device_of(device);
        const aureole_texture_desc c = read(desc, "desc", to_c(rhi::TextureDesc{}));
        aureole_texture& out = given(out_texture, "out_texture");
        out = on.create_texture(to_cpp(c, "desc")).value;
    });
}

aureole_result aureole_external_texture_defaults(aureole_external_texture* external) {
    return guarded([&] { write(external, "external", to_c(rhi::ExternalTexture{}, nullptr)); });
}

aureole_result aureole_wrap_texture(aureole_device* device, const aureole_external_texture* external,
                                    aureole_texture* out_texture) {
    return guarded([&] {
        rhi::Device& on = device_of(device);
        const aureole_external_texture c = read(external, "external", to_c(rhi::ExternalTexture{}, nullptr));
        aureole_texture& out = given(out_texture, "out_texture");
        out = on.wrap_texture(to_cpp(c)).value;
    });
}

aureole_result aureole_create_buffer(aureole_device* device, const char* name, uint64_t size, aureole_usage usage,
                                     aureole_buffer* out_buffer) {
    return guarded([&] {
        rhi::Device& on = device_of(device);
        aureole_buffer& out = given(out_buffer, "out_buffer");
        out = on.create_buffer({text(name), size, usage_of(usage, "usage")}).value;
    });
}

aureole_result aureole_destroy_texture(aureole_device* device, aureole_texture texture, uint64_t last_used_frame) {
    return guarded([&] { device_of(device).destroy(rhi::Texture{texture}, last_used_frame); });
}

aureole_result aureole_destroy_buffer(aureole_device* device, aureole_buffer buffer, uint64_t last_used_frame) {
    return guarded([&] { device_of(device).destroy(rhi::Buffer{buffer}, last_used_frame); });
}

aureole_result aureole_write_buffer(aureole_device* device, aureole_buffer buffer, const void* bytes, uint64_t size) {
    return guarded([&] {
        const auto* from = static_cast<const std::byte*>(bytes);
        device_of(device).write_buffer({buffer}, {&given(from, "bytes"), static_cast<std::size_t>(size)});
    });
}

aureole_result aureole_read_buffer(aureole_device* device, aureole_buffer buffer, void* bytes, uint64_t size) {
    return guarded([&] {
        auto* to = static_cast<std::byte*>(bytes);
        device_of(device).read_buffer({buffer}, {&given(to, "bytes"), static_cast<std::size_t>(size)});
    });
}

aureole_result aureole_read_timestamps(aureole_device* device, double* out_nanoseconds, uint32_t count) {
    return guarded([&] { device_of(device).read_timestamps({&given(out_nanoseconds, "out_nanoseconds"), count}); });
}

aureole_result aureole_get_native_texture(const aureole_device* device, aureole_texture texture,
                                          aureole_native_texture* out_native) {
    return guarded([&] {
        aureole_native_texture c{sizeof(aureole_native_texture), 0, 0, 0};
        given(device, "device").native(rhi::Texture{texture}, c);
        write(out_native, "out_native", c);
    });
}

aureole_result aureole_get_native_buffer(const aureole_device* device, aureole_buffer buffer, uint64_t* out_native) {
    return guarded([&] { given(out_native, "out_native") = given(device, "device").native(rhi::Buffer{buffer}); });
}

aureole_result aureole_begin(aureole_device* device, void* host_list, aureole_commands** out_commands) {
    return aureole_begin_on(device, host_list, no_queue_family, out_commands);
}

aureole_result aureole_begin_on(aureole_device* device, void* host_list, uint32_t queue_family,
                                aureole_commands** out_commands) {
    return guarded([&] {
        aureole_device& on = given(device, "device");
        given(out_commands, "out_commands");
        if (on.commands.list) throw Error(ErrorCode::misuse, "a list of this device is open: aureole_end comes first");
        on.commands.list = &on.begin_on(host_list, queue_family);
        *out_commands = &on.commands;
    });
}

aureole_result aureole_end(aureole_device* device, uint64_t* out_frame) {
    return guarded([&] {
        aureole_device& on = given(device, "device");
        (void)open_list(&on.commands);
        on.commands.list = nullptr;
        const std::uint64_t frame = on.end();
        if (out_frame) *out_frame = frame;
    });
}

aureole_result aureole_wait(aureole_device* device) {
    return guarded([&] { given(device, "device").wait(); });
}

aureole_result aureole_collect(aureole_device* device, uint64_t completed_frame) {
    return guarded([&] { device_of(device).collect(completed_frame); });
}

aureole_result aureole_barrier_texture(aureole_commands* commands, aureole_texture texture, aureole_state before,
                                       aureole_state after) {
    return guarded([&] {
        const rhi::TextureBarrier barrier{{texture}, state_of(before, "before"), state_of(after, "after")};
        open_list(commands).barrier({&barrier, 1}, {});
    });
}

aureole_result aureole_barrier_buffer(aureole_commands* commands, aureole_buffer buffer, aureole_state before,
                                      aureole_state after) {
    return guarded([&] {
        const rhi::BufferBarrier barrier{{buffer}, state_of(before, "before"), state_of(after, "after")};
        open_list(commands).barrier({}, {&barrier, 1});
    });
}

aureole_result aureole_copy_texture_to_buffer(aureole_commands* commands, aureole_texture source, aureole_buffer destination) {
    return guarded([&] { open_list(commands).copy(rhi::TextureToBuffer{{source}, {destination}}); });
}

aureole_result aureole_copy_buffer_to_texture(aureole_commands* commands, aureole_buffer source, aureole_texture destination) {
    return guarded([&] { open_list(commands).copy(rhi::BufferToTexture{{source}, {destination}}); });
}
