#include "rhi/conformance.h"

#include <doctest/doctest.h>

#include <string>

namespace aureole::conformance {

std::span<const Check> checks() {
    static constexpr Check all[] = {
        {"capabilities", check_capabilities},
        {"creation errors", check_creation_errors},
        {"deferred destroy", check_deferred_destroy},
        {"lent textures", check_lent_textures},
        {"texel round trips", check_texel_round_trips},
        {"texture copies", check_texture_copies},
        {"cube copies", check_cube_copies},
        {"storage formats", check_storage_formats},
        {"attachment formats", check_attachment_formats},
        {"format reads", check_format_reads},
        {"nearest filter", check_nearest},
        {"linear filter", check_linear},
        {"linear filter, repeat", check_linear_repeat},
        {"3d textures", check_3d},
        {"cube textures", check_cube},
        {"edges of cubes", check_cube_edges},
        {"specialization", check_specialization},
        {"constants", check_constants},
        {"order of updates", check_update_order},
        {"barriers", check_barriers},
        {"edges of a dispatch", check_edges},
        {"raster", check_raster},
        {"timestamps", check_timestamps},
        {"markers and messages", check_markers_and_messages},
        {"frames", check_frames},
    };
    return all;
}

void run_all(const Target& target) {
    for (const Check& check : checks()) {
        INFO("conformance: ", std::string(check.name));
        CHECK_NOTHROW(check.run(target));
    }
}

}  // namespace aureole::conformance
