#include <aureole/rhi/shader.h>

namespace aureole::rhi {

const char* to_string(SlotKind kind) noexcept {
    switch (kind) {
        case SlotKind::sampled_texture:
            return "sampled_texture";
        case SlotKind::storage_texture:
            return "storage_texture";
        case SlotKind::constants:
            return "constants";
    }
    return "unknown";
}

}  // namespace aureole::rhi
