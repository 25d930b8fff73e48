// GLSL to SPIR-V while the test runs, by the compiler that the build uses: what a host does with its own shaders.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace aureole::host {

enum class Api { vulkan, opengl };

struct Compiled {
    std::vector<std::uint32_t> spirv{};  ///< Empty if the text was refused.
    std::string messages{};
};

/// `stage` as glslangValidator names it: "comp", "frag", "vert". <aureole/glsl/> of this build is on the include path. Files
/// are written to the working folder, which is the test's own.
[[nodiscard]] Compiled compile(const std::string& text, const std::string& stage, Api api = Api::vulkan);

}  // namespace aureole::host
