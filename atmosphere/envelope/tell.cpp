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

InHalfFloats kept_in_half(const Model& model, const AtmosphereParameters& parameters) {
    InHalfFloats kept;
    for (const ModelTable& table : model.tables_for(parameters)) {
        const bool half = table.format == rhi::Format::rgba16_float;
        kept.sky |= half && (table.name == "sky-view table" || table.name == "dome");
        kept.difference |= half && table.name == "scattering table";
    }
    return kept;
}

}  // namespace aureole::detail
