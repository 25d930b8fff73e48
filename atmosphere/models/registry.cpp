// The models by name. A new one adds its line here.
#include "common/check.h"

#include <aureole/models/aureole.h>
#include <aureole/models/bruneton.h>
#include <aureole/models/fog.h>
#include <aureole/models/hillaire.h>
#include <aureole/models/reference.h>
#include <aureole/models/single.h>
#include <aureole/models/single_lut.h>

#include <array>
#include <string>

namespace aureole {
namespace {

using Make = ModelPtr (*)(std::string_view quality);

struct Entry {
    std::string_view name;
    std::string_view summary;
    Make make;
};

constexpr std::array entries{
    Entry{"fog", "homogeneous air in closed form: no tables, no horizon",
          [](std::string_view quality) { return models::fog(models::FogSettings::by_name(quality)); }},
    Entry{"single", "single scattering, marched for each pixel with a nested march to the sun: no tables",
          [](std::string_view quality) { return models::single(models::SingleSettings::by_name(quality)); }},
    Entry{"single-lut", "single scattering, marched for each pixel with a table of optical depth",
          [](std::string_view quality) { return models::single_lut(models::SingleLutSettings::by_name(quality)); }},
    Entry{"hillaire", "Hillaire 2020 as published: isotropic multiple scattering of all orders, sky-view table, froxels",
          [](std::string_view quality) { return models::hillaire(models::HillaireSettings::by_name(quality)); }},
    Entry{"aureole", "ours: spectral quadrature, multiple scattering that keeps its direction",
          [](std::string_view quality) { return models::aureole(QualitySettings::by_name(quality)); }},
    Entry{"bruneton", "Bruneton 2008 and 2017: all orders wanted, precomputed over altitude, view, sun and their angle",
          [](std::string_view quality) { return models::bruneton(models::BrunetonSettings::by_name(quality)); }},
    Entry{"reference", "path tracing, all orders, no tables: noise in place of error, and its standard error",
          [](std::string_view quality) { return models::reference(models::ReferenceSettings::by_name(quality)); }},
};

constexpr auto names = [] {
    std::array<std::string_view, entries.size()> result;
    for (std::size_t i = 0; i < entries.size(); ++i) result[i] = entries[i].name;
    return result;
}();

const Entry& entry_of(std::string_view name) {
    std::string known;
    for (const Entry& entry : entries) {
        if (entry.name == name) return entry;
        known.append(known.empty() ? "" : ", ").append(entry.name);
    }
    detail::reject("model", std::string("\"").append(name).append("\""), "one of " + known);
}

}  // namespace

std::span<const std::string_view> model_names() { return names; }

std::string_view model_summary(std::string_view name) { return entry_of(name).summary; }

ModelPtr model_by_name(std::string_view name, std::string_view quality) { return entry_of(name).make(quality); }

std::string models_by_tables() {
    std::string result;
    for (const Entry& entry : entries) {
        std::string qualities;
        bool all = true;
        for (const std::string_view quality : quality_names()) {
            if (entry.make(quality)->by_tables())
                qualities.append(qualities.empty() ? "" : ", ").append(quality);
            else
                all = false;
        }
        if (qualities.empty()) continue;
        result.append(result.empty() ? "" : ", ").append(entry.name);
        if (!all) result.append(" (").append(qualities).append(")");
    }
    return result;
}

}  // namespace aureole
