#include <aureole/presets.h>

#include <utility>

#include "convert.h"
#include "handles.h"

using namespace aureole;
using namespace aureole::c_api;

aureole_atmosphere::aureole_atmosphere(aureole_device& on, const Setting& chosen, const AtmosphereParameters& parameters,
                                       const ModelPtr& model)
    : device(on), setting(chosen), air(on.rhi_device(), parameters, model) {
    ++device.atmospheres;
}
aureole_atmosphere::~aureole_atmosphere() { --device.atmospheres; }

namespace {

/// The setting in this air. Throws Error(invalid_argument) where a term is to be left out that the air does not have.
Prepared prepared(const Setting& setting, const AtmosphereParameters& air) {
    auto ready = prepare(setting, air);
    if (!ready) throw Error(ErrorCode::invalid_argument, "setting.without", setting.id(), "terms that the air has");
    return *ready;
}

}  // namespace

aureole_result aureole_preset(const char* name, aureole_parameters* out_parameters) {
    return guarded([&] {
        const std::string_view wanted = &given(name, "name");
        static const auto all = [] {
            std::vector<std::pair<std::string_view, std::unique_ptr<const AirInC>>> made;
            for (const std::string_view preset : presets::names())
                made.emplace_back(preset, std::make_unique<const AirInC>(presets::by_name(preset)));
            return made;
        }();
        for (const auto& [preset, air] : all)
            if (preset == wanted) return write(out_parameters, "out_parameters", air->parameters());
        (void)presets::by_name(wanted);  // throws, with the names there are
    });
}

aureole_result aureole_preset_name(uint32_t index, const char** out_name) {
    return guarded([&] {
        const auto names = presets::names();
        if (index >= names.size())
            throw Error(ErrorCode::invalid_argument, "index", std::to_string(index),
                        "0 to " + std::to_string(names.size() - 1));
        given(out_name, "out_name") = names[index].data();  // literals
    });
}

aureole_result aureole_preset_earth_with_visibility(double visibility_m, aureole_parameters* out_parameters) {
    return guarded([&] {
        thread_local std::unique_ptr<const AirInC> latest;
        auto made = std::make_unique<const AirInC>(presets::earth_with_visibility(visibility_m));
        write(out_parameters, "out_parameters", made->parameters());
        latest = std::move(made);
    });
}

aureole_result aureole_validate_parameters(const aureole_parameters* parameters) {
    return guarded([&] { validate(read_parameters(parameters, "parameters")); });
}

aureole_result aureole_vertical_optical_depth(const aureole_parameters* parameters, double out_depth[3]) {
    return guarded(
        [&] { copy(vertical_optical_depth(read_parameters(parameters, "parameters")), &given(out_depth, "out_depth")); });
}

aureole_result aureole_envelope_of_air(const aureole_parameters* parameters, aureole_outside* out, uint32_t capacity,
                                       uint32_t* out_count) {
    return guarded([&] {
        const AtmosphereParameters air = read_parameters(parameters, "parameters");
        validate(air);
        write_outside(outside_envelope(air), out, capacity, out_count);
    });
}

aureole_result aureole_setting_defaults(aureole_setting* setting) {
    return guarded([&] { write(setting, "setting", default_setting()); });
}

aureole_result aureole_create_atmosphere(aureole_device* device, const aureole_parameters* parameters,
                                         const aureole_setting* setting, aureole_atmosphere** out_atmosphere) {
    return guarded([&] {
        aureole_device& on = given(device, "device");
        const Setting chosen = read_setting(setting);
        Prepared ready = prepared(chosen, read_parameters(parameters, "parameters"));
        if (ModelPtr by_numbers = read_model(setting, chosen)) ready.model = std::move(by_numbers);
        aureole_atmosphere*& out = given(out_atmosphere, "out_atmosphere");
        out = new aureole_atmosphere(on, chosen, ready.air, ready.model);
    });
}

aureole_result aureole_destroy_atmosphere(aureole_atmosphere* atmosphere) {
    return guarded([&] {
        if (!atmosphere) return;
        if (atmosphere->views > 0)
            throw Error(ErrorCode::misuse, "the atmosphere has " + std::to_string(atmosphere->views) +
                                               " views that live: they are destroyed before it");
        delete atmosphere;
    });
}

aureole_result aureole_set_parameters(aureole_atmosphere* atmosphere, const aureole_parameters* parameters) {
    return guarded([&] {
        aureole_atmosphere& of = given(atmosphere, "atmosphere");
        of.air.set_parameters(prepared(of.setting, read_parameters(parameters, "parameters")).air);
    });
}

aureole_result aureole_set_multi_scatter_passes_per_frame(aureole_atmosphere* atmosphere, uint32_t passes, uint32_t first_too) {
    return guarded([&] {
        aureole_atmosphere& of = given(atmosphere, "atmosphere");
        const bool first = boolean(first_too, "first_too");
        // What does not fit an int is out of range all the same.
        of.air.set_multi_scatter_passes_per_frame(passes > 1000 ? 1000 : static_cast<int>(passes), first);
    });
}

aureole_result aureole_set_frame(aureole_atmosphere* atmosphere, uint64_t frame) {
    return guarded([&] { given(atmosphere, "atmosphere").air.set_frame(frame); });
}

aureole_result aureole_invalidate(aureole_atmosphere* atmosphere) {
    return guarded([&] { given(atmosphere, "atmosphere").air.invalidate(); });
}

aureole_result aureole_record_atmosphere(aureole_atmosphere* atmosphere, aureole_commands* commands, int32_t first_timestamp) {
    return guarded([&] {
        aureole_atmosphere& of = given(atmosphere, "atmosphere");
        of.air.record(open_list(of.device, commands), timestamps(first_timestamp));
    });
}

aureole_result aureole_get_progress(const aureole_atmosphere* atmosphere, double* out_progress) {
    return guarded([&] { given(out_progress, "out_progress") = given(atmosphere, "atmosphere").air.progress(); });
}

aureole_result aureole_atmosphere_table_bytes(const aureole_atmosphere* atmosphere, uint64_t* out_bytes) {
    return guarded([&] { given(out_bytes, "out_bytes") = given(atmosphere, "atmosphere").air.table_bytes(); });
}

aureole_result aureole_atmosphere_reports(const aureole_atmosphere* atmosphere, aureole_pass_report* out, uint32_t capacity,
                                          uint32_t* out_count) {
    return guarded([&] { write_reports(given(atmosphere, "atmosphere").air.reports(), out, capacity, out_count); });
}
