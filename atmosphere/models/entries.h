// The models and their settings, by name. A new one adds its entry here.
#pragma once

#include <aureole/models/aureole.h>
#include <aureole/models/bruneton.h>
#include <aureole/models/fog.h>
#include <aureole/models/hillaire.h>
#include <aureole/models/reference.h>
#include <aureole/models/single.h>
#include <aureole/models/single_lut.h>

#include <string_view>
#include <tuple>

namespace aureole::detail {

template <class Settings>
struct ModelEntry {
    std::string_view name, summary;
    ModelPtr (*make)(const Settings&);

    [[nodiscard]] static Settings settings(std::string_view quality) { return Settings::by_name(quality); }
};

/// From the cheapest to the dearest.
inline constexpr std::tuple model_entries{
    ModelEntry<models::FogSettings>{"fog", "homogeneous air in closed form: no tables, no horizon", &models::fog},
    ModelEntry<models::SingleSettings>{
        "single", "single scattering, marched for each pixel with a nested march to the sun: no tables", &models::single},
    ModelEntry<models::SingleLutSettings>{
        "single-lut", "single scattering, marched for each pixel with a table of optical depth", &models::single_lut},
    ModelEntry<models::HillaireSettings>{
        "hillaire", "Hillaire 2020 as published: isotropic multiple scattering of all orders, sky-view table, froxels",
        &models::hillaire},
    ModelEntry<QualitySettings>{"aureole", "ours: spectral quadrature, multiple scattering that keeps its direction",
                                &models::aureole},
    ModelEntry<models::BrunetonSettings>{
        "bruneton", "Bruneton 2008 and 2017: all orders wanted, precomputed over altitude, view, sun and their angle",
        &models::bruneton},
    ModelEntry<models::ReferenceSettings>{
        "reference", "path tracing, all orders, no tables: noise in place of error, and its standard error",
        &models::reference},
};

/// Throws Error(invalid_argument) naming the models there are.
[[noreturn]] void reject_model(std::string_view name);

/// What `act(entry)` gives for the entry of this name. Throws as reject_model does.
template <class Act>
auto with_model(std::string_view name, const Act& act) {
    decltype(act(std::get<0>(model_entries))) result{};
    const auto try_one = [&](const auto& entry) {
        if (entry.name != name) return false;
        result = act(entry);
        return true;
    };
    if (!std::apply([&](const auto&... entries) { return (try_one(entries) || ...); }, model_entries)) reject_model(name);
    return result;
}

}  // namespace aureole::detail
