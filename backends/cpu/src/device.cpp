#include "device.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <variant>

#include "processor.h"

namespace aureole::cpu {
namespace {

constexpr unsigned max_threads = 1024;

unsigned checked_threads(unsigned threads) {
    if (threads > max_threads)
        throw Error(ErrorCode::invalid_argument, "threads", std::to_string(threads), "0 to " + std::to_string(max_threads));
    return threads;
}

rhi::Capabilities describe(Precision precision, unsigned threads) {
    rhi::Capabilities c;
    c.backend = "cpu";
    c.device = processor_name() + (precision == Precision::float32 ? " (float)" : " (double)");
    c.driver = std::string("Aureole ") + AUREOLE_VERSION + ", oneTBB " + tbb_version();
    c.threads = threads;
    c.max_texture_2d = c.max_texture_cube = 16384;
    c.max_texture_3d = 2048;
    c.max_push_constant_bytes = 128;
    c.timestamp_slots = timestamp_slots;
    c.storage_write_without_format = true;
    c.raster = true;
    return c;
}

/// Calls `make` and turns its std::bad_alloc into an Error that names the object.
template <class Make>
auto allocate(const char* kind, const std::string& name, const Make& make) {
    try {
        return make();
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::out_of_memory, rhi::field_name(kind, name, "") + ": not enough memory");
    } catch (const std::length_error&) {
        throw Error(ErrorCode::out_of_memory, rhi::field_name(kind, name, "") + ": larger than the address space");
    }
}

}  // namespace

CpuRhiDevice::CpuRhiDevice(const CpuDeviceDesc& desc)
    : precision_(desc.precision),
      count_work_(desc.count_work),
      workers_(checked_threads(desc.threads)),
      capabilities_(describe(desc.precision, workers_.count())),
      timestamps_(timestamp_slots, std::numeric_limits<double>::quiet_NaN()) {}

template <class Handle, class Object>
Handle CpuRhiDevice::add(Pool<Handle, Object>& pool, std::shared_ptr<Object> object) {
    const Handle handle{next_handle_};
    pool.add(handle, std::move(object));
    ++next_handle_;
    return handle;
}

rhi::FormatSupport CpuRhiDevice::format_support(rhi::Format format, rhi::Dimension dimension) const {
    rhi::FormatSupport support;
    if (rhi::bytes_per_texel(format) == 0) return support;
    const bool depth = format == rhi::Format::d32_float;
    support.sampled = support.linear_filter = !depth || dimension == rhi::Dimension::d2;
    support.storage = !depth;
    support.color_attachment = !depth && dimension == rhi::Dimension::d2;
    return support;
}

rhi::Texture CpuRhiDevice::create_texture(const rhi::TextureDesc& desc) {
    rhi::check(desc, capabilities_, format_support(desc.format, desc.dimension));
    return allocate("texture", desc.name,
                    [&] { return add(textures_, std::make_shared<TextureObject>(desc, precision_, nullptr)); });
}

rhi::Texture CpuRhiDevice::wrap_texture(const rhi::ExternalTexture& external) {
    const rhi::TextureDesc& desc = external.desc;
    rhi::check(external, capabilities_, format_support(desc.format, desc.dimension));
    if (!external.cpu_texels)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("texture", desc.name, "cpu_texels"), "null",
                    "the host's texels, tightly packed");
    auto* host = static_cast<std::byte*>(external.cpu_texels);
    return allocate("texture", desc.name,
                    [&] { return add(textures_, std::make_shared<TextureObject>(desc, precision_, host)); });
}

rhi::Buffer CpuRhiDevice::create_buffer(const rhi::BufferDesc& desc) {
    rhi::check(desc);
    return allocate("buffer", desc.name, [&] { return add(buffers_, std::make_shared<BufferObject>(desc)); });
}

rhi::Sampler CpuRhiDevice::create_sampler(const rhi::SamplerDesc& desc) {
    rhi::check(desc);
    return add(samplers_, std::make_shared<rhi::SamplerDesc>(desc));
}

rhi::Pipeline CpuRhiDevice::create_compute_pipeline(const rhi::ComputePipelineDesc& desc) {
    rhi::check(desc, capabilities_);
    auto pipeline = std::make_shared<PipelineObject>(desc, precision_);
    pipeline->work = work_of(desc.name);
    return add(pipelines_, std::move(pipeline));
}

rhi::Pipeline CpuRhiDevice::create_raster_pipeline(const rhi::RasterPipelineDesc& desc) {
    rhi::check(desc, capabilities_, format_support(desc.target_format, rhi::Dimension::d2));
    auto pipeline = std::make_shared<PipelineObject>(desc, precision_);
    pipeline->work = work_of(desc.name);
    return add(pipelines_, std::move(pipeline));
}

rhi::BindingSet CpuRhiDevice::create_binding_set(const rhi::BindingSetDesc& desc) {
    const auto pipeline = pipelines_.alive(desc.pipeline);
    if (!pipeline)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("binding set", desc.name, "pipeline"), "unknown or destroyed",
                    "a live pipeline");
    const rhi::Shader& shader = pipeline->shader();
    rhi::check(desc, shader, *this, *this);

    auto set = std::make_shared<BindingsObject>(desc.name, shader);
    for (const rhi::SlotDesc& slot : shader.slots) {
        const auto& binding = *std::find_if(desc.bindings.begin(), desc.bindings.end(),
                                            [&](const rhi::Binding& b) { return b.slot == slot.slot; });
        if (slot.kind == rhi::SlotKind::constants) {
            set->set_constants(slot, buffers_.alive(binding.buffer));
        } else {
            const auto sampler = samplers_.alive(binding.sampler);
            set->set_texture(slot, textures_.alive(binding.texture), sampler ? *sampler : rhi::SamplerDesc{});
        }
    }
    return add(binding_sets_, std::move(set));
}

void CpuRhiDevice::destroy(rhi::AnyHandle handle, std::uint64_t last_used_frame) {
    const bool null = std::visit([](auto h) { return !h; }, handle);
    if (null) return;
    bool done = false;
    if (const auto* h = std::get_if<rhi::Texture>(&handle)) done = textures_.destroy(*h, last_used_frame);
    if (const auto* h = std::get_if<rhi::Buffer>(&handle)) done = buffers_.destroy(*h, last_used_frame);
    if (const auto* h = std::get_if<rhi::Sampler>(&handle)) done = samplers_.destroy(*h, last_used_frame);
    if (const auto* h = std::get_if<rhi::Pipeline>(&handle)) done = pipelines_.destroy(*h, last_used_frame);
    if (const auto* h = std::get_if<rhi::BindingSet>(&handle)) done = binding_sets_.destroy(*h, last_used_frame);
    if (!done) report(rhi::Severity::error, "destroy: unknown object, or destroyed before");
}

void CpuRhiDevice::collect(std::uint64_t completed_frame) {
    binding_sets_.collect(completed_frame);
    pipelines_.collect(completed_frame);
    samplers_.collect(completed_frame);
    buffers_.collect(completed_frame);
    textures_.collect(completed_frame);
}

void CpuRhiDevice::write_buffer(rhi::Buffer buffer, std::span<const std::byte> bytes) {
    const auto object = buffers_.alive(buffer);
    if (!object) throw Error(ErrorCode::misuse, "write_buffer: unknown or destroyed buffer");
    object->write(bytes);
}

void CpuRhiDevice::read_buffer(rhi::Buffer buffer, std::span<std::byte> bytes) {
    const auto object = buffers_.alive(buffer);
    if (!object) throw Error(ErrorCode::misuse, "read_buffer: unknown or destroyed buffer");
    object->read(bytes);
}

void CpuRhiDevice::read_timestamps(std::span<double> out_nanoseconds) {
    if (out_nanoseconds.size() > timestamps_.size())
        throw Error(ErrorCode::invalid_argument, "read_timestamps", std::to_string(out_nanoseconds.size()),
                    "at most " + std::to_string(timestamps_.size()));
    std::copy_n(timestamps_.begin(), out_nanoseconds.size(), out_nanoseconds.begin());
}

void CpuRhiDevice::set_message_callback(rhi::MessageCallback callback, void* user) {
    callback_ = callback;
    callback_user_ = user;
}

const rhi::TextureDesc* CpuRhiDevice::find(rhi::Texture texture) const {
    const auto object = textures_.alive(texture);
    return object ? &object->desc() : nullptr;
}
const rhi::BufferDesc* CpuRhiDevice::find(rhi::Buffer buffer) const {
    const auto object = buffers_.alive(buffer);
    return object ? &object->desc() : nullptr;
}
const rhi::SamplerDesc* CpuRhiDevice::find(rhi::Sampler sampler) const { return samplers_.alive(sampler).get(); }

void CpuRhiDevice::report(rhi::Severity severity, const std::string& text) const noexcept {
    if (callback_) callback_(callback_user_, severity, text.c_str());
}

PipelineWork* CpuRhiDevice::work_of(const std::string& pipeline) {
    if (!count_work_) return nullptr;
    PipelineWork& work = work_[pipeline];
    work.pipeline = pipeline;
    return &work;
}

std::vector<PipelineWork> CpuRhiDevice::work() const {
    std::vector<PipelineWork> all;
    for (const auto& [name, work] : work_) all.push_back(work);
    return all;
}

void CpuRhiDevice::reset_work() {
    for (auto& [name, work] : work_) work = PipelineWork{name, 0, 0, 0, {}};
}

}  // namespace aureole::cpu
