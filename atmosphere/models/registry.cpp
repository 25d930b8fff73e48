// The models by name. A new one adds its line here.
#include "common/check.h"

#include <aureole/models/aureole.h>
#include <aureole/models/bruneton.h>

#include <array>
#include <string>

namespace aureole {
namespace {

using Make = ModelPtr (*)(std::string_view quality);

struct Entry {
    std::string_view name;
    Make make;
};

constexpr std::array entries{
    Entry{"aureole", [](std::string_view quality) { return models::aureole(QualitySettings::by_name(quality)); }},
    Entry{"bruneton", [](std::string_view quality) { return models::bruneton(models::BrunetonSettings::by_name(quality)); }},
};

constexpr auto names = [] {
    std::array<std::string_view, entries.size()> result;
    for (std::size_t i = 0; i < entries.size(); ++i) result[i] = entries[i].name;
    return result;
}();

}  // namespace

std::span<const std::string_view> model_names() { return names; }

ModelPtr model_by_name(std::string_view name, std::string_view quality) {
    std::string known;
    for (const Entry& entry : entries) {
        if (entry.name == name) return entry.make(quality);
        known += (known.empty() ? "" : ", ") + std::string(entry.name);
    }
    detail::reject("model", "\"" + std::string(name) + "\"", "one of " + known);
}

}  // namespace aureole
