#include <aureole/rhi/error.h>
#include <aureole/rhi/plain_glsl.h>
#include <doctest/doctest.h>

#include <bit>
#include <string>

using namespace aureole;
using namespace aureole::rhi;

namespace {

constexpr SlotDesc slots[] = {{0, SlotKind::sampled_texture, Dimension::d2, "source"},
                              {3, SlotKind::storage_texture, Dimension::d2, "first"},
                              {7, SlotKind::constants, Dimension::d2, "block"},
                              {9, SlotKind::storage_texture, Dimension::d3, "second"}};
constexpr ConstantDesc constants[] = {{0, ConstantKind::integer, 0xfffffffdu, "BELOW"},
                                      {4, ConstantKind::boolean, 1, "LIT"},
                                      {5, ConstantKind::real, std::bit_cast<std::uint32_t>(0.5f), "SHARE"}};
constexpr Shader shader = {
    .name = "trial", .slots = slots, .glsl = "#version 450\nthe rest\n", .cpu = {}, .constants = constants};

bool holds(const std::string& text, const char* line) {
    return text.find("\n" + std::string(line) + "\n") != std::string::npos;
}

}  // namespace

TEST_CASE("plain GLSL has its own version, and a value for every constant") {
    const std::string plain = plain_glsl(shader, {});
    CHECK(plain.starts_with("#version 430\n"));
    CHECK(plain.ends_with("\nthe rest\n"));
    CHECK(plain.find("450") == std::string::npos);
    CHECK(holds(plain, "#define AUREOLE_PLAIN_GLSL"));
    CHECK(holds(plain, "#define AUREOLE_PUSH_BINDING 32"));
    CHECK(holds(plain, "#define AUREOLE_SPEC_0 int(4294967293u)"));
    CHECK(holds(plain, "#define AUREOLE_SPEC_4 true"));
    CHECK(holds(plain, "#define AUREOLE_SPEC_5 uintBitsToFloat(1056964608u)"));

    const Specialization values[] = {{5, std::bit_cast<std::uint32_t>(-1.0f)}, {4, 0}, {77, 3}};
    const std::string special = plain_glsl(shader, values, {.version = 460, .push_binding = 40});
    CHECK(special.starts_with("#version 460\n"));
    CHECK(holds(special, "#define AUREOLE_PUSH_BINDING 40"));
    CHECK(holds(special, "#define AUREOLE_SPEC_0 int(4294967293u)"));
    CHECK(holds(special, "#define AUREOLE_SPEC_4 false"));
    CHECK(holds(special, "#define AUREOLE_SPEC_5 uintBitsToFloat(3212836864u)"));
    CHECK(special.find("SPEC_77") == std::string::npos);
}

TEST_CASE("images are numbered without gaps") {
    CHECK(plain_glsl_image_unit(shader, 3) == 0);
    CHECK(plain_glsl_image_unit(shader, 9) == 1);
    const std::string text = plain_glsl(shader, {});
    CHECK(holds(text, "#define AUREOLE_IMAGE_UNIT_3 0"));
    CHECK(holds(text, "#define AUREOLE_IMAGE_UNIT_9 1"));
    CHECK(text.find("IMAGE_UNIT_0") == std::string::npos);
}

TEST_CASE("a version without compute shaders and a binding that slots may have are refused") {
    CHECK_THROWS_WITH_AS((void)plain_glsl(shader, {}, {.version = 420}),
                         "version: 420 is not allowed; allowed: at least 430, which has compute shaders", Error);
    CHECK_THROWS_WITH_AS((void)plain_glsl(shader, {}, {.push_binding = 31}),
                         "push_binding: 31 is not allowed; allowed: at least 32, beyond all slots", Error);
}
