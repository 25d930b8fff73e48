// What aureole_add_shaders makes of a kernel: interface table, SPIR-V, GLSL and both CPU entries.
#include "shader_tool_test_shaders.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace rhi = aureole::rhi;
namespace shaders = aureole::shaders;

namespace {

template <class real>
rhi::CpuBinding texture(std::vector<real>& texels, rhi::Extent extent) {
    rhi::CpuBinding binding;
    binding.texels = texels.data();
    binding.format = rhi::Format::rgba32_float;
    binding.extent = extent;
    binding.exact = true;
    return binding;
}

constexpr rhi::Extent size{8, 4, 1};
constexpr float scale = 0.2f, pushed = 1.25f;
constexpr std::uint32_t steps = 3;

/// The kernel's result for a source texel of value 7 (the source is one texel, so every sample is 7).
template <class real>
std::vector<real> run_trial(rhi::CpuRun run) {
    std::vector<real> source(4, real(7)), volume(4), sky(4 * 6), target(4 * size.width * size.height, real(-1));
    const float uniforms[20] = {scale};
    const float push[20] = {pushed, pushed, pushed, pushed};
    std::vector<rhi::CpuBinding> bindings(5);
    bindings[0] = texture(source, {1, 1, 1});
    bindings[1].constants = std::as_bytes(std::span(uniforms)).data();
    bindings[1].constants_size = sizeof uniforms;
    bindings[2] = texture(volume, {1, 1, 1});
    bindings[3] = texture(sky, {1, 1, 6});
    bindings[4] = texture(target, size);
    const rhi::Specialization specialization[] = {{0, steps}};
    rhi::CpuArguments arguments;
    arguments.specialization = specialization;
    arguments.bindings = bindings;
    arguments.push_constants = std::as_bytes(std::span(push));
    run(arguments, {{0, 0, 0}, {size.width, size.height, 1}}, nullptr);
    return target;
}

template <class real>
void check_trial(rhi::CpuRun run) {
    const real expected = real(steps) * (real(7) * std::exp(-real(scale)) + real(pushed));
    for (const real value : run_trial<real>(run)) {
        CHECK(std::abs(value - expected) <= real(8) * std::numeric_limits<real>::epsilon() * expected);
    }
}

}  // namespace

TEST_CASE("the interface table comes from the source after preprocessing") {
    const rhi::Shader& shader = shaders::trial;
    CHECK(shader.name == "trial");
    CHECK(shader.stage == rhi::Stage::compute);
    CHECK(shader.local_size[0] == 8);
    CHECK(shader.local_size[1] == 4);
    CHECK(shader.local_size[2] == 1);
    CHECK(shader.push_constant_bytes == 16 + 64);
    struct Expected {
        rhi::SlotKind kind;
        rhi::Dimension dimension;
        const char* name;
    };
    const Expected expected[] = {{rhi::SlotKind::sampled_texture, rhi::Dimension::d2, "source"},
                                 {rhi::SlotKind::constants, rhi::Dimension::d2, "params"},
                                 {rhi::SlotKind::sampled_texture, rhi::Dimension::d3, "volume"},
                                 {rhi::SlotKind::sampled_texture, rhi::Dimension::cube, "sky"},
                                 {rhi::SlotKind::storage_texture, rhi::Dimension::d2, "target"}};
    REQUIRE(shader.slots.size() == std::size(expected));
    for (std::uint32_t i = 0; i < shader.slots.size(); ++i) {
        CAPTURE(i);
        CHECK(shader.slots[i].slot == i);
        CHECK(shader.slots[i].kind == expected[i].kind);
        CHECK(shader.slots[i].dimension == expected[i].dimension);
        CHECK(shader.slots[i].name == expected[i].name);
    }
}

TEST_CASE("the table of specialization constants has their kinds and defaults") {
    const auto constants = shaders::trial.constants;
    REQUIRE(constants.size() == 4);
    CHECK((constants[0].id == 0 && constants[0].kind == rhi::ConstantKind::integer && constants[0].name == "STEPS"));
    CHECK(constants[0].default_bits == 4);
    CHECK((constants[1].id == 1 && constants[1].kind == rhi::ConstantKind::integer && constants[1].name == "BELOW"));
    CHECK(constants[1].default_bits == 0xfffffffdu);
    CHECK((constants[2].id == 7 && constants[2].kind == rhi::ConstantKind::real && constants[2].name == "SHARE"));
    CHECK(constants[2].default_bits == std::bit_cast<std::uint32_t>(-0.375f));
    CHECK((constants[3].id == 9 && constants[3].kind == rhi::ConstantKind::boolean && constants[3].name == "LIT"));
    CHECK(constants[3].default_bits == 1);
    CHECK(shaders::trial_draw.constants.empty());
}

TEST_CASE("SPIR-V and GLSL are whole") {
    for (const rhi::Shader* shader : {&shaders::trial, &shaders::trial_draw}) {
        CAPTURE(shader->name);
        REQUIRE(shader->spirv.size() > 5);
        CHECK(shader->spirv[0] == 0x07230203);  // magic number
        CHECK(shader->spirv[1] == 0x00010300);  // version 1.3
        CHECK(shader->glsl.starts_with("#version 450\n"));
        CHECK(shader->glsl.find("#include") == std::string_view::npos);
        const std::size_t guard = shader->glsl.find("#ifndef AUREOLE_TEST_COMMON_GLSL");
        REQUIRE(guard != std::string_view::npos);
        CHECK(shader->glsl.find("#ifndef AUREOLE_TEST_COMMON_GLSL", guard + 1) == std::string_view::npos);
    }
}

TEST_CASE("the CPU entries compute in float and in double") {
    check_trial<float>(shaders::trial.cpu.run_float);
    check_trial<double>(shaders::trial.cpu.run_double);
}

TEST_CASE("a fragment kernel writes its colour target") {
    const rhi::Shader& shader = shaders::trial_draw;
    CHECK(shader.stage == rhi::Stage::fragment);
    CHECK(shader.push_constant_bytes == 0);
    std::vector<double> source(4 * size.width * size.height, 2.0), target(source.size());
    const rhi::CpuBinding bindings[] = {texture(source, size)};
    const rhi::CpuBinding colour = texture(target, size);
    rhi::CpuArguments arguments;
    arguments.bindings = bindings;
    shader.cpu.run_double(arguments, {{0, 0, 0}, {size.width, size.height, 1}}, &colour);
    const double* last = &target[target.size() - 4];
    CHECK(last[0] == 2.0 + 3.5);
    CHECK(last[1] == 2.0 + 3.5);
    CHECK(last[2] == 2.0);
    CHECK(last[3] == 3.0);
}
