#include "envelope/tell.h"

#include <aureole/rhi/log.h>

#include <spdlog/logger.h>
#include <algorithm>
#include <utility>

namespace aureole::detail {

void tell_outside(std::vector<OutsideEnvelope>& known, std::vector<OutsideEnvelope> now) {
    for (const OutsideEnvelope& one : now)
        if (std::ranges::find(known, one.field, &OutsideEnvelope::field) == known.end()) log()->warn("{}", one.text());
    known = std::move(now);
}

bool keeps_sky_in_half(const Model& model, const AtmosphereParameters& parameters) {
    return std::ranges::any_of(model.tables_for(parameters), [](const ModelTable& table) {
        return table.name == "sky-view table" && table.format == rhi::Format::rgba16_float;
    });
}

}  // namespace aureole::detail
