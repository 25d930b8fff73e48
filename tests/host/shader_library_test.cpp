// <aureole/glsl/aureole.glsl> compiles in a host's shader, whatever names the host uses and whichever API it has.
#include <doctest/doctest.h>

#include "host/glslang.h"
#include "host/host_shader.h"
#include "host/scenes.h"

using namespace aureole;
using namespace aureole::host;

TEST_CASE("the look-ups compile in every stage of a host's shaders, for Vulkan and OpenGL, beside names of the host's own") {
    for (const Scene& scene : {noon(), scenes()[6]}) {  // analytic phase functions; a tabulated one
        INFO(scene.name);
        const Shown shown(passes::open_cpu_float(), scene);
        for (const char* stage : {"comp", "frag", "vert"}) {
            for (const auto& one : {std::pair{false, true}, {true, true}, {false, false}}) {
                const bool opengl = one.first, shadows = one.second;
                HostShader shader;
                shader.shadows = shadows;
                shader.defines = shown.rig.view.shader_defines();
                shader.stage = stage;
                shader.opengl = opengl;
                const Compiled compiled = compile(text_of(shader), stage, opengl ? Api::opengl : Api::vulkan);
                CAPTURE(compiled.messages);
                CAPTURE(opengl);
                CAPTURE(shadows);
                CHECK(compiled.spirv.size() > 1000);
            }
        }
    }
}

TEST_CASE("the display compiles in a shader of either API, beside names of the host's own, before and behind the look-ups") {
    const std::string display = "#include \"aureole_display.glsl\"\n", lookups = "#include \"aureole.glsl\"\n";
    const std::string body =
        "const bool display = true;  // and other names that the texts use for themselves\n"
        "float real(float PI) { return PI; }\n"
        "layout(location = 0) out vec4 shown;\n"
        "void main() { shown = vec4(aureole_display(vec3(0.5), 1, true, display, ivec2(gl_FragCoord.xy), real(3.0)), 1); }\n";
    const Shown shown(passes::open_cpu_float(), noon());
    const std::string defines = "#define AUREOLE_DEFINED_CONSTANTS\n" + shown.rig.view.shader_defines();
    for (const Api api : {Api::vulkan, Api::opengl}) {
        for (const std::string& includes : {display, display + lookups, lookups + display, display + lookups + display}) {
            std::string text = "#version 450\n#extension GL_GOOGLE_include_directive : require\n";
            if (api == Api::opengl) text += "#define AUREOLE_PLAIN_GLSL\n";
            text.append(defines).append(includes).append(body);
            const Compiled compiled = compile(text, "frag", api);
            CAPTURE(includes);
            CAPTURE(compiled.messages);
            CHECK(compiled.spirv.size() > 500);
        }
    }
}

TEST_CASE("a host that forgets the defines is told so by its compiler") {
    HostShader shader;
    const Compiled compiled = compile(text_of(shader), "comp");
    CHECK(compiled.spirv.empty());
    CHECK(compiled.messages.find("AUREOLE_SPEC_0") != std::string::npos);
}
