#include "command_list.h"

#include "formats.h"

namespace aureole::gl {

bool CommandList::refuse(const std::string& complaint) noexcept {
    if (complaint.empty()) return false;
    device_.report(rhi::Severity::error, complaint);
    return true;
}

void CommandList::finish() noexcept {
    while (open_markers_ > 0) end_marker();
    if (stored_) glMemoryBarrier(GL_ALL_BARRIER_BITS);
    stored_ = false;
    host_.restore();
}

void CommandList::write(GLuint buffer, std::span<const std::byte> bytes) noexcept {
    host_.keep_copy_buffer();
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
    glBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void CommandList::update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) {
    if (refuse(rhi::complaint(device_.find(buffer), bytes))) return;
    write(device_.object(buffer)->name, bytes);
}

void CommandList::barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier>) {
    GLbitfield bits = 0;  // buffers are never written by shaders
    for (const rhi::TextureBarrier& texture : textures) bits |= barrier_bits(texture.before, texture.after);
    if (bits != 0) glMemoryBarrier(bits);
}

void CommandList::push(std::span<const std::byte> bytes) noexcept {
    if (bytes.empty()) return;
    write(device_.push_buffer(), bytes);
    host_.keep_block(push_binding);
    glBindBufferBase(GL_UNIFORM_BUFFER, push_binding, device_.push_buffer());
}

void CommandList::bind(const BindingsObject::Slot& slot) noexcept {
    switch (slot.desc->kind) {
        case rhi::SlotKind::sampled_texture:
            host_.keep_texture_unit(slot.unit);
            glActiveTexture(GL_TEXTURE0 + slot.unit);
            glBindTexture(slot.texture->target, slot.texture->name);
            glBindSampler(slot.unit, slot.sampler->name);
            return;
        case rhi::SlotKind::storage_texture:
            host_.keep_image_unit(slot.unit);
            glBindImageTexture(slot.unit, slot.texture->image, 0, GL_TRUE, 0, GL_WRITE_ONLY,
                               pixel_format(slot.texture->desc.format).internal);
            stored_ = true;
            return;
        case rhi::SlotKind::constants:
            host_.keep_block(slot.unit);
            glBindBufferBase(GL_UNIFORM_BUFFER, slot.unit, slot.buffer->name);
    }
}

void CommandList::use(const PipelineObject& pipeline, const BindingsObject* bindings,
                      std::span<const std::byte> push_constants) noexcept {
    host_.keep_program();
    glUseProgram(pipeline.program);
    if (bindings)
        for (const BindingsObject::Slot& slot : bindings->slots) bind(slot);
    push(push_constants);
}

namespace {

/// Facts of objects that may be null, as the rules take them.
template <class Facts, class Object>
struct FactsOf {
    explicit FactsOf(const Object* object) : facts(object ? object->facts() : Facts{}), pointer(object ? &facts : nullptr) {}
    Facts facts;
    const Facts* pointer;
};
using FactsOfPipeline = FactsOf<rhi::PipelineFacts, PipelineObject>;
using FactsOfBindings = FactsOf<rhi::BindingSetFacts, BindingsObject>;

}  // namespace

void CommandList::dispatch(const rhi::DispatchDesc& desc) {
    const PipelineObject* pipeline = device_.object(desc.pipeline);
    const BindingsObject* bindings = device_.object(desc.bindings);
    if (refuse(rhi::complaint(desc, FactsOfPipeline(pipeline).pointer, FactsOfBindings(bindings).pointer))) return;
    use(*pipeline, bindings, desc.push_constants);
    glDispatchCompute(desc.groups[0], desc.groups[1], desc.groups[2]);
}

void CommandList::draw_fullscreen(const rhi::DrawDesc& desc) {
    const PipelineObject* pipeline = device_.object(desc.pipeline);
    const BindingsObject* bindings = device_.object(desc.bindings);
    if (refuse(rhi::complaint(desc, FactsOfPipeline(pipeline).pointer, FactsOfBindings(bindings).pointer,
                              device_.find(desc.target))))
        return;
    const TextureObject& target = *device_.object(desc.target);
    use(*pipeline, bindings, desc.push_constants);
    host_.keep_raster();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
    glViewportIndexedf(0, 0, 0, static_cast<float>(target.desc.extent.width), static_cast<float>(target.desc.extent.height));
    glBindVertexArray(device_.vertex_array());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

namespace {

GLsizei size(std::uint32_t texels) { return static_cast<GLsizei>(texels); }
/// Of pixel transfers: places in the buffer that is bound.
void* offset(std::size_t bytes) { return reinterpret_cast<void*>(bytes); }

/// Calls `transfer(target, offset)` for each image of a texture: a cube's faces one by one.
template <class Transfer>
void for_each_image(const TextureObject& texture, const Transfer& transfer) {
    if (texture.target != GL_TEXTURE_CUBE_MAP) return transfer(texture.target, offset(0));
    const auto face_bytes = static_cast<std::size_t>(rhi::packed_size(texture.desc) / 6);
    for (GLenum face = 0; face < 6; ++face) transfer(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, offset(face * face_bytes));
}

void read(const TextureObject& texture, GLuint buffer) {
    const PixelFormat format = pixel_format(texture.desc.format);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    for_each_image(texture, [&](GLenum target, void* place) { glGetTexImage(target, 0, format.layout, format.type, place); });
}

void write(const TextureObject& texture, GLuint buffer) {
    const PixelFormat format = pixel_format(texture.desc.format);
    const rhi::Extent& e = texture.desc.extent;
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    for_each_image(texture, [&](GLenum target, const void* place) {
        if (target == GL_TEXTURE_3D)
            glTexSubImage3D(target, 0, 0, 0, 0, size(e.width), size(e.height), size(e.depth), format.layout, format.type,
                            place);
        else
            glTexSubImage2D(target, 0, 0, 0, size(e.width), size(e.height), format.layout, format.type, place);
    });
}

void copy_texels(const TextureObject& from, const TextureObject& to) {
    const rhi::Extent& e = from.desc.extent;
    const std::uint32_t layers = from.desc.dimension == rhi::Dimension::cube ? 6 : e.depth;
    glCopyImageSubData(from.name, from.target, 0, 0, 0, 0, to.name, to.target, 0, 0, 0, 0, size(e.width), size(e.height),
                       size(layers));
}

}  // namespace

void CommandList::copy(const rhi::CopyDesc& desc) {
    if (refuse(rhi::complaint(desc, device_))) return;
    if (const auto* both = std::get_if<rhi::TextureToTexture>(&desc))
        return copy_texels(*device_.object(both->source), *device_.object(both->destination));
    host_.keep_pixel_transfer();
    host_.keep_texture_unit(0);
    glActiveTexture(GL_TEXTURE0);
    const auto* out = std::get_if<rhi::TextureToBuffer>(&desc);
    const auto* in = std::get_if<rhi::BufferToTexture>(&desc);
    const TextureObject& texture = *device_.object(out ? out->source : in->destination);
    glBindTexture(texture.target, texture.name);
    if (out)
        read(texture, device_.object(out->destination)->name);
    else
        gl::write(texture, device_.object(in->source)->name);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

void CommandList::begin_marker(const char* name) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
    ++open_markers_;
}

void CommandList::end_marker() {
    if (open_markers_ == 0) return device_.report(rhi::Severity::error, "end_marker: no marker is open");
    glPopDebugGroup();
    --open_markers_;
}

void CommandList::timestamp(std::uint32_t index) {
    const std::uint32_t slots = device_.capabilities().timestamp_slots;
    if (index >= slots)
        return device_.report(rhi::Severity::error, "timestamp: slot " + std::to_string(index) +
                                                        " is not allowed; allowed: 0 to " + std::to_string(slots) +
                                                        ", exclusive");
    device_.record_timestamp(index);
}

}  // namespace aureole::gl
