// A host's device as a table of C callbacks, here over the CPU device: it does what every device must, and what its callbacks
// say when they fail comes out as it is.
#include <aureole.h>
#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi_tests/conformance.h>
#include <doctest/doctest.h>

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "adapter_device.h"
#include "convert.h"

using namespace aureole;
using namespace aureole::c_api;

namespace {

/// The host: what C++ calls with, from what C is called with.
struct Host {
    std::unique_ptr<cpu::CpuDevice> cpu = cpu::create_cpu_device();
    bool fail = false;

    [[nodiscard]] rhi::Device& device() const { return cpu->device(); }
};
Host& host(void* user) { return *static_cast<Host*>(user); }
rhi::Device& device(void* user) { return host(user).device(); }
rhi::CommandList& list(void* commands) { return *static_cast<rhi::CommandList*>(commands); }

/// As a host's callbacks do it: nothing is thrown out of them.
template <class Act>
aureole_result answer(void* user, const Act& act) {
    if (host(user).fail) {
        aureole_set_callback_error("the host has no more of them");
        return AUREOLE_OUT_OF_MEMORY;
    }
    try {
        act();
        return AUREOLE_OK;
    } catch (const Error& error) {
        aureole_set_callback_error(error.what());
        return result_of(error.code());
    }
}

std::span<const std::byte> bytes_at(const void* bytes, std::uint64_t size) {
    return {static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)};
}

std::vector<rhi::Specialization> values_of(const aureole_pipeline_desc& desc) {
    std::vector<rhi::Specialization> values;
    for (std::uint32_t i = 0; i < desc.specialization_count; ++i)
        values.push_back({desc.specialization[i].id, desc.specialization[i].bits});
    return values;
}

void set_objects(aureole_adapter& c) {
    c.format_support = [](void* user, aureole_format format, aureole_dimension dimension) {
        const auto s = device(user).format_support(static_cast<rhi::Format>(format), static_cast<rhi::Dimension>(dimension));
        const auto flag = [](bool has, std::uint32_t bit) { return has ? bit : 0u; };
        return flag(s.sampled, AUREOLE_SUPPORT_SAMPLED) | flag(s.linear_filter, AUREOLE_SUPPORT_LINEAR_FILTER) |
               flag(s.storage, AUREOLE_SUPPORT_STORAGE) | flag(s.color_attachment, AUREOLE_SUPPORT_COLOR_ATTACHMENT);
    };
    c.create_texture = [](void* user, const aureole_texture_desc* desc, aureole_texture* out) {
        return answer(user, [&] { *out = device(user).create_texture(to_cpp(*desc, "desc")).value; });
    };
    c.wrap_texture = [](void* user, const aureole_external_texture* external, aureole_texture* out) {
        return answer(user, [&] { *out = device(user).wrap_texture(to_cpp(*external)).value; });
    };
    c.create_buffer = [](void* user, const aureole_buffer_desc* desc, aureole_buffer* out) {
        return answer(user, [&] {
            *out = device(user).create_buffer({desc->name, desc->size, static_cast<rhi::Usage>(desc->usage)}).value;
        });
    };
    c.create_sampler = [](void* user, const aureole_sampler_desc* desc, std::uint64_t* out) {
        const auto address = [](aureole_address a) { return static_cast<rhi::Address>(a); };
        const rhi::SamplerDesc wanted{static_cast<rhi::Filter>(desc->filter), address(desc->address_u),
                                      address(desc->address_v), address(desc->address_w)};
        return answer(user, [&] { *out = device(user).create_sampler(wanted).value; });
    };
    c.create_compute_pipeline = [](void* user, const aureole_pipeline_desc* desc, std::uint64_t* out) {
        return answer(user, [&] {
            *out = device(user).create_compute_pipeline({desc->name, &shader_of(*desc->shader), values_of(*desc)}).value;
        });
    };
    c.create_raster_pipeline = [](void* user, const aureole_pipeline_desc* desc, std::uint64_t* out) {
        const auto format = static_cast<rhi::Format>(desc->target_format);
        return answer(user, [&] {
            *out = device(user).create_raster_pipeline({desc->name, &shader_of(*desc->shader), values_of(*desc), format}).value;
        });
    };
    c.create_binding_set = [](void* user, const aureole_binding_set_desc* desc, std::uint64_t* out) {
        std::vector<rhi::Binding> bindings;
        for (std::uint32_t i = 0; i < desc->binding_count; ++i) {
            const aureole_binding& b = desc->bindings[i];
            bindings.push_back({b.slot, {b.texture}, {b.sampler}, {b.buffer}});
        }
        return answer(user, [&] { *out = device(user).create_binding_set({desc->name, {desc->pipeline}, bindings}).value; });
    };
    c.destroy = [](void* user, aureole_object_kind kind, std::uint64_t handle, std::uint64_t frame) {
        const rhi::AnyHandle by_kind[] = {rhi::Texture{handle}, rhi::Buffer{handle}, rhi::Sampler{handle},
                                          rhi::Pipeline{handle}, rhi::BindingSet{handle}};
        device(user).destroy(by_kind[kind], frame);
    };
    c.collect = [](void* user, std::uint64_t frame) { device(user).collect(frame); };
    c.write_buffer = [](void* user, aureole_buffer buffer, const void* bytes, std::uint64_t size) {
        return answer(user, [&] { device(user).write_buffer({buffer}, bytes_at(bytes, size)); });
    };
    c.read_buffer = [](void* user, aureole_buffer buffer, void* bytes, std::uint64_t size) {
        const std::span<std::byte> to(static_cast<std::byte*>(bytes), static_cast<std::size_t>(size));
        return answer(user, [&] { device(user).read_buffer({buffer}, to); });
    };
    c.read_timestamps = [](void* user, double* out, std::uint32_t count) {
        return answer(user, [&] { device(user).read_timestamps({out, count}); });
    };
}

void set_commands(aureole_adapter& c) {
    c.update_constants = [](void*, void* to, aureole_buffer buffer, const void* bytes, std::uint64_t size) {
        list(to).update_constants({buffer}, bytes_at(bytes, size));
    };
    c.barrier = [](void*, void* to, const aureole_texture_barrier* textures, std::uint32_t texture_count,
                   const aureole_buffer_barrier* buffers, std::uint32_t buffer_count) {
        for (std::uint32_t i = 0; i < texture_count; ++i) {
            const rhi::TextureBarrier b{
                {textures[i].texture}, static_cast<rhi::State>(textures[i].before), static_cast<rhi::State>(textures[i].after)};
            list(to).barrier({&b, 1}, {});
        }
        for (std::uint32_t i = 0; i < buffer_count; ++i) {
            const rhi::BufferBarrier b{
                {buffers[i].buffer}, static_cast<rhi::State>(buffers[i].before), static_cast<rhi::State>(buffers[i].after)};
            list(to).barrier({}, {&b, 1});
        }
    };
    c.dispatch = [](void*, void* to, const aureole_dispatch* d) {
        list(to).dispatch({{d->pipeline},
                           {d->binding_set},
                           bytes_at(d->push_constants, d->push_constant_bytes),
                           {d->groups[0], d->groups[1], d->groups[2]}});
    };
    c.draw_fullscreen = [](void*, void* to, const aureole_draw* d) {
        list(to).draw_fullscreen(
            {{d->pipeline}, {d->binding_set}, bytes_at(d->push_constants, d->push_constant_bytes), {d->target}});
    };
    c.copy_texture_to_buffer = [](void*, void* to, aureole_texture source, aureole_buffer destination) {
        list(to).copy(rhi::TextureToBuffer{{source}, {destination}});
    };
    c.copy_buffer_to_texture = [](void*, void* to, aureole_buffer source, aureole_texture destination) {
        list(to).copy(rhi::BufferToTexture{{source}, {destination}});
    };
    c.copy_texture_to_texture = [](void*, void* to, aureole_texture source, aureole_texture destination) {
        list(to).copy(rhi::TextureToTexture{{source}, {destination}});
    };
    c.begin_marker = [](void*, void* to, const char* name) { list(to).begin_marker(name); };
    c.end_marker = [](void*, void* to) { list(to).end_marker(); };
    c.timestamp = [](void*, void* to, std::uint32_t slot) { list(to).timestamp(slot); };
}

aureole_adapter adapter_of(Host& on) {
    aureole_adapter c{};
    c.struct_size = sizeof c;
    c.user = &on;
    const rhi::Capabilities& has = on.device().capabilities();
    c.backend = "host", c.device = "a host's", c.driver = "of the host";
    c.max_texture_2d = has.max_texture_2d, c.max_texture_3d = has.max_texture_3d, c.max_texture_cube = has.max_texture_cube;
    c.max_push_constant_bytes = has.max_push_constant_bytes;
    c.timestamp_slots = has.timestamp_slots;
    c.storage_write_without_format = c.raster = 1;
    set_objects(c);
    set_commands(c);
    return c;
}

/// The host's frame: its list is the CPU device's.
class HostQueue final : public rhi::Queue {
public:
    HostQueue(Host& on, AdapterDevice& adapter) : host_(on), adapter_(adapter) {}
    [[nodiscard]] rhi::CommandList& begin() override { return adapter_.list(&host_.cpu->queue().begin()); }
    std::uint64_t submit() override { return host_.cpu->queue().submit(); }
    void wait() override { host_.cpu->queue().wait(); }

private:
    Host& host_;
    AdapterDevice& adapter_;
};

}  // namespace

TEST_CASE("a device of C callbacks does what every device must") {
    Host on;
    AdapterDevice adapter(adapter_of(on));
    HostQueue queue(on, adapter);
    std::deque<std::vector<std::byte>> memory;
    conformance::Target target{adapter, queue, true};
    target.lend = [&](const rhi::TextureDesc& desc) {
        memory.emplace_back(static_cast<std::size_t>(rhi::packed_size(desc)));
        rhi::ExternalTexture external{desc};
        external.cpu_texels = memory.back().data();
        external.state = rhi::State::general;
        return external;
    };
    target.pass_tolerance = 1e-300;
    const conformance::Report report = conformance::run_all(target);
    CAPTURE(report.text());
    CHECK(report.passed());
    CHECK(report.count(conformance::Outcome::skipped) == 0);
}

TEST_CASE("a callback that fails is an error with its result and its words, and leaves nothing behind") {
    Host on;
    const aureole_adapter adapter = adapter_of(on);
    aureole_device* device = nullptr;
    REQUIRE(aureole_create_adapter_device(&adapter, &device) == AUREOLE_OK);
    aureole_parameters air{};
    air.struct_size = sizeof air;
    REQUIRE(aureole_preset("earth", &air) == AUREOLE_OK);
    on.fail = true;
    aureole_atmosphere* atmosphere = nullptr;
    CHECK(aureole_create_atmosphere(device, &air, nullptr, &atmosphere) == AUREOLE_OUT_OF_MEMORY);
    CHECK(std::string(aureole_last_error()).find("the host has no more of them") != std::string::npos);
    CHECK(atmosphere == nullptr);
    on.fail = false;
    CHECK(aureole_create_atmosphere(device, &air, nullptr, &atmosphere) == AUREOLE_OK);
    CHECK(aureole_destroy_atmosphere(atmosphere) == AUREOLE_OK);
    CHECK(aureole_destroy_device(device) == AUREOLE_OK);
}

TEST_CASE("an adapter without a callback that it needs is refused by its name") {
    Host on;
    aureole_adapter adapter = adapter_of(on);
    aureole_device* device = nullptr;
    adapter.dispatch = nullptr;
    CHECK(aureole_create_adapter_device(&adapter, &device) == AUREOLE_INVALID_ARGUMENT);
    CHECK(std::string(aureole_last_error_field()) == "adapter.dispatch");
    adapter = adapter_of(on);
    adapter.raster = adapter.timestamp_slots = 0;
    adapter.draw_fullscreen = nullptr, adapter.create_raster_pipeline = nullptr;
    adapter.timestamp = nullptr, adapter.read_timestamps = nullptr, adapter.begin_marker = nullptr,
    adapter.wrap_texture = nullptr;
    CHECK(aureole_create_adapter_device(&adapter, &device) == AUREOLE_OK);
    CHECK(aureole_destroy_device(device) == AUREOLE_OK);
}
