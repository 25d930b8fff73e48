// The models by name.
#include "common/check.h"
#include "models/entries.h"

#include <array>
#include <string>

namespace aureole {
namespace {

constexpr std::array names =
    std::apply([](const auto&... entries) { return std::array{entries.name...}; }, detail::model_entries);

}  // namespace

void detail::reject_model(std::string_view name) {
    std::string known;
    for (const std::string_view one : names) known.append(known.empty() ? "" : ", ").append(one);
    reject("model", std::string("\"").append(name).append("\""), "one of " + known);
}

std::span<const std::string_view> model_names() { return names; }

std::string_view model_summary(std::string_view name) {
    return detail::with_model(name, [](const auto& entry) { return entry.summary; });
}

ModelPtr model_by_name(std::string_view name, std::string_view quality) {
    return detail::with_model(name, [&](const auto& entry) { return entry.make(entry.settings(quality)); });
}

}  // namespace aureole
