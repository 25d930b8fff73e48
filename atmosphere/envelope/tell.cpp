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

bool keeps_sky_in_half(const Model& model, const AtmosphereParameters& parameters) {
    return std::ranges::any_of(model.tables_for(parameters), [](const ModelTable& table) {
        return (table.name == "sky-view table" || table.name == "dome") && table.format == rhi::Format::rgba16_float;
    });
}

}  // namespace aureole::detail
