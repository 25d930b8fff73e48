// Settings of models by number: each field by the name that it has in C++. Ranges are the models' own to check.
#include "models/entries.h"

#include <aureole/models/spectral.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

#include "convert.h"
#include "numbers.h"

namespace aureole::c_api {
namespace {

using namespace models;

using Field = std::variant<int*, std::uint32_t*, bool*, double*, rhi::Format*, Steps*, Dome::Phase*, BrunetonSampling*,
                           FogSettings::Mode*, FogSettings::Sky*, ReferenceSettings::Show*, ReferenceSettings::Tracking*>;
struct Named {
    const char* name;
    Field field;
};
using Fields = std::vector<Named>;

Fields fields_of(QualitySettings& s) {
    return {{"transmittance.width", &s.transmittance.width},
            {"transmittance.height", &s.transmittance.height},
            {"transmittance_nodes", &s.transmittance_nodes},
            {"multi_scatter.width", &s.multi_scatter.width},
            {"multi_scatter.height", &s.multi_scatter.height},
            {"angular_order", &s.angular_order},
            {"angular_order_as_needed", &s.angular_order_as_needed},
            {"multi_scatter_zenith", &s.multi_scatter_zenith},
            {"multi_scatter_azimuth", &s.multi_scatter_azimuth},
            {"multi_scatter_nodes", &s.multi_scatter_nodes},
            {"multi_scatter_later_nodes", &s.multi_scatter_later_nodes},
            {"multi_scatter_orders", &s.multi_scatter_orders},
            {"ground_light", &s.ground_light},
            {"sky_view.width", &s.sky_view.width},
            {"sky_view.height", &s.sky_view.height},
            {"sky_view_nodes", &s.sky_view_nodes},
            {"aerial_perspective.width", &s.aerial_perspective.width},
            {"aerial_perspective.height", &s.aerial_perspective.height},
            {"aerial_perspective.depth", &s.aerial_perspective.depth},
            {"aerial_perspective_nodes", &s.aerial_perspective_nodes},
            {"table_format", &s.table_format},
            {"froxel_format", &s.froxel_format}};
}

Fields fields_of(BrunetonSettings& s) {
    return {{"transmittance.width", &s.transmittance.width},
            {"transmittance.height", &s.transmittance.height},
            {"irradiance.width", &s.irradiance.width},
            {"irradiance.height", &s.irradiance.height},
            {"altitude_nodes", &s.altitude_nodes},
            {"view_nodes", &s.view_nodes},
            {"sun_nodes", &s.sun_nodes},
            {"nu_nodes", &s.nu_nodes},
            {"orders", &s.orders},
            {"combined", &s.combined},
            {"format", &s.format},
            {"sampling", &s.sampling},
            {"transmittance_nodes", &s.transmittance_nodes},
            {"ray_nodes", &s.ray_nodes},
            {"zenith_nodes", &s.zenith_nodes},
            {"azimuth_nodes", &s.azimuth_nodes},
            {"lowest_sun_deg", &s.lowest_sun_deg},
            {"slices_per_frame", &s.slices_per_frame}};
}

Fields fields_of(HillaireSettings& s) {
    return {{"transmittance.width", &s.transmittance.width},
            {"transmittance.height", &s.transmittance.height},
            {"transmittance_steps", &s.transmittance_steps},
            {"multi_scatter.width", &s.multi_scatter.width},
            {"multi_scatter.height", &s.multi_scatter.height},
            {"multi_scatter_steps", &s.multi_scatter_steps},
            {"fast_sky", &s.fast_sky},
            {"sky_view.width", &s.sky_view.width},
            {"sky_view.height", &s.sky_view.height},
            {"sky_view_steps", &s.sky_view_steps},
            {"fast_aerial_perspective", &s.fast_aerial_perspective},
            {"aerial_perspective.width", &s.aerial_perspective.width},
            {"aerial_perspective.height", &s.aerial_perspective.height},
            {"aerial_perspective.depth", &s.aerial_perspective.depth},
            {"grey_transmittance", &s.grey_transmittance},
            {"march_steps", &s.march_steps},
            {"table_format", &s.table_format},
            {"froxel_format", &s.froxel_format}};
}

Fields with_dome(Fields fields, Dome& dome) {
    for (const Named& more : Fields{{"dome.size.width", &dome.size.width},
                                    {"dome.size.height", &dome.size.height},
                                    {"dome.phase", &dome.phase},
                                    {"dome.format", &dome.format}})
        fields.push_back(more);
    return fields;
}

Fields fields_of(SingleSettings& s) {
    return with_dome({{"steps", &s.steps}, {"view_steps", &s.view_steps}, {"light_steps", &s.light_steps}}, s.dome);
}

Fields fields_of(SingleLutSettings& s) {
    return with_dome({{"steps", &s.steps},
                      {"view_steps", &s.view_steps},
                      {"table.width", &s.table.width},
                      {"table.height", &s.table.height},
                      {"table_nodes", &s.table_nodes},
                      {"table_format", &s.table_format}},
                     s.dome);
}

Fields fields_of(FogSettings& s) {
    return {{"mode", &s.mode},
            {"sky", &s.sky},
            {"colour.r", &s.colour.x},
            {"colour.g", &s.colour.y},
            {"colour.b", &s.colour.z},
            {"density_per_m", &s.density_per_m},
            {"transmittance_nodes", &s.transmittance_nodes}};
}

Fields fields_of(ReferenceSettings& s) {
    return {{"show", &s.show},
            {"tracking", &s.tracking},
            {"paths_per_frame", &s.paths_per_frame},
            {"max_paths", &s.max_paths},
            {"film_width", &s.film_width},
            {"film_height", &s.film_height},
            {"max_order", &s.max_order},
            {"sampled_first_order", &s.sampled_first_order},
            {"first_order_parts", &s.first_order_parts},
            {"nodes", &s.nodes},
            {"roulette_order", &s.roulette_order},
            {"seed", &s.seed},
            {"light_paths", &s.light_paths}};
}

/// False for what is no value of the field's type; which of those it takes the model says.
template <class T>
[[nodiscard]] bool set(T& to, double value) {
    if constexpr (std::is_same_v<T, double>) {
        to = value;
        return true;
    } else if constexpr (std::is_enum_v<T>) {
        std::underlying_type_t<T> number{};
        const bool fits = set(number, value);
        to = static_cast<T>(number);
        return fits;
    } else {
        constexpr double least = std::numeric_limits<T>::lowest(), most = std::numeric_limits<T>::max();
        const bool fits = value >= least && value <= most && value == std::floor(value);
        to = fits ? static_cast<T>(value) : value < 0 ? std::numeric_limits<T>::lowest() : std::numeric_limits<T>::max();
        return fits;
    }
}

/// Settings of one model under way.
template <class Settings>
class ByNumber {
public:
    ByNumber(Settings settings, const Setting& chosen, ModelPtr (*make)(const Settings&))
        : settings_(std::move(settings)), model_(chosen.model), make_(make), fields_(fields_of(settings_)) {}
    ByNumber(const ByNumber&) = delete;
    ByNumber& operator=(const ByNumber&) = delete;

    void set_number(const aureole_number& number, const std::string& where) {
        const Named& named = find(&given(number.name, where), where);
        if (!std::visit([&](auto* field) { return set(*field, number.value); }, named.field)) refuse(named, number.value);
    }
    [[nodiscard]] Numbers numbers() const {
        Numbers numbers{make_(settings_), {}};  // refuses what is out of range
        for (const Named& f : fields_)
            numbers.values.push_back({f.name, std::visit([](auto* field) { return static_cast<double>(*field); }, f.field)});
        return numbers;
    }

private:
    [[nodiscard]] const Named& find(std::string_view name, const std::string& where) const {
        const auto found = std::ranges::find_if(fields_, [&](const Named& f) { return f.name == name; });
        if (found != fields_.end()) return *found;
        std::string known;
        for (const Named& f : fields_) known.append(known.empty() ? "" : ", ").append(f.name);
        throw Error(ErrorCode::invalid_argument, where, "\"" + std::string(name) + "\"",
                    "a number of the model " + model_ + ": " + known);
    }
    /// In the words that the model has for another number that it does not take.
    [[noreturn]] void refuse(const Named& named, double value) const {
        std::string name = model_ + "." + named.name, allowed = "0 or 1";
        std::ranges::replace(name, '-', '_');  // as the models name themselves in errors
        if (!std::holds_alternative<bool*>(named.field)) {
            allowed = "as documented";
            std::visit([](auto* field) { (void)set(*field, 1e300); }, named.field);  // the most that its type holds
            try {
                (void)make_(settings_);
            } catch (const Error& error) {
                // A size whose other half is 0 is refused by the other's name, which has the same range.
                allowed = (error.field() == name ? "" : "as of " + error.field() + ", ") + error.allowed();
            }
            allowed = "whole numbers: " + allowed;
        }
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, value).ptr;
        throw Error(ErrorCode::invalid_argument, name, std::string(text, end), allowed);
    }

    Settings settings_;
    std::string model_;
    ModelPtr (*make_)(const Settings&);
    Fields fields_;  ///< Of settings_.
};

template <class Settings>
Numbers numbers_of(Settings settings, const Setting& chosen, std::span<const aureole_number> numbers,
                   ModelPtr (*make)(const Settings&)) {
    ByNumber<Settings> made(std::move(settings), chosen, make);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        made.set_number(numbers[i], "setting.numbers[" + std::to_string(i) + "].name");
    return made.numbers();
}

}  // namespace

Numbers make_by_numbers(const Setting& setting, std::span<const aureole_number> numbers) {
    return detail::with_model(setting.model, [&](const auto& entry) {
        return numbers_of(entry.settings(setting.quality), setting, numbers, entry.make);
    });
}

}  // namespace aureole::c_api

using namespace aureole;
using namespace aureole::c_api;

namespace {

std::span<const aureole_number> numbers_in(const aureole_setting* setting) {
    if (!setting) return {};
    const aureole_setting c = read(setting, "setting", default_setting());
    if (c.number_count == 0) return {};
    return {&given(c.numbers, "setting.numbers"), c.number_count};
}

void refuse_simplifications(const Setting& chosen) {
    for (const std::string& what : chosen.without)
        if (std::ranges::find(simplification_names(), what) != simplification_names().end())
            throw Error(ErrorCode::invalid_argument, "setting.without", "\"" + what + "\" beside numbers",
                        "terms of the air: numbers say all else");
}

}  // namespace

ModelPtr c_api::read_model(const aureole_setting* setting, const Setting& chosen) {
    const auto numbers = numbers_in(setting);
    if (numbers.empty()) return {};
    refuse_simplifications(chosen);
    const ModelPtr model = make_by_numbers(chosen, numbers).model;
    return chosen.in_rgb() ? model : models::spectral(model, {.wavelengths = models::wavelengths_by_name(chosen.spectral)});
}

aureole_result aureole_get_setting_number(const aureole_setting* setting, uint32_t index, aureole_number* out_number,
                                          uint32_t* out_count) {
    return guarded([&] {
        // A setting that creates no atmosphere has no numbers, and simplifications are told by no number.
        const Setting chosen = read_setting(setting);
        validate(chosen);
        refuse_simplifications(chosen);
        const Numbers numbers = make_by_numbers(chosen, numbers_in(setting));
        const std::size_t count = numbers.values.size();
        if (!out_count) given(out_number, "out_number");
        if (out_number && index >= count)
            throw Error(ErrorCode::invalid_argument, "index", std::to_string(index), "less than " + std::to_string(count));
        if (out_number) *out_number = numbers.values[index];
        if (out_count) *out_count = static_cast<std::uint32_t>(count);
    });
}
