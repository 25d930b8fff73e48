#include "adapter_device.h"

#include <array>
#include <utility>
#include <vector>

#include "adapter_list.h"
#include "convert.h"
#include "handles.h"

namespace aureole::c_api {
namespace {

/// What a callback returned.
void check_result(aureole_result result, const char* function) {
    const std::string said = take_callback_error();
    if (result == AUREOLE_OK) return;
    throw Error(code_of(result), std::string(function) + ": " + (said.empty() ? "the host's callback failed" : said));
}

std::uint64_t check_handle(std::uint64_t handle, const char* function) {
    if (handle == 0) throw Error(ErrorCode::internal, std::string(function) + ": the host's callback gave the handle 0");
    return handle;
}

rhi::Capabilities capabilities_of(const aureole_adapter& c) {
    rhi::Capabilities capabilities;
    capabilities.backend = text(c.backend);
    capabilities.device = text(c.device);
    capabilities.driver = text(c.driver);
    capabilities.max_texture_2d = c.max_texture_2d;
    capabilities.max_texture_3d = c.max_texture_3d;
    capabilities.max_texture_cube = c.max_texture_cube;
    capabilities.max_push_constant_bytes = c.max_push_constant_bytes;
    capabilities.timestamp_slots = c.timestamp_slots;
    capabilities.storage_write_without_format = boolean(c.storage_write_without_format, "adapter.storage_write_without_format");
    capabilities.raster = boolean(c.raster, "adapter.raster");
    return capabilities;
}

void need(bool there, const char* callback) {
    if (!there) throw Error(ErrorCode::invalid_argument, std::string("adapter.") + callback, "NULL", "a callback");
}

void check_callbacks(const aureole_adapter& c) {
    need(c.format_support, "format_support");
    need(c.create_texture, "create_texture");
    need(c.create_buffer, "create_buffer");
    need(c.create_sampler, "create_sampler");
    need(c.create_compute_pipeline, "create_compute_pipeline");
    need(c.create_raster_pipeline || !c.raster, "create_raster_pipeline");
    need(c.create_binding_set, "create_binding_set");
    need(c.destroy, "destroy");
    need(c.collect, "collect");
    need(c.write_buffer, "write_buffer");
    need(c.read_buffer, "read_buffer");
    need(c.read_timestamps || c.timestamp_slots == 0, "read_timestamps");
    need(c.update_constants, "update_constants");
    need(c.barrier, "barrier");
    need(c.dispatch, "dispatch");
    need(c.draw_fullscreen || !c.raster, "draw_fullscreen");
    need(c.copy_texture_to_buffer, "copy_texture_to_buffer");
    need(c.copy_buffer_to_texture, "copy_buffer_to_texture");
    need(c.copy_texture_to_texture, "copy_texture_to_texture");
    need(c.end_marker || !c.begin_marker, "end_marker");
    need(c.timestamp || c.timestamp_slots == 0, "timestamp");
}

static_assert(number(rhi::Filter::linear) == AUREOLE_LINEAR && number(rhi::Address::repeat) == AUREOLE_REPEAT);

}  // namespace

AdapterDevice::AdapterDevice(const aureole_adapter& adapter)
    : c_(adapter), capabilities_(capabilities_of(adapter)), list_(std::make_unique<List>(*this)) {
    check_callbacks(c_);
}

AdapterDevice::~AdapterDevice() = default;

rhi::CommandList& AdapterDevice::list(void* host_list) {
    list_->begin(host_list);
    return *list_;
}

rhi::FormatSupport AdapterDevice::format_support(rhi::Format format, rhi::Dimension dimension) const {
    if (format == rhi::Format::undefined) return {};
    const std::uint32_t flags = c_.format_support(c_.user, number(format), number(dimension));
    const auto has = [&](std::uint32_t flag) { return (flags & flag) != 0; };
    return {has(AUREOLE_SUPPORT_SAMPLED), has(AUREOLE_SUPPORT_LINEAR_FILTER), has(AUREOLE_SUPPORT_STORAGE),
            has(AUREOLE_SUPPORT_COLOR_ATTACHMENT)};
}

const rhi::TextureDesc* AdapterDevice::find(rhi::Texture texture) const { return record_of(textures_, texture.value); }
const rhi::BufferDesc* AdapterDevice::find(rhi::Buffer buffer) const { return record_of(buffers_, buffer.value); }
const rhi::SamplerDesc* AdapterDevice::find(rhi::Sampler sampler) const { return record_of(samplers_, sampler.value); }

rhi::Texture AdapterDevice::create_texture(const rhi::TextureDesc& desc) {
    rhi::check(desc, capabilities_, format_support(desc.format, desc.dimension));
    const aureole_texture_desc c = to_c(desc);
    rhi::Texture texture;
    check_result(c_.create_texture(c_.user, &c, &texture.value), "create_texture");
    textures_[check_handle(texture.value, "create_texture")] = desc;
    return texture;
}

rhi::Texture AdapterDevice::wrap_texture(const rhi::ExternalTexture& external) {
    rhi::check(external, capabilities_, format_support(external.desc.format, external.desc.dimension));
    if (!c_.wrap_texture) throw Error(ErrorCode::unsupported, "wrap_texture: the host's adapter takes no textures");
    const aureole_texture_desc desc = to_c(external.desc);
    const aureole_external_texture c = to_c(external, &desc);
    rhi::Texture texture;
    check_result(c_.wrap_texture(c_.user, &c, &texture.value), "wrap_texture");
    textures_[check_handle(texture.value, "wrap_texture")] = external.desc;
    return texture;
}

rhi::Buffer AdapterDevice::create_buffer(const rhi::BufferDesc& desc) {
    rhi::check(desc);
    const aureole_buffer_desc c{desc.name.c_str(), desc.size, number(desc.usage)};
    rhi::Buffer buffer;
    check_result(c_.create_buffer(c_.user, &c, &buffer.value), "create_buffer");
    buffers_[check_handle(buffer.value, "create_buffer")] = desc;
    return buffer;
}

rhi::Sampler AdapterDevice::create_sampler(const rhi::SamplerDesc& desc) {
    rhi::check(desc);
    const aureole_sampler_desc c{number(desc.filter), number(desc.address_u), number(desc.address_v), number(desc.address_w)};
    rhi::Sampler sampler;
    check_result(c_.create_sampler(c_.user, &c, &sampler.value), "create_sampler");
    samplers_[check_handle(sampler.value, "create_sampler")] = desc;
    return sampler;
}

rhi::Pipeline AdapterDevice::add_pipeline(PipelineRecord record, std::span<const rhi::Specialization> specialization,
                                          aureole_result (*create)(void*, const aureole_pipeline_desc*, std::uint64_t*),
                                          const char* function) {
    std::vector<aureole_specialization> values;
    for (const rhi::Specialization& value : specialization) values.push_back({value.id, value.bits});
    const aureole_pipeline_desc c{record.name.c_str(), &shader_in_c(*record.shader), values.data(),
                                  static_cast<std::uint32_t>(values.size()), number(record.target_format)};
    rhi::Pipeline pipeline;
    check_result(create(c_.user, &c, &pipeline.value), function);
    pipelines_[check_handle(pipeline.value, function)] = std::move(record);
    return pipeline;
}

rhi::Pipeline AdapterDevice::create_compute_pipeline(const rhi::ComputePipelineDesc& desc) {
    rhi::check(desc, capabilities_);
    return add_pipeline({desc.name, desc.shader, rhi::Format::undefined}, desc.specialization, c_.create_compute_pipeline,
                        "create_compute_pipeline");
}

rhi::Pipeline AdapterDevice::create_raster_pipeline(const rhi::RasterPipelineDesc& desc) {
    rhi::check(desc, capabilities_, format_support(desc.target_format, rhi::Dimension::d2));
    return add_pipeline({desc.name, desc.shader, desc.target_format}, desc.specialization, c_.create_raster_pipeline,
                        "create_raster_pipeline");
}

rhi::BindingSet AdapterDevice::create_binding_set(const rhi::BindingSetDesc& desc) {
    const PipelineRecord* pipeline = record_of(pipelines_, desc.pipeline.value);
    if (!pipeline)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("binding set", desc.name, "pipeline"), "unknown or destroyed",
                    "a live pipeline");
    rhi::check(desc, *pipeline->shader, *this, *this);
    std::vector<aureole_binding> bindings;
    for (const rhi::Binding& b : desc.bindings) bindings.push_back({b.slot, b.texture.value, b.sampler.value, b.buffer.value});
    const aureole_binding_set_desc c{desc.name.c_str(), desc.pipeline.value, bindings.data(),
                                     static_cast<std::uint32_t>(bindings.size())};
    rhi::BindingSet set;
    check_result(c_.create_binding_set(c_.user, &c, &set.value), "create_binding_set");
    sets_[check_handle(set.value, "create_binding_set")] = {desc.name, pipeline->shader};
    return set;
}

void AdapterDevice::destroy(rhi::AnyHandle handle, std::uint64_t last_used_frame) {
    const std::uint64_t value = std::visit([](auto h) { return h.value; }, handle);
    if (value == 0) return;
    const std::size_t known = std::holds_alternative<rhi::Texture>(handle)    ? textures_.erase(value)
                              : std::holds_alternative<rhi::Buffer>(handle)   ? buffers_.erase(value)
                              : std::holds_alternative<rhi::Sampler>(handle)  ? samplers_.erase(value)
                              : std::holds_alternative<rhi::Pipeline>(handle) ? pipelines_.erase(value)
                                                                              : sets_.erase(value);
    if (known == 0) return tell("destroy: unknown object, or destroyed before");
    c_.destroy(c_.user, static_cast<aureole_object_kind>(handle.index()), value, last_used_frame);
}
// The kinds in C are the places of the alternatives.
static_assert(std::is_same_v<std::variant_alternative_t<AUREOLE_OBJECT_TEXTURE, rhi::AnyHandle>, rhi::Texture>);
static_assert(std::is_same_v<std::variant_alternative_t<AUREOLE_OBJECT_BUFFER, rhi::AnyHandle>, rhi::Buffer>);
static_assert(std::is_same_v<std::variant_alternative_t<AUREOLE_OBJECT_SAMPLER, rhi::AnyHandle>, rhi::Sampler>);
static_assert(std::is_same_v<std::variant_alternative_t<AUREOLE_OBJECT_PIPELINE, rhi::AnyHandle>, rhi::Pipeline>);
static_assert(std::is_same_v<std::variant_alternative_t<AUREOLE_OBJECT_BINDING_SET, rhi::AnyHandle>, rhi::BindingSet>);

void AdapterDevice::collect(std::uint64_t completed_frame) { c_.collect(c_.user, completed_frame); }

const rhi::BufferDesc& AdapterDevice::usable(rhi::Buffer buffer, rhi::Usage usage, std::size_t bytes,
                                             const char* function) const {
    const rhi::BufferDesc* desc = find(buffer);
    if (!desc) throw Error(ErrorCode::misuse, std::string(function) + ": unknown or destroyed buffer");
    if (!rhi::has(desc->usage, usage))
        throw Error(ErrorCode::misuse, std::string(function) + ": " + rhi::field_name("buffer", desc->name, "") +
                                           " has not the usage " + rhi::to_string(usage));
    if (bytes > desc->size)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("buffer", desc->name, "bytes"), std::to_string(bytes),
                    "at most " + std::to_string(desc->size));
    return *desc;
}

void AdapterDevice::write_buffer(rhi::Buffer buffer, std::span<const std::byte> bytes) {
    (void)usable(buffer, rhi::Usage::upload, bytes.size(), "write_buffer");
    check_result(c_.write_buffer(c_.user, buffer.value, bytes.data(), bytes.size()), "write_buffer");
}

void AdapterDevice::read_buffer(rhi::Buffer buffer, std::span<std::byte> bytes) {
    (void)usable(buffer, rhi::Usage::read_back, bytes.size(), "read_buffer");
    check_result(c_.read_buffer(c_.user, buffer.value, bytes.data(), bytes.size()), "read_buffer");
}

void AdapterDevice::read_timestamps(std::span<double> out_nanoseconds) {
    if (out_nanoseconds.size() > capabilities_.timestamp_slots)
        throw Error(ErrorCode::invalid_argument, "read_timestamps", std::to_string(out_nanoseconds.size()),
                    "at most " + std::to_string(capabilities_.timestamp_slots));
    if (out_nanoseconds.empty()) return;
    check_result(c_.read_timestamps(c_.user, out_nanoseconds.data(), static_cast<std::uint32_t>(out_nanoseconds.size())),
                 "read_timestamps");
}

void AdapterDevice::set_message_callback(rhi::MessageCallback callback, void* user) {
    callback_ = callback, callback_user_ = user;
}

void AdapterDevice::tell(const std::string& text) const noexcept {
    if (callback_) callback_(callback_user_, rhi::Severity::error, text.c_str());
}

namespace {

/// A host's device in C: lists are the host's.
struct HostDevice final : aureole_device {
    explicit HostDevice(const aureole_adapter& adapter) : made(adapter) {}
    [[nodiscard]] rhi::Device& rhi_device() override { return made; }
    [[nodiscard]] rhi::CommandList& begin(void* host_list) override { return made.list(host_list); }
    std::uint64_t end() override { return 0; }

    AdapterDevice made;
};

const aureole_adapter no_adapter = [] {
    aureole_adapter nothing{};
    nothing.struct_size = sizeof nothing;
    return nothing;
}();

}  // namespace
}  // namespace aureole::c_api

using namespace aureole::c_api;

aureole_result aureole_adapter_defaults(aureole_adapter* adapter) {
    return guarded([&] { write(adapter, "adapter", no_adapter); });
}

aureole_result aureole_create_adapter_device(const aureole_adapter* adapter, aureole_device** out_device) {
    return guarded([&] {
        const aureole_adapter c = read(adapter, "adapter", no_adapter);
        aureole_device*& out = given(out_device, "out_device");
        out = new HostDevice(c);
    });
}
