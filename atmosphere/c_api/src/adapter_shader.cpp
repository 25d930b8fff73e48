// Shaders as C sees them: made once, and kept as long as the library.
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "adapter_device.h"
#include "guard.h"

namespace aureole::c_api {
namespace {

struct ShaderInC {
    explicit ShaderInC(const rhi::Shader& shader) : origin(shader), name(shader.name), glsl(shader.glsl) {
        for (const rhi::SlotDesc& slot : shader.slots) names.emplace_back(slot.name);
        for (std::size_t i = 0; i < shader.slots.size(); ++i)
            slots.push_back(
                {shader.slots[i].slot, number(shader.slots[i].kind), number(shader.slots[i].dimension), names[i].c_str()});
        c = {name.c_str(),
             number(shader.stage),
             {shader.local_size[0], shader.local_size[1], shader.local_size[2]},
             shader.push_constant_bytes,
             static_cast<std::uint32_t>(slots.size()),
             slots.data(),
             shader.spirv.data(),
             shader.spirv.size(),
             glsl.c_str()};
    }
    ShaderInC(const ShaderInC&) = delete;
    ShaderInC& operator=(const ShaderInC&) = delete;

    aureole_shader c;
    const rhi::Shader& origin;
    std::string name, glsl;
    std::vector<std::string> names;
    std::vector<aureole_slot> slots;
};

static_assert(number(rhi::SlotKind::constants) == AUREOLE_SLOT_CONSTANTS);
static_assert(number(rhi::Stage::fragment) == AUREOLE_STAGE_FRAGMENT);

struct Registry {
    std::mutex mutex;
    std::map<const rhi::Shader*, std::unique_ptr<ShaderInC>> by_origin;
    std::map<const aureole_shader*, const rhi::Shader*> origins;
};
Registry& registry() {
    static Registry all;
    return all;
}

}  // namespace

const aureole_shader& shader_in_c(const rhi::Shader& shader) {
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    std::unique_ptr<ShaderInC>& made = all.by_origin[&shader];
    if (!made) made = std::make_unique<ShaderInC>(shader);
    all.origins[&made->c] = &shader;
    return made->c;
}

const rhi::Shader& shader_of(const aureole_shader& shader) {
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    return *all.origins.at(&shader);
}

}  // namespace aureole::c_api
