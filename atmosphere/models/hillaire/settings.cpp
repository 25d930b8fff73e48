#include "common/check.h"
#include "common/check_table.h"

#include <aureole/models/hillaire.h>

namespace aureole::models {

void validate(const HillaireSettings& s) {
    constexpr double most_steps = 4096;
    detail::check_size_2d("hillaire.transmittance", s.transmittance, 2, 4096);
    detail::check("hillaire.transmittance_steps", s.transmittance_steps, 1, most_steps);
    detail::check_size_2d("hillaire.multi_scatter", s.multi_scatter, 2, 256);
    detail::check("hillaire.multi_scatter_steps", s.multi_scatter_steps, 1, most_steps);
    detail::check_sky_view("hillaire.sky_view", s.sky_view);
    detail::check("hillaire.sky_view_steps", s.sky_view_steps, 1, most_steps);
    detail::check_froxels("hillaire.aerial_perspective", s.aerial_perspective);
    detail::check("hillaire.march_steps", s.march_steps, 1, most_steps);
    detail::check_table_format("hillaire.table_format", s.table_format);
    detail::check_table_format("hillaire.froxel_format", s.froxel_format);
}

HillaireSettings HillaireSettings::standard() { return {}; }

HillaireSettings HillaireSettings::low() {
    HillaireSettings s;
    s.sky_view = {96, 50, 1};
    s.sky_view_steps = 8;
    s.aerial_perspective = {32, 32, 16};
    return s;
}

HillaireSettings HillaireSettings::high() {
    HillaireSettings s;
    s.fast_sky = s.fast_aerial_perspective = false;
    s.grey_transmittance = false;
    return s;
}

HillaireSettings HillaireSettings::converged() {
    HillaireSettings s = high();
    s.transmittance = {512, 128, 1};
    s.transmittance_steps = 1024;    // even steps: the error halves only as they double
    s.multi_scatter = {256, 32, 1};  // the widest that any device takes; twilight is a few texels of it
    s.multi_scatter_steps = 256;
    s.sky_view = {128, 192, 1};  // for the light table alone
    s.sky_view_steps = 64;
    s.march_steps = 512;
    s.table_format = s.froxel_format = rhi::Format::rgba32_float;
    return s;
}

HillaireSettings HillaireSettings::by_name(std::string_view name) {
    if (name == "low") return low();
    if (name == "default") return standard();
    if (name == "high") return high();
    if (name == "converged") return converged();
    detail::reject_quality(name);
}

}  // namespace aureole::models
