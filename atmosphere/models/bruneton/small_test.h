// Small tables of the model, and what tests read of it.
#pragma once

#include "models/bruneton/bruneton.h"

#include "module/air.h"

#include "passes/rig.h"

namespace aureole::bruneton_test {

inline models::BrunetonSettings small() {
    models::BrunetonSettings s;
    s.transmittance = {40, 12, 1};
    s.irradiance = {11, 5, 1};
    s.altitude_nodes = 5;
    s.view_nodes = 14;
    s.sun_nodes = 9;
    s.nu_nodes = 4;
    s.orders = 3;
    s.format = rhi::Format::rgba32_float;
    s.ray_nodes = 5;
    s.zenith_nodes = 3;
    s.azimuth_nodes = 5;
    return s;
}

inline passes::Setup setup_of(const char* preset, const models::BrunetonSettings& settings) {
    passes::Setup setup;
    setup.air = presets::by_name(preset);
    setup.model = models::bruneton(settings);
    return setup;
}

inline detail::BrunetonAir& model_of(passes::AirRig& rig) {
    return dynamic_cast<detail::BrunetonAir&>(*rig.air.impl().tables->model);
}
inline passes::Image scattering(passes::AirRig& rig) { return rig.backend.read(model_of(rig).scattering().handle); }
inline passes::Image irradiance(passes::AirRig& rig) { return rig.backend.read(model_of(rig).irradiance().handle); }

}  // namespace aureole::bruneton_test
