// The shader of a host: its own bindings, names and constants, and the look-ups of <aureole/glsl/aureole.glsl>.
#pragma once

#include <string>

namespace aureole::host {

struct HostShader {
    std::string defines{};  ///< View::shader_defines().
    int set = 2;            ///< Of Aureole's bindings.
    int first_slot = 0;     ///< Of Aureole's eight slots; other than 0 redefines them.
    bool opengl = false;
    bool shadows = true;         ///< Of its own, for aureole_march.
    std::string stage = "comp";  ///< "comp" answers questions as host_lookups.comp.glsl does; others call every look-up once.
};

[[nodiscard]] std::string text_of(const HostShader& shader);

}  // namespace aureole::host
