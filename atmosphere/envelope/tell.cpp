#include "envelope/tell.h"

#include <aureole/rhi/log.h>

#include <spdlog/logger.h>
#include <algorithm>
#include <utility>

namespace aureole::detail {

bool Teller::another_is(const OutsideEnvelope& outside) const {
    return std::ranges::any_of(
        all_, [&](const Teller* one) { return one != this && std::ranges::find(one->known_, outside) != one->known_.end(); });
}

void Teller::tell(std::vector<OutsideEnvelope> now) {
    for (const OutsideEnvelope& one : now) {
        const bool is_known = std::ranges::find(known_, one.field, &OutsideEnvelope::field) != known_.end();
        if (!is_known && !another_is(one)) log()->warn("{}", one.text());
    }
    known_ = std::move(now);
}

namespace {

/// Where bruneton's table in floats is within 1 % of that in double down to a sun of -18 degrees: by searches
/// (docs/stability.md).
bool has_deep_twilight(const AtmosphereParameters& parameters) {
    return parameters.planet.bottom_radius_m <= 7e6 && greatest_extinction_per_m(parameters) <= 1e-3;
}

}  // namespace

KeptInTables kept_in_tables(const Model& model, const AtmosphereParameters& parameters) {
    KeptInTables kept;
    for (const ModelTable& table : model.tables_for(parameters)) {
        const bool half = table.format == rhi::Format::rgba16_float;
        kept.half_sky |= half && (table.name == "sky-view table" || table.name == "dome");
        kept.half_difference |= half && table.name == "scattering table";
        kept.coarse_sun_axis |= table.name == "scattering table" && !has_deep_twilight(parameters);
    }
    return kept;
}

}  // namespace aureole::detail
