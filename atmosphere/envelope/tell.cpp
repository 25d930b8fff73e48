#include "envelope/tell.h"

#include <aureole/rhi/log.h>

#include <spdlog/logger.h>
#include <algorithm>
#include <utility>

namespace aureole::detail {

namespace {

bool names(const std::vector<OutsideEnvelope>& some, const std::string& field) {
    return std::ranges::find(some, field, &OutsideEnvelope::field) != some.end();
}

}  // namespace

void tell_outside(std::vector<OutsideEnvelope>& known, std::vector<OutsideEnvelope> now, std::vector<OutsideEnvelope>& told) {
    std::erase_if(told, [&](const OutsideEnvelope& one) { return names(known, one.field) && !names(now, one.field); });
    for (const OutsideEnvelope& one : now) {
        if (names(known, one.field) || std::ranges::find(told, one) != told.end()) continue;
        log()->warn("{}", one.text());
        told.push_back(one);
    }
    known = std::move(now);
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
