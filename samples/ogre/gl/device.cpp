#include "device.h"

#include "formats.h"
#include "host_state.h"

#include <aureole/rhi/plain_glsl.h>

#include <algorithm>
#include <limits>

namespace aureole::gl {
namespace {

constexpr std::uint32_t max_push_bytes = 128;

std::uint32_t limit(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return static_cast<std::uint32_t>(std::max(value, 0));
}

std::string text(GLenum name) {
    const auto* bytes = glGetString(name);
    return bytes ? reinterpret_cast<const char*>(bytes) : "";
}

rhi::Capabilities describe() {
    rhi::Capabilities c;
    c.backend = "opengl";
    c.device = text(GL_RENDERER);
    c.driver = text(GL_VENDOR) + ", OpenGL " + text(GL_VERSION);
    c.max_texture_2d = limit(GL_MAX_TEXTURE_SIZE);
    c.max_texture_3d = limit(GL_MAX_3D_TEXTURE_SIZE);
    c.max_texture_cube = limit(GL_MAX_CUBE_MAP_TEXTURE_SIZE);
    c.max_push_constant_bytes = max_push_bytes;
    GLint bits = 0;
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    c.timestamp_slots = bits > 0 ? max_timestamps : 0;
    c.storage_write_without_format = true;  // GLSL asks for none on images that are only written
    c.raster = true;
    return c;
}

void check_access(const rhi::BufferDesc& desc, rhi::Usage usage, std::size_t bytes) {
    if (!rhi::has(desc.usage, usage))
        throw Error(ErrorCode::misuse, rhi::field_name("buffer", desc.name, "usage"), rhi::to_string(desc.usage),
                    rhi::to_string(usage));
    if (bytes > desc.size)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("buffer", desc.name, "bytes"), std::to_string(bytes),
                    "at most its size, " + std::to_string(desc.size));
}

}  // namespace

Device::Device() : capabilities_(describe()), max_block_bytes_(limit(GL_MAX_UNIFORM_BLOCK_SIZE)) {
    HostState kept;
    kept.keep_copy_buffer();
    glGenBuffers(1, &push_buffer_);
    glBindBuffer(GL_COPY_WRITE_BUFFER, push_buffer_);
    glBufferData(GL_COPY_WRITE_BUFFER, max_push_bytes, nullptr, GL_DYNAMIC_DRAW);
    kept.restore();
    glGenVertexArrays(1, &vertex_array_);
    glGenQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

Device::~Device() {
    glDeleteBuffers(1, &push_buffer_);
    glDeleteVertexArrays(1, &vertex_array_);
    glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

rhi::FormatSupport Device::format_support(rhi::Format format, rhi::Dimension dimension) const {
    return gl::format_support(format, dimension);
}

rhi::Texture Device::create_texture(const rhi::TextureDesc& desc) {
    rhi::check(desc, capabilities_, format_support(desc.format, desc.dimension));
    return add(textures_, std::make_shared<TextureObject>(desc));
}

rhi::Texture Device::wrap_texture(const rhi::ExternalTexture& external) {
    rhi::check(external, capabilities_, format_support(external.desc.format, external.desc.dimension));
    return add(textures_, std::make_shared<TextureObject>(external));
}

rhi::Buffer Device::create_buffer(const rhi::BufferDesc& desc) {
    rhi::check(desc);
    if (rhi::has(desc.usage, rhi::Usage::constants) && desc.size > max_block_bytes_)
        throw Error(ErrorCode::unsupported, rhi::field_name("buffer", desc.name, "size"), std::to_string(desc.size),
                    "at most " + std::to_string(max_block_bytes_) + " for constants");
    return add(buffers_, std::make_shared<BufferObject>(desc));
}

rhi::Sampler Device::create_sampler(const rhi::SamplerDesc& desc) {
    rhi::check(desc);
    return add(samplers_, std::make_shared<SamplerObject>(desc));
}

rhi::Pipeline Device::create_compute_pipeline(const rhi::ComputePipelineDesc& desc) {
    rhi::check(desc, capabilities_);
    return add(pipelines_,
               std::make_shared<PipelineObject>(desc.name, *desc.shader, desc.specialization, rhi::Format::undefined));
}

rhi::Pipeline Device::create_raster_pipeline(const rhi::RasterPipelineDesc& desc) {
    rhi::check(desc, capabilities_, format_support(desc.target_format, rhi::Dimension::d2));
    return add(pipelines_, std::make_shared<PipelineObject>(desc.name, *desc.shader, desc.specialization, desc.target_format));
}

BindingsObject::Slot Device::fill(const rhi::Shader& shader, const rhi::SlotDesc& slot,
                                  std::span<const rhi::Binding> bindings) const {
    const auto here = [&](const rhi::Binding& b) { return b.slot == slot.slot; };
    const rhi::Binding& binding = *std::find_if(bindings.begin(), bindings.end(), here);
    const bool image = slot.kind == rhi::SlotKind::storage_texture;
    return {&slot, image ? rhi::plain_glsl_image_unit(shader, slot.slot) : slot.slot, textures_.share(binding.texture),
            samplers_.share(binding.sampler), buffers_.share(binding.buffer)};
}

rhi::BindingSet Device::create_binding_set(const rhi::BindingSetDesc& desc) {
    const PipelineObject* pipeline = pipelines_.find(desc.pipeline);
    if (!pipeline)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("binding set", desc.name, "pipeline"), "unknown or destroyed",
                    "a live pipeline");
    const rhi::Shader& shader = *pipeline->shader;
    rhi::check(desc, shader, *this, *this);
    auto set = std::make_shared<BindingsObject>(BindingsObject{desc.name, &shader, {}});
    for (const rhi::SlotDesc& slot : shader.slots) set->slots.push_back(fill(shader, slot, desc.bindings));
    return add(binding_sets_, std::move(set));
}

void Device::destroy(rhi::AnyHandle handle, std::uint64_t) {
    if (std::visit([](auto h) { return !h; }, handle)) return;
    bool done = false;
    if (const auto* h = std::get_if<rhi::Texture>(&handle)) done = textures_.destroy(*h);
    if (const auto* h = std::get_if<rhi::Buffer>(&handle)) done = buffers_.destroy(*h);
    if (const auto* h = std::get_if<rhi::Sampler>(&handle)) done = samplers_.destroy(*h);
    if (const auto* h = std::get_if<rhi::Pipeline>(&handle)) done = pipelines_.destroy(*h);
    if (const auto* h = std::get_if<rhi::BindingSet>(&handle)) done = binding_sets_.destroy(*h);
    if (!done) report(rhi::Severity::error, "destroy: unknown object, or destroyed before");
}

void Device::write_buffer(rhi::Buffer buffer, std::span<const std::byte> bytes) {
    const BufferObject* object = buffers_.find(buffer);
    if (!object) throw Error(ErrorCode::misuse, "write_buffer: unknown or destroyed buffer");
    check_access(object->desc, rhi::Usage::upload, bytes.size());
    HostState kept;
    kept.keep_copy_buffer();
    glBindBuffer(GL_COPY_WRITE_BUFFER, object->name);
    glBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    kept.restore();
}

void Device::read_buffer(rhi::Buffer buffer, std::span<std::byte> bytes) {
    const BufferObject* object = buffers_.find(buffer);
    if (!object) throw Error(ErrorCode::misuse, "read_buffer: unknown or destroyed buffer");
    check_access(object->desc, rhi::Usage::read_back, bytes.size());
    HostState kept;
    kept.keep_copy_buffer();
    glBindBuffer(GL_COPY_WRITE_BUFFER, object->name);
    glGetBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    kept.restore();
}

void Device::record_timestamp(std::uint32_t index) noexcept {
    glQueryCounter(queries_[index], GL_TIMESTAMP);
    timed_.set(index);
}

void Device::read_timestamps(std::span<double> out_nanoseconds) {
    if (out_nanoseconds.size() > capabilities_.timestamp_slots)
        throw Error(ErrorCode::invalid_argument, "read_timestamps", std::to_string(out_nanoseconds.size()),
                    "at most " + std::to_string(capabilities_.timestamp_slots));
    for (std::size_t i = 0; i < out_nanoseconds.size(); ++i) {
        out_nanoseconds[i] = std::numeric_limits<double>::quiet_NaN();
        if (!timed_.test(i)) continue;
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(queries_[i], GL_QUERY_RESULT, &nanoseconds);
        out_nanoseconds[i] = static_cast<double>(nanoseconds);
    }
}

void Device::set_message_callback(rhi::MessageCallback callback, void* user) {
    callback_ = callback;
    callback_user_ = user;
}

const rhi::TextureDesc* Device::find(rhi::Texture texture) const {
    const TextureObject* object = textures_.find(texture);
    return object ? &object->desc : nullptr;
}
const rhi::BufferDesc* Device::find(rhi::Buffer buffer) const {
    const BufferObject* object = buffers_.find(buffer);
    return object ? &object->desc : nullptr;
}
const rhi::SamplerDesc* Device::find(rhi::Sampler sampler) const {
    const SamplerObject* object = samplers_.find(sampler);
    return object ? &object->desc : nullptr;
}

void Device::report(rhi::Severity severity, const std::string& text) const noexcept {
    if (callback_) callback_(callback_user_, severity, text.c_str());
}

}  // namespace aureole::gl
