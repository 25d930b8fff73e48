#include "models/entries.h"

#include <aureole/models/spectral.h>
#include <aureole/setting.h>

#include <algorithm>
#include <array>
#include <utility>

namespace aureole {
namespace {

using models::BrunetonSettings;
using models::FogSettings;
using models::HillaireSettings;
using models::ReferenceSettings;
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
    if (what == direction) return s.angular_order_as_needed = false, std::exchange(s.angular_order, 0) != 0;
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

bool leave_out(FogSettings&, std::string_view) { return false; }
bool leave_out(ReferenceSettings&, std::string_view) { return false; }

[[noreturn]] void reject_without(const Setting& setting, std::string_view what) {
    std::string allowed;
    for (const std::string_view name : names) allowed.append("\"").append(name).append("\", ");
    throw Error(ErrorCode::invalid_argument, "without",
                std::string("\"").append(what).append("\" of ").append(setting.baseline()),
                allowed + "where the model has it, or a term of the air by its name");
}

bool is_simplification(std::string_view what) { return std::ranges::find(names, what) != names.end(); }

template <class Settings>
ModelPtr make(Settings settings, const Setting& setting, ModelPtr (*make_model)(const Settings&)) {
    for (const std::string& what : setting.without)
        if (is_simplification(what) && what != wavelengths && !leave_out(settings, what)) reject_without(setting, what);
    return make_model(settings);
}

ModelPtr make_model(const Setting& setting) {
    for (auto what = setting.without.begin(); what != setting.without.end(); ++what)
        if (std::find(setting.without.begin(), what, *what) != what)
            throw Error(ErrorCode::invalid_argument, "without", "\"" + *what + "\" twice", "each once");
    if (setting.in_rgb() && setting.leaves_out(wavelengths)) reject_without(setting, wavelengths);
    return detail::with_model(setting.model,
                              [&](const auto& entry) { return make(entry.settings(setting.quality), setting, entry.make); });
}

ModelPtr in_its_colours(const Setting& setting, ModelPtr model) {
    if (setting.in_rgb()) return model;
    const models::SpectralSettings colours{models::wavelengths_by_name(setting.spectral)};
    return setting.leaves_out(wavelengths) ? model : models::spectral(model, colours);
}

}  // namespace

std::string Setting::id() const {
    std::string text = model + " " + quality + (in_rgb() ? "" : " " + spectral);
    for (std::size_t i = 0; i < without.size(); ++i) text += (i == 0 ? ", without " : " and ") + without[i];
    return text;
}

std::string Setting::baseline() const { return without.empty() ? "" : Setting{model, quality, spectral, {}}.id(); }

bool Setting::leaves_out(std::string_view what) const { return std::ranges::find(without, what) != without.end(); }

std::span<const std::string_view> simplification_names() { return names; }

void validate(const Setting& setting) { (void)in_its_colours(setting, make_model(setting)); }

std::optional<Prepared> prepare(const Setting& setting, const AtmosphereParameters& air) {
    Prepared prepared{air, in_its_colours(setting, make_model(setting))};
    for (const std::string& what : setting.without) {
        if (is_simplification(what)) continue;
        if (std::erase_if(prepared.air.terms, [&](const DensityTerm& term) { return term.name == what; }) == 0) return {};
    }
    return prepared;
}

Setting converged(const Setting& setting) {
    if (setting.model == "fog" && setting.quality == "low") return setting;  // one colour: as it is
    Setting result = setting;
    result.quality = "converged";
    const auto leave = [&](std::string_view what) {
        if (!result.leaves_out(what)) result.without.emplace_back(what);
    };
    // What these qualities leave out of the light is the model's, not the samples'.
    if (setting.model == "aureole" && setting.quality == "low" && !setting.leaves_out(multiple)) leave(direction);
    if (setting.model == "hillaire" && setting.quality != "high" && setting.quality != "converged") leave(colour);
    std::erase_if(result.without, [](const std::string& what) { return what == samples || what == precision; });
    return result;
}

}  // namespace aureole
