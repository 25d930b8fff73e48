// The checks, by the file that holds them. Each says what it finds through report.h.
#pragma once

#include <aureole/rhi_tests/conformance.h>

namespace aureole::conformance {

void check_capabilities(const Target&);  // objects_checks.cpp
void check_creation_errors(const Target&);
void check_deferred_destroy(const Target&);
void check_find(const Target&);
void check_lent_textures(const Target&);
void check_texel_round_trips(const Target&);  // copy_checks.cpp
void check_texture_copies(const Target&);
void check_cube_copies(const Target&);
void check_storage_formats(const Target&);  // format_checks.cpp
void check_attachment_formats(const Target&);
void check_format_reads(const Target&);
void check_nearest(const Target&);  // sampling_checks.cpp
void check_linear(const Target&);
void check_linear_repeat(const Target&);
void check_3d(const Target&);
void check_cube(const Target&);
void check_cube_edges(const Target&);
void check_specialization(const Target&);  // command_checks.cpp
void check_constants(const Target&);
void check_update_order(const Target&);
void check_barriers(const Target&);
void check_edges(const Target&);
void check_raster(const Target&);
void check_raster_barriers(const Target&);
void check_timestamps(const Target&);
void check_markers_and_messages(const Target&);
void check_frames(const Target&);
void check_transmittance(const Target&);  // air_checks.cpp
void check_multi_scatter(const Target&);
void check_sky_view(const Target&);  // view_checks.cpp
void check_aerial_perspective(const Target&);
void check_light(const Target&);
void check_composite(const Target&);
void check_composite_drawn(const Target&);

}  // namespace aureole::conformance
