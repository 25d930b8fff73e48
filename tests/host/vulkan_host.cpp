#include "host/vulkan_host.h"

#include <doctest/doctest.h>

#include <cstring>

#include "host/glslang.h"

namespace aureole::host {

using namespace aureole::vulkan::test;

OpenHost::OpenHost(Host& host)
    : host_(host),
      guest_(vulkan::borrow_vulkan_device(host.lend())),
      queue_(host, *guest_),
      linear_(make_sampler(host, VK_FILTER_LINEAR)),
      nearest_(make_sampler(host, VK_FILTER_NEAREST)) {}

OpenHost::~OpenHost() {
    vkDestroySampler(host_.device(), linear_, nullptr);
    vkDestroySampler(host_.device(), nearest_, nullptr);
}

Asker::Asker(const OpenHost& open, const passes::Rig& rig, HostShader shader, std::span<const Question> questions)
    : host_(open.host()),
      count_(static_cast<std::uint32_t>(questions.size())),
      answers_(host_.make_buffer(count_ * answer_columns * 4 * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)) {
    shader.defines = rig.view.shader_defines();
    const Compiled compiled = compile(text_of(shader), "comp");
    CAPTURE(compiled.messages);
    REQUIRE(!compiled.spirv.empty());
    std::vector<ProgramSet> sets(static_cast<std::size_t>(shader.set) + 1);  // those between stay empty
    sets.front() = own_set(questions);
    sets.back() = aureole_set(open, rig, shader.first_slot);
    program_ = std::make_unique<HostProgram>(host_, compiled.spirv, std::move(sets));
}

ProgramSet Asker::own_set(std::span<const Question> questions) const {
    std::vector<float> floats;
    for (const glm::dvec4& texel : encode(questions))
        for (int c = 0; c < 4; ++c) floats.push_back(static_cast<float>(texel[c]));
    const HostBuffer& asked = host_.make_buffer(floats.size() * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    std::memcpy(asked.bytes.data(), floats.data(), asked.bytes.size());
    return {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {}, {asked.buffer, 0, VK_WHOLE_SIZE}},
            {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {}, {answers_.buffer, 0, VK_WHOLE_SIZE}}};
}

ProgramSet Asker::aureole_set(const OpenHost& open, const passes::Rig& rig, int first_slot) const {
    auto slot = static_cast<std::uint32_t>(first_slot);
    const auto block = [&](rhi::Buffer buffer) {
        return ProgramSlot{slot++, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, {}, {open.guest().native(buffer), 0, VK_WHOLE_SIZE}};
    };
    const auto table = [&](rhi::Texture texture, VkSampler sampler) {
        const vulkan::NativeTexture native = open.guest().native(texture);
        const VkDescriptorImageInfo image = {sampler, native.sampled_view, native.sampled_layout};
        return ProgramSlot{slot++, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, image, {}};
    };
    return {block(rig.view.air_block()),
            block(rig.view.view_block()),
            table(rig.view.sky_view_table(), open.linear()),
            table(rig.air.transmittance_table(), open.linear()),
            table(rig.view.aerial_perspective_table(), open.linear()),
            table(rig.view.light_table(), open.linear()),
            table(rig.view.phase_table(), open.nearest()),
            table(rig.view.profile_table(), open.nearest())};
}

void Asker::record() {
    program_->record((count_ + 63) / 64);
    host_.publish_shader_writes();
}

std::vector<Answer> Asker::answers() const {
    std::vector<float> floats(answers_.bytes.size() / sizeof(float));
    std::memcpy(floats.data(), answers_.bytes.data(), answers_.bytes.size());
    std::vector<glm::dvec4> texels;
    for (std::size_t i = 0; i < floats.size(); i += 4)
        texels.emplace_back(floats[i], floats[i + 1], floats[i + 2], floats[i + 3]);
    return decode(texels);
}

}  // namespace aureole::host
