#include "measure/setting.h"

#include <aureole/models/aureole.h>
#include <aureole/models/bruneton.h>
#include <aureole/models/hillaire.h>
#include <aureole/models/single.h>
#include <aureole/models/single_lut.h>
#include <aureole/rhi/error.h>

#include <algorithm>
#include <array>
#include <utility>

namespace aureole::app {
namespace {

using models::BrunetonSettings;
using models::HillaireSettings;
using models::SingleLutSettings;
using models::SingleSettings;

constexpr std::string_view multiple = "multiple scattering", direction = "its direction", ground_light = "ground light",
                           samples = "half the samples", precision = "float tables", colour = "coloured transmittance",
                           wavelengths = "wavelengths";
constexpr std::array names{multiple, direction, ground_light, samples, precision, colour, wavelengths};
constexpr rhi::Format half = rhi::Format::rgba16_float;

void halve(int& count, int least) { count = std::max(least, (count + 1) / 2); }

// Each returns whether the model has what is to be left out, and leaves it out.

bool leave_out(QualitySettings& s, std::string_view what) {
    if (what == multiple) return s.multi_scatter_orders = 0, true;
    if (what == direction) return s.angular_order = 0, s.angular_order_as_needed = false, true;
    if (what == ground_light) return s.ground_light = false, true;
    if (what == precision) return s.table_format = s.froxel_format = half, true;
    if (what != samples) return false;
    for (int* nodes : {&s.transmittance_nodes, &s.multi_scatter_nodes, &s.multi_scatter_later_nodes, &s.sky_view_nodes})
        halve(*nodes, 2);
    halve(s.aerial_perspective_nodes, 1);
    return true;
}

bool leave_out(HillaireSettings& s, std::string_view what) {
    if (what == colour) return !std::exchange(s.grey_transmittance, true);
    if (what != samples) return false;
    for (int* steps : {&s.transmittance_steps, &s.multi_scatter_steps, &s.sky_view_steps, &s.march_steps}) halve(*steps, 1);
    return true;
}

bool leave_out(BrunetonSettings& s, std::string_view what) {
    if (what == precision) return s.format = half, true;
    if (what != samples) return false;
    for (int* nodes : {&s.transmittance_nodes, &s.ray_nodes, &s.zenith_nodes, &s.azimuth_nodes}) halve(*nodes, 2);
    return true;
}

bool leave_out(SingleSettings& s, std::string_view what) {
    if (what != samples) return false;
    halve(s.view_steps, 2);
    halve(s.light_steps, 2);
    return true;
}

bool leave_out(SingleLutSettings& s, std::string_view what) {
    if (what == precision) return s.table_format = half, true;
    if (what != samples) return false;
    halve(s.view_steps, 2);
    halve(s.table_nodes, 2);
    return true;
}

[[noreturn]] void reject_without(const SuiteSetting& setting, std::string_view what) {
    std::string allowed;
    for (const std::string_view name : names) allowed.append("\"").append(name).append("\", ");
    throw Error(ErrorCode::invalid_argument, "without",
                std::string("\"").append(what).append("\" of ").append(SuiteSetting{setting.model, {}}.id()),
                allowed + "where the model has it, or a term of the air by its name");
}

bool is_simplification(std::string_view what) { return std::ranges::find(names, what) != names.end(); }

bool without(const SuiteSetting& setting, std::string_view what) {
    return std::ranges::find(setting.without, what) != setting.without.end();
}

template <class Settings>
ModelPtr make(Settings settings, const SuiteSetting& setting, ModelPtr (*make_model)(const Settings&)) {
    for (const std::string& what : setting.without)
        if (is_simplification(what) && what != wavelengths && !leave_out(settings, what)) reject_without(setting, what);
    return make_model(settings);
}

ModelPtr make_model(const SuiteSetting& setting) {
    const auto& [name, quality, spectral] = setting.model;
    if (setting.model.in_rgb() && without(setting, wavelengths)) reject_without(setting, wavelengths);
    if (name == "aureole") return make(QualitySettings::by_name(quality), setting, &models::aureole);
    if (name == "hillaire") return make(HillaireSettings::by_name(quality), setting, &models::hillaire);
    if (name == "bruneton") return make(BrunetonSettings::by_name(quality), setting, &models::bruneton);
    if (name == "single") return make(SingleSettings::by_name(quality), setting, &models::single);
    if (name == "single-lut") return make(SingleLutSettings::by_name(quality), setting, &models::single_lut);
    for (const std::string& what : setting.without)
        if (is_simplification(what) && what != wavelengths) reject_without(setting, what);
    return model_by_name(name, quality);
}

}  // namespace

std::span<const std::string_view> simplification_names() { return names; }

void check(const SuiteSetting& setting) {
    (void)setting.model.in_its_colours(make_model(setting));
    for (std::size_t i = 0; i < setting.without.size(); ++i)
        if (std::find(setting.without.begin(), setting.without.begin() + static_cast<std::ptrdiff_t>(i), setting.without[i]) !=
            setting.without.begin() + static_cast<std::ptrdiff_t>(i))
            throw Error(ErrorCode::invalid_argument, "without", "\"" + setting.without[i] + "\" twice", "each once");
}

std::optional<Prepared> prepare(const SuiteSetting& setting, const AtmosphereParameters& air) {
    const ModelPtr model = make_model(setting);
    Prepared prepared{air, without(setting, wavelengths) ? model : setting.model.in_its_colours(model)};
    for (const std::string& what : setting.without) {
        if (is_simplification(what)) continue;
        if (std::erase_if(prepared.air.terms, [&](const DensityTerm& term) { return term.name == what; }) == 0) return {};
    }
    return prepared;
}

bool is_for(const SuiteSetting& setting, const SuiteAir& air) {
    return setting.model.in_rgb() == (air.spectral == "rgb") && prepare(setting, air.parameters).has_value();
}

SuiteSetting converged(const SuiteSetting& setting) {
    const auto& [name, quality, spectral] = setting.model;
    if (name == "fog" && quality == "low") return setting;  // one colour: as it is
    SuiteSetting result = setting;
    result.model.quality = "converged";
    const auto leave = [&](std::string_view what) {
        if (!without(result, what)) result.without.emplace_back(what);
    };
    // What these qualities leave out of the light is the model's, not the samples'.
    if (name == "aureole" && quality == "low" && !without(setting, multiple)) leave(direction);
    if (name == "hillaire" && quality != "high") leave(colour);
    std::erase_if(result.without, [](const std::string& what) { return what == samples || what == precision; });
    return result;
}

}  // namespace aureole::app
